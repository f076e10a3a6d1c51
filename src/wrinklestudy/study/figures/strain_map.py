"""Maps of the critical thickness over strain and L/W as contours."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, NullLocator

from wrinklestudy.equilibrium.islands import Ridge, ridge_of_table
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.series import number
from wrinklestudy.typing import Array

if TYPE_CHECKING:
    import pandas as pd

_TICKS = (0.5, 0.7, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 6.0, 8.0, 12.0, 20.0)  # of L/W
FEW_TICKS = (0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 8.0, 20.0)  # of L/W, for low panels
# Contours of t/W or t/L: these times powers of ten
_STEPS = (1.0, 1.5, 2.0, 3.0, 5.0, 7.0)
_MOST, _RANGE = 10, 20.0  # contours, and their largest over their smallest
_NONE = 1e-12  # is drawn for zero, which has no logarithm
_CROWDED = 0.08  # part of the strains, at small ones, that gets no labels
_FINE = 301  # points that contours are drawn through, along each axis


@dataclass(frozen=True, eq=False)
class StrainMap:
    """A quantity of one model over L/W (rows) and strain (columns); NaN where it is not known."""

    aspects: Array
    strains: Array
    values: Array

    def in_lengths(self) -> "StrainMap":
        """Return thicknesses over L in place of W."""
        return StrainMap(self.aspects, self.strains, self.values / self.aspects[:, None])

    def ridges(self) -> dict[float, Ridge]:
        """Return the largest tau_1/W over strain of each L/W."""
        found = {}
        for aspect, row in zip(self.aspects, self.values, strict=True):
            known = np.isfinite(row)
            if known.any():
                found[float(aspect)] = ridge_of_table(self.strains[known], row[known])
        return found


def of_table(table: "pd.DataFrame", column: str = "critical_thickness") -> StrainMap:
    """Return a column for the parity with the larger critical thickness.

    Parameters
    ----------
    table : DataFrame
        Rows of a map of one model, of one parity or of both.
    column : str
        What is wanted.
    """
    ordered = table.sort_values("critical_thickness", na_position="first", kind="stable")
    larger = ordered.groupby(["aspect", "strain"]).tail(1)
    grid = larger.pivot_table(
        index="aspect", columns="strain", values=column, dropna=False, aggfunc="first"
    )
    aspects, strains = grid.index.to_numpy(float), grid.columns.to_numpy(float)
    return StrainMap(aspects, strains, grid.to_numpy(float))


def contours(axes: Axes, shown: StrainMap, label: Literal["t/W", "t/L"] = "t/W") -> None:
    """Draw labelled contours of a thickness with shades between them; holes stay white."""
    from matplotlib.colors import LogNorm

    levels = round_levels(shown.values)
    if not levels:
        axes.text(0.5, 0.5, "no sheet wrinkles", transform=axes.transAxes, ha="center")
        return
    strains, aspects, values = finer(shown)
    # the lowest shade begins at the lowest contour
    shades, norm = [*levels, 10.0 * levels[-1]], LogNorm(0.7 * levels[0], 3.0 * levels[-1])
    axes.contourf(strains, aspects, values, shades, norm=norm, cmap="YlGnBu", alpha=0.75, zorder=0)
    lines = axes.contour(
        strains, aspects, values, levels=levels, colors=style.BLACK, linewidths=0.5
    )
    axes.clabel(lines, fmt={level: f"${number(level)}$" for level in levels}, fontsize=6)
    for text in lines.labelTexts:  # where contours crowd labels cover each other
        if text.get_position()[0] < _CROWDED * strains[-1]:
            text.set_visible(False)
    axes.set_title(f"${label}$", loc="right", fontsize=7.0, pad=2.0)


def finer(shown: StrainMap) -> tuple[Array, Array, "np.ma.MaskedArray[Any, Any]"]:
    """Return strains, L/W and thicknesses between those of a map; around holes as they are.

    At zero strain nothing wrinkles. The square of the thickness is smooth there.
    """
    from scipy.interpolate import PchipInterpolator

    strains = np.concatenate([[0.0], shown.strains])
    values = np.hstack([np.zeros((len(shown.aspects), 1)), shown.values])
    values = np.where(np.isnan(values), np.nan, np.maximum(values, _NONE))
    if not np.isfinite(values).all():
        return strains, shown.aspects, np.ma.masked_invalid(values)
    fine = np.linspace(0.0, strains[-1], _FINE)
    long = np.geomspace(shown.aspects[0], shown.aspects[-1], _FINE)
    squared = PchipInterpolator(strains, values**2, axis=1)(fine)
    squared = PchipInterpolator(shown.aspects, squared, axis=0)(long)
    return fine, long, np.ma.masked_invalid(np.sqrt(np.maximum(squared, _NONE**2)))


def round_levels(values: Array) -> list[float]:
    """Return round numbers between the largest of some values and a twentieth of it."""
    highest = float(np.nanmax(values, initial=0.0))
    if highest <= 0.0:
        return []
    powers = 10.0 ** np.arange(np.floor(np.log10(highest)) - 2.0, np.log10(highest) + 1.0)
    levels = [float(f"{step * power:.6g}") for power in powers for step in _STEPS]
    return [level for level in levels if highest / _RANGE < level < highest][-_MOST:]


def finish(axes: Axes, shown: StrainMap, title: str = "", ticks: Sequence[float] = _TICKS) -> None:
    """Set the axes of a map."""
    axes.set_xlim(0.0, float(shown.strains[-1]))
    axes.set_ylim(float(shown.aspects[0]), float(shown.aspects[-1]))
    axes.set_xlabel(r"strain $\varepsilon$")
    axes.set_ylabel("$L/W$")
    axes.set_yscale("log")  # all that changes much does so below L/W = 3
    axes.yaxis.set_major_locator(FixedLocator(ticks))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_locator(NullLocator())
    axes.set_title(title, loc="left", fontsize=8.0, pad=2.0)


def panels(count: int) -> tuple[Figure, Sequence[Axes]]:
    """Return a figure with a panel for each model, two in a row."""
    rows, columns = -(-count // 2), min(count, 2)
    figure = style.new(style.COLUMN * (1.25 if columns == 1 else 2.2), 6.2 * rows)
    every = list(np.ravel(figure.subplots(rows, columns, squeeze=False)))
    for axes in every[count:]:
        axes.remove()
    return figure, every[:count]


def draw_one(shown: StrainMap, title: str) -> Figure:
    """Draw the contours of one model."""
    figure, (axes,) = panels(1)
    contours(axes, shown)
    finish(axes, shown, title)
    return figure
