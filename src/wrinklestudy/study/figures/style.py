"""One look for all figures: sizes, fonts, colours, markers, and how files are written."""

from collections.abc import Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure, FigureBase, SubFigure

from wrinklestudy.files import origin
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.mechanics.laws import LAWS

# Widths in cm of the paper's figures: one column and two.
COLUMN = 6.5
WIDE = 13.0
_CM = 1.0 / 2.54
LETTER = 9.0  # font size of the letters of panels
_LINE = 0.36  # height in cm of a line of a legend

# Okabe and Ito's colours, told apart with any colour vision.
BLACK, GREY = "#000000", "#7f7f7f"
ORANGE, SKY, GREEN = "#E69F00", "#56B4E9", "#009E73"
BLUE, VERMILLION, PURPLE = "#0072B2", "#D55E00", "#CC79A7"

_RC: dict[Any, Any] = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 8.0,
    "axes.labelsize": 8.5,
    "axes.linewidth": 0.6,
    "axes.unicode_minus": True,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.top": True,
    "ytick.right": True,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.minor.visible": True,
    "ytick.minor.visible": True,
    "lines.linewidth": 1.0,
    "lines.markersize": 3.2,
    "legend.frameon": False,
    "legend.fontsize": 7.0,
    "legend.handlelength": 1.8,
    "savefig.dpi": 300,
    "pdf.fonttype": 42,
    "svg.hashsalt": "wrinklestudy",
    "svg.fonttype": "path",
}

# The backend stays as it is: a figure is saved without one, and to set it may load a window system.
_KEPT = {"backend", "backend_fallback"}

_METADATA: dict[str, dict[str, str | None]] = {
    ".pdf": {"CreationDate": None},
    ".png": {"Software": None},
    ".svg": {"Date": None},
}


@dataclass(frozen=True)
class Look:
    """How one series is drawn, and its name in the legend."""

    color: str
    marker: str
    line: str
    label: str = ""


_CYCLE = (
    Look(BLUE, "o", "-"),
    Look(VERMILLION, "s", "--"),
    Look(GREEN, "^", "-."),
    Look(PURPLE, "D", ":"),
    Look(ORANGE, "v", "-"),
    Look(SKY, "P", "--"),
    Look(BLACK, "X", "-."),
)
# Markers and lines of an ordered series; its colours run from dark to light.
_MARKERS, _LINES = "osD^vPX", ("-", "--", "-.")
_DARK, _LIGHT = 0.0, 0.88


def law_label(law: str) -> str:
    """Return the name of a law for a figure; one that is not registered keeps its own."""
    return LAWS[law].label if law in LAWS else law


def short_law_label(law: str) -> str:
    """Return the short name of a law for a figure; one that is not registered keeps its own."""
    return LAWS[law].short_label if law in LAWS else law


def looks(laws: list[str]) -> list[Look]:
    """Return one look per series: by law if each law occurs once, otherwise in turn."""
    places = list(range(len(laws)))
    if len(set(laws)) == len(laws) and set(laws) <= set(LAWS):
        places = [list(LAWS).index(law) for law in laws]
    return [_CYCLE[k % len(_CYCLE)] for k in places]


def ordered(count: int) -> list[Look]:
    """Return the looks of sheets that differ by a growing number: colours from dark to light."""
    shades = mpl.colormaps["viridis"]
    steps = [_DARK + (_LIGHT - _DARK) * k / max(count - 1, 1) for k in range(count)]
    return [
        Look(to_hex(shades(step)), _MARKERS[k % len(_MARKERS)], _LINES[k % len(_LINES)])
        for k, step in enumerate(steps)
    ]


def applied() -> AbstractContextManager[None]:
    """Return a context in which figures are made and saved in the shared style.

    Everything that the style leaves open is as matplotlib has it by default: a `matplotlibrc` of
    the user, or one in the working folder, changes nothing.
    """
    defaults = {key: value for key, value in mpl.rcParamsDefault.items() if key not in _KEPT}
    return mpl.rc_context(defaults | _RC)


def new(width: float, height: float) -> Figure:
    """Return an empty figure of a size in cm."""
    return Figure(figsize=(width * _CM, height * _CM), layout="constrained")


def place(on: SubFigure | None, width: float, height: float) -> FigureBase:
    """Return the part of a page to draw on, or without one an empty figure of a size in cm."""
    return on or new(width, height)


def panel(width: float = COLUMN, height: float = 4.8) -> tuple[Figure, Axes]:
    """Return a figure of a size in cm with one pair of axes."""
    figure = new(width, height)
    return figure, figure.add_subplot()


def panel_on(on: SubFigure | None, height: float = 4.8) -> tuple[FigureBase, Axes]:
    """Return one pair of axes on a part of a page, or without one on a figure of one column."""
    figure = place(on, COLUMN, height)
    return figure, figure.add_subplot()


def legend_above(
    axes: Axes,
    first: Sequence[str] = (),
    title: str = "",
    whole_width: bool = True,
    columns: int = 2,
) -> float:
    """Put the legend of some axes above them, where it covers nothing, every label once.

    Parameters
    ----------
    axes : Axes
        With labelled artists.
    first : sequence of str
        Labels that come first.
    title : str
        Line above the entries.
    whole_width : bool
        Over the width of the figure, otherwise in one column over the axes.
    columns : int
        Columns over the width of the figure.

    Returns
    -------
    float
        Height in cm that the figure needs for it; see `grow`.
    """
    entries: dict[str, Any] = {}
    for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
        entries.setdefault(label, handle)
    order = sorted(entries, key=lambda label: label not in first)
    options: dict[str, Any] = {"title": title or None, "alignment": "left", "labelspacing": 0.3}
    handles = [entries[label] for label in order]
    if whole_width:
        options |= {"ncols": columns, "columnspacing": 1.0}
        axes.figure.legend(handles, order, loc="outside upper left", **options)
        lines = -(-len(order) // columns)
    else:
        options |= {"bbox_to_anchor": (-0.02, 1.0), "borderaxespad": 0.2}
        axes.legend(handles, order, loc="lower left", **options)
        lines = sum(label.count("\n") + 1 for label in order)
    return _LINE * (lines + bool(title)) + 0.1


def grow(figure: FigureBase, height: float) -> None:
    """Make a figure taller by a height in cm; a part of a page is as tall as the page gives it."""
    if isinstance(figure, Figure):
        figure.set_figheight(float(figure.get_figheight()) + height * _CM)


def save(figure: Figure, path: str | PathLike[str]) -> None:
    """Write the figure whole or not at all, with its origin and without a date in it."""
    suffix = Path(path).suffix
    with atomic_path(path) as temporary:
        figure.savefig(temporary, metadata=_METADATA[suffix] | origin.metadata(suffix))
