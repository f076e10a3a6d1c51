"""Fig. 7c: amplitude against Phi lambda over the whole range of strain."""

import numpy as np
from matplotlib.figure import FigureBase, SubFigure

from wrinklestudy.studies.panaitescu2019.figures import slaving
from wrinklestudy.study.figures import measured, style
from wrinklestudy.study.figures.against_strain import coarse, legend, styled
from wrinklestudy.study.figures.inputs import Inputs


def draw(inputs: Inputs, on: SubFigure | None = None) -> FigureBase:
    """Draw A/t against Phi lambda/t of the wrinkled states, arrows towards larger strain."""
    series = inputs.series
    figure, axes = style.panel_on(on, 5.4)
    farthest, highest = measured.slaving(axes, inputs.scans_of([sheet.size for sheet in series]))
    for sheet, look in styled(series):
        for average in slaving.AVERAGES:
            slaved, amplitude = slaving.trajectory(sheet, average)
            label = look.label if average == slaving.AVERAGES[0] else None
            slaving.points(axes, slaved, amplitude, look, label)
            coarse(axes, sheet, slaved, amplitude)
            slaving.arrows(axes, slaved, amplitude, look.color)
            farthest = float(np.nanmax([farthest, *slaved]))
            highest = float(np.nanmax([highest, *amplitude]))
    holes = sum(sheet.status.count("not-converged") for sheet in series)
    slaving.finish(axes, farthest, highest, holes)
    legend(figure, axes, series)
    return figure
