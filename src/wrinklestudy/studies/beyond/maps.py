"""What figures and claims of maps share: models, the paper's sheets, roots of tau_1 = t."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from wrinklestudy.study.figures.strain_map import StrainMap
from wrinklestudy.study.figures.style import law_label
from wrinklestudy.typing import Array

if TYPE_CHECKING:
    import pandas as pd

# The paper's sheets, all of its latex, and the strains at which they are marked.
PAPER_MATERIAL = "latex"
PAPER_ASPECTS = (1.5, 1.8, 2.0, 2.5, 3.0, 3.5)
PAPER_THICKNESS = 1.0e-3
PAPER_STRAINS = tuple(0.04 * k for k in range(1, 13))
# t/L of the boundary that was published for the 10:1 sheet: t/W = 1e-3 at L/W = 2
PUBLISHED_OVER_LENGTH = 5.0e-4
# t/W at which the stability boundary is looked at
THICKNESSES = np.geomspace(1e-4, 1.6e-3, 41)


def by_model(table: "pd.DataFrame") -> "Iterator[tuple[str, pd.DataFrame]]":
    """Yield the title of each model with its rows, in the order of the table."""
    for name, rows in table.groupby("material", sort=False):
        first = rows.iloc[0]
        bending = "" if first.bending == "thinning" else f", {first.bending}"
        yield f"{name}: {law_label(first.law)}{bending}", rows


class BirthAndDecay(NamedTuple):
    """Strains between which a sheet wrinkles on a map; NaN where there is none or it is unknown."""

    birth: float
    decay: float


def edges(strains: Array, squared: Array, thickness: float) -> BirthAndDecay:
    """Return the first and the last root of tau_1(eps) = t between the strains of a map.

    Parameters
    ----------
    strains, squared : arrays
        tau_1^2 at strains, in which it is interpolated linearly; at zero strain it is zero.
    thickness : float
        t in the units of tau_1.
    """
    known = np.isfinite(squared)
    x = np.concatenate([[0.0], strains[known]])
    excess = np.concatenate([[0.0], squared[known]]) / thickness**2 - 1.0
    up = np.flatnonzero((excess[:-1] < 0.0) & (excess[1:] >= 0.0))
    down = np.flatnonzero((excess[:-1] >= 0.0) & (excess[1:] < 0.0))

    def root(k: int) -> float:
        return float(x[k] - excess[k] * (x[k + 1] - x[k]) / (excess[k + 1] - excess[k]))

    birth = root(up[0]) if len(up) else np.nan
    ends = len(down) > 0 and excess[-1] < 0.0
    return BirthAndDecay(birth, root(down[-1]) if ends else np.nan)


def value_at(shown: StrainMap, aspect: float, strain: float) -> float:
    """Return a quantity between the points of a map, linearly; NaN outside of it."""
    inside = shown.aspects[0] <= aspect <= shown.aspects[-1]
    if not (inside and strain <= shown.strains[-1]):
        return float("nan")
    over_strain = [float(np.interp(strain, shown.strains, row)) for row in shown.values]
    return float(np.interp(aspect, shown.aspects, over_strain))


def along_boundary(tau: StrainMap, quartic: StrainMap, thicknesses: Array) -> tuple[Array, Array]:
    """Return g at birth and at decay of sheets of some t/W, (thicknesses, L/W) each.

    NaN where the sheet does not wrinkle, or where its wrinkles outlast the map.
    """
    ends = np.full((2, len(thicknesses), len(tau.aspects)), np.nan)
    for k, (row, coefficients) in enumerate(zip(tau.values, quartic.values, strict=True)):
        known = np.isfinite(coefficients)
        for j, thickness in enumerate(thicknesses):
            for end, strain in enumerate(edges(tau.strains, row**2, thickness)):
                if known.any() and np.isfinite(strain):
                    values = np.interp(strain, tau.strains[known], coefficients[known])
                    ends[end, j, k] = values
    return ends[0], ends[1]
