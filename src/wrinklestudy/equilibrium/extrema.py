"""Maxima and minima of a curve that is known at some strains and costly at others."""

from collections.abc import Callable
from typing import NamedTuple

_TOLERANCE = 1.0e-5  # of the square of the curve, in parts of it
_MAX_EVALUATIONS = 60
_SHRINK = 0.5  # a bracket that two steps do not shrink this much is halved
_NARROW = 0.1  # part of the strain: in such a bracket a parabola is believed
_SAME = 1.0e-3  # strains nearer than this part of a bracket count as the same


class _Parabola(NamedTuple):
    """Parabola through three points of a function: p + (x - a) (q + r (x - b))."""

    a: float
    b: float
    p: float
    q: float
    r: float

    def at(self, x: float) -> float:
        return self.p + (x - self.a) * (self.q + self.r * (x - self.b))

    @property
    def vertex(self) -> float:
        return 0.5 * (self.a + self.b) - 0.5 * self.q / self.r if self.r else self.b


def inner_extrema(table: dict[float, float], sign: float) -> list[float]:
    """Return the strains of a table where it has a maximum (sign 1) or a minimum (-1) inside."""
    strains = sorted(table)
    heights = [sign * table[strain] for strain in strains]
    return [
        strains[k]
        for k in range(1, len(strains) - 1)
        if heights[k - 1] < heights[k] >= heights[k + 1]
    ]


def refine(
    curve: Callable[[float], float], table: dict[float, float], place: float, sign: float
) -> float:
    """Refine an inner extremum of a table; what is computed joins it.

    Steps to the vertex of the parabola through three points of the square of the curve, with
    bisection where they are slow, as at a kink. It ends where a parabola in a narrow bracket, or
    one that foretold the last value, promises no more than a hundred-thousandth.

    Parameters
    ----------
    curve : callable
        The curve, >= 0.
    table : dict
        Values of the curve by strain.
    place : float
        The strain in the table; see `inner_extrema`.
    sign : float
        1 for a maximum, -1 for a minimum.

    Returns
    -------
    float
        Strain of the extremum in the table.
    """

    def height(strain: float) -> float:
        return sign * table[strain] ** 2

    strains = sorted(table)
    k = strains.index(place)
    low, high = strains[k - 1], strains[k + 1]
    foretold, widths = high - low < _NARROW * place, [2.0 * (high - low)] * 2
    for _ in range(_MAX_EVALUATIONS):
        parabola = _through(low, place, high, height)
        tolerance = _TOLERANCE * max(abs(height(place)), abs(height(low)), abs(height(high)))
        if foretold and parabola.at(parabola.vertex) - height(place) <= tolerance:
            break
        strain = parabola.vertex
        slow = high - low > _SHRINK * widths[-2]
        if slow or abs(strain - place) < _SAME * (high - low) or not low < strain < high:
            middle = low if place - low > high - place else high
            strain = 0.5 * (place + middle)
        if strain in (low, place, high):
            break
        table[strain] = curve(strain)
        foretold = abs(parabola.at(strain) - height(strain)) <= tolerance
        widths.append(high - low)
        if height(strain) > height(place):
            low, place, high = (low, strain, place) if strain < place else (place, strain, high)
        else:
            low, high = (strain, high) if strain < place else (low, strain)
    return place


def _through(a: float, b: float, c: float, height: Callable[[float], float]) -> _Parabola:
    slope = (height(b) - height(a)) / (b - a)
    bend = ((height(c) - height(b)) / (c - b) - slope) / (c - a)
    return _Parabola(a, b, height(a), slope, bend)
