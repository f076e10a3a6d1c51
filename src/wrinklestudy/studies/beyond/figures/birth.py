"""The strain of birth against thickness, and how it departs from a square law."""

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from wrinklestudy.studies.beyond.thresholds import LINEAR, by_mesh
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs) -> Figure:
    """Draw the birth strain against t/W, and divided by (t/W)^2."""
    figure = style.new(style.WIDE, 5.2)
    left, right = figure.subplots(1, 2)
    thresholds = by_mesh(inputs.series)
    first = thresholds[0]
    law = first.law(LINEAR)
    fine = np.geomspace(1e-6, first.thickness[-1], 100)
    exponent = law.exponents["thickness"].value
    left.loglog(fine, law.at(thickness=fine), "-", color=style.GREY, lw=0.8)
    left.annotate(
        rf"$(t/W)^{{{exponent:.3f}}}$",
        (fine[35], float(law.at(thickness=fine[35]))),
        xytext=(6, -10),
        textcoords="offset points",
    )
    right.axhline(1.0, color=style.GREY, lw=0.8)
    for number, (threshold, look) in enumerate(
        zip(thresholds, style.ordered(len(thresholds)), strict=True)
    ):
        label = "mesh of the study" if number == 0 else f"{number}. finer mesh"
        face = look.color if number == 0 else "none"
        points: dict[str, Any] = {
            "color": look.color,
            "mfc": face,
            "ms": 3.2 + 1.6 * number,
            "label": label,
        }
        left.loglog(threshold.thickness, threshold.strain, look.marker, **points)
        reduced = threshold.strain / law.at(thickness=threshold.thickness)
        right.semilogx(threshold.thickness, reduced, look.marker, **points)
    right.xaxis.set_minor_formatter(NullFormatter())
    left.set_xlabel("$t/W$")
    left.set_ylabel(r"birth strain $\varepsilon_c$")
    right.set_xlabel("$t/W$")
    right.set_ylabel(r"$\varepsilon_c$ / power law")
    style.grow(figure, style.legend_above(left, columns=3))
    return figure
