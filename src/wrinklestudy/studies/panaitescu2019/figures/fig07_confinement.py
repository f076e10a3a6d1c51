"""Fig. 7b: confinement Phi^2 = (W_act - W_proj)/W_proj against strain.

The inset shows the same points on a logarithmic scale beside nu eps, which the original
Cerda-Mahadevan model assumes.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import FigureBase, SubFigure

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.figures import measured, style
from wrinklestudy.study.figures.against_strain import BELOW, extremes, finish, points, styled
from wrinklestudy.study.figures.inputs import Inputs

_COLUMN = "phi_squared"


def draw(inputs: Inputs, on: SubFigure | None = None) -> FigureBase:
    """Draw Phi^2 of the full width against strain, birth and decay included."""
    series = inputs.series
    figure, axes = style.panel_on(on)
    for sheet, look in styled(series):
        strain, confinement = sheet.curve(_COLUMN)
        axes.plot(strain, 1e3 * confinement, look.line, color=look.color, lw=0.8)
        points(axes, sheet, look, _COLUMN, 1e3)
    largest = 1e3 * extremes(series, _COLUMN)[1] or 1.0
    scanned = measured.confinement(inputs.scans_of([sheet.size for sheet in series]))
    if scanned is not None:
        largest = max(largest, measured.band(axes, scanned, 1e3))
    axes.set_ylabel(r"$\Phi^2 \times 10^3$")
    axes.set_ylim(-BELOW * largest, 2.0 * largest)
    end = finish(figure, axes, series)
    _inset(axes.inset_axes((0.66, 0.60, 0.32, 0.34)), series, end)
    return figure


def _inset(axes: Axes, series: list[SheetStates], end: float) -> None:
    strain = np.linspace(0.01 * end, end, 200)
    axes.plot(strain, theory.cm_confinement(strain), "--", color=style.BLACK, lw=0.8)
    axes.text(0.5 * end, 0.15 * end, r"$\nu\varepsilon$", ha="center", va="top", fontsize=7)
    for sheet, look in styled(series):
        wrinkled = sheet.of_status("wrinkled")
        strain, value = sheet.column("strain")[wrinkled], sheet.column(_COLUMN)[wrinkled]
        axes.plot(strain, value, look.marker, color=look.color, ms=1.6)
    axes.set_yscale("log")
    axes.set_xlim(0.0, 1.02 * end)
    axes.set_ylim(1e-5, 1.0)
    axes.set_yticks([1e-4, 1e-2, 1.0])
    axes.tick_params(labelsize=6)
    axes.set_ylabel(r"$\Phi^2$", fontsize=6, labelpad=-1)
