"""Profiles across the sheet: from a computed state or from a laser scan."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.metrics.interpolant import DeformedSheet, subdivided
from wrinklestudy.typing import Array

SAMPLES_PER_CELL = 64
LEAST_POINTS = 8


class FoldedProfileError(ValueError):
    """A cross-section folds over itself, as on a mesh that is far too coarse for its wrinkles."""


@dataclass(frozen=True)
class Profile:
    """A cross-section of the sheet.

    Parameters
    ----------
    y : ndarray, shape (n,)
        Deformed coordinate across the sheet, strictly increasing, over the full width.
    z : ndarray, shape (n,)
        Deflection, in the unit of ``y``.
    x : ndarray, shape (n,), optional
        Deformed coordinate along the pull (zero on the line half-way between the clamps).
    """

    y: Array
    z: Array
    x: Array | None = None

    def __post_init__(self) -> None:
        """Refuse what is no cross-section.

        Raises
        ------
        ValueError
            If the shapes differ, there are fewer than 8 points, a number is not finite or ``y``
            does not increase.
        """
        if self.y.ndim != 1 or self.y.shape != self.z.shape:
            raise ValueError(f"profile: y {self.y.shape} and z {self.z.shape} must be two columns")
        if len(self.y) < LEAST_POINTS:
            raise ValueError(f"profile: {len(self.y)} points, at least {LEAST_POINTS} are needed")
        if not (np.isfinite(self.y).all() and np.isfinite(self.z).all()):
            raise ValueError("profile: y and z must be finite")
        if not (np.diff(self.y) > 0.0).all():
            raise ValueError("profile: y must increase strictly")


def profile_from_state(
    sheet: DeformedSheet, x: float = 0.0, per_cell: int = SAMPLES_PER_CELL
) -> Profile:
    """Return the cross-section of a computed state on the material line X = ``x``.

    Parameters
    ----------
    sheet : DeformedSheet
    x : float
        Reference coordinate of the line, between -L/2 and L/2; 0 is half-way between the clamps.
    per_cell : int
        Samples of the finite element interpolant per cell.

    Returns
    -------
    Profile
        Over the full width, in units of W, in deformed coordinates.

    Raises
    ------
    ValueError
        If the line is outside the sheet.
    FoldedProfileError
        If y does not increase along it.
    """
    whole = sheet.unfolded()
    end = whole.grid.x[-1]
    if not abs(x) <= end:
        raise ValueError(f"x = {x:g}: must lie between -L/2 and L/2 = {end:g} (in units of W)")
    line = whole.evaluate(np.array([x]), subdivided(whole.grid.y, per_cell))[:, 0, :]
    if not (np.diff(line[1]) > 0.0).all():
        raise FoldedProfileError(
            f"the cross-section at X = {x:g} folds over itself, nothing can be measured on it"
        )
    return Profile(y=line[1], z=line[2], x=line[0])
