"""Fig. 1: nominal stress against strain, one panel per measured material.

The paper's panel shows T/Y of latex with the fitted Mooney-Rivlin curve, Saint Venant-Kirchhoff
and an incompressible Hookean sheet. It states Y = 1 MPa, while the initial slope of its own
constants is 6 (C10 + C01) = 1.32 MPa: the stated modulus is used, and the panel gives both.
Every other material (Treloar's rubber) has its own panel in MPa, with all fits made to it.
The user's own measured stress is drawn in the first panel.
"""

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.material.choice import Choice, choose
from wrinklestudy.material.data import Measurement, read
from wrinklestudy.material.homogeneous import MODES, nominal_stress
from wrinklestudy.material.preload import REMOVE, shifted
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import law_of
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.figures import measured, style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.measurements import Points

# File name of the curve that the paper's figure shows.
PAPER_SOURCE = "latex_panaitescu2019.csv"

_PASCAL_PER_MPA = 1.0e6
_MODE_MARKERS = dict(zip(MODES, ("o", "s", "^"), strict=True))
_MODE_NAMES = dict(zip(MODES, ("uniaxial", "equibiaxial", "pure shear"), strict=True))
_FIT_LOOKS = ((style.BLUE, "-"), (style.VERMILLION, "--"), (style.GREEN, "-."), (style.PURPLE, ":"))
# A fit is drawn this far beyond its window, to show where it leaves the data.
_BEYOND = 1.35


def draw(inputs: Inputs) -> Figure:
    """Draw T/Y of the paper's material and T of the others against strain."""
    fits = inputs.fits()
    files = {path.name: path for path in inputs.data}
    curves = sorted({_curve(fit) for fit in fits}, key=lambda one: (one[0] != PAPER_SOURCE, one))
    if not curves:
        raise ValueError("materials: none given, this figure shows material fits")
    figure = style.new(style.WIDE if len(curves) > 1 else style.COLUMN, 5.2)
    panels = figure.subplots(1, len(curves), squeeze=False)[0]
    legends = []
    for k, (axes, curve) in enumerate(zip(panels, curves, strict=True)):
        own = [fit for fit in fits if _curve(fit) == curve]
        data = _data(files, own[0])
        if curve[0] == PAPER_SOURCE:
            _paper_panel(axes, own, data)
        else:
            _panel_in_mpa(axes, own, data)
        if k == 0:
            _measured_by_user(axes, inputs.measured_stress(), curve[0] == PAPER_SOURCE)
        legends.append(style.legend_above(axes, whole_width=False))
        if len(curves) > 1:
            letter = "abcdefgh"[k]
            axes.text(0.03, 0.97, f"({letter})", transform=axes.transAxes, va="top")
    style.grow(figure, max(legends))
    return figure


def _curve(fit: Fit) -> tuple[str, str, int, str]:
    """Return what tells the measured curves of fits apart: file, branch, cycle, preload."""
    return fit.source, fit.branch, fit.cycle, fit.preload


def _data(files: dict[str, Path], fit: Fit) -> Measurement | None:
    """Return the points of the branch that a fit is to, without the preload that it is without."""
    if fit.source not in files:
        return None
    data = read(files[fit.source])
    points = choose(data, Choice(branch=fit.branch, cycle=fit.cycle)).points
    return shifted(points, fit.offsets) if fit.preload == REMOVE else points


def _measured_by_user(axes: Axes, points: Points | None, over_young: bool) -> None:
    if points is None:
        return
    unit = theory.STATED_YOUNG_MODULUS if over_young else _PASCAL_PER_MPA
    measured.bars(axes, points.strain, points.value / unit, points.error / unit)
    axes.set_xlim(right=max(axes.get_xlim()[1], 1.02 * float(points.strain.max())))
    highest = float(np.nanmax([points.value, points.value + points.error])) / unit
    axes.set_ylim(top=max(axes.get_ylim()[1], 1.05 * highest))


def _paper_panel(axes: Axes, fits: list[Fit], data: Measurement | None) -> None:
    young = theory.STATED_YOUNG_MODULUS
    end = max(fit.stretch_range[1] for fit in fits) - 1.0
    strain = np.linspace(0.0, end, 200)
    if data is not None:
        shown = slice(None, None, max(1, len(data.stretch) // 17))
        axes.plot(
            data.stretch[shown] - 1.0,
            data.stress[shown] / young,
            "o",
            color=style.BLACK,
            mfc="none",
            mew=0.6,
            label="latex, rebuilt from the published constants",
        )
    for fit, look in zip(fits, style.looks([fit.law for fit in fits]), strict=True):
        stress = nominal_stress(fit.material(), 1.0 + strain, "uniaxial")
        name = _short_label(fit, end)
        axes.plot(strain, stress / young, look.line, color=look.color, label=name)
    for stress, line, color, name in (
        (theory.uniaxial_svk(strain), (0, (5, 1, 1, 1, 1, 1)), style.GREY, "SVK"),
        (theory.uniaxial_hookean(strain), ":", style.ORANGE, "Hookean, incompressible"),
    ):
        axes.plot(strain, stress, linestyle=line, color=color, label=f"{name}, $Y$ as stated")
    axes.set_xlabel(r"strain $\varepsilon$")
    axes.set_ylabel("$T/Y$")
    axes.set_xlim(0.0, end)
    axes.set_ylim(bottom=0.0)
    place: dict[str, Any] = {"transform": axes.transAxes, "ha": "left", "va": "top"}
    axes.text(0.03, 0.87, _moduli(fits), fontsize=7, **place)


def _short_label(fit: Fit, end: float) -> str:
    """Return the law of a fit, and the range of the fit if that is not the whole curve."""
    window = fit.stretch_range[1] - 1.0
    if law_of(fit.law).small_strain:
        return f"{style.law_label(fit.law)}, initial slope"
    within = f" for $\\varepsilon \\leq {window:.3g}$" if window < end else ""
    return f"{style.law_label(fit.law)}, fit{within}"


def _moduli(fits: list[Fit]) -> str:
    """Return the modulus that the panel divides by, beside the initial slopes of the fits."""
    lines = [f"$Y = {theory.STATED_YOUNG_MODULUS / _PASCAL_PER_MPA:g}$ MPa as stated"]
    for fit in fits:
        if fit.law == "mooney-rivlin":
            slope = theory.initial_slope(fit.constants["c10"], fit.constants["c01"])
            lines.append(f"$6(C_{{10}} + C_{{01}}) = {slope / _PASCAL_PER_MPA:.2f}$ MPa")
    return "\n".join(lines)


def _panel_in_mpa(axes: Axes, fits: list[Fit], data: Measurement | None) -> None:
    largest = max(1.0 + _BEYOND * (fit.stretch_range[1] - 1.0) for fit in fits)
    if data is not None:
        largest = min(largest, float(data.stretch.max()))
    modes = [mode for mode in MODES if data is None or mode in data.mode]
    top = _measured_points(axes, data, modes, largest) if data is not None else np.inf
    stretch = np.linspace(1.0, largest, 200)
    for k, fit in enumerate(fits):
        color, line = _FIT_LOOKS[k % len(_FIT_LOOKS)]
        for mode in modes:
            stress = nominal_stress(fit.material(), stretch, mode) / _PASCAL_PER_MPA
            label = _fit_label(fit) if mode == modes[0] else None
            axes.plot(stretch - 1.0, stress, line, color=color, label=label)
    axes.set_xlabel(r"strain $\varepsilon$")
    axes.set_ylabel("$T$ (MPa)")
    axes.set_xlim(0.0, largest - 1.0)
    axes.set_ylim(0.0, None if data is None else 1.25 * top)


def _measured_points(axes: Axes, data: Measurement, modes: list[str], largest: float) -> float:
    """Draw the points up to a stretch and return the largest stress among them in MPa."""
    top = 0.0
    for mode in modes:
        keep = (data.mode == mode) & (data.stretch <= largest)
        stress = data.stress[keep] / _PASCAL_PER_MPA
        top = max(top, float(stress.max(initial=0.0)))
        axes.plot(
            data.stretch[keep] - 1.0,
            stress,
            _MODE_MARKERS[mode],
            color=style.BLACK,
            mfc="white",
            mew=0.6,
            zorder=3,
            clip_on=False,
            label=f"{data.source.split('.')[0]}, {_MODE_NAMES[mode]}",
        )
    return top


def _fit_label(fit: Fit) -> str:
    """Return law, data and constants of a fit in two lines."""
    which = "all modes" if len(fit.modes) == len(MODES) else f"{', '.join(fit.modes)} only"
    law, window = style.short_law_label(fit.law), fit.stretch_range[1] - 1.0
    return f"{law}, {which}, $\\varepsilon \\leq {window:.3g}$:\n{_constants(fit)}"


def _constants(fit: Fit) -> str:
    """Return the constants of a fit: those in MPa, then the pure numbers."""
    symbols = {constant.name: constant.symbol for constant in law_of(fit.law).constants}
    texts: dict[str, list[str]] = {"Pa": [], "": []}
    for name, unit in fit.units.items():
        value = fit.constants[name] / (_PASCAL_PER_MPA if unit == "Pa" else 1.0)
        number = f"{value:.3f}" if unit == "Pa" else f"{value:.3g}"
        texts[unit].append(f"${symbols[name]} = {number}$")
    return ", ".join([f"{', '.join(texts['Pa'])} MPa", *texts[""]])
