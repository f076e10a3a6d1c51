"""Fig. 6 as the paper prints it: the sheets of all lengths above those of all thicknesses."""

from matplotlib.figure import Figure

from wrinklestudy.studies.panaitescu2019.figures import fig06_aspect, fig06_thickness
from wrinklestudy.study.figures import page
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs) -> Figure:
    """Draw both panels, each from the sheets that differ from the first in L/W or in t/W alone."""
    own = inputs.series[0]
    lengths = inputs.only(lambda sheet: sheet.thickness == own.thickness)
    thicknesses = inputs.only(lambda sheet: sheet.aspect == own.aspect)
    return page.draw([(fig06_aspect.draw, lengths), (fig06_thickness.draw, thicknesses)])
