"""Hexahedra of order 3 through the thickness of a sheet, with the elements and rules of FElupe.

One layer of cells covers the quarter sheet. In the plane the functions are those of FElupe's
Lagrange element of order 3; through the thickness its four functions are combined to the powers
1, zeta, zeta^2, zeta^3 of zeta = z/(t/2), so that parts of a displacement which are even or odd
under z -> -z are apart, and what the middle surface does is a coefficient.

With two layers the one below the middle surface mirrors the one above: powers of |zeta|, times the
sign of zeta for what is odd.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import felupe
import numpy as np

from wrinklestudy.typing import Array, Indices

ORDER = 3  # of the hexahedra
_SIDE = ORDER + 1
# Which displacements: even keeps the sheet flat (in-plane even in z, w odd), odd bends it.
Part = Literal["even", "odd", "both"]


class Function(NamedTuple):
    """One function through the thickness: zeta^power, mirrored so that it is even or odd."""

    power: int
    even: bool


def functions(part: Part, component: int, layers: int) -> list[Function]:
    """Return the functions through the thickness of a displacement in x, y or z."""
    if part == "both":
        if layers != 1:
            raise ValueError(f"layers = {layers}: displacements that mix parities need one layer")
        return [Function(power, power % 2 == 0) for power in range(_SIDE)]
    even = (part == "even") == (component < 2)
    if layers == 1:
        return [Function(power, even) for power in range(0 if even else 1, _SIDE, 2)]
    return [Function(power, even) for power in range(0 if even else 1, _SIDE)]


@dataclass(frozen=True)
class SolidElement:
    """The functions of one hexahedron at the points of a Gauss rule, on the cube [-1, 1]^3.

    Parameters
    ----------
    part : {'even', 'odd', 'both'}
    layers : {1, 2}
        Elements through the thickness.
    pressure_degree : int
        Of the pressure in each direction within an element.
    """

    part: Part
    layers: int = 1
    pressure_degree: int = ORDER - 1

    @cached_property
    def _lagrange(self) -> felupe.ArbitraryOrderLagrangeElement:
        return felupe.ArbitraryOrderLagrangeElement(order=ORDER, dim=3)

    @cached_property
    def _rule(self) -> tuple[Array, Array]:
        """Points (q, 3) and weights of the whole thickness; a half of it counts twice."""
        rule = felupe.GaussLegendre(order=ORDER, dim=3)
        points, weights = np.asarray(rule.points), np.asarray(rule.weights)
        if self.layers == 2:
            return points, 2.0 * weights
        if self.part == "both":
            return points, weights
        upper = points[:, 2] > 0.0
        return points[upper], 2.0 * weights[upper]

    @property
    def weights(self) -> Array:
        """Weights of the points, (q,)."""
        return self._rule[1]

    def height(self, local: Array) -> Array:
        """Return zeta of the third coordinate in the element."""
        return 0.5 * (1.0 + local) if self.layers == 2 else local

    @cached_property
    def in_plane(self) -> Indices:
        """Place of the 16 functions on the 4 x 4 grid of an element, (16, 2), x first."""
        return np.array([(i, j) for i in range(_SIDE) for j in range(_SIDE)])

    def through(self, component: int) -> list[Function]:
        """Return the functions through the thickness of a component."""
        return functions(self.part, component, self.layers)

    def gradient(self, component: int) -> Array:
        """Return the derivatives of the functions of a component, (16 x functions, 3, q).

        In the order of `in_plane`, for each function through the thickness.
        """
        element = self._lagrange
        nodes = np.asarray(element.points)
        places = np.rint((nodes[:, :2] + 1.0) * 0.5 * ORDER).astype(int)
        number = places[:, 0] * _SIDE + places[:, 1]
        combined = []
        for power, _ in self.through(component):
            weights = np.zeros((len(nodes), _SIDE**2))
            weights[np.arange(len(nodes)), number] = self.height(nodes[:, 2]) ** power
            combined.append(weights)
        derivatives = np.stack([element.gradient(point) for point in self._rule[0]], axis=-1)
        return np.einsum("an,ajq->njq", np.concatenate(combined, axis=1), derivatives)

    @cached_property
    def pressure(self) -> Array:
        """Functions of the pressure, (m, q), orthonormal in the mean over the element."""
        points = self._rule[0]
        along = [self._legendre(points[:, axis]) for axis in range(3)]
        degrees = range(self.pressure_degree + 1)
        # a pressure that belongs to even displacements is even
        kept = [
            d
            for d in degrees
            if self.layers == 2 or self.part == "both" or (d % 2 == 0) == (self.part == "even")
        ]
        rows = [
            along[0][i] * along[1][j] * along[2][k] for i in degrees for j in degrees for k in kept
        ]
        return np.array(rows)

    def _legendre(self, local: Array) -> Array:
        count = self.pressure_degree + 1
        values = np.polynomial.legendre.legvander(local, count - 1).T
        scaled: Array = values * np.sqrt(2.0 * np.arange(count) + 1.0)[:, None]
        return scaled
