"""The thickest sheet that wrinkles over strain and L/W, in units of the length."""

from matplotlib.figure import Figure

from wrinklestudy.studies.beyond import maps
from wrinklestudy.studies.beyond.figures.map_contours import draw_in
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs) -> Figure:
    """Draw contours of tau_1/L with the tips of the island whose boundary was published."""
    return draw_in(inputs, "t/L", maps.PUBLISHED_OVER_LENGTH)
