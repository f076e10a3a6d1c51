"""What the figures over strain have in common: points, holes, axis and legend."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.figures import style
from wrinklestudy.figures.inputs import Series, sheet_note
from wrinklestudy.figures.style import GREY, Look, looks


def styled(series: list[Series]) -> list[tuple[Series, Look]]:
    """Return the series, each with its look."""
    return list(zip(series, looks([one.law for one in series]), strict=True))


def points(axes: Axes, one: Series, look: Look, column: str, factor: float = 1.0) -> None:
    """Draw a column over strain: wrinkled states filled, flat ones open, holes on the axis."""
    strain, value = one.column("strain"), factor * one.column(column)
    faces = ((one.wrinkled, look.color, one.label), (one.flat, "white", "flat"))
    for which, face, label in faces:
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
    if one.holes.any():
        axes.plot(
            strain[one.holes],
            np.full(int(one.holes.sum()), 0.025),
            "x",
            color=GREY,
            ms=3.0,
            mew=0.7,
            transform=axes.get_xaxis_transform(),
            label="not converged",
        )


def finish(figure: Figure, axes: Axes, series: list[Series]) -> float:
    """Set the strain axis and the legend above it; return the largest strain."""
    end = largest_strain(series)
    axes.set_xlabel(r"strain $\varepsilon$")
    axes.set_xlim(0.0, 1.02 * end)
    legend(figure, axes, series)
    return end


def legend(figure: Figure, axes: Axes, series: list[Series]) -> None:
    """Put a legend above the axes, which names the sheet if there is but one."""
    sheets = sorted({(one.aspect, one.thickness) for one in series})
    title = sheet_note(*sheets[0]) if len(sheets) == 1 else ""
    style.grow(figure, style.legend_above(axes, [one.label for one in series], title))


def largest_strain(series: list[Series]) -> float:
    """Return the largest strain of all series, birth and decay included."""
    strains = [[*one.column("strain"), one.birth, one.decay] for one in series]
    return float(np.nanmax(np.concatenate(strains)))


def extremes(series: list[Series], column: str) -> tuple[float, float]:
    """Return smallest and largest finite value of a column; 0 and 1 if there is none."""
    values = np.concatenate([one.column(column) for one in series])
    values = values[np.isfinite(values)]
    return (float(values.min()), float(values.max())) if len(values) else (0.0, 1.0)
