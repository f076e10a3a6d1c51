"""Fig. 7c: amplitude against Phi lambda, the slaving condition A = C lambda Phi.

The constant C depends on the width over which Phi^2 is averaged, which the paper leaves open: both
the full width and the central wrinkle alone are drawn, with the lines C = 1 (the paper's best fit)
and C = 1/pi (a sinusoid).
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from wrinklestudy import theory
from wrinklestudy.figures import style
from wrinklestudy.figures.against_strain import legend, styled
from wrinklestudy.figures.inputs import Inputs, Series

Array = NDArray[np.float64]

_AVERAGES = ("phi_squared", "phi_squared_central")


def draw(inputs: Inputs) -> Figure:
    """Draw A/t against Phi lambda/t of the wrinkled states, arrows toward larger strain."""
    series = inputs.sheet_series()
    figure, axes = style.panel(height=5.4)
    farthest, highest = 0.0, 0.0
    for one, look in styled(series):
        amplitude = np.where(one.wrinkled, one.column("amplitude_over_thickness"), np.nan)
        for average in _AVERAGES:
            slaved = _slaved(one, average)
            full = average == "phi_squared"
            axes.plot(slaved, amplitude, look.line, color=look.color, lw=0.5)
            axes.plot(
                slaved,
                amplitude,
                look.marker,
                color=look.color,
                mfc=look.color if full else "white",
                mew=0.6,
                label=one.label if full else None,
            )
            _arrows(axes, slaved, amplitude, look.color)
            farthest = float(np.nanmax([farthest, *slaved]))
            highest = float(np.nanmax([highest, *amplitude]))
    farthest, highest = 1.08 * (farthest or 1.0), 1.12 * (highest or 1.0)
    _line(axes, 1.0, "$C = 1$", "-", min(farthest, highest))
    slope = theory.SINUSOID_CONSTANT
    _line(axes, slope, r"$C = 1/\pi$", "--", min(farthest, highest / slope))
    for face, name in (("black", "full width"), ("white", "central wrinkle")):
        axes.plot([], [], "o", color=style.BLACK, mfc=face, mew=0.6, label=rf"$\Phi$: {name}")
    axes.set_xlim(0.0, farthest)
    axes.set_ylim(0.0, highest)
    axes.set_xlabel(r"$\Phi\lambda/t$")
    axes.set_ylabel("$A/t$")
    legend(figure, axes, series)
    return figure


def _slaved(one: Series, average: str) -> Array:
    """Return Phi lambda/t of the wrinkled states, NaN elsewhere."""
    confinement = np.sqrt(one.column(average))
    product = confinement * one.column("wavelength_over_width") / one.thickness
    return np.where(one.wrinkled, product, np.nan)


def _line(axes: Axes, constant: float, label: str, line: str, end: float) -> None:
    axes.plot([0.0, end], [0.0, constant * end], line, color=style.BLACK, lw=0.7, label=label)


def _arrows(axes: Axes, x: Array, y: Array, color: str) -> None:
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
