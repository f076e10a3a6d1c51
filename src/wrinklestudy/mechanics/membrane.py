"""Energy of a flat sheet that is stretched in its plane: density, gradient and Hessian."""

from typing import Protocol

import numpy as np

from wrinklestudy.typing import Array


class MetricEnergy(Protocol):
    """An energy of the in-plane metric: a law, or its relaxed form."""

    @property
    def linear_in_plane(self) -> bool:
        """Whether it is an energy of 1 + 2 E with the linear strain E, see `laws.Law`."""

    def energy(self, metric: Array) -> Array:
        """Return the strain energy per reference volume, shape ``(...)``."""

    def derivatives(self, metric: Array) -> tuple[Array, Array]:
        """Return dW/dg of shape ``(3, ...)`` and d2W/dg2 of shape ``(3, 3, ...)``."""


def frame(law: MetricEnergy, derivatives: Array) -> Array:
    """Return the vectors that turn dx,1 and dx,2 into a change of the metric, (2, 2, ...).

    da11 = 2 p.dx,1, da22 = 2 q.dx,2, da12 = q.dx,1 + p.dx,2 with p = x,1 and q = x,2; for a strain
    that is linear in the displacement those of the undeformed sheet.
    """
    if not law.linear_in_plane:
        return derivatives
    vectors = np.zeros_like(derivatives)
    vectors[0, 0] = vectors[1, 1] = 1.0
    return vectors


def _metric(law: MetricEnergy, derivatives: Array) -> Array:
    p, q = derivatives
    if law.linear_in_plane:
        return np.stack([2.0 * p[0] - 1.0, 2.0 * q[1] - 1.0, q[0] + p[1]])
    return np.stack([(p * p).sum(axis=0), (q * q).sum(axis=0), (p * q).sum(axis=0)])


def energy(law: MetricEnergy, derivatives: Array) -> Array:
    """Return W(a) of a flat sheet from x,1 and x,2 of the in-plane position, (2, 2, ...)."""
    return law.energy(_metric(law, derivatives))


def force(law: MetricEnergy, derivatives: Array) -> Array:
    """Return dW/da of a flat sheet, (3, ...)."""
    return law.derivatives(_metric(law, derivatives))[0]


def stiffness(law: MetricEnergy, derivatives: Array) -> Array:
    """Return d2W/da2 of a flat sheet, (3, 3, ...)."""
    return law.derivatives(_metric(law, derivatives))[1]


def gradient(stress: Array, vectors: Array) -> Array:
    """Return the derivative of a function of the metric with respect to x,1 and x,2.

    Parameters
    ----------
    stress : (3, ...) array
        Derivative of that function with respect to the metric.
    vectors : (2, 2, ...) array
        From `frame`.
    """
    p, q = vectors
    return np.stack([2.0 * stress[0] * p + stress[2] * q, 2.0 * stress[1] * q + stress[2] * p])


def expansion(law: MetricEnergy, derivatives: Array) -> tuple[Array, Array, list[Array]]:
    """Return energy, gradient and Hessian of the sheet per unit of thickness.

    Parameters
    ----------
    law : MetricEnergy
        Dimensionless material law, or its relaxed form.
    derivatives : (2, 2, ...) array
        x,1 and x,2 of the in-plane position.

    Returns
    -------
    energy : (...) array
        W(a).
    gradient : (2, 2, ...) array
    hessian : list of arrays
        Pairs of components (0,0) (0,1) (1,1) with 3, 4 and 3 rows.
    """
    vectors = frame(law, derivatives)
    p, q = vectors
    metric = _metric(law, derivatives)
    stress, stretching = law.derivatives(metric)
    variations = ((2.0 * p, None), (None, 2.0 * q), (q, p))  # da along dx,1 and dx,2
    stiff = np.zeros((3, 2, *p.shape))
    for k in range(3):
        for m, directions in enumerate(variations):
            for c, vector in enumerate(directions):
                if vector is not None:
                    stiff[k, c] += stretching[k, m] * vector
    blocks = []
    for i, j in ((0, 0), (0, 1), (1, 1)):
        rows = []
        entries = [(a, b) for a in range(2) for b in range(a if i == j else 0, 2)]
        for a, b in entries:
            entry = np.zeros(p.shape[1:])
            for k in range(3):
                vector = variations[k][a]
                if vector is not None:
                    entry += vector[i] * stiff[k, b, j]
            if i == j and not law.linear_in_plane:
                entry += stress[2] if a != b else 2.0 * stress[a]
            rows.append(entry)
        blocks.append(np.stack(rows))
    return law.energy(metric), gradient(stress, vectors), blocks
