"""The largest value of a curve that is known at a few strains."""

import numpy as np
from numpy.typing import ArrayLike

from wrinklestudy.typing import Array


def peak(strain: ArrayLike, value: ArrayLike) -> tuple[float, float]:
    """Return strain and height of the maximum of a curve, between its samples.

    This is the maximum of the parabola through the largest sample and its two neighbours; it lies
    between them. If a sample beside the largest is NaN (a state that did not converge), the maximum
    is unknown. If the largest sample is the first or the last, it is returned as it is, although
    the maximum may lie beyond it.

    Parameters
    ----------
    strain : array_like, shape (n,)
        Strains, all different, in any order.
    value : array_like, shape (n,)
        The curve, such as A/t: zero where the sheet is flat.

    Returns
    -------
    strain_at_max : float
        NaN if no sample is above zero, so that the curve has no peak, or if the peak is unknown.
    max : float
        0 if no sample is above zero; NaN if the peak is unknown or there are no samples.

    Raises
    ------
    ValueError
        If the shapes differ or a strain occurs twice.

    Examples
    --------
    >>> peak([0.0, 1.0, 3.0], [0.75, 1.0, 0.0])
    (1.0, 1.0)
    """
    x, y = np.asarray(strain, dtype=np.float64), np.asarray(value, dtype=np.float64)
    if x.shape != y.shape or x.ndim != 1:
        raise ValueError(f"strain {x.shape} and value {y.shape}: must be two columns alike")
    order = np.argsort(x)
    x, y = x[order], y[order]
    if (np.diff(x) == 0.0).any():
        raise ValueError("strain: must hold every strain once")
    nan = float("nan")
    if not (y > 0.0).any():
        return nan, 0.0 if len(y) and np.isfinite(y).all() else nan
    top = int(np.nanargmax(y))
    if np.isnan(y[max(top - 1, 0) : top + 2]).any():
        return nan, nan
    if not 0 < top < len(x) - 1:
        return float(x[top]), float(y[top])
    return _vertex(x[top - 1 : top + 2], y[top - 1 : top + 2])


def _vertex(x: Array, y: Array) -> tuple[float, float]:
    """Return the vertex of the parabola through three points, the middle one the highest."""
    # Newton's form around the middle point loses no digits; the curve rises before it, so that
    # the curvature is below zero.
    left, right = (y[1] - y[0]) / (x[1] - x[0]), (y[2] - y[1]) / (x[2] - x[1])
    curvature = (right - left) / (x[2] - x[0])
    slope = left + curvature * (x[1] - x[0])
    shift = -0.5 * slope / curvature
    return float(x[1] + shift), float(y[1] + 0.5 * slope * shift)
