"""Fig. 5a: amplitude over thickness against strain."""

import numpy as np
from matplotlib.figure import Figure

from wrinklestudy.figures import style
from wrinklestudy.figures.against_strain import extremes, finish, points, styled
from wrinklestudy.figures.inputs import Inputs

_COLUMN = "amplitude_over_thickness"


def draw(inputs: Inputs) -> Figure:
    """Draw A/t against strain; diamonds are birth and decay strain of the eigenvalue problem."""
    series = inputs.sheet_series()
    figure, axes = style.panel()
    for one, look in styled(series):
        axes.plot(*one.curve(_COLUMN), look.line, color=look.color, lw=0.8)
        points(axes, one, look, _COLUMN)
        ends = [strain for strain in (one.birth, one.decay) if np.isfinite(strain)]
        if ends:
            axes.plot(
                ends,
                np.zeros(len(ends)),
                "D",
                color=look.color,
                mfc="white",
                ms=4.0,
                zorder=4,
                clip_on=False,
                label="birth, decay",
            )
    axes.set_ylabel("$A/t$")
    highest = extremes(series, _COLUMN)[1] or 1.0
    axes.set_ylim(-0.04 * highest, 1.1 * highest)
    finish(figure, axes, series)
    return figure
