"""The law of Saint Venant and Kirchhoff."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self

import numpy as np

from wrinklestudy.mechanics.laws.base import Constant, Law, Material
from wrinklestudy.typing import Array


@dataclass(frozen=True)
class SaintVenantKirchhoff(Law):
    """Saint Venant-Kirchhoff sheet in plane stress, in units of its shear modulus.

    W = [E11^2 + E22^2 + 2 nu E11 E22 + 2 (1 - nu) E12^2] / (1 - nu), E = (g - 1) / 2.

    Parameters
    ----------
    poisson : float
        Poisson's ratio nu, 0 <= nu <= 1/2.
    """

    name = "svk"
    label = "Saint Venant\N{EN DASH}Kirchhoff"
    short_label = "SVK"
    constants = (
        Constant("young", "Y", "Pa", "Young's modulus", 0.0, above=True, default=1.0e6),
        Constant("poisson", r"\nu", "", "Poisson's ratio", 0.0, 0.5, default=0.5, fitted=False),
    )
    small_strain = True

    poisson: float = 0.5

    @classmethod
    def shear_modulus(cls, constants: Mapping[str, float]) -> float:
        """Return Y / (2 (1 + nu))."""
        return constants["young"] / (2.0 * (1.0 + constants["poisson"]))

    @classmethod
    def dimensionless(cls, constants: Mapping[str, float], modulus: float) -> Self:  # noqa: ARG003
        """Return the law, which keeps nothing but Poisson's ratio."""
        return cls(constants["poisson"])

    def physical(self, modulus: float) -> dict[str, float]:
        """Return Young's modulus in Pa and Poisson's ratio."""
        return {"young": 2.0 * (1.0 + self.poisson) * modulus, "poisson": self.poisson}

    @classmethod
    def polyconvex(cls, constants: Mapping[str, float]) -> bool:  # noqa: ARG003
        """Return False: A. Raoult, Aplikace matematiky 31, 417 (1986)."""
        return False

    def _stiffness(self) -> Array:
        nu = self.poisson
        # E = (g - 1) / 2 brings a factor 1/4; g12 stands for two entries.
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

    def natural_width(self, stretch: Array) -> Array:
        """Return the transverse stretch under uniaxial tension, from E22 = -nu E11.

        NaN where the law leaves no width: nu (lambda^2 - 1) > 1.
        """
        with np.errstate(invalid="ignore"):
            return np.sqrt(1.0 - self.poisson * (stretch**2 - 1.0))


def saint_venant_kirchhoff(young: float = 1.0e6, poisson: float = 0.5) -> Material:
    """Return a Saint Venant-Kirchhoff material from Young's modulus in Pa and Poisson's ratio.

    Raises
    ------
    ValueError
        If Young's modulus is not positive or Poisson's ratio is outside [0, 0.5].
    """
    return SaintVenantKirchhoff.material(young=young, poisson=poisson)
