"""A picture of measured stresses, fitted laws and how well these are known."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from wrinklestudy.material.choice import Choice, choose
from wrinklestudy.material.data import Measurement
from wrinklestudy.material.preload import REMOVE, shifted
from wrinklestudy.material.result import Fit
from wrinklestudy.material.uncertainty import CONFIDENCE, stress_band
from wrinklestudy.study.figures import style

_WIDTH, _HEIGHT = 10.0, 7.0  # cm
_POINTS = 200
_MARKERS = {"uniaxial": "o", "biaxial": "s", "shear": "^"}
_KILO, _MEGA = 1e3, 1e6


def draw(path: Path, data: Measurement, fits: Sequence[Fit]) -> None:
    """Draw the points of a file, the curves of laws and their 95 % bands, in each mode.

    Parameters
    ----------
    path : Path
        Picture to write; the suffix says of which kind.
    data : Measurement
        All points of the file.
    fits : sequence of Fit
        Of that file, with the same choice of points.
    """
    with style.applied():
        figure, axes = style.panel(_WIDTH, _HEIGHT)
        first = fits[0]
        if first.preload == REMOVE:
            data = shifted(data, first.offsets)
        mega = float(np.abs(data.stress).max()) >= 0.5 * _MEGA
        unit = _MEGA if mega else _KILO
        _points(axes, data, first, unit)
        for fit, look in zip(fits, style.looks([fit.law for fit in fits]), strict=True):
            _curves(axes, fit, data, look, unit)
        axes.axhline(0.0, color=style.GREY, lw=0.4, zorder=0)
        axes.set_xlabel(r"strain $\varepsilon$")
        axes.set_ylabel(f"$T$ ({'MPa' if mega else 'kPa'})")
        style.grow(figure, style.legend_above(axes))
        style.save(figure, path)


def _points(axes: Axes, data: Measurement, fit: Fit, unit: float) -> None:
    """Draw the points that are fitted in black, the others in grey."""
    rows = choose(data, Choice(fit.stretch_range, fit.modes, fit.branch, fit.cycle)).rows
    used = np.zeros(data.stretch.shape, dtype=np.bool_)
    used[rows] = True
    for mode in data.modes:
        for group, color, label in (
            (used, style.BLACK, mode),
            (~used, style.GREY, "not fitted"),
        ):
            own = data.kept(group & (data.mode == mode))
            if own.stretch.size:
                error = None if own.standard_error is None else own.standard_error / unit
                axes.errorbar(
                    own.stretch - 1.0,
                    own.stress / unit,
                    yerr=error,
                    fmt=_MARKERS[mode],
                    color=color,
                    mfc="none",
                    mew=0.6,
                    elinewidth=0.5,
                    label=label,
                )


def _curves(axes: Axes, fit: Fit, data: Measurement, look: style.Look, unit: float) -> None:
    """Draw the stress of a law with its band in the modes that it is fitted to, where data is."""
    for mode in fit.modes:
        own = data.select(fit.stretch_range, [mode]).stretch
        stretch = np.linspace(min(own.min(), 1.0), max(own.max(), 1.0), _POINTS)
        stress, half = stress_band(fit, stretch, mode)
        strain, low, high = stretch - 1.0, (stress - half) / unit, (stress + half) / unit
        label = f"{style.short_law_label(fit.law)}, {CONFIDENCE:.0%} band"
        axes.fill_between(strain, low, high, color=look.color, alpha=0.25, lw=0.0, label=label)
        label = style.law_label(fit.law)
        axes.plot(strain, stress / unit, look.line, color=look.color, label=label)
