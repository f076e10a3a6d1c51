"""What a page shows: sheets with the shapes of their states, maps of tau_1, tension fields."""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.results.tension import TensionRow
from wrinklestudy.typing import Array

_STRAINS = 61  # of a map that is drawn through the curves of sheets


@dataclass(frozen=True, eq=False)
class ShownSheet:
    """A sheet of the page.

    Parameters
    ----------
    sheet : SheetStates
        Its states by strain, and where it is unstable.
    shapes : tuple of DeformedSheet or None
        The shape of each state; None where it did not converge.
    material : str
        What the material is called, without bending law and parity.
    width_mm : float or None
        W, if it is known.
    """

    sheet: SheetStates
    shapes: tuple[DeformedSheet | None, ...] = field(repr=False)
    material: str
    width_mm: float | None = None

    @property
    def wrinkled(self) -> int:
        """How many of its states are wrinkled."""
        return self.sheet.status.count("wrinkled")


@dataclass(frozen=True, eq=False)
class ShownMap:
    """tau_1/W of one model over L/W (rows) and strain (columns); NaN where it is not known.

    Parameters
    ----------
    model : str
        Name of the model.
    aspects, strains : ndarray
    values : ndarray, shape (aspects, strains)
    computed : tuple of (strain, L/W)
        Where it was computed, if the values between are interpolated; else empty.
    """

    model: str
    aspects: Array
    strains: Array
    values: Array
    computed: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True, eq=False)
class Content:
    """All that a page shows.

    Parameters
    ----------
    title, source : str
        Its heading, and where the numbers come from.
    sheets : sequence of ShownSheet
    maps : sequence of ShownMap
        At most one for each model.
    tension : mapping
        Tension fields by `ShownSheet.material`.
    constants : mapping
        The constants of each material in words.
    first : int
        Which sheet is shown first.
    """

    title: str
    source: str
    sheets: Sequence[ShownSheet]
    maps: Sequence[ShownMap] = ()
    tension: Mapping[str, Sequence[TensionRow]] = field(default_factory=dict)
    constants: Mapping[str, str] = field(default_factory=dict)
    first: int = 0


def map_of_points(model: str, points: Iterable[tuple[float, float, float | None]]) -> ShownMap:
    """Return the map of one model from points of both parities, of which the larger counts.

    Parameters
    ----------
    model : str
    points : iterable of (L/W, strain, tau_1/W or None)
    """
    largest: dict[tuple[float, float], float] = {}
    for aspect, strain, tau in points:
        before = largest.get((aspect, strain), math.nan)
        largest[aspect, strain] = float(np.fmax(before, math.nan if tau is None else tau))
    aspects = sorted({aspect for aspect, _ in largest})
    strains = sorted({strain for _, strain in largest})
    values = [[largest.get((aspect, strain), math.nan) for strain in strains] for aspect in aspects]
    return ShownMap(model, np.array(aspects), np.array(strains), np.array(values))


def map_of_curves(
    model: str, curves: Mapping[float, Sequence[tuple[float, float]]], largest: float
) -> ShownMap | None:
    """Return a map through curves tau_1(eps) that were computed at other strains for each L/W.

    Between the strains of a curve tau_1^2, which is smooth at zero strain too, is interpolated;
    beyond them tau_1 follows that of the nearest L/W on both sides, and is not known where one is
    missing.

    Parameters
    ----------
    model : str
    curves : mapping
        Pairs (strain, tau_1/W) by L/W, sorted by strain.
    largest : float
        Strain at which the map ends.
    """
    from scipy.interpolate import PchipInterpolator

    if not curves:
        return None
    strains = np.linspace(0.0, largest, _STRAINS)
    aspects = sorted(curves)
    values = []
    for aspect in aspects:
        known, tau = np.array([(0.0, 0.0), *curves[aspect]]).T
        squared = PchipInterpolator(known, tau**2, extrapolate=False)(strains)
        values.append(np.sqrt(np.maximum(squared, 0.0)))
    table = _continued(np.array(aspects), np.array(values))
    computed = tuple(
        (strain, aspect) for aspect in aspects for strain, _ in curves[aspect] if strain <= largest
    )
    return ShownMap(model, np.array(aspects), strains, table, computed)


def _continued(aspects: Array, values: Array) -> Array:
    """Return a map whose rows go on beyond their last strain in proportion to those around them."""
    filled = values.copy()
    for k in range(1, len(aspects) - 1):
        others = np.arange(len(aspects)) != k
        around = np.array(
            [_between(aspects[k], aspects[others], column[others]) for column in values.T]
        )
        last = int(np.flatnonzero(np.isfinite(values[k]))[-1])
        if around[last] > 0.0:
            filled[k, last + 1 :] = around[last + 1 :] * values[k, last] / around[last]
    return filled


def _between(aspect: float, aspects: Array, values: Array) -> float:
    """Return a value between the nearest known ones, NaN where there is none on one side."""
    known = np.isfinite(values)
    if not known.any():
        return math.nan
    return float(np.interp(aspect, aspects[known], values[known], left=math.nan, right=math.nan))
