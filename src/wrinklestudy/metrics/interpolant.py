"""Deformed sheets as bicubic Hermite fields on a tensor grid: evaluation and unfolding.

The interpolant is the finite element function itself, so that what is measured on it does not
depend on where the nodes lie (the nodes alone miss a wrinkle's peak by up to 8%).
"""

from dataclasses import dataclass, replace

import numpy as np

from wrinklestudy.fem.boundary import NO_MIRRORS, Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.hermite import hermite_curve
from wrinklestudy.typing import Array


@dataclass(frozen=True, eq=False)
class DeformedSheet:
    """The deformed sheet as it was solved: on its grid, with its mirrors.

    Parameters
    ----------
    grid : Grid
        Grid lines in units of W.
    nodes : ndarray, shape (3, 4, nx + 1, ny + 1)
        Deformed x, y, z in units of W: value, d/dX, d/dY, d2/dXdY at the nodes.
    symmetry : Symmetry
        Mirrors that bound the grid.
    """

    grid: Grid
    nodes: Array
    symmetry: Symmetry

    def unfolded(self) -> "DeformedSheet":
        """Return the whole sheet, without mirrors."""
        y, nodes = self.symmetry.unfold_across(self.grid.y, self.nodes)
        x, nodes = self.symmetry.unfold_along(self.grid.x, nodes)
        return DeformedSheet(Grid(x, y), nodes, NO_MIRRORS)

    def flattened(self) -> "DeformedSheet":
        """Return the same sheet with z = 0."""
        nodes = self.nodes.copy()
        nodes[2] = 0.0
        return replace(self, nodes=nodes)

    def evaluate(self, x: Array, y: Array, dx: int = 0, dy: int = 0) -> Array:
        """Return the deformed position or a derivative of it, (3, m, n), see `evaluate`."""
        return evaluate(self.grid, self.nodes, x, y, dx, dy)


def evaluate(grid: Grid, nodes: Array, x: Array, y: Array, dx: int = 0, dy: int = 0) -> Array:
    """Return a bicubic Hermite field, or a derivative of it, on a tensor grid of points.

    Parameters
    ----------
    grid : Grid
        Its lines increase.
    nodes : ndarray, shape (..., 4, nx + 1, ny + 1)
        Value, d/dX, d/dY, d2/dXdY at the nodes.
    x, y : ndarray, shapes (m,) and (n,)
        Reference coordinates of the points.
    dx, dy : {0, 1, 2}
        Orders of the derivatives d^dx/dX^dx d^dy/dY^dy.

    Returns
    -------
    ndarray, shape (..., m, n)
    """
    # A tensor product: first values and Y-slopes, each cubic Hermite along X.
    value, slope_x, slope_y, mixed = np.moveaxis(nodes, -3, 0).swapaxes(-1, -2)
    along = hermite_curve(grid.x, value, slope_x, x, dx)
    slope_along = hermite_curve(grid.x, slope_y, mixed, x, dx)
    return hermite_curve(grid.y, along.swapaxes(-1, -2), slope_along.swapaxes(-1, -2), y, dy)


def subdivided(lines: Array, per_cell: int) -> Array:
    """Return grid lines with every cell cut into ``per_cell`` equal parts, the old lines kept."""
    cells = len(lines) - 1
    steps = np.arange(cells * per_cell + 1) / per_cell
    return np.interp(steps, np.arange(cells + 1), lines)
