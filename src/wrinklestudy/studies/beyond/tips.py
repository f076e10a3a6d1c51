"""The tips of the islands of every map of a study: interpolated, and corrected by solutions."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache

from wrinklestudy.equilibrium.islands import (
    Held,
    Island,
    Ridge,
    RidgeOfLaw,
    SolvedTip,
    Tip,
    corrected,
    interpolated,
    islands,
)
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond import maps
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.figures import strain_map

HELD: tuple[tuple[Held, float], ...] = (
    ("t/W", maps.PAPER_THICKNESS),
    ("t/L", maps.PUBLISHED_OVER_LENGTH),
)
FEWEST = 3  # L/W of a map between which one can interpolate


@dataclass(frozen=True)
class TipOfModel:
    """A tip of an island of a model.

    Parameters
    ----------
    model, bending : str
    held : {'t/W', 't/L'}
    thickness : float
        In units of what is held.
    end : str
        ``first`` or ``last``.
    aspect, strain : float
        L/W of the tip and where the sheet of that L/W wrinkles last; NaN if it is not found.
    between : float
        L/W of the tip between those of the map.
    change : float
        Last correction, in parts of the L/W.
    """

    model: str
    bending: str
    held: Held
    thickness: float
    end: str
    aspect: float
    strain: float
    between: float
    change: float


def ridges(study: StudyTables) -> dict[tuple[str, str], dict[float, Ridge]]:
    """Return the largest tau_1/W over strain by (model, bending law) and L/W.

    Raises
    ------
    MissingError
        If the study has no map with enough L/W.
    """
    known = {
        (str(rows.iloc[0].material), str(rows.iloc[0].bending)): strain_map.of_table(rows).ridges()
        for _, rows in maps.by_model(study.table("map"))
    }
    enough = {model: found for model, found in known.items() if len(found) >= FEWEST}
    if not enough:
        raise MissingError(f"a map with {FEWEST} L/W")
    return enough


def islands_between(study: StudyTables, held: Held) -> dict[str, list[Island]]:
    """Return the islands of each model between the L/W of its map."""
    thickness = dict(HELD)[held]
    return {
        model: islands(known, interpolated(known), thickness, held)
        for (model, _), known in ridges(study).items()
    }


def law_of(study: StudyTables, model: str) -> Law:
    """Return the law of a model; the name of a variant begins with that of its material.

    Raises
    ------
    MissingError
        If the material is not there.
    """
    laws = {fitted.name: fitted.fit.material().law for fitted in study.materials}
    laws |= {name: material.law for name, material in study.given.items()}
    own = [name for name in laws if model == name or model.startswith(f"{name}-")]
    if not own:
        raise MissingError(f"the material of {model}")
    return laws[max(own, key=len)]


@lru_cache(maxsize=1)  # claims and table share them: a second of CPU each
def tips(study: StudyTables) -> tuple[TipOfModel, ...]:
    """Return the tips of all islands that lie on the maps, to 0.2% of their L/W or better.

    Solved on the default mesh, for antisymmetric wrinkles.

    Raises
    ------
    MissingError
        If there is none.
    """
    found = tuple(_tips(study))
    if not found:
        raise MissingError("a tip of an island on a map")
    return found


def _tips(study: StudyTables) -> Iterator[TipOfModel]:
    for (model, bending), known in ridges(study).items():
        between = interpolated(known)
        ridge = RidgeOfLaw(law_of(study, model), PlanarSettings(bending=bending))
        for held, thickness in HELD:
            for island in islands(known, between, thickness, held):
                for end, guess in (("first", island.first), ("last", island.last)):
                    if guess is not None:
                        tip, change = _corrected(guess, ridge, between, thickness, held)
                        yield TipOfModel(
                            *(model, bending, held, thickness, end),
                            *(tip.aspect, tip.strain, guess.aspect, change),
                        )


def _corrected(
    guess: Tip, ridge: RidgeOfLaw, between: Callable[[float, float], Ridge], size: float, held: Held
) -> SolvedTip:
    """Return a corrected tip, NaN if it is not found: a map may be too coarse for it."""
    try:
        return corrected(guess, ridge, between, size, held)
    except ArithmeticError:
        return SolvedTip(Tip(math.nan, math.nan), math.nan)


def of_models(every: tuple[TipOfModel, ...], held: Held) -> dict[str, dict[str, TipOfModel]]:
    """Return the tips by model and end."""
    by_model: dict[str, dict[str, TipOfModel]] = {}
    for tip in every:
        if tip.held == held:
            by_model.setdefault(tip.model, {})[tip.end] = tip
    return by_model
