"""The page: one HTML file that needs nothing else, with its numbers and Plotly inside.

The template escapes every text, and so does the JSON of the numbers, in which no tag can end.
"""

import math
from pathlib import Path
from typing import Any

from jinja2.utils import htmlsafe_json_dumps
from markupsafe import Markup

from wrinklestudy.explorer.content import Content, ShownMap, ShownSheet
from wrinklestudy.explorer.sampling import SAMPLES, Samples, packed_shape
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.results.rows import StateRow, columns, numbers_of
from wrinklestudy.results.tension import TensionRow
from wrinklestudy.study import pages
from wrinklestudy.typing import AnyPath

MOST_BYTES = 15_000_000
_FOR_HEIGHTS = 7_500_000  # bytes for the z of all wrinkled states
_FOLDER = Path(__file__).parent / "page"
_SCRIPTS = ("numbers.js", "choice.js", "look.js", "plots.js", "maps.js", "words.js", "main.js")
_MARK = '<meta name="generator" content="wrinklestudy explore">'
# What of a state the page shows or offers for download besides its texts.
_STATE_COLUMNS = tuple(
    name for name, column in columns(StateRow).items() if not column.identifies or name == "strain"
)
_TENSION_COLUMNS = ("strain", "status", "phi_squared", "phi_squared_error", "nominal_stress_pa")


def write_page(content: Content, output: AnyPath) -> None:
    """Write the page; see `page` for the errors."""
    text = page(content)
    with atomic_path(output) as path:
        path.write_text(text, encoding="utf-8")


def is_page(path: AnyPath) -> bool:
    """Return whether a file is a page that `write_page` wrote."""
    with open(path, "rb") as file:
        return _MARK.encode() in file.read(2000)


def page(content: Content) -> str:
    """Return the page as text.

    Parameters
    ----------
    content : Content

    Raises
    ------
    ValueError
        If there is nothing to show, or too much for one file; one line.
    """
    from plotly.offline import get_plotlyjs

    if not content.sheets:
        raise ValueError("the page would have no sheet to show")
    count = sum(sheet.wrinkled for sheet in content.sheets)
    fitting = [samples for samples in SAMPLES if count * samples.letters <= _FOR_HEIGHTS]
    scripts = "\n".join(map(_text, _SCRIPTS))
    text = pages.render(
        "page.html.j2",
        _FOLDER,
        title=content.title,
        source=content.source,
        mark=Markup(_MARK),
        style=Markup(_text("style.css")),
        before=Markup(_text("before.js")),
        plotly=Markup(get_plotlyjs()),
        script=Markup(scripts),
        numbers=htmlsafe_json_dumps(
            numbers(content, (fitting or SAMPLES[-1:])[0]),
            allow_nan=False,
            separators=(",", ":"),
        ),
    )
    size = len(text.encode())
    if size > MOST_BYTES:
        raise ValueError(
            f"{count} wrinkled states make a page of {size / 1e6:.0f} MB, more than "
            f"{MOST_BYTES / 1e6:.0f} MB; leave out sheets or strains"
        )
    return text


def numbers(content: Content, samples: Samples) -> dict[str, Any]:
    """Return what the page shows as plain values: NaN is None, arrays are lists or base64."""
    state_columns, tension_columns = columns(StateRow), columns(TensionRow)
    return {
        "title": content.title,
        "source": content.source,
        "constants": dict(content.constants),
        "first": content.first,
        "columns": {name: state_columns[name].unit for name in _STATE_COLUMNS},
        "sheets": [_sheet(shown, samples) for shown in content.sheets],
        "maps": {shown.model: _map(shown) for shown in content.maps},
        "tension": {
            material: [
                {"aspect": row.aspect} | {name: getattr(row, name) for name in _TENSION_COLUMNS}
                for row in rows
            ]
            for material, rows in content.tension.items()
        },
        "tensionUnits": {name: tension_columns[name].unit for name in _TENSION_COLUMNS},
    }


def _text(name: str) -> str:
    return (_FOLDER / name).read_text(encoding="utf-8")


def _sheet(shown: ShownSheet, samples: Samples) -> dict[str, Any]:
    sheet = shown.sheet
    table = {
        name: [getattr(row, name) for row in sheet.states]
        if column.kind is str
        else _plain(numbers_of(sheet.states, name))
        for name, column in columns(StateRow).items()
        if name in _STATE_COLUMNS
    }
    curves = ("amplitude_over_thickness", "phi_squared")
    return {
        "model": sheet.material,
        "material": shown.material,
        "law": sheet.law,
        "bending": sheet.bending,
        "parity": sheet.parity,
        "aspect": sheet.aspect,
        "thickness": sheet.thickness,
        "widthMm": shown.width_mm,
        "birth": _number(sheet.birth),
        "decay": _number(sheet.decay),
        "largestCritical": _number(sheet.max_critical_thickness),
        "states": table,
        # zero at birth and decay, as in the figures
        "curves": {name: [_plain(part) for part in sheet.curve(name)] for name in curves},
        "shapes": [
            None if shape is None else packed_shape(shape, status == "flat", samples)
            for shape, status in zip(shown.shapes, sheet.status, strict=True)
        ],
    }


def _map(shown: ShownMap) -> dict[str, Any]:
    return {
        "aspects": _plain(shown.aspects),
        "strains": _plain(shown.strains),
        "values": [_plain(row) for row in shown.values],
        "computed": [list(place) for place in shown.computed],
    }


def _plain(values: Any) -> list[float | None]:
    return [_number(value) for value in values]


def _number(value: float) -> float | None:
    """Return a number that JSON has, None for NaN."""
    return float(value) if math.isfinite(value) else None
