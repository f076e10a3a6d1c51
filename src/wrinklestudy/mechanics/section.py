"""Energy of the cross-section as a function of metric and curvature of the mid-surface.

Through the thickness g(zeta) = a - 2 zeta lambda3 b, and two Gauss points at +- t/(2 sqrt 3) give
the energy per reference area

    psi(a, b) = t/2 [W(g+) + W(g-)],

exact to t^3. Derivatives are exact and written by hand.
"""

import math
from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

import numpy as np

from wrinklestudy.mechanics.laws import Law
from wrinklestudy.typing import Array

Bending = Literal["thinning", "fixed-thickness", "fvk"]
BENDING_LAWS: tuple[Bending, ...] = get_args(Bending)


class SectionDerivatives(NamedTuple):
    """Derivatives of the section energy psi(a, b); points are the last axes."""

    force: Array  # d psi / da, (3, ...)
    moment: Array  # d psi / db, (3, ...)
    stretching: Array  # d2 psi / da da, (3, 3, ...)
    coupling: Array  # d2 psi / da db, (3, 3, ...)
    bending: Array  # d2 psi / db db, (3, 3, ...)


@dataclass(frozen=True)
class Section:
    """Energy of the cross-section as a function of metric and curvature.

    Parameters
    ----------
    law : Law
        Dimensionless material law.
    thickness : float
        t in units of W.
    bending : {'thinning', 'fixed-thickness', 'fvk'}
        'thinning': lambda3 in the metric through the thickness follows from the law, so that the
        bending stiffness falls as the sheet is stretched. 'fixed-thickness': lambda3 = 1 there.
        'fvk': quadratic energy of the second derivatives of the deflection with the initial
        modulus, as in the Foppl-von Karman equations.
    """

    law: Law
    thickness: float
    bending: Bending = "thinning"

    def __post_init__(self) -> None:
        if self.bending not in BENDING_LAWS:
            raise ValueError(
                f"bending = {self.bending!r}: must be one of {', '.join(BENDING_LAWS)}"
            )

    def _fvk_stiffness(self) -> Array:
        """Return the constant stiffness E t^3 / 12 (1 - nu^2) = mu t^3 / 6 (1 - nu)."""
        nu = self.law.poisson
        stiffness = np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 2.0 * (1.0 - nu)]])
        return stiffness * self.thickness**3 / (6.0 * (1.0 - nu))

    def energy(self, metric: Array, curvature: Array) -> Array:
        """Return the energy per reference area in units of mu W, shape ``(...)``."""
        if self.bending == "fvk":
            flat: Array = self.thickness * self.law.energy(metric)
            stiffness = self._fvk_stiffness()
            return flat + 0.5 * np.einsum("i...,ij,j...->...", curvature, stiffness, curvature)
        shift = self.thickness / math.sqrt(3.0) * curvature
        if self.bending == "thinning":
            shift *= self.law.thickness_stretch(metric)[0]
        both = self.law.energy(metric - shift) + self.law.energy(metric + shift)
        return 0.5 * self.thickness * both

    def derivatives(self, metric: Array, curvature: Array) -> SectionDerivatives:
        """Return the first and second derivatives of the energy with respect to a and b."""
        if self.bending == "fvk":
            return self._fvk_derivatives(metric, curvature)
        lever = self.thickness / math.sqrt(3.0)  # 2 zeta of the upper Gauss point
        weight = 0.5 * self.thickness
        thinning = self.bending == "thinning"
        if thinning:
            stretch, slope, hessian = self.law.thickness_stretch(metric)
            arm = lever * stretch
            slope *= lever
            hessian *= lever
        else:
            arm = np.full(metric.shape[1:], lever)
        upper, upper2 = self.law.derivatives(metric - arm * curvature)
        lower, lower2 = self.law.derivatives(metric + arm * curvature)
        mean, jump = weight * (upper + lower), weight * (upper - lower)
        mean2, jump2 = weight * (upper2 + lower2), weight * (upper2 - lower2)
        bending = arm**2 * mean2
        coupling = -arm * jump2
        if not thinning:
            return SectionDerivatives(mean, -arm * jump, mean2, coupling, bending)
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

    def _fvk_derivatives(self, metric: Array, curvature: Array) -> SectionDerivatives:
        stress, tangent = self.law.derivatives(metric)
        stiffness = self._fvk_stiffness()
        moment = np.tensordot(stiffness, curvature, axes=1)
        points = (1,) * (metric.ndim - 1)
        bending = np.broadcast_to(stiffness.reshape(3, 3, *points), tangent.shape)
        return SectionDerivatives(
            self.thickness * stress,
            moment,
            self.thickness * tangent,
            np.zeros_like(tangent),
            np.ascontiguousarray(bending),
        )
