"""Fig. 7 as the paper prints it: width, confinement, slaving and collapse on one page."""

from matplotlib.figure import Figure

from wrinklestudy.studies.panaitescu2019.figures import (
    fig07_collapse,
    fig07_confinement,
    fig07_slaving,
    fig07_width,
)
from wrinklestudy.study.figures import page
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs) -> Figure:
    """Draw the first three panels from the first sheet, the last from the sheets of all lengths."""
    own = inputs.series[0]
    alone = inputs.only(lambda sheet: sheet.size == own.size)
    lengths = inputs.only(lambda sheet: sheet.thickness == own.thickness)
    single = (fig07_width.draw, fig07_confinement.draw, fig07_slaving.draw)
    return page.draw(
        [*((draw_panel, alone) for draw_panel in single), (fig07_collapse.draw, lengths)], columns=2
    )
