"""Wavelength against the scaled Cerda-Mahadevan equation, and length of the wrinkles, over L/W."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from wrinklestudy.studies.beyond.lengths import LONG, Lengths, lengths
from wrinklestudy.studies.beyond.power_law import line, power_law
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.series import number
from wrinklestudy.study.figures.style import GREY


def draw(inputs: Inputs) -> Figure:
    """Draw lambda over the equation, and l/W with its power law, against L/W."""
    figure = style.new(style.WIDE, 5.6)
    left, right = figure.subplots(1, 2)
    found = lengths(inputs.series)
    left.axhspan(0.9, 1.1, color=GREY, alpha=0.25, lw=0.0)
    left.axhline(1.0, color=GREY, lw=0.8)
    thicknesses = np.unique(found.thickness)
    for thickness, look in zip(thicknesses, style.ordered(len(thicknesses)), strict=True):
        _thickness(left, right, found.where(found.thickness == thickness), look, thickness)
    _law(right, found.where(found.joined))
    for axes in (left, right):
        axes.set_xscale("log")
        ticks = np.unique(found.aspect)
        axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.set_xlabel("$L/W$")
    left.set_ylabel(r"$\lambda\;/\;0.8\,\lambda_{\mathrm{CM}}$")
    right.set_yscale("log")
    right.yaxis.set_minor_formatter(NullFormatter())
    low, high = float(found.material_envelope.min()), float(found.material_envelope.max())
    ticks = np.array(
        [tick for tick in (0.5, 0.7, 1, 1.5, 2, 3, 4, 6) if low / 1.3 < tick < 1.3 * high]
    )
    right.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    right.set_ylabel(r"$\ell/W$")
    style.grow(figure, style.legend_above(left, columns=4))
    return figure


def _thickness(left: Axes, right: Axes, found: Lengths, look: style.Look, thickness: float) -> None:
    """Draw the states of one thickness: the larger the marker, the larger the strain."""
    sizes = 6.0 + 130.0 * found.strain
    options: dict[str, Any] = {"color": look.color, "marker": look.marker, "alpha": 0.8}
    label = f"$t/W = {number(thickness)}$"
    left.scatter(
        found.aspect, found.against_theory, s=sizes, label=label, linewidths=0.0, **options
    )
    for chosen, line_width, face in ((found.joined, 0.0, look.color), (~found.joined, 0.8, "none")):
        right.scatter(
            found.aspect[chosen],
            found.material_envelope[chosen],
            s=sizes[chosen],
            linewidths=line_width,
            **options | {"facecolor": face},
        )


def _law(axes: Axes, found: Lengths) -> None:
    """Draw the power law of l in L/W alone, and the slope of a fixed fraction of L."""
    if np.ptp(found.aspect) == 0.0 or len(found.aspect) < 3:
        return
    law = power_law(found.material_envelope, aspect=found.aspect)
    fine = np.geomspace(found.aspect.min(), found.aspect.max(), 50)
    alpha = law.exponents["aspect"]
    axes.plot(fine, law.at(aspect=fine), "-", color=GREY, lw=0.8)
    long = found.where(found.aspect >= LONG)
    if len(np.unique(long.aspect)) > 2:
        straight = line(long.material_envelope, long.aspect)
        whole = np.linspace(LONG, found.aspect.max(), 100)
        text = rf"$\ell = {straight.slope.value:.2f} L {straight.offset.value:+.2f} W$"
        axes.plot(whole, straight.at(whole), "--", color=style.VERMILLION, lw=0.8, label=text)
        axes.legend(loc="lower right")
    axes.annotate(
        rf"$\ell \sim L^{{{alpha.value:.2f} \pm {alpha.error:.2f}}}$",
        (fine[10], float(law.at(aspect=fine[10]))),
        xytext=(-34, 30),
        textcoords="offset points",
    )
