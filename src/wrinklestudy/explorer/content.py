"""What a page shows: sheets with the shapes of their states, maps of tau_1, tension fields."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.results.maps import MapRow
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


def map_of_rows(model: str, rows: Sequence[MapRow]) -> ShownMap:
    """Return the map of one model from the rows of its tables: of both parities the larger."""
    largest: dict[tuple[float, float], float] = {}
    for row in rows:
        value = math.nan if row.critical_thickness is None else row.critical_thickness
        place = row.aspect, row.strain
        largest[place] = float(np.fmax(largest.get(place, math.nan), value))
    aspects = sorted({aspect for aspect, _ in largest})
    strains = sorted({strain for _, strain in largest})
    values = [[largest.get((aspect, strain), math.nan) for strain in strains] for aspect in aspects]
    return ShownMap(model, np.array(aspects), np.array(strains), np.array(values))


def map_of_curves(
    model: str, curves: Mapping[float, Sequence[tuple[float, float]]], largest: float
) -> ShownMap | None:
    """Return a map through curves tau_1(eps) that were computed at other strains for each L/W.

    Between the strains of a curve tau_1^2, which is smooth at zero strain too, is interpolated;
    beyond them tau_1 is interpolated between the nearest L/W on both sides, and not known where
    one is missing.

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
    table = np.array(values)
    for column in table.T:
        known_here = np.isfinite(column)
        if known_here.any():
            lengths, here = np.array(aspects)[known_here], column[known_here]
            column[:] = np.interp(aspects, lengths, here, left=np.nan, right=np.nan)
    computed = tuple(
        (strain, aspect) for aspect in aspects for strain, _ in curves[aspect] if strain <= largest
    )
    return ShownMap(model, np.array(aspects), strains, table, computed)
