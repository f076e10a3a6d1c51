"""Incompressible isotropic laws in plane stress: functions of trace and determinant of the metric.

The thickness follows from the metric, C33 = 1/det g, so that an isotropic energy depends on
T = tr g and D = det g alone. A law gives that function and its derivatives with respect to T and D;
here they become derivatives with respect to the components of the metric.
"""

from abc import abstractmethod
from typing import NamedTuple

import numpy as np

from wrinklestudy.mechanics.laws.base import Law
from wrinklestudy.typing import Array

# d2(det g) / dg dg in the components (g11, g22, g12)
_DET_HESSIAN = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -2.0]])


def determinant(metric: Array) -> Array:
    """Return det g = g11 g22 - g12^2, shape ``(...)``."""
    return metric[0] * metric[1] - metric[2] ** 2


def _determinant_gradient(metric: Array) -> Array:
    return np.stack([metric[1], metric[0], -2.0 * metric[2]])


class Slopes(NamedTuple):
    """Derivatives of an energy W(T, D) at points, (...) each; `trace2` is None where it is zero."""

    trace: Array  # W_T
    det: Array  # W_D
    trace2: Array | None  # W_TT
    mixed: Array  # W_TD
    det2: Array  # W_DD


class IncompressibleLaw(Law):
    """An incompressible isotropic law in plane stress."""

    @abstractmethod
    def density(self, trace: Array, det: Array) -> Array:
        """Return W(T, D), also of complex T and D, so that complex steps can check slopes."""

    @abstractmethod
    def slopes(self, trace: Array, det: Array) -> Slopes:
        """Return the first and second derivatives of W(T, D)."""

    @property
    def poisson(self) -> float:
        """Poisson's ratio of the undeformed material: 1/2, incompressible."""
        return 0.5

    def natural_width(self, stretch: Array) -> Array:
        """Return the transverse stretch under uniaxial tension, lambda^(-1/2)."""
        return stretch**-0.5

    def energy(self, metric: Array) -> Array:
        """Return the strain energy per reference volume, shape ``(...)``."""
        return self.density(metric[0] + metric[1], determinant(metric))

    def derivatives(self, metric: Array) -> tuple[Array, Array]:
        """Return dW/dg of shape ``(3, ...)`` and d2W/dg2 of shape ``(3, 3, ...)``."""
        by_trace, by_det, by_trace2, mixed, by_det2 = self.slopes(
            metric[0] + metric[1], determinant(metric)
        )
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
                if j < 2 and by_trace2 is not None:
                    entry = entry + by_trace2
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
