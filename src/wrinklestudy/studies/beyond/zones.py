"""Parities and places of critical modes on the maps of a study."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from wrinklestudy.study.figures import strain_map

if TYPE_CHECKING:
    import pandas as pd

CENTRAL = 0.02  # x/L up to which a mode counts as largest at the centre


def parities(table: "pd.DataFrame", thinnest: float) -> "pd.DataFrame":
    """Return the points of a table of maps where both parities are known, with their difference.

    Parameters
    ----------
    table : DataFrame
        Columns of `MapRow`.
    thinnest : float
        Critical thickness over W below which points are left out.

    Returns
    -------
    DataFrame
        Columns material, aspect, strain, critical_thickness (the larger one) and apart: that of
        antisymmetric over that of symmetric wrinkles, less 1.
    """
    pairs = table.pivot_table(
        index=["material", "aspect", "strain"],
        columns="parity",
        values="critical_thickness",
        aggfunc="first",
    ).reindex(columns=["antisymmetric", "symmetric"])
    larger = pairs.max(axis=1, skipna=False)
    pairs = pairs[larger >= thinnest]
    pairs = pairs.assign(
        critical_thickness=larger, apart=pairs["antisymmetric"] / pairs["symmetric"] - 1.0
    )
    return pairs.reset_index()


@dataclass(frozen=True)
class Zones:
    """Where over L/W the largest wrinkle of a model leaves the centre.

    Parameters
    ----------
    last_central, first_apart : float
        L/W of the map between which it leaves.
    settled : bool
        Whether it is off the centre on all longer sheets of the map.
    longest, place_at_longest : float
        The largest L/W, and |x|/L of its largest wrinkle.
    """

    last_central: float
    first_apart: float
    settled: bool
    longest: float
    place_at_longest: float


def zones(table: "pd.DataFrame") -> dict[str, Zones]:
    """Return the zones of each model, at the strain where the thickest sheet wrinkles.

    Models whose mode never leaves the centre, or is nowhere at it, are left out.
    """
    found = {}
    for model, rows in table.groupby("material", sort=False):
        known = rows[rows["largest_at"].notna()]
        largest = known.loc[known.groupby("aspect")["critical_thickness"].idxmax()]
        aspects, places = largest["aspect"].to_numpy(), largest["largest_at"].to_numpy()
        apart = places > CENTRAL
        if apart.any() and not apart[0]:
            first = int(np.argmax(apart))
            found[str(model)] = Zones(
                *(float(aspects[first - 1]), float(aspects[first]), bool(apart[first:].all())),
                *(float(aspects[-1]), float(places[-1])),
            )
    return found


def distances_from_clamp(
    table: "pd.DataFrame", shortest: float, strain: float
) -> dict[str, dict[float, float]]:
    """Return (1/2 - x/L) L/W of the largest wrinkle by model and L/W, from a L/W on.

    Parameters
    ----------
    table : DataFrame
        Columns of `MapRow`.
    shortest : float
        L/W from which sheets count.
    strain : float
        The strain of each map nearest to it is taken.
    """
    found: dict[str, dict[float, float]] = {}
    for model, rows in table.groupby("material", sort=False):
        place = strain_map.of_table(rows, "largest_at")
        column = int(np.argmin(np.abs(place.strains - strain)))
        distances = {
            float(aspect): float((0.5 - at) * aspect)
            for aspect, at in zip(place.aspects, place.values[:, column], strict=True)
            if aspect >= shortest and np.isfinite(at)
        }
        if distances:
            found[str(model)] = distances
    return found
