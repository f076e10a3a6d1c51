"""Up to which strain the centre of the flat sheet is compressed, over C01/C10 and L/W."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from wrinklestudy.mechanics.laws import Material
from wrinklestudy.studies.beyond.rubber import ratio, share
from wrinklestudy.typing import Array

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class Ending:
    """Where compression at the centre ends on sheets of one rubber and L/W.

    Parameters
    ----------
    aspect, ratio : float
        L/W and C01/C10.
    strain : float
        Where it ends; inf if it lasts to the largest strain.
    error : float
        Of it: what half the cells in each direction and half the strains change, added; 0 if inf.
    returns : float
        Where the centre is compressed again; NaN if nowhere.
    least : float
        Smallest n/sqrt(b) - 1 beyond its largest: negative if compression ends.
    last : float
        Largest strain looked at.
    """

    aspect: float
    ratio: float
    strain: float
    error: float
    returns: float
    least: float
    last: float

    @property
    def ends(self) -> bool:
        """Whether it ends at all."""
        return bool(np.isfinite(self.strain))


def endings(table: "pd.DataFrame", material: Callable[[str], Material]) -> list[Ending]:
    """Return where compression ends, by L/W and C01/C10.

    Parameters
    ----------
    table : DataFrame
        Of the stage ``compression``.
    material : callable
        Returns a Mooney-Rivlin or neo-Hookean material by its name in the table.
    """
    known = table[table["central_excess"].notna()]
    found = []
    for name in known["material"].unique():
        of_rubber = float(ratio(share(material(name))))
        own = known[known["material"] == name]
        for aspect in own["aspect"].unique():
            rows = own[own["aspect"] == aspect].sort_values("strain")
            found.append(_ending(rows, float(aspect), of_rubber))
    return sorted(found, key=lambda ending: (ending.aspect, ending.ratio))


def _ending(rows: "pd.DataFrame", aspect: float, of_rubber: float) -> Ending:
    strain, fine, coarse = (
        rows[["strain", "central_excess", "coarse_central_excess"]].to_numpy(float).T
    )
    ends, returns = crossings(strain, fine)
    top = int(np.argmax(fine))
    # the last strain stays, so that both look as far
    every_second = slice((len(strain) - 1) % 2, None, 2)
    others = [crossings(strain, coarse)[0], crossings(strain[every_second], fine[every_second])[0]]
    error = sum(abs(other - ends) for other in others) if np.isfinite(ends) else 0.0
    least = float(fine[top:].min())
    return Ending(aspect, of_rubber, ends, error, returns, least, float(strain[-1]))


def crossings(strain: Array, excess: Array) -> tuple[float, float]:
    """Return where an excess first becomes negative, inf if nowhere, and then positive, or NaN.

    Between the strains it is the monotone cubic.
    """
    from scipy.interpolate import PchipInterpolator

    roots = PchipInterpolator(strain, excess).roots(extrapolate=False)
    down = np.flatnonzero((excess[:-1] > 0.0) & (excess[1:] <= 0.0))
    if not len(down):
        return float("inf"), float("nan")
    ends = roots[roots >= strain[down[0]]][0]
    later = roots[roots > strain[down[0] + 1]]
    return float(ends), float(later[0]) if len(later) else float("nan")


@dataclass(frozen=True)
class Turn:
    """Between which C01/C10 compression stops ending, at one L/W.

    Parameters
    ----------
    last_ending, first_lasting : float
        C01/C10; inf if it ends for every ratio of the study, the first 0 if for none.
    rises : bool
        Whether the strain grows with the ratio as long as it is finite, and never ends beyond.
    """

    last_ending: float
    first_lasting: float
    rises: bool


def turns(found: list[Ending]) -> Mapping[float, Turn]:
    """Return the turn at each L/W."""
    by_aspect = {}
    for aspect in sorted({ending.aspect for ending in found}):
        own = [ending for ending in found if ending.aspect == aspect]
        ending, lasting = ([e for e in own if e.ends is ends] for ends in (True, False))
        strains = [e.strain for e in own]
        rises = all(
            low < high or (not np.isfinite(low) and not np.isfinite(high))
            for low, high in pairwise(strains)
        )
        by_aspect[aspect] = Turn(
            max((e.ratio for e in ending), default=0.0),
            min((e.ratio for e in lasting), default=float("inf")),
            rises,
        )
    return by_aspect
