"""Cubic Hermite functions of one variable; apart from the element, which loads scikit-fem."""

import numpy as np

from wrinklestudy.typing import Array


def hermite(s: Array, derivative: int) -> Array:
    """Return a derivative of the four cubic Hermite functions on the unit interval.

    Parameters
    ----------
    s : (...) array
        Points in [0, 1].
    derivative : {0, 1, 2}
        Order of the derivative.

    Returns
    -------
    (2, 2, ...) array
        Entry ``[end, order]`` belongs to the value (order 0) or slope (order 1) at the end s = 0
        or 1.
    """
    if derivative == 0:
        rows = (
            (1 - 3 * s**2 + 2 * s**3, s - 2 * s**2 + s**3),
            (3 * s**2 - 2 * s**3, s**3 - s**2),
        )
    elif derivative == 1:
        rows = ((6 * s**2 - 6 * s, 1 - 4 * s + 3 * s**2), (6 * s - 6 * s**2, 3 * s**2 - 2 * s))
    else:
        rows = ((12 * s - 6, 6 * s - 4), (6 - 12 * s, 6 * s - 2))
    return np.array(rows)


def hermite_curve(
    lines: Array, value: Array, slope: Array, points: Array, derivative: int = 0
) -> Array:
    """Return piecewise cubic Hermite functions of one variable, or a derivative of them.

    Parameters
    ----------
    lines : (n,) array
        Where the pieces meet, increasing; the first and last piece go on beyond the ends.
    value, slope : (..., n) arrays
        Values and slopes there.
    points : array
        Where to evaluate.
    derivative : {0, 1, 2}
        Order of the derivative.

    Returns
    -------
    (..., *points.shape) array
    """
    left = np.clip(np.searchsorted(lines, points, side="right") - 1, 0, len(lines) - 2)
    width = np.diff(lines)[left]
    first, second = hermite((points - lines[left]) / width, derivative)
    values = first[0] * value[..., left] + second[0] * value[..., left + 1]
    slopes = first[1] * slope[..., left] + second[1] * slope[..., left + 1]
    total: Array = (values + width * slopes) / width**derivative
    return total
