"""The thickest sheet that wrinkles over strain and L/W, in units of the width."""

from matplotlib.figure import Figure

from wrinklestudy.studies.beyond import maps
from wrinklestudy.studies.beyond.figures.map_contours import draw_in
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs) -> Figure:
    """Draw contours of tau_1/W with the paper's sheets and the tips of their island."""
    return draw_in(inputs, "t/W", maps.PAPER_THICKNESS)
