"""The relaxed energy of a sheet that wrinkles at no cost: what tension field theory minimises.

Where a sheet is narrower, across its larger stretch, than uniaxial tension alone would make it,
fine wrinkles take up the excess width and only the tension along them costs energy; where neither
direction is stretched it is slack. With squared principal stretches a >= b of the in-plane metric
and the natural width n(lambda), the transverse stretch under uniaxial tension, the energy is

    taut      b >= n^2(sqrt a)   W(a, b)
    wrinkled  b <  n^2(sqrt a)   w(a) = W(a, n^2(sqrt a))
    slack     a <= 1             0

Source: A. C. Pipkin, IMA J. Appl. Math. 36, 85 (1986); D. J. Steigmann, Proc. R. Soc. Lond. A 429,
141 (1990).
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from wrinklestudy.mechanics.laws import Law
from wrinklestudy.typing import Array, Mask


def check_relaxed(law: Law | type[Law]) -> None:
    """Refuse a law that has no relaxed energy.

    Raises
    ------
    ValueError
        If its strain is linear in the plane: its natural width is that of no metric.
    """
    if law.linear_in_plane:
        raise ValueError(f"law {law.name}: has no tension field, its strain is linear in the plane")


class Stretches(NamedTuple):
    """Principal stretches of a metric and the direction of the larger one, (...) each."""

    larger: Array  # a, its square
    smaller: Array  # b
    along: Array  # cosine and sine of the direction of the larger stretch, (2, ...)


def principal_stretches(metric: Array) -> Stretches:
    """Return the squared principal stretches of an in-plane metric, (3, ...), and the direction."""
    mean, half = 0.5 * (metric[0] + metric[1]), 0.5 * (metric[0] - metric[1])
    radius = np.hypot(half, metric[2])
    larger = mean + radius
    # det / a and not a difference, which would lose digits where b is small
    smaller = (metric[0] * metric[1] - metric[2] ** 2) / larger
    angle = 0.5 * np.arctan2(metric[2], half)
    return Stretches(larger, smaller, np.stack([np.cos(angle), np.sin(angle)]))


class Regions(NamedTuple):
    """Where a sheet is wrinkled and where it is slack, (...) each; it is taut elsewhere."""

    wrinkled: Mask
    slack: Mask


@dataclass(frozen=True)
class RelaxedLaw:
    """The relaxed energy of a law, with a remainder of its own: (1 - delta) W_relaxed + delta W.

    Parameters
    ----------
    law : Law
        Dimensionless material law.
    remainder : float
        delta, 0 for tension field theory, 1 for the law itself.
    """

    law: Law
    remainder: float = 0.0

    @property
    def linear_in_plane(self) -> bool:
        """As of the law; `check_relaxed` refuses laws of a linear strain."""
        return self.law.linear_in_plane

    def natural_square(self, larger: Array) -> Array:
        """Return n^2, the squared width under uniaxial tension; 0 where the law leaves none."""
        with np.errstate(invalid="ignore"):
            return np.nan_to_num(self.law.natural_width(np.sqrt(larger))) ** 2

    def regions(self, stretches: Stretches) -> Regions:
        """Return where a sheet with these stretches is wrinkled and where it is slack."""
        wrinkled = stretches.smaller < self.natural_square(stretches.larger)
        slack = (stretches.larger <= 1.0) & (stretches.smaller < 1.0)
        return Regions(wrinkled & ~slack, slack)

    def energy(self, metric: Array) -> Array:
        """Return the energy per reference volume, shape ``(...)``."""
        stretches = principal_stretches(metric)
        regions = self.regions(stretches)
        energy = self.law.energy(metric)
        relaxed = np.where(regions.slack, 0.0, energy)
        relaxed[regions.wrinkled] = self.law.energy(self._uniaxial(stretches, regions.wrinkled))
        return (1.0 - self.remainder) * relaxed + self.remainder * energy

    def derivatives(self, metric: Array) -> tuple[Array, Array]:
        """Return dW/dg of shape ``(3, ...)`` and d2W/dg2 of shape ``(3, 3, ...)``."""
        stretches = principal_stretches(metric)
        regions = self.regions(stretches)
        stress, tangent = self.law.derivatives(metric)
        stress[:, regions.slack] *= self.remainder
        tangent[:, :, regions.slack] *= self.remainder
        where = regions.wrinkled
        tension, slope = self._wrinkled(stretches, where)
        kept = self.remainder
        stress[:, where] = (1.0 - kept) * tension + kept * stress[:, where]
        tangent[:, :, where] = (1.0 - kept) * slope + kept * tangent[:, :, where]
        return stress, tangent

    def _uniaxial(self, stretches: Stretches, where: Mask) -> Array:
        """Return the metric, in principal axes, of uniaxial tension at the larger stretches."""
        larger = stretches.larger[where]
        return np.stack([larger, self.natural_square(larger), np.zeros_like(larger)])

    def _wrinkled(self, stretches: Stretches, where: Mask) -> tuple[Array, Array]:
        """Return the derivatives of w(a) with respect to the metric at the wrinkled points.

        With the direction (c, s) of the larger stretch da = (c^2, s^2, 2 c s) . dg and
        d2a = 2/(a - b) (m . dg)^2, where m . dg = dg between the principal axes. As W,b vanishes at
        the natural width, w'(a) = W,a and w''(a) = W,aa - W,ab^2/W,bb.
        """
        natural = self._uniaxial(stretches, where)
        stress, tangent = self.law.derivatives(natural)
        slope = stress[0]
        curvature = tangent[0, 0] - tangent[0, 1] ** 2 / tangent[1, 1]
        c, s = stretches.along[:, where]
        first = np.stack([c * c, s * s, 2.0 * c * s])
        turn = np.stack([-c * s, c * s, c * c - s * s])
        turning = 2.0 * slope / (stretches.larger[where] - stretches.smaller[where])
        hessian = curvature * first[:, None] * first + turning * turn[:, None] * turn
        return slope * first, hessian
