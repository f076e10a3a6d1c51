"""Quantities of the whole sheet rather than of its mid-line."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.metrics.interpolant import DeformedSheet, evaluate, subdivided
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import FLAP

_SAMPLES_PER_CELL = 8
_REFINEMENTS = 4


@dataclass(frozen=True)
class SheetPeak:
    """The largest deflection over the whole sheet, and where it is.

    Parameters
    ----------
    amplitude : float
        Largest |z| in units of W.
    x, y : float
        Reference coordinates of the point in the part that was solved, in units of W.
    """

    amplitude: float
    x: float
    y: float


@dataclass(frozen=True)
class Envelope:
    """How long and how high the wrinkles are, without the strips of width `FLAP` at the clamps.

    Parameters
    ----------
    amplitude : float
        Largest |z| in units of W.
    x : float
        Reference coordinate along the pull where that is, in units of W.
    length, deformed_length : float
        Length along the pull over which the largest |z| across the sheet is above half of its
        maximum, in units of W: of the undeformed sheet, and of the deformed mid-line above it. Two
        zones of wrinkles count together, without what lies between them.
    """

    amplitude: float
    x: float
    length: float
    deformed_length: float


@dataclass(frozen=True)
class SampledSurface:
    """The full deformed sheet, sampled.

    Parameters
    ----------
    position : ndarray, shape (3, m, n)
        Deformed x, y, z in units of W.
    normal : ndarray, shape (3, m, n)
        Unit normal, pointing up.
    reference_x, reference_y : ndarray, shapes (m,) and (n,)
        Reference coordinates of the samples in units of W.
    """

    position: Array
    normal: Array
    reference_x: Array
    reference_y: Array


def sheet_peak(sheet: DeformedSheet) -> SheetPeak:
    """Return the largest |z| of the interpolant over the sheet.

    If the largest deflection is not near x = 0, take care: a flap at the corner where clamp and
    free edge meet is no wrinkle.
    """
    grid, deflection = sheet.grid, sheet.nodes[2]
    x = subdivided(grid.x, _SAMPLES_PER_CELL)
    y = subdivided(grid.y, _SAMPLES_PER_CELL)
    for _ in range(_REFINEMENTS):
        height = np.abs(evaluate(grid, deflection, x, y))
        i, j = np.unravel_index(int(np.argmax(height)), height.shape)
        best = SheetPeak(float(height[i, j]), float(x[i]), float(y[j]))
        x, y = _around(x, int(i)), _around(y, int(j))
    return best


def envelope(sheet: DeformedSheet) -> Envelope:
    """Return the lengths over which the wrinkles of a sheet are above half of their height."""
    x = subdivided(sheet.grid.x, _SAMPLES_PER_CELL)
    y = subdivided(sheet.grid.y, _SAMPLES_PER_CELL)
    height = np.abs(evaluate(sheet.grid, sheet.nodes[2], x, y)).max(axis=1)
    along = evaluate(sheet.grid, sheet.nodes[0], x, np.array([0.0]))[:, 0]
    whole = sheet.unfolded().grid.x
    copies = np.ptp(whole) / np.ptp(sheet.grid.x)
    height[np.abs(x) > np.abs(whole).max() - FLAP] = 0.0
    top = int(np.argmax(height))
    level = 0.5 * float(height[top])
    lengths = (copies * _length_above(place, height, level) for place in (x, along))
    return Envelope(2.0 * level, float(x[top]), *lengths)


def _length_above(place: Array, height: Array, level: float) -> float:
    """Return the length over which a piecewise linear height is above a level."""
    over = height - level
    above, all_of_it = np.maximum(over, 0.0), np.abs(over)
    share = (above[:-1] + above[1:]) / (all_of_it[:-1] + all_of_it[1:])
    return float(share @ np.diff(place))


def _around(points: Array, k: int) -> Array:
    """Return 17 points between the neighbours of point ``k``."""
    low, high = points[max(k - 1, 0)], points[min(k + 1, len(points) - 1)]
    return np.linspace(low, high, 2 * _SAMPLES_PER_CELL + 1)


def full_surface(sheet: DeformedSheet, per_cell: tuple[int, int]) -> SampledSurface:
    """Return the whole deformed sheet and its unit normals.

    n = x,X x x,Y / |x,X x x,Y| from the derivatives of the interpolant.

    Parameters
    ----------
    sheet : DeformedSheet
    per_cell : tuple of int
        Samples per cell along the pull and across.
    """
    whole = sheet.unfolded()
    x, y = subdivided(whole.grid.x, per_cell[0]), subdivided(whole.grid.y, per_cell[1])
    along, across = whole.evaluate(x, y, dx=1), whole.evaluate(x, y, dy=1)
    normal = np.cross(along, across, axis=0)
    normal /= np.linalg.norm(normal, axis=0)
    return SampledSurface(whole.evaluate(x, y), normal, x, y)
