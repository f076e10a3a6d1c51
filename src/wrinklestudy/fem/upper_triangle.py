"""Symmetric matrices that are given by their upper triangle, in CSR form."""

import numpy as np
from scipy import sparse

from wrinklestudy.typing import Array


def symmetric(upper: sparse.csr_array) -> sparse.csr_array:
    """Return the whole symmetric matrix from its upper triangle."""
    whole = upper + upper.T - sparse.diags_array(upper.diagonal())
    return sparse.csr_array(whole)


def multiply(upper: sparse.csr_array, vector: Array) -> Array:
    """Return the product of a symmetric matrix, given by its upper triangle, and a vector."""
    product: Array = upper @ vector + upper.T @ vector
    diagonal = upper.diagonal()
    product -= (diagonal if vector.ndim == 1 else diagonal[:, None]) * vector
    return product


def backward_error(upper: sparse.csr_array, solution: Array, rhs: Array) -> float:
    r"""Return how far a solution is from satisfying K x = b.

    .. math:: |S (b - K x)| / (|S^{-1} x| + |S b|)

    in the largest norm, where S K S has a unit diagonal: so that an error in the bending, which is
    t^2 times softer than the stretching, counts as much.

    Parameters
    ----------
    upper : (n, n) sparse array
        Upper triangle of K.
    solution, rhs : (n,) or (n, k) arrays
        x and b.

    Returns
    -------
    float
        The largest of all right-hand sides; NaN where a number is not finite.
    """
    scale = _unit_scale(upper)
    if rhs.ndim > 1:
        scale = scale[:, None]
    left = np.abs(scale * (rhs - multiply(upper, solution))).max(axis=0)
    size = np.abs(solution / scale).max(axis=0) + np.abs(scale * rhs).max(axis=0)
    return float(np.max(left / np.where(size == 0.0, 1.0, size), initial=0.0))


def _unit_scale(upper: sparse.csr_array) -> Array:
    """Return the factors of rows and columns that give a matrix a diagonal of ones."""
    diagonal = np.abs(upper.diagonal())
    scale: Array = 1.0 / np.sqrt(np.where(diagonal > 0, diagonal, 1.0))
    return scale


def scaled(upper: sparse.csr_array) -> tuple[sparse.csr_array, Array]:
    """Scale rows and columns to a unit diagonal: bending is t^2 times softer than stretching.

    Returns
    -------
    upper : (n, n) sparse array
        Upper triangle of S K S.
    scale : (n,) array
        The diagonal of S.
    """
    scale = _unit_scale(upper)
    rows = np.repeat(scale, np.diff(upper.indptr))
    data = upper.data * rows * scale[upper.indices]
    return sparse.csr_array((data, upper.indices, upper.indptr), shape=upper.shape), scale
