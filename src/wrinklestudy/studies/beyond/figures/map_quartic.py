"""Whether wrinkles are born and vanish gradually or with a jump, over L/W and thickness."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from wrinklestudy.studies.beyond import maps
from wrinklestudy.study.figures import strain_map, style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.series import number
from wrinklestudy.typing import Array

_ENDS = ("birth", "decay")
_SCALE = LogNorm(5e-3, 0.3)


def draw(inputs: Inputs) -> Figure:
    """Draw the quartic coefficient at birth and at decay, a row for each model."""
    models = list(maps.by_model(inputs.table("map")))
    figure = style.new(2.0 * style.COLUMN, 5.2 * len(models))
    panels = figure.subplots(len(models), 2, squeeze=False)
    for line, (title, rows) in zip(panels, models, strict=True):
        rows = rows[rows.parity == "antisymmetric"]
        tau, quartic = strain_map.of_table(rows), strain_map.of_table(rows, "quartic")
        at_birth, at_decay = maps.along_boundary(tau, quartic, maps.THICKNESSES)
        for axes, end, values in zip(line, _ENDS, (at_birth, at_decay), strict=True):
            mesh = _signs(axes, tau.aspects, values)
            first = axes is line[0]
            axes.set_title(f"{title}, {end}" if first else end, loc="left", fontsize=8.0)
        figure.colorbar(mesh, ax=list(line), label="$g$", aspect=25)
    style.grow(figure, style.legend_above(panels[0, 0], columns=1))
    return figure


def _signs(axes: Axes, aspects: Array, values: Array) -> QuadMesh:
    """Shade where the coefficient is positive, cross where it is not; say which there are."""
    positive = np.ma.masked_where(~(values > 0.0), values)
    mesh = axes.pcolormesh(
        aspects, maps.THICKNESSES, positive, norm=_SCALE, cmap="viridis", rasterized=True
    )
    rows, columns = np.nonzero(values < 0.0)
    if len(rows):
        axes.plot(
            aspects[columns],
            maps.THICKNESSES[rows],
            "x",
            ms=2.0,
            color=style.VERMILLION,
            label="subcritical, $g < 0$",
        )
    label = f"shaded: supercritical, $g > 0$; line: $t/W = {number(maps.PAPER_THICKNESS)}$"
    axes.axhline(maps.PAPER_THICKNESS, color=style.BLACK, lw=0.6, ls="--", label=label)
    axes.set_yscale("log")
    axes.set_xlabel("$L/W$")
    axes.set_ylabel("$t/W$")
    return mesh
