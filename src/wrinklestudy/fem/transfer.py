"""Fields and grids from one mesh to another."""

import numpy as np

from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.hermite import hermite_curve
from wrinklestudy.fem.space import Space
from wrinklestudy.typing import Array


def transferred(field: Array, source: Space, target: Space) -> Array:
    """Return the field of a target space that interpolates one of a source space.

    Value, slopes and mixed derivative at the nodes of the target are those of the Hermite
    interpolant of the source, so that nested grids lose nothing.

    Parameters
    ----------
    field : (..., size) array
        Degrees of freedom on the source.
    source, target : Space
        On grids of the same rectangle.
    """
    # A tensor product: first the lines along x, with x last, then those across.
    nodes = np.moveaxis(source.nodes_from_field(field), -3, 0).swapaxes(-1, -2)
    value, slope_x, slope_y, mixed = nodes
    along = (source.grid.x, target.grid.x)
    halves = (*_along(*along, value, slope_x), *_along(*along, slope_y, mixed))
    value, slope_x, slope_y, mixed = (half.swapaxes(-1, -2) for half in halves)
    across = (source.grid.y, target.grid.y)
    value, slope_y = _along(*across, value, slope_y)
    slope_x, mixed = _along(*across, slope_x, mixed)
    return target.field_from_nodes(np.stack([value, slope_x, slope_y, mixed], axis=-3))


def _along(lines: Array, wanted: Array, value: Array, slope: Array) -> tuple[Array, Array]:
    """Return value and slope at other grid lines along the last axis."""
    first, second = (hermite_curve(lines, value, slope, wanted, order) for order in (0, 1))
    return first, second


def coarsened(grid: Grid, along: int, across: int) -> Grid:
    """Return a grid of the same rectangle and grading with at most so many cells."""
    return Grid(_fewer(grid.x, along), _fewer(grid.y, across))


def _fewer(lines: Array, count: int) -> Array:
    """Return at most ``count + 1`` grid lines spaced as some are."""
    if len(lines) <= count + 1:
        return lines
    places = np.linspace(0.0, len(lines) - 1.0, count + 1)
    return np.interp(places, np.arange(len(lines)), lines)
