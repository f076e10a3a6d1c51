"""Amplitude over strain of one sheet with a membrane of small strain and with finite strain."""

from matplotlib.figure import Figure

from wrinklestudy.studies.literature.membranes import SMALL_STRAIN
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.against_strain import BELOW, extremes, finish, points, styled
from wrinklestudy.study.figures.inputs import Inputs

_COLUMN = "amplitude_over_thickness"


def draw(inputs: Inputs) -> Figure:
    """Draw A/t against strain, a line for each membrane."""
    series = sorted(inputs.series, key=lambda sheet: sheet.material != SMALL_STRAIN)
    figure, axes = style.panel(1.3 * style.COLUMN, 5.6)
    for sheet, look in styled(series):
        wide = 1.6 if sheet.material == SMALL_STRAIN else 0.9
        axes.plot(*sheet.curve(_COLUMN), look.line, color=look.color, lw=wide)
        points(axes, sheet, look, _COLUMN)
    axes.set_ylabel("$A/t$")
    highest = extremes(series, _COLUMN)[1] or 1.0
    axes.set_ylim(-BELOW * highest, 1.1 * highest)
    finish(figure, axes, series)
    return figure
