"""Bending laws: how the energy of a cross-section follows from metric and curvature.

The registry is `BENDING_LAWS`; `docs/recipes/bending_law.md` says how to add one. Derivatives are
exact and written by hand.
"""

import math
from abc import ABC, abstractmethod
from typing import ClassVar, NamedTuple

import numpy as np

from wrinklestudy.mechanics.laws import Law
from wrinklestudy.mechanics.surface import SurfaceGeometry, curved_surface, shallow_surface
from wrinklestudy.typing import Array


class SectionDerivatives(NamedTuple):
    """Derivatives of the section energy psi(a, b); points are the last axes."""

    force: Array  # d psi / da, (3, ...)
    moment: Array  # d psi / db, (3, ...)
    stretching: Array  # d2 psi / da da, (3, 3, ...)
    coupling: Array  # d2 psi / da db, (3, 3, ...)
    bending: Array  # d2 psi / db db, (3, 3, ...)


class BendingLaw(ABC):
    """Energy psi(a, b) of a cross-section of a given thickness, in units of mu W.

    Attributes
    ----------
    name : str
        Name in files, in the config and on the command line.
    label : str
        For figures and tables.
    meaning : str
        One line for the help of the command line.
    """

    name: ClassVar[str]
    label: ClassVar[str]
    meaning: ClassVar[str]

    def surface(self, derivatives: Array) -> SurfaceGeometry:
        """Return the geometry of the mid-surface from x,1 x,2 x,11 x,22 x,12, (5, 3, ...)."""
        return curved_surface(derivatives)

    @abstractmethod
    def energy(self, law: Law, thickness: float | Array, metric: Array, curvature: Array) -> Array:
        """Return the energy per reference area in units of mu W, shape ``(...)``.

        Parameters
        ----------
        law : Law
            Dimensionless material law.
        thickness : float or array
            t in units of W.
        metric, curvature : (3, ...) arrays
            a and b of the mid-surface.
        """

    @abstractmethod
    def derivatives(
        self, law: Law, thickness: float | Array, metric: Array, curvature: Array
    ) -> SectionDerivatives:
        """Return the first and second derivatives of the energy with respect to a and b."""


def _two_points_energy(
    law: Law, thickness: float | Array, metric: Array, curvature: Array, stretch: Array | None
) -> Array:
    """Return psi = t/2 [W(a - arm b) + W(a + arm b)], arm = t/sqrt(3) times any stretch."""
    shift = thickness / math.sqrt(3.0) * curvature
    if stretch is not None:
        shift *= stretch
    both = law.energy(metric - shift) + law.energy(metric + shift)
    return 0.5 * thickness * both


class _TwoPoints(NamedTuple):
    """Mean and half difference, times t, of the derivatives of W at the two Gauss points."""

    mean: Array  # first derivatives, (3, ...)
    jump: Array
    mean2: Array  # second derivatives, (3, 3, ...)
    jump2: Array


def _two_points(law: Law, thickness: float | Array, metric: Array, shift: Array) -> _TwoPoints:
    weight = 0.5 * thickness
    upper, upper2 = law.derivatives(metric - shift)
    lower, lower2 = law.derivatives(metric + shift)
    mean, jump = weight * (upper + lower), weight * (upper - lower)
    return _TwoPoints(mean, jump, weight * (upper2 + lower2), weight * (upper2 - lower2))


class FixedThicknessBending(BendingLaw):
    """Kirchhoff-Love section with g(zeta) = a - 2 zeta b, in which the sheet keeps its thickness.

    Two Gauss points at +- t/(2 sqrt 3) make the energy exact to t^3. Common in shell codes.
    """

    name = "fixed-thickness"
    label = "fixed thickness"
    meaning = "the sheet bends with the thickness it has at rest"

    def energy(self, law: Law, thickness: float | Array, metric: Array, curvature: Array) -> Array:
        """Return t/2 [W(g+) + W(g-)]."""
        return _two_points_energy(law, thickness, metric, curvature, None)

    def derivatives(
        self, law: Law, thickness: float | Array, metric: Array, curvature: Array
    ) -> SectionDerivatives:
        """Return the first and second derivatives of the energy with respect to a and b."""
        arm = thickness / math.sqrt(3.0)  # 2 zeta of the upper Gauss point
        mean, jump, mean2, jump2 = _two_points(law, thickness, metric, arm * curvature)
        return SectionDerivatives(mean, -arm * jump, mean2, -arm * jump2, arm * arm * mean2)


class ThinningBending(BendingLaw):
    """Kirchhoff-Love section with g(zeta) = a - 2 zeta lambda3 b; the law gives lambda3.

    The bending stiffness falls as the sheet is stretched and thins. Two Gauss points at
    +- t/(2 sqrt 3) make the energy exact to t^3.
    """

    name = "thinning"
    label = "thinning"
    meaning = "the sheet bends with the thickness to which stretching reduces it"

    def energy(self, law: Law, thickness: float | Array, metric: Array, curvature: Array) -> Array:
        """Return t/2 [W(g+) + W(g-)]."""
        stretch = law.thickness_stretch(metric)[0]
        return _two_points_energy(law, thickness, metric, curvature, stretch)

    def derivatives(
        self, law: Law, thickness: float | Array, metric: Array, curvature: Array
    ) -> SectionDerivatives:
        """Return the first and second derivatives of the energy with respect to a and b."""
        lever = thickness / math.sqrt(3.0)  # 2 zeta of the upper Gauss point
        stretch, slope, hessian = law.thickness_stretch(metric)
        arm = lever * stretch
        slope *= lever
        hessian *= lever
        mean, jump, mean2, jump2 = _two_points(law, thickness, metric, arm * curvature)
        bending = arm**2 * mean2
        coupling = -arm * jump2
        # g+- = a -+ arm(a) b: every derivative with respect to a has a part along b.
        work = np.einsum("i...,i...->...", jump, curvature)
        jump_b = np.einsum("ij...,j...->i...", jump2, curvature)
        mean_b = np.einsum("ij...,j...->i...", mean2, curvature)
        work2 = np.einsum("i...,i...->...", mean_b, curvature)
        force = mean - work * slope
        coupling += slope[:, None] * (arm * mean_b - jump)[None, :]
        stretching = mean2 - work * hessian
        stretching -= jump_b[:, None] * slope[None, :] + slope[:, None] * jump_b[None, :]
        stretching += work2 * slope[:, None] * slope[None, :]
        return SectionDerivatives(force, -arm * jump, stretching, coupling, bending)


class FvkBending(BendingLaw):
    """Quadratic energy of the second derivatives of the deflection and the initial modulus.

    This is the bending energy of the Foppl-von Karman equations, added to the full membrane
    energy. It is tied to the direction z, because the normal does not turn.
    """

    name = "fvk"
    label = "FvK"
    meaning = "second derivatives of the deflection, with the stiffness of the sheet at rest"

    def surface(self, derivatives: Array) -> SurfaceGeometry:
        """Return the geometry with the fixed normal z."""
        return shallow_surface(derivatives)

    def energy(self, law: Law, thickness: float | Array, metric: Array, curvature: Array) -> Array:
        """Return t W(a) + b.D b / 2."""
        flat: Array = thickness * law.energy(metric)
        bent = np.einsum("i...,ij,j...->...", curvature, _initial_stiffness(law), curvature)
        return flat + 0.5 * thickness**3 * bent

    def derivatives(
        self, law: Law, thickness: float | Array, metric: Array, curvature: Array
    ) -> SectionDerivatives:
        """Return the first and second derivatives of the energy with respect to a and b."""
        stress, tangent = law.derivatives(metric)
        stiffness = _initial_stiffness(law)
        moment = thickness**3 * np.tensordot(stiffness, curvature, axes=1)
        points = (1,) * (metric.ndim - 1)
        bending = np.broadcast_to(thickness**3 * stiffness.reshape(3, 3, *points), tangent.shape)
        return SectionDerivatives(
            thickness * stress,
            moment,
            thickness * tangent,
            np.zeros_like(tangent),
            np.ascontiguousarray(bending),
        )


def _initial_stiffness(law: Law) -> Array:
    """Return the constant stiffness over t^3, E / 12 (1 - nu^2) = mu / 6 (1 - nu), (3, 3)."""
    nu = law.poisson
    stiffness = np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 2.0 * (1.0 - nu)]])
    return stiffness / (6.0 * (1.0 - nu))


# The registry: all bending laws by name, in the order in which they are offered; the default first.
BENDING_LAWS: dict[str, BendingLaw] = {
    bending.name: bending for bending in (ThinningBending(), FixedThicknessBending(), FvkBending())
}


def bending_law_of(name: str) -> BendingLaw:
    """Return a bending law.

    Raises
    ------
    ValueError
        If there is no bending law of that name.
    """
    if name not in BENDING_LAWS:
        raise ValueError(f"bending = {name!r}: must be one of {', '.join(BENDING_LAWS)}")
    return BENDING_LAWS[name]


def check_bending(law: Law | type[Law], name: str) -> None:
    """Refuse a bending law that is unknown or does not go with a material law.

    Raises
    ------
    ValueError
        In one line.
    """
    bending_law_of(name)
    if law.bendings and name not in law.bendings:
        allowed = ", ".join(law.bendings)
        raise ValueError(f"bending = {name!r}: must be {allowed} with the law {law.name}")
