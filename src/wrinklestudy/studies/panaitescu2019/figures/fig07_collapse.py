"""Fig. 7d: amplitude against Phi lambda beyond eps = 0.15, for several L/W.

The caption in the paper says both eps > 0 and eps > 0.15; the second is used.
"""

import numpy as np
from matplotlib.figure import FigureBase, SubFigure

from wrinklestudy.studies.panaitescu2019.figures import slaving
from wrinklestudy.study.figures import measured, style
from wrinklestudy.study.figures.against_strain import coarse, legend, styled
from wrinklestudy.study.figures.inputs import Inputs

# Strain beyond which states are shown.
ABOVE = 0.15


def draw(inputs: Inputs, on: SubFigure | None = None) -> FigureBase:
    """Draw A/t against Phi lambda/t of the wrinkled states beyond the strain `ABOVE`."""
    series = sorted(inputs.series, key=lambda sheet: (sheet.aspect, sheet.thickness))
    figure, axes = style.panel_on(on, 6.4)
    scans = inputs.scans_of([sheet.size for sheet in series])
    shown = [scan for scan in scans if scan.strain > ABOVE]
    farthest, highest = measured.slaving(axes, shown)
    holes = 0
    for sheet, look in styled(series):
        holes += int((sheet.of_status("not-converged") & (sheet.column("strain") > ABOVE)).sum())
        for average in slaving.AVERAGES:
            slaved, amplitude = slaving.trajectory(sheet, average, ABOVE)
            if np.isfinite(slaved).any():
                label = look.label if average == slaving.AVERAGES[0] else None
                slaving.points(axes, slaved, amplitude, look, label)
                coarse(axes, sheet, slaved, amplitude)
            farthest = float(np.nanmax([farthest, *slaved]))
            highest = float(np.nanmax([highest, *amplitude]))
    slaving.finish(axes, farthest, highest, holes)
    axes.text(0.97, 0.04, rf"$\varepsilon > {ABOVE:g}$", transform=axes.transAxes, ha="right")
    legend(figure, axes, series)
    return figure
