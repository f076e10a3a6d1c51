"""Fig. 5a: amplitude over thickness against strain, one curve per model, with what was measured."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import FigureBase, SubFigure

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.against_strain import (
    BELOW,
    extremes,
    finish,
    overlay,
    points,
    styled,
)
from wrinklestudy.study.figures.inputs import Inputs

_COLUMN = "amplitude_over_thickness"


def draw(inputs: Inputs, on: SubFigure | None = None) -> FigureBase:
    """Draw A/t against strain; diamonds are birth and decay strain of the eigenvalue problem."""
    series = inputs.series
    figure, axes = style.panel_on(on)
    for sheet, look in styled(series):
        axes.plot(*sheet.curve(_COLUMN), look.line, color=look.color, lw=0.8)
        points(axes, sheet, look, _COLUMN)
        _ends(axes, sheet, look.color)
    measured = overlay(axes, series, inputs.measured_amplitude())
    axes.set_ylabel("$A/t$")
    highest = max(extremes(series, _COLUMN)[1], measured) or 1.0
    axes.set_ylim(-BELOW * highest, 1.1 * highest)
    finish(figure, axes, series)
    return figure


def _ends(axes: Axes, sheet: SheetStates, color: str) -> None:
    ends = [strain for strain in (sheet.birth, sheet.decay) if np.isfinite(strain)]
    if ends:
        axes.plot(
            ends,
            np.zeros(len(ends)),
            "D",
            color=color,
            mfc="white",
            ms=4.0,
            zorder=4,
            clip_on=False,
            label="birth, decay",
        )
