"""Fig. 6a: largest amplitude over strain against L/W, and the curves that it is taken from."""

from matplotlib.figure import Figure

from wrinklestudy.study.figures import against_sheet
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs) -> Figure:
    """Draw max A/t against L/W, and A/t against strain for each L/W."""
    return against_sheet.draw(inputs, 0, lambda aspect: aspect, "L/W")
