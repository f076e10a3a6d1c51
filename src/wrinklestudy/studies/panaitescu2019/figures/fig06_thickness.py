"""Fig. 6b: largest amplitude over strain against W/t, and the curves from which it is taken."""

from matplotlib.figure import FigureBase, SubFigure

from wrinklestudy.study.figures import against_sheet
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs, on: SubFigure | None = None) -> FigureBase:
    """Draw max A/t against W/t, and A/t against strain for each t/W."""
    return against_sheet.draw(inputs, 1, lambda thickness: 1.0 / thickness, "W/t", on)
