"""Fig. 5 as the paper prints it: amplitude above wavelength."""

from matplotlib.figure import Figure

from wrinklestudy.studies.panaitescu2019.figures import fig05_amplitude, fig05_wavelength
from wrinklestudy.study.figures import page
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs) -> Figure:
    """Draw both panels from the same sheets."""
    return page.draw([(fig05_amplitude.draw, inputs), (fig05_wavelength.draw, inputs)])
