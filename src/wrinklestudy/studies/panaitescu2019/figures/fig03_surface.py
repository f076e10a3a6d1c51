"""Fig. 3c: the computed surface, deflection mapped to colour between +-3.5e-3 W.

The caption of the paper's figure gives the strain as (L - L0)/W0 = 0.12, which would be 0.06 of its
own definition (L - L0)/L0: both are shown. The paper gives its colour bar in thicknesses too, 2.5;
at t/W = 1e-3 it is 3.5 t. The surface is seen obliquely from above with the deflection drawn
larger than it is, by the factor given in the figure; the two dashed lines bound the central 80%
of the length, the part that the paper scanned.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.metrics.surface import SampledSurface
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.oblique import ObliqueView, projected
from wrinklestudy.typing import Array

# The paper's colour bar, in units of W, and the part of the length that it scanned.
COLOR_LIMIT = 3.5e-3
SCANNED = 0.8

VIEW = ObliqueView(exaggeration=10.0, limit=COLOR_LIMIT)
_SAMPLES = (3, 8)  # per cell along and across


def draw(inputs: Inputs) -> Figure:
    """Draw the surfaces of the states given, one below the other, with one colour bar."""
    states = inputs.loaded_states()
    figure = style.new(style.WIDE, 1.2 + 4.4 * len(states))
    panels = figure.subplots(len(states), 1, squeeze=False)[:, 0]
    for axes, state in zip(panels, states, strict=True):
        axes.set_aspect("equal")
        axes.axis("off")
        if state.status == "not-converged":
            axes.text(0.5, 0.5, "not converged", transform=axes.transAxes, ha="center")
        else:
            surface = state.surface(per_cell=_SAMPLES)
            _scanned_part(axes, surface, VIEW.draw(axes, surface))
        title = rf"$\varepsilon = (L - L_0)/L_0 = {state.strain:g}$"
        axes.set_title(title, loc="left", fontsize=8.0, pad=4.0)
    factor = rf"$z$ drawn $\times\,{VIEW.exaggeration:g}$"
    figure.suptitle(f"{states[0].note}, {factor}", fontsize=8.0)
    scale, label = VIEW.scale(unit=1e-3), "$10^3\\,z/W$"
    figure.colorbar(scale, ax=list(panels), shrink=0.7, aspect=25, label=label)
    return figure


def _scanned_part(axes: Axes, surface: SampledSurface, points: Array) -> None:
    for end in (-SCANNED, SCANNED):
        row = int(np.argmin(np.abs(surface.reference_x - end * surface.reference_x[-1])))
        axes.plot(*projected(points[:, row]), "--", color=style.BLACK, lw=0.6)
