"""`wrinklestudy explore`: one HTML file to look at a study, or at a sheet of one's own."""

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from wrinklestudy.cli.map_command import LARGER, MapTask, check_memory, computed
from wrinklestudy.cli.output import Answer
from wrinklestudy.cli.outputs import add_overwrite, planned, write
from wrinklestudy.cli.sentences import failures
from wrinklestudy.cli.shaped_states import add_strains, bare, given_strains, shaped_states
from wrinklestudy.cli.sheet_options import GivenSize, add_sheet, given_size, mesh_settings, sheet
from wrinklestudy.cli.solving import kept, solve_all
from wrinklestudy.vocabulary import ASPECT

if TYPE_CHECKING:
    from wrinklestudy.equilibrium.newton import Observer
    from wrinklestudy.explorer.content import Content, ShownMap
    from wrinklestudy.results.tension import TensionRow
    from wrinklestudy.sheet import Sheet

_STATES = 22
_LENGTHS = (0.65, 0.75, 0.85, 1.0, 1.2, 1.45, 1.8)  # of the map, over that of the sheet
_MAP_STRAINS = (0.02, 0.05, 0.1, 0.16, 0.24, 0.34, 0.46, 0.6, 0.8, 1.0)  # over the largest
_TENSION_STRAINS = (0.05, 0.12, 0.22, 0.35, 0.5, 0.75, 1.0)


@dataclass(frozen=True)
class _FieldTask:
    """A strain at which the tension field of a sheet is wanted."""

    sheet: "Sheet"
    strain: float


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    parser.description = (
        "Write a page of a study that has been computed (--config alone), or compute one sheet, a "
        "small map around it and its tension field (size and material), and write a page of them."
    )
    add_sheet(parser)
    add_strains(parser)
    parser.add_argument("--output", metavar="FILE.html", help="the page to write")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> Answer:
    """Write the page and say what is on it."""
    from wrinklestudy.explorer.page import is_page, write_page

    if arguments.output is None:
        raise ValueError("--output: missing; the page to write, such as explorer.html")
    path = Path(arguments.output).expanduser()
    own = path.is_file() and is_page(path)  # a page of before is replaced without a word
    (file,) = planned("--output", arguments.output, (".html",), arguments.overwrite or own, [""])
    assert file is not None
    content = _content_of_study(arguments) if _is_study(arguments) else _content_of_sheet(arguments)
    write(file, lambda path: write_page(content, path))
    states = [row for shown in content.sheets for row in shown.sheet.states]
    values = {
        "output": str(file),
        "sheets": len(content.sheets),
        "states": len(states),
        "bytes": file.stat().st_size,
    }
    size = f"{file.stat().st_size / 1e6:.1f} MB"
    count = "1 sheet" if len(content.sheets) == 1 else f"{len(content.sheets)} sheets"
    text = f"{file}: {count}, {len(states)} states, {size}\n"
    missing = () if _is_study(arguments) else tuple(failures([row.shown() for row in states]))
    return Answer(values, text, missing)


def _is_study(arguments: argparse.Namespace) -> bool:
    """Return whether a study is wanted, not a sheet; refuse what is neither."""
    if arguments.config is None or arguments.material is not None:
        return False
    other = sorted(arguments.given - {"config", "output"})
    if other:
        raise ValueError(
            f"--config {arguments.config}: is the page of a study; "
            f"--{other[0].replace('_', '-')} cannot go with it"
        )
    return True


def _content_of_study(arguments: argparse.Namespace) -> "Content":
    from wrinklestudy.explorer.from_study import content_of_study
    from wrinklestudy.study.config.reading import read_study

    return content_of_study(read_study(arguments.config), arguments.config)


def _content_of_sheet(arguments: argparse.Namespace) -> "Content":
    """Compute what the page of one sheet shows."""
    from wrinklestudy.explorer.content import Content, ShownSheet
    from wrinklestudy.explorer.from_study import constants_text

    strains = given_strains(arguments)
    size = given_size(arguments)
    chosen = sheet(arguments, size)
    lengths = _lengths(chosen.aspect)
    check_memory(max(lengths), mesh_settings(arguments), min(arguments.jobs, len(lengths)))
    states, shapes = shaped_states(chosen, strains, _STATES, arguments.jobs)
    largest = states.states[-1].strain
    material = arguments.material or states.law
    relaxes = not chosen.material.law.linear_in_plane  # others have no tension field
    return Content(
        title=f"A sheet of {_size_text(size)}",
        source="a sheet of one's own (wrinklestudy explore)",
        sheets=[ShownSheet(states, shapes, material, size.width_mm)],
        maps=[_map(chosen, states.material, lengths, largest, arguments.jobs)],
        tension={material: _tension(chosen, largest, arguments.jobs)} if relaxes else {},
        constants={material: constants_text(chosen.material)},
    )


def _size_text(size: GivenSize) -> str:
    if size.width_mm is None:
        return f"L/W = {size.aspect:g}, t/W = {size.thickness:g}"
    lengths = (size.length_mm or 0.0, size.width_mm, size.thickness * size.width_mm)
    return " × ".join(f"{length:g}" for length in lengths) + " mm"


def _lengths(aspect: float) -> list[float]:
    """Return the L/W of the map around a sheet."""
    return [length for f in _LENGTHS if (length := float(f"{f * aspect:.3g}")) in ASPECT]


def _strains(parts: Sequence[float], largest: float) -> list[float]:
    return sorted({float(f"{part * largest:.3g}") for part in parts})


def _map(
    chosen: "Sheet", model: str, lengths: Sequence[float], largest: float, jobs: int
) -> "ShownMap":
    from wrinklestudy.explorer.content import map_of_points

    strains = tuple(_strains(_MAP_STRAINS, largest))
    tasks = [
        MapTask(length, strains, chosen.material, chosen.bending, chosen.mesh, LARGER)
        for length in lengths
    ]
    points = [point for of_length in computed(tasks, jobs) for point in of_length]
    return map_of_points(
        model, ((p["aspect"], p["strain"], p["critical_thickness"]) for p in points)
    )


def _tension(chosen: "Sheet", largest: float, jobs: int) -> "list[TensionRow]":
    tasks = [_FieldTask(bare(chosen), strain) for strain in _strains(_TENSION_STRAINS, largest)]
    return [values["row"] for values in solve_all(_field, tasks, jobs)]


def _field(task: _FieldTask, observer: "Observer | None" = None) -> dict[str, Any]:
    return {"row": kept(task.sheet).tension_field(task.strain, observer).row}
