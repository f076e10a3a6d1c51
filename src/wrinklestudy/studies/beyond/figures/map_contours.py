"""Contours of the critical thickness over strain and L/W, a panel for each model."""

from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.equilibrium.islands import interpolated, islands
from wrinklestudy.studies.beyond import maps
from wrinklestudy.study.figures import strain_map, style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.series import number
from wrinklestudy.study.figures.strain_map import StrainMap

Unit = Literal["t/W", "t/L"]


def draw_in(inputs: Inputs, unit: Unit, thickness: float) -> Figure:
    """Draw the maps in units of W or L, with the tips of the island of one thickness."""
    models = list(maps.by_model(inputs.table("map")))
    figure, panels = strain_map.panels(len(models))
    for axes, (title, rows) in zip(panels, models, strict=True):
        shown = strain_map.of_table(rows)
        strain_map.contours(axes, shown.in_lengths() if unit == "t/L" else shown, unit)
        if unit == "t/W" and rows.iloc[0].material == maps.PAPER_MATERIAL:
            _paper(axes, shown)
        _tips(axes, shown, unit, thickness)
        _holes(axes, shown)
        strain_map.finish(axes, shown, title)
    first = panels[0]
    style.grow(figure, style.legend_above(first, columns=3))
    return figure


def _paper(axes: Axes, shown: StrainMap) -> None:
    """Mark the paper's sheets where they are wrinkled and where they are flat."""
    marks = {True: ("o", style.VERMILLION, "paper's sheets, wrinkled")}
    marks[False] = ("o", "white", "flat")
    points = [(eps, a) for a in maps.PAPER_ASPECTS for eps in maps.PAPER_STRAINS]
    tau = np.array([maps.value_at(shown, a, eps) for eps, a in points])
    for wrinkled, (marker, face, label) in marks.items():
        which = np.isfinite(tau) & ((tau > maps.PAPER_THICKNESS) == wrinkled)
        if which.any():
            axes.plot(
                *np.array(points)[which].T,
                marker,
                ms=2.2,
                mfc=face,
                mec=style.VERMILLION,
                mew=0.5,
                label=label,
            )


def _tips(axes: Axes, shown: StrainMap, unit: Unit, thickness: float) -> None:
    """Mark the first and the last L/W that wrinkles, interpolated between those of the map."""
    ridges = shown.ridges()
    if len(ridges) < 2:
        return
    for island in islands(ridges, interpolated(ridges), thickness, unit):
        for tip, above in ((island.first, -9), (island.last, 2)):
            if tip is None:
                continue
            label = f"tips at ${unit} = {number(thickness)}$"
            axes.plot([tip.strain], [tip.aspect], "*", ms=6, color=style.ORANGE, label=label)
            axes.annotate(
                f"{tip.aspect:.3g}",
                (tip.strain, tip.aspect),
                xytext=(4, above),
                textcoords="offset points",
                fontsize=6.5,
                bbox={"facecolor": "white", "alpha": 0.7, "edgecolor": "none", "pad": 0.5},
            )


def _holes(axes: Axes, shown: StrainMap) -> None:
    rows, columns = np.nonzero(np.isnan(shown.values))
    if len(rows):
        axes.plot(
            shown.strains[columns],
            shown.aspects[rows],
            "x",
            ms=2.0,
            mew=0.5,
            color=style.GREY,
            label="not converged",
        )
