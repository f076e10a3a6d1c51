"""Plane-stress hyperelastic laws as functions of the in-plane metric.

A law is made dimensionless with the initial shear modulus, so that only the shape of the
energy is left: the ratio C01/C10 for Mooney-Rivlin, nothing for neo-Hookean, Poisson's ratio for
Saint Venant-Kirchhoff. Metrics have the shape ``(3, ...)`` with components (g11, g22, g12).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from wrinklestudy.typing import Array

LAWS = ("mooney-rivlin", "neo-hookean", "svk")

# d2(det g) / dg dg in the components (g11, g22, g12)
_DET_HESSIAN = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -2.0]])


class Law(Protocol):
    """What the plate needs to know of a material, in units of its initial shear modulus."""

    @property
    def poisson(self) -> float:
        """Poisson's ratio of the undeformed material."""

    def energy(self, metric: Array) -> Array:
        """Return the strain energy per reference volume, shape ``(...)``."""

    def derivatives(self, metric: Array) -> tuple[Array, Array]:
        """Return dW/dg of shape ``(3, ...)`` and d2W/dg2 of shape ``(3, 3, ...)``."""

    def thickness_stretch(self, metric: Array) -> tuple[Array, Array, Array]:
        """Return lambda3 and its first and second derivatives with respect to the metric."""


def determinant(metric: Array) -> Array:
    """Return det g = g11 g22 - g12^2, shape ``(...)``."""
    return metric[0] * metric[1] - metric[2] ** 2


def _determinant_gradient(metric: Array) -> Array:
    return np.stack([metric[1], metric[0], -2.0 * metric[2]])


@dataclass(frozen=True)
class MooneyRivlin:
    """Incompressible Mooney-Rivlin sheet in plane stress; neo-Hookean for ``c01 = 0``.

    W = c10 (I1 - 3) + c01 (I2 - 3) with I1 = tr g + 1/det g, I2 = det g + tr g / det g.

    Parameters
    ----------
    c10, c01 : float
        Constants in units of the initial shear modulus 2 (C10 + C01), so that c10 + c01 = 1/2.
    """

    c10: float
    c01: float

    @property
    def poisson(self) -> float:
        """Poisson's ratio of the undeformed material: 1/2, incompressible."""
        return 0.5

    def energy(self, metric: Array) -> Array:
        """Return the strain energy per reference volume, shape ``(...)``."""
        det, trace = determinant(metric), metric[0] + metric[1]
        return self.c10 * (trace + 1.0 / det - 3.0) + self.c01 * (det + trace / det - 3.0)

    def derivatives(self, metric: Array) -> tuple[Array, Array]:
        """Return dW/dg of shape ``(3, ...)`` and d2W/dg2 of shape ``(3, 3, ...)``."""
        det, trace = determinant(metric), metric[0] + metric[1]
        inverse = 1.0 / det
        square = inverse * inverse
        by_trace = self.c10 + self.c01 * inverse
        by_det = self.c01 - (self.c10 + self.c01 * trace) * square
        mixed = -self.c01 * square
        by_det2 = 2.0 * (self.c10 + self.c01 * trace) * square * inverse
        slope = _determinant_gradient(metric)
        stress = by_det * slope
        stress[:2] += by_trace
        tangent = np.empty((3, *metric.shape))
        for i in range(3):
            for j in range(i, 3):
                entry = by_det2 * slope[i] * slope[j]
                if i < 2:
                    entry = entry + mixed * slope[j]
                if j < 2:
                    entry = entry + mixed * slope[i]
                if _DET_HESSIAN[i, j] != 0.0:
                    entry = entry + _DET_HESSIAN[i, j] * by_det
                tangent[i, j] = tangent[j, i] = entry
        return stress, tangent

    def thickness_stretch(self, metric: Array) -> tuple[Array, Array, Array]:
        """Return lambda3 = 1/sqrt(det g) and its first and second derivatives."""
        det = determinant(metric)
        stretch = det**-0.5
        slope = _determinant_gradient(metric)
        first = -0.5 * stretch / det
        second = -1.5 * first / det
        hessian = second * slope[:, None] * slope[None, :]
        hessian += first * _DET_HESSIAN.reshape(3, 3, *([1] * det.ndim))
        return stretch, first * slope, hessian


@dataclass(frozen=True)
class SaintVenantKirchhoff:
    """Saint Venant-Kirchhoff sheet in plane stress, in units of its shear modulus.

    W = [E11^2 + E22^2 + 2 nu E11 E22 + 2 (1 - nu) E12^2] / (1 - nu), E = (g - 1) / 2.

    Parameters
    ----------
    poisson : float
        Poisson's ratio nu, 0 <= nu <= 1/2.
    """

    poisson: float = 0.5

    def _stiffness(self) -> Array:
        nu = self.poisson
        # E = (g - 1) / 2 brings a factor 1/4; g12 stands for two entries of E.
        full = np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 2.0 * (1.0 - nu)]])
        return full / (2.0 * (1.0 - nu))

    def _strain(self, metric: Array) -> Array:
        strain = metric.copy()
        strain[:2] -= 1.0
        return strain

    def energy(self, metric: Array) -> Array:
        """Return the strain energy per reference volume, shape ``(...)``."""
        strain = self._strain(metric)
        return 0.5 * np.einsum("i...,ij,j...->...", strain, self._stiffness(), strain)

    def derivatives(self, metric: Array) -> tuple[Array, Array]:
        """Return dW/dg of shape ``(3, ...)`` and d2W/dg2 of shape ``(3, 3, ...)``."""
        stiffness = self._stiffness()
        stress = np.tensordot(stiffness, self._strain(metric), axes=1)
        points = metric.shape[1:]
        tangent = np.broadcast_to(
            stiffness.reshape(3, 3, *([1] * len(points))), (3, 3, *points)
        ).copy()
        return stress, tangent

    def thickness_stretch(self, metric: Array) -> tuple[Array, Array, Array]:
        """Return lambda3 = sqrt(1 + 2 E33), E33 = -nu/(1 - nu) (E11 + E22), and its derivatives.

        NaN where the law leaves no thickness: (E11 + E22) nu/(1 - nu) > 1/2.
        """
        ratio = self.poisson / (1.0 - self.poisson)
        with np.errstate(invalid="ignore"):
            stretch = np.sqrt(1.0 - ratio * (metric[0] + metric[1] - 2.0))
        gradient = np.zeros_like(metric)
        gradient[:2] = -0.5 * ratio / stretch
        hessian = np.zeros((3, *metric.shape))
        hessian[:2, :2] = -0.25 * ratio**2 / stretch**3
        return stretch, gradient, hessian


@dataclass(frozen=True)
class Material:
    """A law together with its initial shear modulus.

    Parameters
    ----------
    law : Law
        Dimensionless law.
    shear_modulus : float
        Initial shear modulus in Pa.
    """

    law: Law
    shear_modulus: float

    @property
    def young_modulus(self) -> float:
        """Initial slope of the uniaxial stress-strain curve in Pa: 2 (1 + nu) mu."""
        return 2.0 * (1.0 + self.law.poisson) * self.shear_modulus


def mooney_rivlin(c10: float, c01: float) -> Material:
    """Return an incompressible Mooney-Rivlin material from its constants in Pa.

    Raises
    ------
    ValueError
        If the initial shear modulus 2 (c10 + c01) is not positive or a constant is negative.
    """
    if c10 < 0 or c01 < 0 or c10 + c01 <= 0:
        raise ValueError(f"c10 = {c10:g}, c01 = {c01:g}: both must be >= 0 Pa and one positive")
    modulus = 2.0 * (c10 + c01)
    return Material(MooneyRivlin(c10 / modulus, c01 / modulus), modulus)


def neo_hookean(c10: float) -> Material:
    """Return an incompressible neo-Hookean material, Mooney-Rivlin with c01 = 0, from C10 in Pa."""
    return mooney_rivlin(c10, 0.0)


def saint_venant_kirchhoff(young: float = 1.0e6, poisson: float = 0.5) -> Material:
    """Return a Saint Venant-Kirchhoff material from Young's modulus in Pa and Poisson's ratio.

    Raises
    ------
    ValueError
        If Young's modulus is not positive or Poisson's ratio is outside [0, 0.5].
    """
    if young <= 0:
        raise ValueError(f"young = {young:g}: must be > 0 Pa")
    if not 0.0 <= poisson <= 0.5:
        raise ValueError(f"poisson = {poisson:g}: must lie in [0, 0.5]")
    return Material(SaintVenantKirchhoff(poisson), young / (2.0 * (1.0 + poisson)))


def describe(material: Material) -> dict[str, str | float]:
    """Return the law and its constants as plain values, pascals included."""
    law = material.law
    if isinstance(law, SaintVenantKirchhoff):
        constants = {"young_pa": material.young_modulus, "poisson": law.poisson}
        return {"law": "svk", **constants}
    if not isinstance(law, MooneyRivlin):
        raise TypeError(f"{type(law).__name__} has no description: not one of {', '.join(LAWS)}")
    constants = {"c10_pa": law.c10 * material.shear_modulus}
    if law.c01 == 0.0:
        return {"law": "neo-hookean", **constants}
    return {"law": "mooney-rivlin", **constants, "c01_pa": law.c01 * material.shear_modulus}


def from_description(values: Mapping[str, Any]) -> Material:
    """Return the material that `describe` described; other keys are ignored.

    Raises
    ------
    ValueError
        If the law is unknown.
    """
    if values["law"] == "svk":
        return saint_venant_kirchhoff(values["young_pa"], values["poisson"])
    if values["law"] in ("neo-hookean", "mooney-rivlin"):
        return mooney_rivlin(values["c10_pa"], values.get("c01_pa", 0.0))
    raise ValueError(f"law = {values['law']!r}: must be one of {', '.join(LAWS)}")
