"""The largest amplitude of each sheet of a row of sheets, against L/W or W/t."""

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import FigureBase, SubFigure

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.figures import measured, style
from wrinklestudy.study.figures.against_strain import BELOW, coarse, extremes, holes, legend, styled
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.style import GREY, Look
from wrinklestudy.study.measurements import Points, SheetSize

_COLUMN = "amplitude_over_thickness"


def draw(
    inputs: Inputs,
    varied: int,
    number: Callable[[float], float],
    symbol: str,
    on: SubFigure | None = None,
) -> FigureBase:
    """Draw max A/t over strain against a number of the sheet, and the curves A/t beside it.

    The maximum may lie between the states (`results.peaks`). Of measured data the highest point of
    each sheet is drawn, if the sheet agrees in what is not varied.

    Parameters
    ----------
    inputs : Inputs
        Tables of the sheets and measured data.
    varied : int
        What differs between the sheets: 0 for L/W, 1 for t/W.
    number : callable
        What the figure is drawn against, as a function of what differs.
    symbol : str
        The name of that number in mathtext.
    on : SubFigure
        Part of a page to draw on; without one the figure is made.
    """

    def place(sheet: SheetSize) -> float:
        return number(sheet[varied])

    pairs = styled(sorted(inputs.series, key=lambda sheet: place(sheet.size)))
    series = [sheet for sheet, _ in pairs]
    figure = style.place(on, style.WIDE, 5.2)
    peaks, curves = figure.subplots(1, 2)
    for sheet, look in pairs:
        _maximum(peaks, sheet, look, place(sheet.size))
        _curve(curves, sheet, look)
    shared = {sheet.size[1 - varied] for sheet in series}
    amplitudes = sorted(inputs.measured_amplitude().items())
    row = {place(size): points for size, points in amplitudes if size[1 - varied] in shared}
    maxima = [sheet.peak["max_amplitude_over_thickness"] for sheet in series]
    largest = [*maxima, extremes(series, _COLUMN)[1], _measured(peaks, row)]
    highest = float(np.nanmax(largest)) or 1.0
    for axes in (peaks, curves):
        axes.set_ylim(-BELOW * highest, 1.12 * highest)
    peaks.set_xlabel(f"${symbol}$")
    peaks.set_ylabel(r"$\max_\varepsilon A/t$")
    peaks.margins(x=0.08)
    curves.set_xlabel(r"strain $\varepsilon$")
    curves.set_xlim(0.0, 1.02 * float(curves.dataLim.x1))
    curves.set_ylabel("$A/t$")
    legend(figure, peaks, series, columns=4)
    return figure


def _maximum(axes: Axes, sheet: SheetStates, look: Look, x: float) -> None:
    """Draw the maximum of a sheet: at 0 if it never wrinkles, as a hole if it is unknown."""
    highest = sheet.peak["max_amplitude_over_thickness"]
    if sheet.never_wrinkles:
        axes.plot([x], [0.0], "v", color=GREY, mfc="white", ms=5.0, mew=0.8, label="never wrinkles")
        axes.plot([], [], look.line, color=look.color, label=look.label)
    elif np.isfinite(highest):
        axes.plot([x], [highest], look.marker, color=look.color, ms=4.5, label=look.label)
    else:
        axes.plot(
            [x],
            [0.025],
            "x",
            color=GREY,
            ms=4.0,
            transform=axes.get_xaxis_transform(),
            label="maximum not known",
        )
        axes.plot([], [], look.line, color=look.color, label=look.label)


def _curve(axes: Axes, sheet: SheetStates, look: Look) -> None:
    axes.plot(*sheet.curve(_COLUMN), look.line, color=look.color, lw=0.8)
    wrinkled = sheet.of_status("wrinkled")
    strain, amplitude = sheet.column("strain")[wrinkled], sheet.column(_COLUMN)[wrinkled]
    axes.plot(strain, amplitude, look.marker, color=look.color, ms=2.4)
    coarse(axes, sheet, sheet.column("strain"), sheet.column(_COLUMN))
    holes(axes, sheet, look.color)


def _measured(axes: Axes, by_sheet: dict[float, Points]) -> float:
    """Draw the largest measured amplitude of each sheet; return the highest end of a bar."""
    if not by_sheet:
        return 0.0
    value, error = np.array([points.highest() for points in by_sheet.values()]).T
    measured.bars(axes, np.array(list(by_sheet)), value, error)
    return float(np.nanmax([value, value + error]))
