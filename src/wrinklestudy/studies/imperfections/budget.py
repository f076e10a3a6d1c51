"""The error of a measured decay strain: clamps, rubber, the law and the steps of the strain."""

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from wrinklestudy.material.result import Fit
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond.rubber import (
    MEASURED,
    NUMBERS,
    Curves,
    curves,
    interval,
    sampled_shares,
    share,
)
from wrinklestudy.studies.beyond.selections import RATIO, named
from wrinklestudy.studies.imperfections.effects import RIPPLE, Effect, unit, words
from wrinklestudy.study.claims.tables import StudyTables

# How well a careful experiment is taken to be set up, in the units of the imperfections.
SET_UP: Mapping[str, float] = {
    "shear": 0.01,
    "rotate": 0.01,
    "twist": 0.03,
    "pitch": 0.03,
    "lift": 0.03,
    "thickness-along": 0.03,
    "thickness-across": 0.03,
    RIPPLE: 0.01,
}
_DECAY = "decay strain"
UNIAXIAL, ALL_MODES = "treloar-uniaxial", "treloar"


class Share(NamedTuple):
    """One source of the error of a measured decay strain.

    Parameters
    ----------
    source : str
        'set-up', 'rubber' or 'steps'.
    what : str
        In words, with how well it is known.
    error : float
        Of the decay strain; NaN if it is not known.
    """

    source: str
    what: str
    error: float


def decay_curve(study: StudyTables) -> Curves:
    """Return the decay strain over the ratio C01/C10.

    Raises
    ------
    MissingError
        If there are too few rubbers of given ratios.
    """
    _, aspect, thickness = study.wanted
    size = [s for s in study.sheets if (s.aspect, s.thickness) == (aspect, thickness)]
    sheets = named(size, RATIO)
    materials = [study.given[sheet.material] for sheet in sheets]
    own = study.material.fit.material()
    return curves([*sheets, study.sheet], [*materials, own], {_DECAY: NUMBERS[_DECAY]})


def budget(study: StudyTables, found: tuple[Effect, ...]) -> list[Share]:
    """Return what a measured decay strain of the figure sheet is uncertain by.

    Parameters
    ----------
    study : StudyTables
    found : tuple of Effect
        Of the imperfections of that sheet.
    """
    shares = []
    for effect in found:
        size = SET_UP.get(effect.kind.split()[0])
        if size is not None:
            what = f"{words(effect.kind)}, {size:g} {unit(effect.kind)}"
            shares.append(Share("set-up", what, effect.decay_at(size)))
    shares += _of_rubber(study)
    shares.append(Share("steps", f"steps of {MEASURED:g} between strains", 0.5 * MEASURED))
    return shares


def _of_rubber(study: StudyTables) -> list[Share]:
    """Return the error by the fit of the rubber, and by what one mode of test leaves open."""
    found = decay_curve(study)
    fits = {material.name: material.fit for material in study.materials}
    own = interval(found.at(_DECAY, sampled_shares(study.material.fit)))
    shares = [
        Share(
            "rubber",
            f"constants of {study.material.name}, scatter of the fit (95%)",
            0.5 * (own.high - own.low),
        )
    ]
    if UNIAXIAL in fits and ALL_MODES in fits:
        one, every = (_at(found, fits[name]) for name in (UNIAXIAL, ALL_MODES))
        what = f"one mode of test against all: {UNIAXIAL} and {ALL_MODES}, decay of this sheet"
        shares.append(Share("rubber", what, abs(one - every)))
    return shares


def _at(found: Curves, fit: Fit) -> float:
    return float(found.at(_DECAY, share(fit.material())))


def total(shares: list[Share], *sources: str) -> float:
    """Return the square root of the sum of squares of errors from some sources, all by default.

    Raises
    ------
    MissingError
        If one of them is not known.
    """
    chosen = [share for share in shares if not sources or share.source in sources]
    unknown = [share.what for share in chosen if math.isnan(share.error)]
    if unknown:
        raise MissingError(f"the decay strain with {unknown[0]}")
    return float(np.sqrt(sum(share.error**2 for share in chosen)))
