"""Bicubic Hermite fields on a tensor grid: evaluation, and the full sheet from a quarter.

A field has the shape ``(..., 4, nx + 1, ny + 1)``: value, d/dX, d/dY, d2/dXdY at the nodes. The
interpolant is the finite element function itself, so what is measured on it does not depend on
where the nodes happen to lie (nodes alone miss a wrinkle's peak by up to 8%).
"""

import numpy as np

from wrinklestudy.typing import Array

# Parity of the deformed x, y, z under X -> -X: x is odd, y and z are even.
_ALONG = (-1.0, 1.0, 1.0)
# The same under Y -> -Y, by the parity of the wrinkle.
_ACROSS = {"antisymmetric": (1.0, -1.0, -1.0), "symmetric": (1.0, -1.0, 1.0)}


def evaluate(
    grid_x: Array, grid_y: Array, field: Array, x: Array, y: Array, dx: int = 0, dy: int = 0
) -> Array:
    """Return a bicubic Hermite field, or a derivative of it, on a tensor grid of points.

    Parameters
    ----------
    grid_x, grid_y : ndarray, shapes (nx + 1,) and (ny + 1,)
        Node coordinates, increasing.
    field : ndarray, shape (..., 4, nx + 1, ny + 1)
        Value, d/dX, d/dY, d2/dXdY at the nodes.
    x, y : ndarray, shapes (m,) and (n,)
        Reference coordinates of the points.
    dx, dy : int
        Orders of the derivatives d^dx/dX^dx d^dy/dY^dy.

    Returns
    -------
    ndarray, shape (..., m, n)
    """
    from scipy.interpolate import CubicHermiteSpline  # here for the time that it takes

    # A tensor product: the values and the Y-slopes are each cubic Hermite along X first.
    along = CubicHermiteSpline(
        grid_x, field[..., [0, 2], :, :], field[..., [1, 3], :, :], axis=field.ndim - 2
    )(x, dx)
    across = CubicHermiteSpline(
        grid_y, along[..., 0, :, :], along[..., 1, :, :], axis=along.ndim - 2
    )
    return np.asarray(across(y, dy))


def subdivided(grid: Array, per_cell: int) -> Array:
    """Return the grid with every cell cut into ``per_cell`` equal parts, nodes included."""
    cells = len(grid) - 1
    steps = np.arange(cells * per_cell + 1) / per_cell
    return np.interp(steps, np.arange(cells + 1), grid)


def unfolded_across(grid_y: Array, position: Array, parity: str) -> tuple[Array, Array]:
    """Return the grid and the deformed position over the full width from the half 0 <= Y.

    Parameters
    ----------
    grid_y : ndarray, shape (ny + 1,)
        From 0 (mid-line) to 1/2 (free edge).
    position : ndarray, shape (3, 4, nx + 1, ny + 1)
        Deformed x, y, z.
    parity : str
        ``antisymmetric`` (z odd in Y) or ``symmetric`` (z even in Y).

    Returns
    -------
    ndarray, shape (2 ny + 1,)
        Grid across.
    ndarray, shape (3, 4, nx + 1, 2 ny + 1)
        Deformed x, y, z.

    Raises
    ------
    ValueError
        If the parity has another name.
    """
    if parity not in _ACROSS:
        raise ValueError(f"parity = {parity!r}: must be one of {', '.join(_ACROSS)}")
    sign = np.multiply.outer(_ACROSS[parity], (1.0, 1.0, -1.0, -1.0))[:, :, None, None]
    mirrored = sign * position[..., :0:-1]
    return (
        np.concatenate([-grid_y[:0:-1], grid_y]),
        np.concatenate([mirrored, position], axis=3),
    )


def unfolded(
    grid_x: Array, grid_y: Array, position: Array, parity: str
) -> tuple[Array, Array, Array]:
    """Return grid and deformed position of the full sheet from the solved quarter.

    Parameters
    ----------
    grid_x, grid_y : ndarray, shapes (nx + 1,) and (ny + 1,)
        From the centre to the clamp and to the free edge.
    position : ndarray, shape (3, 4, nx + 1, ny + 1)
        Deformed x, y, z of the quarter.
    parity : str
        ``antisymmetric`` or ``symmetric``.

    Returns
    -------
    ndarray, shape (2 nx + 1,)
        Grid along the pull.
    ndarray, shape (2 ny + 1,)
        Grid across.
    ndarray, shape (3, 4, 2 nx + 1, 2 ny + 1)
        Deformed x, y, z.
    """
    grid_y, position = unfolded_across(grid_y, position, parity)
    sign = np.multiply.outer(_ALONG, (1.0, -1.0, 1.0, -1.0))[:, :, None, None]
    mirrored = sign * position[:, :, :0:-1]
    return (
        np.concatenate([-grid_x[:0:-1], grid_x]),
        grid_y,
        np.concatenate([mirrored, position], axis=2),
    )
