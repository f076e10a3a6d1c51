"""Fields and grids from one mesh to another."""

import numpy as np

from wrinklestudy.fem.grid import Grid
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
    value, slope_x, slope_y, mixed = np.moveaxis(source.nodes_from_field(field), -3, 0)
    x, y = target.grid.x, target.grid.y
    value, slope_x = _along(source.grid.x, value, slope_x, x, -2)
    slope_y, mixed = _along(source.grid.x, slope_y, mixed, x, -2)
    value, slope_y = _along(source.grid.y, value, slope_y, y, -1)
    slope_x, mixed = _along(source.grid.y, slope_x, mixed, y, -1)
    return target.field_from_nodes(np.stack([value, slope_x, slope_y, mixed], axis=-3))


def _along(
    lines: Array, value: Array, slope: Array, wanted: Array, axis: int
) -> tuple[Array, Array]:
    """Return value and slope at other grid lines along an axis."""
    from scipy.interpolate import CubicHermiteSpline

    spline = CubicHermiteSpline(lines, value, slope, axis=axis)
    return spline(wanted), spline(wanted, 1)


def coarsened(grid: Grid, along: int, across: int) -> Grid:
    """Return a grid of the same rectangle and grading with at most so many cells."""
    return Grid(_fewer(grid.x, along), _fewer(grid.y, across))


def _fewer(lines: Array, count: int) -> Array:
    """Return at most ``count + 1`` grid lines spaced as some are."""
    if len(lines) <= count + 1:
        return lines
    places = np.linspace(0.0, len(lines) - 1.0, count + 1)
    return np.interp(places, np.arange(len(lines)), lines)
