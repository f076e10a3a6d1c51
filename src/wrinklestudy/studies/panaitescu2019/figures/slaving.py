"""What Figs. 7c and 7d have in common: A/t against Phi lambda/t, the condition A = C lambda Phi.

The constant C depends on the width over which Phi^2 is averaged, which the paper leaves open: both
the full width (filled) and the central wrinkle alone (open) are drawn, with the lines C = 1 (the
paper's best fit) and C = 1/pi (a sinusoid).
"""

import numpy as np
from matplotlib.axes import Axes

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.style import Look
from wrinklestudy.typing import Array

AVERAGES = ("phi_squared", "phi_squared_central")


def trajectory(sheet: SheetStates, average: str, above: float = 0.0) -> tuple[Array, Array]:
    """Return Phi lambda/t and A/t of the wrinkled states beyond a strain, NaN elsewhere."""
    shown = sheet.wrinkled_above(above)
    confinement = np.sqrt(sheet.column(average))
    product = confinement * sheet.column("wavelength_over_width") / sheet.thickness
    amplitude = sheet.column("amplitude_over_thickness")
    return np.where(shown, product, np.nan), np.where(shown, amplitude, np.nan)


def points(axes: Axes, x: Array, y: Array, look: Look, label: str | None) -> None:
    """Draw a trajectory: filled and in the legend with a label, open without."""
    axes.plot(x, y, look.line, color=look.color, lw=0.5)
    face = "white" if label is None else look.color
    axes.plot(x, y, look.marker, color=look.color, mfc=face, mew=0.6, label=label)


def finish(axes: Axes, farthest: float, highest: float, holes: int) -> None:
    """Draw the lines of constant C and set axes and legend entries.

    Parameters
    ----------
    axes : Axes
        With the points.
    farthest, highest : float
        Largest Phi lambda/t and A/t, 0 without points.
    holes : int
        Number of states that did not converge, which cannot be drawn in this plane.
    """
    farthest, highest = 1.08 * (farthest or 1.0), 1.12 * (highest or 1.0)
    _line(axes, 1.0, "$C = 1$", "-", min(farthest, highest))
    slope = theory.SINUSOID_CONSTANT
    _line(axes, slope, r"$C = 1/\pi$", "--", min(farthest, highest / slope))
    for face, name in (("black", "full width"), ("white", "central wrinkle")):
        axes.plot([], [], "o", color=style.BLACK, mfc=face, mew=0.6, label=rf"$\Phi$: {name}")
    if holes:
        axes.plot([], [], "x", color=style.GREY, ms=3.0, mew=0.7, label=f"{holes} not converged")
    axes.set_xlim(0.0, farthest)
    axes.set_ylim(0.0, highest)
    axes.set_xlabel(r"$\Phi\lambda/t$")
    axes.set_ylabel("$A/t$")


def _line(axes: Axes, constant: float, label: str, line: str, end: float) -> None:
    axes.plot([0.0, end], [0.0, constant * end], line, color=style.BLACK, lw=0.7, label=label)


def arrows(axes: Axes, x: Array, y: Array, color: str) -> None:
    """Draw an arrow on the way up and one on the way down, from a state to the next."""
    whole = np.flatnonzero(np.isfinite(x[:-1] + y[:-1] + x[1:] + y[1:]))
    if len(whole) < 2:
        return
    length = np.hypot(np.diff(x), np.diff(y))
    top = int(np.nanargmax(y))
    for part in (whole[whole < top], whole[whole >= top]):
        if len(part):
            k = int(part[np.argmax(length[part])])
            axes.annotate(
                "",
                xy=(x[k + 1], y[k + 1]),
                xytext=(x[k], y[k]),
                arrowprops={"arrowstyle": "-|>", "color": color, "lw": 0.8, "mutation_scale": 9},
            )
