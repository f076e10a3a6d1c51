"""What the figures over strain have in common: points, holes, axis and legend."""

from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import FigureBase
from matplotlib.lines import Line2D

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.figures import measured, style
from wrinklestudy.study.figures.series import labels, note
from wrinklestudy.study.figures.style import GREY, Look, looks
from wrinklestudy.study.measurements import Points, SheetSize
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import FEWEST_CELLS

# An axis begins this fraction of its highest value below zero, to leave room for marks of holes.
BELOW = 0.09
# Labels of marks that several series may have.
COARSE = f"fewer than {FEWEST_CELLS:g} cells per wavelength"
SHARED = ("flat", "not converged", "birth, decay", COARSE)


def styled(series: list[SheetStates]) -> list[tuple[SheetStates, Look]]:
    """Return the series, each with its look: by L/W or t/W if these vary, by law otherwise."""
    sizes = {sheet.size for sheet in series}
    chosen = (
        style.ordered(len(series)) if len(sizes) > 1 else looks([sheet.law for sheet in series])
    )
    named = [replace(look, label=label) for look, label in zip(chosen, labels(series), strict=True)]
    return list(zip(series, named, strict=True))


def points(axes: Axes, sheet: SheetStates, look: Look, column: str, factor: float = 1.0) -> None:
    """Draw a column over strain: wrinkled states filled, flat ones open, holes on the axis."""
    strain, value = sheet.column("strain"), factor * sheet.column(column)
    wrinkled, flat = sheet.of_status("wrinkled"), sheet.of_status("flat")
    for which, face, label in ((wrinkled, look.color, look.label), (flat, "white", "flat")):
        shown = which & np.isfinite(value)
        if shown.any():
            axes.plot(
                strain[shown],
                value[shown],
                look.marker,
                color=look.color,
                mfc=face,
                mew=0.6,
                label=label,
            )
    coarse(axes, sheet, strain, value)
    holes(axes, sheet, look.color)


def coarse(axes: Axes, sheet: SheetStates, x: Array, y: Array) -> None:
    """Cross the points of those states through whose mesh is too coarse for their wrinkles."""
    few = sheet.of_status("wrinkled") & (sheet.column("cells_per_wavelength") < FEWEST_CELLS)
    few &= np.isfinite(x + y)
    if few.any():
        axes.plot(x[few], y[few], "+", color=GREY, ms=7.0, mew=0.6, label=COARSE)


def holes(axes: Axes, sheet: SheetStates, color: str) -> None:
    """Draw a cross just above the strain axis for every state that did not converge."""
    strain = sheet.column("strain")[sheet.of_status("not-converged")]
    if len(strain):
        axes.plot(
            strain,
            np.full(len(strain), 0.025),
            "x",
            color=color,
            ms=3.0,
            mew=0.7,
            transform=axes.get_xaxis_transform(),
            label="not converged",
        )


def overlay(
    axes: Axes, series: list[SheetStates], measured_points: dict[SheetSize, Points]
) -> float:
    """Draw what was measured on the sheets of the figure; return the largest value, 0 if none."""
    own = [
        measured_points[size]
        for size in sorted({sheet.size for sheet in series})
        if size in measured_points
    ]
    return max((measured.band(axes, sheet) for sheet in own), default=0.0)


def finish(figure: FigureBase, axes: Axes, series: list[SheetStates]) -> float:
    """Set the strain axis and the legend above it; return the largest strain, measured or not."""
    end = max(largest_strain(series), float(axes.dataLim.x1))
    axes.set_xlabel(r"strain $\varepsilon$")
    axes.set_xlim(0.0, 1.02 * end)
    legend(figure, axes, series)
    return end


def legend(figure: FigureBase, axes: Axes, series: list[SheetStates], columns: int = 2) -> None:
    """Put a legend above the axes that names what the series have in common."""
    names = labels(series)
    style.grow(figure, style.legend_above(axes, names, note(series), columns=columns))
    if len(series) > 1:  # marks that several series share have no colour
        (shown,) = figure.legends
        for handle, text in zip(shown.legend_handles, shown.get_texts(), strict=True):
            if isinstance(handle, Line2D) and text.get_text() in SHARED:
                handle.set_color(GREY)


def largest_strain(series: list[SheetStates]) -> float:
    """Return the largest strain of all series, birth and decay included."""
    strains = [[*sheet.column("strain"), sheet.birth, sheet.decay] for sheet in series]
    return float(np.nanmax(np.concatenate(strains)))


def extremes(series: list[SheetStates], column: str) -> tuple[float, float]:
    """Return smallest and largest finite value of a column; 0 and 1 if there is none."""
    values = np.concatenate([sheet.column(column) for sheet in series])
    values = values[np.isfinite(values)]
    return (float(values.min()), float(values.max())) if len(values) else (0.0, 1.0)
