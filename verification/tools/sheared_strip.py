"""Mansfield's wrinkled strip: one clamp sheared along the other and moved away from it.

Straight rays of tension run from clamp to clamp. A ray whose cotangent with the strip is c crosses
the mid-line at s; with c' = dc/ds rays at the distance xi from the mid-line are spread by
1 + xi c', so that a ray that carries T ds is lengthened by

    e = T/(Y sin^2) int dxi/(1 + xi c') = 2 T artanh(p)/(Y c' sin^2),    p = H c'/2.

The clamps prescribe e = u sin + v cos. The elastic energy int T e ds/2 = Y/(2 H) int f g ds with

    f(c) = ((u + v c)/(1 + c^2))^2,    g(p) = p/artanh(p)

is the largest among all families of rays (complementary energy). It does not name s, which gives
the first integral f (g - p g') = const, that is

    f(c) h(p) = f(c0),    h(p) = p^2/((1 - p^2) artanh(p)^2),

with c0 at the centre, where p = 0. The free ends are rays: c = 0 there, so that the half length is
the integral of dc H/(2 p) from 0 to c0.

Source: E. H. Mansfield, Proc. R. Soc. Lond. A 316, 269 (1970).
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

from wrinklestudy.typing import Array

_SMALL = 1e-6  # of h - 1, below which two terms of its series are exact to rounding


@dataclass(frozen=True)
class MansfieldStrip:
    """Tension rays of a strip between two clamps, for small strains.

    Parameters
    ----------
    distance, length : float
        H between the clamps and length of the clamps.
    extension, shear : float
        u and v of one clamp, both > 0, in the same unit.
    """

    distance: float
    length: float
    extension: float
    shear: float

    @property
    def _endless(self) -> float:
        """Cotangent of the rays of an endless strip, where f is largest."""
        return float((np.hypot(self.extension, self.shear) - self.extension) / self.shear)

    @property
    def endless_angle(self) -> float:
        """Angle between the rays of an endless strip and the clamps."""
        return float(np.arctan2(1.0, self._endless))

    @cached_property
    def centre(self) -> float:
        """Cotangent c0 at the centre, below that of an endless strip."""
        endless = self._endless

        def excess(logarithm: float) -> float:
            centre = float(endless - np.exp(logarithm))
            return self._station(centre, centre) - 0.5 * self.length

        below = brentq(excess, -18.0, np.log(0.5 * endless), xtol=1e-12)
        return float(endless - np.exp(below))

    def angle(self, station: float) -> float:
        """Return the angle between ray and clamps at a distance along the mid-line from the centre.

        At the centre it is that of `centre`, at the free end 90 degrees.
        """
        if station <= 0.0:
            return float(np.arctan2(1.0, self.centre))
        if station >= 0.5 * self.length:
            return 0.5 * np.pi
        gap = brentq(
            lambda gap: self._station(gap, self.centre) - station, 0.0, self.centre, xtol=1e-12
        )
        return float(np.arctan2(1.0, self.centre - gap))

    def angles(self, stations: Array) -> Array:
        """Return `angle` at several places on either side of the centre."""
        return np.array([self.angle(abs(float(s))) for s in stations])

    @cached_property
    def forces(self) -> tuple[float, float]:
        """Forces on a clamp away from the other one and along it, over Y t.

        A ray carries T = Y sin^2 e g/H for each length of the mid-line.
        """
        normal = 2.0 * self._integral(self.centre, self._tension)
        along = 2.0 * self._integral(self.centre, lambda c, p: c * self._tension(c, p))
        return normal, along

    @cached_property
    def energy(self) -> float:
        """Elastic energy over Y t, int f g ds/(2 H)."""

        def of(c: float, p: float) -> float:
            even = p / np.arctanh(p) if p > 0.0 else 1.0
            return float(((self.extension + self.shear * c) / (1.0 + c * c)) ** 2 * even)

        return self._integral(self.centre, of) / self.distance

    def _tension(self, c: float, p: float) -> float:
        """Return T sin/Y of a ray."""
        even = p / np.arctanh(p) if p > 0.0 else 1.0
        return float((self.extension + self.shear * c) * even / (1.0 + c * c) ** 2 / self.distance)

    def _station(self, gap: float, centre: float) -> float:
        """Return the distance along the mid-line from the centre to the ray c = centre - gap."""
        return self._integral(centre, lambda _c, _p: 1.0, gap)

    def _integral(
        self,
        centre: float,
        of: Callable[[float, float], float],
        gap: float | None = None,
    ) -> float:
        """Integrate a function of c and p along the mid-line, from the centre to c = centre - gap.

        With c = centre - z^2 the integrand ds/dz = H z/p is finite at the centre.
        """

        def integrand(z: float) -> float:
            p = self._ratio(z * z, centre)
            return self.distance * z / p * of(centre - z * z, p)

        end = np.sqrt(centre if gap is None else gap)
        return float(quad(integrand, 0.0, end, epsabs=1e-12, epsrel=1e-11, limit=200)[0])

    def _ratio(self, gap: float, centre: float) -> float:
        """Return p of the ray c = centre - gap."""
        u, v, c = self.extension, self.shear, centre - gap
        own = (u + v * c) / (1.0 + c * c)
        other = (u + v * centre) / (1.0 + centre**2)
        # other - own without the difference of nearly equal numbers
        slope = (v - v * c * centre - u * (c + centre)) / ((1.0 + c * c) * (1.0 + centre**2))
        excess = gap * slope * (own + other) / own**2  # h - 1
        if excess < _SMALL:
            return float(np.sqrt(3.0 * excess - 7.2 * excess**2))

        def missing(p: float) -> float:
            return p * p / ((1.0 - p * p) * np.arctanh(p) ** 2) - 1.0 - excess

        return float(brentq(missing, 1e-4, 1.0 - 1e-14, xtol=1e-15))
