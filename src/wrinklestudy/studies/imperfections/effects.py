"""What imperfections of each kind and size change, and how large they may be."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from wrinklestudy.results.imperfect_sheets import COMBINED, PERFECT
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.typing import Array

ImperfectRow = Mapping[Any, Any]  # a row by column
ImperfectRows = Sequence[ImperfectRow]

AMPLITUDE = 0.02  # of A: what an experiment can tell
DECAY = 0.01  # of the decay strain: half of a step between strains of an experiment
HEIGHT = "envelope_amplitude"  # does not depend on the phase of the pattern
GRAVITY, RIPPLE = "density", "thickness-ripple"
_SMALLEST_EXPONENT, _LARGEST_EXPONENT = 1.0, 2.0  # of a small effect: odd or even in its cause

# In words and unit, by what the kind begins with.
_WORDS = {
    "shear": ("clamp shifted across the pull", "W"),
    "rotate": ("clamp turned in the plane", "rad"),
    "twist": ("clamps twisted about the pull", "rad"),
    "pitch": ("clamp turned about its own line", "rad"),
    "lift": ("clamp shifted out of the plane", "W"),
    "thickness-along": ("thickness from end to end", "t"),
    "thickness-across": ("thickness from edge to edge", "t"),
    RIPPLE: ("thickness ripple across", "t"),
    "thickness-table": ("measured thickness", ""),
    GRAVITY: ("weight of the sheet", "kg/m³"),
}


def words(kind: str) -> str:
    """Return a kind of imperfection in words."""
    name, *rest = kind.split()
    text = _WORDS.get(name, (kind, ""))[0]
    return f"{text}, wavelength {float(rest[0]):g} W" if name == RIPPLE else text


def unit(kind: str) -> str:
    """Return the unit of the size of a kind of imperfection; t is of parts of the thickness."""
    return _WORDS.get(kind.split()[0], ("", ""))[1]


@dataclass(frozen=True)
class Reached:
    """The size at which a change reaches a limit.

    Parameters
    ----------
    size : float
        NaN if unknown; with how = 'above' the largest size that was computed.
    how : {'between', 'below', 'above', 'unknown'}
        Between two sizes computed; below the smallest, by the power law of the two smallest; not
        reached; or unknown because a number is missing.
    """

    size: float
    how: Literal["between", "below", "above", "unknown"]

    def text(self, of: str) -> str:
        """Return it in words, with a unit."""
        if self.how == "unknown":
            return "not known"
        mark = {"between": "", "below": "about ", "above": "not reached up to "}[self.how]
        return f"{mark}{self.size:.2g} {of}".strip()

    @property
    def bound(self) -> float:
        """The size up to which the change stays within the limit, as far as is known."""
        return 0.0 if self.how == "unknown" else self.size


def reached(
    sizes: Sequence[float] | Array, changes: Sequence[float] | Array, limit: float
) -> Reached:
    """Return the size at which |change| first reaches a limit.

    Between sizes |change| is a power law, below the smallest one that of the two smallest with an
    exponent between 1 and 2.

    Parameters
    ----------
    sizes : sequence of float
        Positive, increasing.
    changes : sequence of float
        One for each size; NaN where it is not known.
    limit : float
    """
    size, change = np.asarray(sizes, dtype=float), np.abs(np.asarray(changes, dtype=float))
    beyond = np.flatnonzero(~(change < limit))  # a number that is not known ends the search
    if len(size) == 0 or (len(beyond) and math.isnan(change[beyond[0]])):
        return Reached(math.nan, "unknown")
    if not len(beyond):
        return Reached(float(size[-1]), "above")
    k = int(beyond[0])
    if k > 0 and change[k - 1] == 0.0:
        return Reached(float(size[k]), "between")
    if k > 0:
        return Reached(_on_power_law(size, change, k - 1, limit), "between")
    exponent = _LARGEST_EXPONENT
    if len(size) > 1 and change[1] > 0.0:
        exponent = math.log(change[1] / change[0]) / math.log(size[1] / size[0])
    exponent = min(max(exponent, _SMALLEST_EXPONENT), _LARGEST_EXPONENT)
    return Reached(float(size[0] * (limit / change[0]) ** (1.0 / exponent)), "below")


def _on_power_law(size: Array, change: Array, k: int, limit: float) -> float:
    """Return the size at which a power law through two points reaches a limit."""
    share = math.log(limit / change[k]) / math.log(change[k + 1] / change[k])
    return float(size[k] * (size[k + 1] / size[k]) ** share)


@dataclass(frozen=True, eq=False)
class Effect:
    """What imperfections of one kind change, over their size.

    Parameters
    ----------
    kind : str
    sizes : (n,) array
        Increasing.
    amplitude : mapping
        Relative change of the amplitude of the envelope by strain, (n,) arrays.
    decay : (n,) array
        Change of the decay strain.
    parity : mapping
        Change of the energy of the antisymmetric state against the symmetric one by strain, over
        the energy of bending of the wrinkles, (n,) arrays.
    """

    kind: str
    sizes: Array
    amplitude: Mapping[float, Array]
    decay: Array
    parity: Mapping[float, Array]

    def amplitude_limit(self, strain: float) -> Reached:
        """Return the size at which the amplitude at a strain changes by what can be told."""
        return reached(self.sizes, self.amplitude[strain], AMPLITUDE)

    @property
    def decay_limit(self) -> Reached:
        """The size at which the decay strain changes by what can be told."""
        return reached(self.sizes, self.decay, DECAY)

    @property
    def limits(self) -> tuple[Reached, ...]:
        """All of these limits."""
        return (*(self.amplitude_limit(strain) for strain in self.amplitude), self.decay_limit)

    def decay_at(self, size: float) -> float:
        """Return |change| of the decay strain at a size, by the power laws of `reached`.

        NaN beyond the sizes computed, or where it is not known.
        """
        change = np.abs(self.decay)
        if not np.isfinite(change).all() or size > self.sizes[-1] * (1.0 + 1e-9):
            return math.nan
        if len(self.sizes) == 1 or (change <= 0.0).any():
            return float(np.interp(size, [0.0, *self.sizes], [0.0, *change]))
        logs = np.log(self.sizes), np.log(change)
        if size >= self.sizes[0]:
            return float(np.exp(np.interp(math.log(size), *logs)))
        slope = (logs[1][1] - logs[1][0]) / (logs[0][1] - logs[0][0])
        exponent = min(max(slope, _SMALLEST_EXPONENT), _LARGEST_EXPONENT)
        return float(change[0] * (size / self.sizes[0]) ** exponent)


def rows_of(study: StudyTables) -> ImperfectRows:
    """Return the rows of imperfect sheets of the model and size of the figure sheet.

    Raises
    ------
    MissingError
        If there are none.
    """
    rows: ImperfectRows = study.table("imperfection").to_dict("records")
    chosen = [
        row for row in rows if (row["material"], row["aspect"], row["thickness"]) == study.wanted
    ]
    if not chosen:
        raise MissingError("imperfect sheets of the size of the figure sheet")
    return chosen


def effects(rows: ImperfectRows) -> tuple[Effect, ...]:
    """Return the effects of all kinds of imperfections of one sheet, in a fixed order.

    Parameters
    ----------
    rows : list of mapping
        Rows of the stage `imperfection` of sheets of one model and size.

    Raises
    ------
    MissingError
        If there is no perfect sheet to compare with.
    """
    perfect = {row["strain"]: row for row in rows if row["imperfection"] == PERFECT}
    if not perfect:
        raise MissingError("the perfect sheet, solved without mirrors")
    order = list(_WORDS)
    kinds = [
        kind
        for kind in dict.fromkeys(str(row["kind"]) for row in rows)
        if kind not in (PERFECT, COMBINED) and kind.split()[0] in order
    ]
    kinds.sort(key=lambda kind: (order.index(kind.split()[0]), kind))
    return tuple(_effect(kind, rows, perfect) for kind in kinds)


def _effect(kind: str, rows: ImperfectRows, perfect: Mapping[float, ImperfectRow]) -> Effect:
    own = {(row["size"], row["strain"]): row for row in rows if row["kind"] == kind}
    sizes = sorted({size for size, _ in own if size > 0.0})
    strains = sorted({strain for _, strain in own if strain in perfect})

    def change(column: str, strain: float) -> Array:
        """Return a column less that of the perfect sheet; NaN where there is no row."""
        known = [float(own[s, strain][column]) if (s, strain) in own else math.nan for s in sizes]
        return np.array(known) - float(perfect[strain][column])

    return Effect(
        kind,
        np.array(sizes),
        {e: change(HEIGHT, e) / float(perfect[e][HEIGHT]) for e in strains},
        change("decay_strain", strains[0]) if strains else np.full(len(sizes), math.nan),
        {e: change("parity_energy", e) for e in strains},
    )


def effects_of(study: StudyTables) -> tuple[Effect, ...]:
    """Return the effects on the figure sheet of a study.

    Raises
    ------
    MissingError
        If the study has no imperfect sheets of its size.
    """
    return effects(rows_of(study))


def effect_of(study: StudyTables, kind: str) -> Effect:
    """Return the effect of the first kind that begins in some way.

    Raises
    ------
    MissingError
        If the study has none.
    """
    for effect in effects_of(study):
        if effect.kind.startswith(kind):
            return effect
    raise MissingError(f"imperfections of the kind {kind}")
