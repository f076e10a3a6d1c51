"""What the statements on lengths take from the maps: ranges of L/W with wrinkles, strains."""

from typing import TYPE_CHECKING

import numpy as np

from wrinklestudy.equilibrium.islands import Held
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond import tips
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.figures import strain_map
from wrinklestudy.study.figures.strain_map import StrainMap

if TYPE_CHECKING:
    import pandas as pd

# t/W and t/L of the paper's sheet; that the latter was held by Li and Healey is inferred
HELD: dict[Held, float] = dict(tips.HELD)
HOOKEAN = "svk-50-fvk"


def map_of(table: "pd.DataFrame", model: str) -> StrainMap:
    """Return the critical thickness of a model over L/W and strain.

    Raises
    ------
    MissingError
        If there is no map of it.
    """
    rows = table[table["material"] == model]
    if rows.empty:
        raise MissingError(f"a map of {model}")
    return strain_map.of_table(rows)


def critical_at(table: "pd.DataFrame", model: str, strain: float) -> dict[float, float]:
    """Return tau_1/W of a model at a strain of its map, by L/W.

    Raises
    ------
    MissingError
        If the map has no such strain.
    """
    shown = map_of(table, model)
    column = np.flatnonzero(np.isclose(shown.strains, strain, rtol=1e-9))
    if not len(column):
        raise MissingError(f"strain {strain:g} on the map of {model}")
    values = shown.values[:, column[0]]
    known = np.isfinite(values)
    return dict(zip(shown.aspects[known].tolist(), values[known].tolist(), strict=True))


def largest_at(table: "pd.DataFrame", aspect: float) -> dict[str, float]:
    """Return the largest tau_1/W over strain of sheets of one L/W, by model.

    Models whose map lacks this L/W are left out.
    """
    found = {}
    for model, rows in table.groupby("material", sort=False):
        ridges = strain_map.of_table(rows).ridges()
        if aspect in ridges:
            found[str(model)] = ridges[aspect].thickness
    return found


def last_lengths(study: StudyTables, held: Held) -> dict[str, float]:
    """Return the last L/W that wrinkles, by model, where it lies on the map.

    Raises
    ------
    MissingError
        If no island ends on a map.
    """
    found = tips.of_models(tips.tips(study), held)
    last = {model: ends["last"].aspect for model, ends in found.items() if "last" in ends}
    if not last:
        raise MissingError(f"an upper end of an island at fixed {held}")
    return last


def birth_strain(thickness: float, critical: float, strain: float) -> float:
    """Return the strain at which a thin sheet wrinkles: tau_1^2 grows like the strain near zero.

    Parameters
    ----------
    thickness : float
        t/W.
    critical : float
        tau_1/W at a small strain.
    strain : float
        That strain.
    """
    return strain * (thickness / critical) ** 2 if critical > 0.0 else float("inf")
