"""The islands of wrinkled sheets on a map over (eps, L/W): their first and last L/W.

A sheet of a thickness wrinkles at some strain if the largest tau_1 over strain exceeds it, so that
the tips of its island over L/W are roots of max tau_1(L/W) = t. If t/L is held in place of t/W, the
thickness in units of W grows with L/W.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np

from wrinklestudy.equilibrium.critical_curve import CriticalCurve
from wrinklestudy.equilibrium.critical_map import map_grid
from wrinklestudy.equilibrium.extrema import refine
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import Law

Held = Literal["t/W", "t/L"]

_TOLERANCE = 2.0e-3  # of the L/W of a tip, in parts of it
_MAX_STEPS = 20
_NEAR = 5.0e-3  # a correction below this part of L/W is the last
_MAX_CORRECTIONS = 5
_BESIDE = (0.85, 1.0, 1.18)  # strains of a first bracket of a maximum, in parts of the expected one


class Ridge(NamedTuple):
    """The largest tau_1/W over strain of sheets of one L/W, and where it is."""

    thickness: float
    strain: float


class Tip(NamedTuple):
    """An end of an island."""

    aspect: float  # L/W
    strain: float  # where the sheet of that L/W wrinkles last


@dataclass(frozen=True)
class Island:
    """A range of L/W in which sheets of one thickness wrinkle at some strain.

    Parameters
    ----------
    thickness : float
        t/W or t/L.
    held : {'t/W', 't/L'}
    first, last : Tip or None
        None where the island reaches beyond the map.
    """

    thickness: float
    held: Held
    first: Tip | None
    last: Tip | None


def ridge_of(curve: Callable[[float], float], strains: Sequence[float]) -> Ridge:
    """Return the largest value of a curve tau_1(eps)/W near some strains; see `extrema.refine`.

    A maximum at the largest of the strains is not looked for beyond it.
    """
    table = {strain: curve(strain) for strain in sorted(strains)}
    place = max(table, key=table.__getitem__)
    if min(table) < place < max(table):
        place = refine(curve, table, place, 1.0)
    return Ridge(table[place], place)


def ridge_of_table(strains: Sequence[float], thicknesses: Sequence[float]) -> Ridge:
    """Return the largest tau_1/W of a table over strain.

    Between strains it is that of the parabola through the three largest neighbours of tau_1^2.
    """
    table = dict(sorted(zip(strains, thicknesses, strict=True)))
    x, squared = np.array(list(table)), np.array(list(table.values())) ** 2
    k = int(squared.argmax())
    if 0 < k < len(x) - 1 and squared[k] > 0.0:
        second, first, _ = np.polyfit(x[k - 1 : k + 2] - x[k], squared[k - 1 : k + 2], 2)
        if second < 0.0:
            shift = float(np.clip(-0.5 * first / second, x[k - 1] - x[k], x[k + 1] - x[k]))
            highest = squared[k] + (first + second * shift) * shift
            return Ridge(float(np.sqrt(highest)), float(x[k]) + shift)
    return Ridge(float(np.sqrt(squared[k])), float(x[k]))


def interpolated(ridges: Mapping[float, Ridge]) -> Callable[[float, float], Ridge]:
    """Return the largest tau_1/W between the L/W of a map: a stand-in for `RidgeOfLaw`.

    With steps of 0.2 tips are right to 0.3%; of 0.5, to 1.5%.
    """
    from scipy.interpolate import CubicSpline, PchipInterpolator

    aspects = sorted(ridges)
    squared = CubicSpline(aspects, [ridges[a].thickness ** 2 for a in aspects])
    strains = PchipInterpolator(aspects, [ridges[a].strain for a in aspects])

    def ridge(aspect: float, _: float) -> Ridge:
        highest = float(np.sqrt(max(float(squared(aspect)), 0.0)))
        return Ridge(highest, float(strains(aspect)))

    return ridge


def islands(
    ridges: Mapping[float, Ridge],
    ridge: Callable[[float, float], Ridge],
    thickness: float,
    held: Held = "t/W",
) -> list[Island]:
    """Return the islands of a thickness, with tips to 0.2% of their L/W.

    Parameters
    ----------
    ridges : mapping
        The largest tau_1/W over strain of each L/W of a map.
    ridge : callable
        Gives one from L/W and the strain that is expected: `RidgeOfLaw`, or `interpolated`.
    thickness : float
        t/W or t/L.
    held : {'t/W', 't/L'}
        What the thickness is.
    """
    aspects = sorted(ridges)
    inside = [_excess(ridges[a].thickness, a, thickness, held) > 0.0 for a in aspects]
    tips = [
        _tip({a: ridges[a], b: ridges[b]}, ridge, thickness, held)
        for k, (a, b) in enumerate(pairwise(aspects))
        if inside[k] != inside[k + 1]
    ]
    ends: list[Tip | None] = [*tips]
    if inside and inside[0]:
        ends.insert(0, None)
    if len(ends) % 2:
        ends.append(None)
    pairs = zip(ends[::2], ends[1::2], strict=True)
    return [Island(thickness, held, first, last) for first, last in pairs]


class SolvedTip(NamedTuple):
    """A tip that was interpolated, corrected by direct solutions."""

    tip: Tip
    change: float  # last correction, in parts of the L/W


def corrected(
    guess: Tip,
    ridge: Callable[[float, float], Ridge],
    between: Callable[[float, float], Ridge],
    thickness: float,
    held: Held = "t/W",
) -> SolvedTip:
    """Return a tip from few direct solutions, by Newton steps with the slope of the map.

    The error that a step leaves is that of the slope times the step. It ends with a step below
    0.5% of the L/W.

    Parameters
    ----------
    guess : Tip
        Found between the L/W of a map.
    ridge : callable
        `RidgeOfLaw`.
    between : callable
        `interpolated`, for the slope.
    thickness : float
        t/W or t/L.
    held : {'t/W', 't/L'}

    Raises
    ------
    ArithmeticError
        If it is not found.
    """
    aspect, strain = guess
    width = _NEAR * aspect
    ahead, behind = (
        _excess(
            between(guess.aspect + side, strain).thickness, guess.aspect + side, thickness, held
        )
        for side in (width, -width)
    )
    slope = (ahead - behind) / (2.0 * width)
    for _ in range(_MAX_CORRECTIONS):
        highest, strain = ridge(aspect, strain)
        step = -_excess(highest, aspect, thickness, held) / slope if slope != 0.0 else np.inf
        if not abs(step) < 0.2 * aspect:
            break
        aspect += step
        if abs(step) < _NEAR * aspect:
            return SolvedTip(Tip(aspect, strain), step / aspect)
    raise ArithmeticError(f"no tip is found near L/W = {guess.aspect:.4g}")


@dataclass(frozen=True)
class RidgeOfLaw:
    """The largest tau_1/W over strain, computed on the meshes of maps (`map_grid`).

    Parameters
    ----------
    law : Law
    settings : PlanarSettings
        Bending law and parity.
    mesh : MeshSettings
    largest : float
        Strain beyond which no maximum is looked for.
    """

    law: Law
    settings: PlanarSettings = field(default_factory=PlanarSettings)
    mesh: MeshSettings = field(default_factory=MeshSettings)
    largest: float = 1.0

    def __call__(self, aspect: float, expected: float) -> Ridge:
        """Return the largest tau_1/W of a L/W, near the strain where it is expected."""
        curve = CriticalCurve(Space(map_grid(aspect, self.mesh)), self.law, self.settings)
        strains = {min(factor * expected, self.largest) for factor in _BESIDE}
        return ridge_of(curve, sorted(strains))


def _excess(highest: float, aspect: float, thickness: float, held: Held) -> float:
    """Return by how much tau_1^2 exceeds t^2, in units of t^2: smooth in L/W."""
    given = thickness * aspect if held == "t/L" else thickness
    return (highest / given) ** 2 - 1.0


def _tip(
    known: dict[float, Ridge],
    ridge: Callable[[float, float], Ridge],
    thickness: float,
    held: Held,
) -> Tip:
    """Refine a tip between two L/W by a safeguarded secant; what is computed becomes known."""
    low, high = sorted(known)
    excess = {a: _excess(known[a].thickness, a, thickness, held) for a in known}
    last = np.inf
    for _ in range(_MAX_STEPS):
        one, other = sorted(excess, key=lambda a: abs(excess[a]))[:2]
        rise = excess[other] - excess[one]
        guess = one - excess[one] * (other - one) / rise if rise != 0.0 else one
        if not low < guess < high:
            guess = 0.5 * (low + high)
        strain = float(np.interp(guess, [low, high], [known[low].strain, known[high].strain]))
        if min(abs(guess - last), high - low) < _TOLERANCE * guess:
            return Tip(guess, strain)
        last = guess
        known[guess] = ridge(guess, strain)
        excess[guess] = _excess(known[guess].thickness, guess, thickness, held)
        if (excess[guess] > 0.0) == (excess[high] > 0.0):
            high = guess
        else:
            low = guess
    return Tip(guess, strain)
