"""Geometry of the deformed mid-surface: what a bending law takes as metric and curvature."""

from typing import NamedTuple

import numpy as np

from wrinklestudy.typing import Array

_VOIGT = ((0, 0), (1, 1), (0, 1))


class SurfaceGeometry(NamedTuple):
    """Geometry of the mid-surface at points; b = n.(x,ab), Christoffel symbols x,ab.a^c."""

    tangents: Array  # x,1 and x,2: (2, 3, ...)
    normal: Array  # n: (3, ...)
    dual: Array  # a^1 and a^2: (2, 3, ...)
    metric: Array  # a: (3, ...)
    inverse: Array  # a^11, a^22, a^12: (3, ...)
    curvature: Array  # b: (3, ...)
    christoffel: Array  # (2, 3, ...): upper index, then 11, 22, 12
    linear_in_plane: bool = False  # then metric and tangents are those of `linear_strain`


def dot(a: Array, b: Array) -> Array:
    """Return the scalar product of vectors, (3, ...) each."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _metric(first: Array) -> Array:
    return np.stack([dot(first[i], first[j]) for i, j in _VOIGT])


def curved_surface(derivatives: Array) -> SurfaceGeometry:
    """Return the geometry from x,1 x,2 x,11 x,22 x,12 of shape (5, 3, ...)."""
    first, second = derivatives[:2], derivatives[2:]
    metric = _metric(first)
    p, q = first
    cross = np.stack(
        [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    )
    det = metric[0] * metric[1] - metric[2] ** 2
    normal = cross / np.sqrt(det)
    inverse = np.stack([metric[1], metric[0], -metric[2]]) / det
    dual = np.stack([inverse[0] * p + inverse[2] * q, inverse[2] * p + inverse[1] * q])
    curvature = np.stack([dot(second[k], normal) for k in range(3)])
    christoffel = np.stack([np.stack([dot(second[k], d) for k in range(3)]) for d in dual])
    return SurfaceGeometry(first, normal, dual, metric, inverse, curvature, christoffel)


def linear_strain(surface: SurfaceGeometry) -> SurfaceGeometry:
    """Return a geometry whose metric is 1 + 2 E, E = (u_a,b + u_b,a + w,a w,b)/2.

    Its tangents are what turns dx,1 and dx,2 into a change of this metric: (1, 0, w,1) and
    (0, 1, w,2).
    """
    p, q = surface.tangents
    tangents = np.zeros_like(surface.tangents)
    tangents[0, 0] = tangents[1, 1] = 1.0
    tangents[:, 2] = surface.tangents[:, 2]
    metric = np.stack(
        [2.0 * p[0] - 1.0 + p[2] ** 2, 2.0 * q[1] - 1.0 + q[2] ** 2, q[0] + p[1] + p[2] * q[2]]
    )
    return surface._replace(tangents=tangents, metric=metric, linear_in_plane=True)


def shallow_surface(derivatives: Array) -> SurfaceGeometry:
    """Return the geometry with the normal fixed at z, whatever the deflection.

    The curvature is then made of the second derivatives of the deflection, z,11 z,22 z,12.
    """
    first, second = derivatives[:2], derivatives[2:]
    metric = _metric(first)
    points = metric.shape[1:]
    normal = np.zeros((3, *points), dtype=derivatives.dtype)
    normal[2] = 1.0
    zeros = np.zeros((2, 3, *points), dtype=derivatives.dtype)
    return SurfaceGeometry(
        first, normal, zeros, metric, np.zeros_like(metric), second[:, 2], zeros.copy()
    )
