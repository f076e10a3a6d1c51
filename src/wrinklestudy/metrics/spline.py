"""The cubic spline z(y) through the points of a profile, its turning points and its zeros.

scipy.interpolate has such splines too, but to import it takes a tenth of the time of a solve.
"""

from dataclasses import dataclass
from typing import Self

import numpy as np
from scipy.linalg import solve_banded

from wrinklestudy.fem.hermite import hermite_curve
from wrinklestudy.typing import Array

_HALVINGS = 60  # of a bracket, to rounding


@dataclass(frozen=True, eq=False)
class ProfileSpline:
    """Cubic pieces that meet with the same slope.

    Parameters
    ----------
    y, z, slope : ndarray, shape (n,)
        Where the pieces meet, increasing, and values and slopes there.
    """

    y: Array
    z: Array
    slope: Array

    @classmethod
    def through(cls, y: Array, z: Array) -> Self:
        """Return the spline through points, "not-a-knot": the two pieces at either end are one.

        Source: C. de Boor, A Practical Guide to Splines (2001), chapter IV.

        Parameters
        ----------
        y, z : ndarray, shape (n,), n >= 4
        """
        wide = np.diff(y)
        rise = np.diff(z) / wide
        bands, right = np.zeros((3, len(y))), np.empty(len(y))
        bands[0, 2:], bands[2, :-2] = wide[:-1], wide[1:]
        bands[1, 1:-1] = 2.0 * (wide[:-1] + wide[1:])
        right[1:-1] = 3.0 * (wide[1:] * rise[:-1] + wide[:-1] * rise[1:])
        bands[0, 1], bands[1, 0] = wide[0] + wide[1], wide[1]
        bands[2, -2], bands[1, -1] = wide[-1] + wide[-2], wide[-2]
        right[0] = _end(wide[0], wide[1], rise[0], rise[1])
        right[-1] = _end(wide[-1], wide[-2], rise[-1], rise[-2])
        return cls(y, z, solve_banded((1, 1), bands, right))

    def __call__(self, y: Array, derivative: int = 0) -> Array:
        """Return z or a derivative of it at points, shape ``y.shape``."""
        return hermite_curve(self.y, self.z, self.slope, y, derivative)

    def turning_points(self) -> Array:
        """Return where dz/dy changes its sign, in increasing y."""
        # dz/dy = start + 2 b s + a s^2 over the piece 0 <= s <= 1 is monotonic up to s = -b/a.
        wide = np.diff(self.y)
        rise = np.diff(self.z) / wide
        start, end = self.slope[:-1], self.slope[1:]
        a, b = 3.0 * (start + end - 2.0 * rise), 3.0 * rise - 2.0 * start - end
        inside = (a * b < 0.0) & (np.abs(b) < np.abs(a))
        vertices = (self.y[:-1] - wide * b / np.where(inside, a, 1.0))[inside]
        return self._changes(np.union1d(self.y, vertices), 1)

    def zeros(self) -> Array:
        """Return where z changes its sign, in increasing y."""
        return self._changes(np.union1d(self.y, self.turning_points()), 0)

    def _changes(self, marks: Array, derivative: int) -> Array:
        """Return where a derivative that is monotonic between the marks changes its sign.

        A sign counts where there is one, so that a change at a mark, or over pieces where the
        derivative is zero throughout, is found once.
        """
        values = self(marks, derivative)
        marks, signs = marks[values != 0.0], np.sign(values[values != 0.0])
        change = np.flatnonzero(signs[:-1] != signs[1:])
        low, high, sign = marks[change], marks[change + 1], signs[change]
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            before = sign * self(middle, derivative) > 0.0
            low, high = np.where(before, middle, low), np.where(before, high, middle)
        return 0.5 * (low + high)


def _end(wide: float, next_wide: float, rise: float, next_rise: float) -> float:
    """Return the right side of the condition that the first piece goes on into the next."""
    both = wide + next_wide
    return ((wide + 2.0 * both) * next_wide * rise + wide**2 * next_rise) / both
