"""Fig. 6a: largest amplitude over strain against L/W, and the curves from which it is taken."""

from matplotlib.figure import FigureBase, SubFigure

from wrinklestudy.study.figures import against_sheet
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs, on: SubFigure | None = None) -> FigureBase:
    """Draw max A/t against L/W, and A/t against strain for each L/W."""
    return against_sheet.draw(inputs, 0, lambda aspect: aspect, "L/W", on)
