"""Fig. 7a: actual width W_act, the arc length across the centre, against strain."""

import numpy as np
from matplotlib.figure import FigureBase, SubFigure

from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.against_strain import finish, largest_strain, points, styled
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs, on: SubFigure | None = None) -> FigureBase:
    """Draw W_act/W with 1 - nu eps and, for finite strain, (1 + eps)^(-1/2)."""
    series = inputs.series
    figure, axes = style.panel_on(on)
    strain = np.linspace(0.0, largest_strain(series), 200)
    linear = theory.actual_width(strain)
    name = r"$1 - \nu\varepsilon$, $\nu = 1/2$"
    axes.plot(strain, linear, "--", color=style.BLACK, lw=0.8, label=name)
    name = r"$(1 + \varepsilon)^{-1/2}$"
    axes.plot(strain, theory.uniaxial_width(strain), ":", color=style.GREY, label=name)
    for sheet, look in styled(series):
        points(axes, sheet, look, "arc_width_over_width")
    axes.set_ylabel(r"$W_{\mathrm{act}}/W$")
    axes.set_ylim(top=1.005)
    finish(figure, axes, series)
    return figure
