"""Fig. 6b: largest amplitude over strain against W/t, and the curves from which it is taken."""

from matplotlib.figure import Figure

from wrinklestudy.study.figures import against_sheet
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs) -> Figure:
    """Draw max A/t against W/t, and A/t against strain for each t/W."""
    return against_sheet.draw(inputs, 1, lambda thickness: 1.0 / thickness, "W/t")
