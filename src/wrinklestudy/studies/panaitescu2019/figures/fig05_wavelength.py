"""Fig. 5b: wavelength over width against strain, with 0.8 times Cerda and Mahadevan's.

lambda_CM = sqrt(2 pi L t) / [3 (1 - nu^2) eps]^(1/4) with nu = 1/2.
"""

import numpy as np
from matplotlib.figure import FigureBase, SubFigure

from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.against_strain import (
    extremes,
    finish,
    largest_strain,
    overlay,
    points,
    styled,
)
from wrinklestudy.study.figures.inputs import Inputs

_COLUMN = "wavelength_over_width"


def draw(inputs: Inputs, on: SubFigure | None = None) -> FigureBase:
    """Draw lambda/W of the wrinkled states against strain and the closed form beside it."""
    series = inputs.series
    figure, axes = style.panel_on(on)
    for sheet, look in styled(series):
        axes.plot(
            sheet.column("strain"), sheet.column(_COLUMN), look.line, color=look.color, lw=0.8
        )
        points(axes, sheet, look, _COLUMN)
    measured = overlay(axes, series, inputs.measured_wavelength())
    strain = largest_strain(series) * np.linspace(0.02, 1.0, 300)
    for aspect, thickness in sorted({sheet.size for sheet in series}):
        closed = theory.cm_wavelength(strain, aspect, thickness, factor=theory.WAVELENGTH_FACTOR)
        axes.plot(strain, closed, ":", color=style.BLACK, label=_closed_form_label())
    axes.set_ylabel(r"$\lambda/W$")
    shortest, longest = extremes(series, _COLUMN)
    axes.set_ylim(0.65 * shortest, 1.25 * max(longest, measured))
    finish(figure, axes, series)
    return figure


def _closed_form_label() -> str:
    return rf"${theory.WAVELENGTH_FACTOR:g}\,\lambda_{{\mathrm{{CM}}}}$, $\nu = 1/2$"
