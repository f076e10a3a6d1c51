"""How the two clamps are set: where an experiment's clamps are shifted, turned or twisted a little.

Positions are in units of W, angles in radians. The right clamp is the one at X = L/2.
"""

from dataclasses import dataclass, fields
from typing import NamedTuple

import numpy as np

from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import ANGLE, SHIFT


class End(NamedTuple):
    """Where a clamp holds its end of the sheet.

    Parameters
    ----------
    centre : (3,) array
        Deformed position of the middle of the end.
    line : (3,) array
        Unit vector along the clamp; the end is held straight and unstretched.
    normal : (3,) array
        Unit normal of the sheet at the clamp: the sheet leaves the clamp within its plane.
    """

    centre: Array
    line: Array
    normal: Array


@dataclass(frozen=True)
class Clamps:
    """Errors of the two clamps, all zero where they are perfect.

    Parameters
    ----------
    shear : float
        Shift of the right clamp against the left one across the pull, in units of W; half of it is
        put on each.
    rotate : float
        Turn of the right clamp in the plane of the sheet about its own centre, in radians.
    twist : float
        Turn of the right clamp against the left one about the axis of the pull, in radians. Half of
        it is put on each, so that the middle of the sheet stays level.
    pitch : float
        Turn of the right clamp about its own line, in radians: the slope of the sheet there.
    lift : float
        Shift of the right clamp against the left one out of the plane, in units of W; half of it is
        put on each.

    Raises
    ------
    ValueError
        If a number is not allowed; one line.
    """

    shear: float = 0.0
    rotate: float = 0.0
    twist: float = 0.0
    pitch: float = 0.0
    lift: float = 0.0

    def __post_init__(self) -> None:
        for item in fields(self):
            value, limits = getattr(self, item.name), CLAMP_LIMITS[item.name]
            if value not in limits:
                raise ValueError(f"{item.name} = {value:g}: must be {limits}")

    @property
    def perfect(self) -> bool:
        """Whether nothing is shifted or turned."""
        return self == Clamps()

    @property
    def planar(self) -> bool:
        """Whether the ends stay in the plane of the sheet, so that there is a flat state."""
        return self.twist == self.pitch == self.lift == 0.0

    def in_plane(self) -> "Clamps":
        """Return the same clamps put back into the plane of the sheet."""
        return Clamps(self.shear, self.rotate)

    def end(self, side: float, length: float) -> End:
        """Return where a clamp holds its end.

        Parameters
        ----------
        side : {-1, 1}
            Left or right.
        length : float
            L' of the stretched sheet in units of W.
        """
        centre = 0.5 * side * np.array([length, self.shear, self.lift])
        right = 1.0 if side > 0.0 else 0.0
        turn = _turn(2, right * self.rotate) @ _turn(0, 0.5 * side * self.twist)
        frame = turn @ _turn(1, -right * self.pitch)
        return End(centre, frame[:, 1], frame[:, 2])

    def keep(self, signs: tuple[int, int, int]) -> bool:
        """Return whether the clamps are the same after changes of sign of x, y and z.

        Parameters
        ----------
        signs : (int, int, int)
            1 or -1 for each direction; (-1, 1, 1) swaps the two clamps.
        """
        x, y, z = signs
        single = self.rotate != 0.0 or self.pitch != 0.0
        if x < 0 and single:
            return False
        kept = (
            (self.shear, x * y),
            (self.rotate, x * y),
            (self.twist, x * y * z),
            (self.pitch, x * z),
            (self.lift, x * z),
        )
        return all(sign > 0 for value, sign in kept if value != 0.0)


CLAMP_LIMITS = {"shear": SHIFT, "rotate": ANGLE, "twist": ANGLE, "pitch": ANGLE, "lift": SHIFT}


def _turn(axis: int, angle: float) -> Array:
    """Return the matrix of a turn about an axis."""
    matrix = np.eye(3)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix[i, i] = matrix[j, j] = np.cos(angle)
    matrix[i, j], matrix[j, i] = -np.sin(angle), np.sin(angle)
    return matrix
