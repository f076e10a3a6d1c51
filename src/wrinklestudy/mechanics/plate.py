"""Kirchhoff-Love plate energy with finite membrane strain: density, gradient and Hessian.

The mid-surface x(X, Y) has the metric a = (x,1.x,1, x,2.x,2, x,1.x,2) and the curvature
b = (x,11.n, x,22.n, x,12.n). `section` gives the energy psi(a, b) of the cross-section and its
derivatives; here they become derivatives with respect to x,1 x,2 x,11 x,22 x,12, exact and written
by hand.
"""

from typing import NamedTuple

import numpy as np

from wrinklestudy.mechanics.bending import SectionDerivatives
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.mechanics.section import Section
from wrinklestudy.mechanics.surface import SurfaceGeometry, dot
from wrinklestudy.typing import Array


def respond(section: Section, derivatives: Array) -> tuple[SurfaceGeometry, SectionDerivatives]:
    """Return the geometry and the section's derivatives from x,1 x,2 x,11 x,22 x,12 at points."""
    surface = section.surface(derivatives)
    return surface, section.derivatives(surface.metric, surface.curvature)


def energy(section: Section, derivatives: Array) -> Array:
    """Return the energy density at points from x,1 x,2 x,11 x,22 x,12 of shape (5, 3, ...)."""
    surface = section.surface(derivatives)
    return section.energy(surface.metric, surface.curvature)


def _metric_variation(surface: SurfaceGeometry) -> list[tuple[tuple[int, Array], ...]]:
    """Return da as (direction, vector) terms for a11, a22, a12."""
    p, q = surface.tangents
    return [((0, 2.0 * p),), ((1, 2.0 * q),), ((0, q), (1, p))]


def gradient(surface: SurfaceGeometry, section: SectionDerivatives) -> Array:
    """Return the derivative of the energy density, (5, 3, ...).

    da11 = 2 x,1.dx,1 and so on; db_k = n.(dx,k - Gamma^c_k dx,c), k = 11, 22, 12.
    """
    force, moment, normal = section.force, section.moment, surface.normal
    result = np.empty((5, *normal.shape))
    p, q = surface.tangents
    pull = np.einsum("k...,ck...->c...", moment, surface.christoffel)
    result[0] = 2.0 * force[0] * p + force[2] * q - pull[0] * normal
    result[1] = 2.0 * force[1] * q + force[2] * p - pull[1] * normal
    for k in range(3):
        result[2 + k] = moment[k] * normal
    return result


def predict(
    surface: SurfaceGeometry, section: SectionDerivatives, step: Array
) -> tuple[Array, Array]:
    """Return force and moment, (3, ...) each, after a step, to first order in it.

    Parameters
    ----------
    surface : SurfaceGeometry
        Geometry before the step.
    section : SectionDerivatives
        Section before the step.
    step : (5, 3, ...) array
        Change of x,1 x,2 x,11 x,22 x,12.
    """
    (p, q), along = surface.tangents, [dot(surface.normal, change) for change in step]
    metric = np.stack(
        [2.0 * dot(p, step[0]), 2.0 * dot(q, step[1]), dot(q, step[0]) + dot(p, step[1])]
    )
    turned = surface.christoffel[0] * along[0] + surface.christoffel[1] * along[1]
    curvature = np.stack(along[2:]) - turned
    force = np.einsum("km...,m...->k...", section.stretching, metric)
    force += np.einsum("km...,m...->k...", section.coupling, curvature)
    moment = np.einsum("km...,k...->m...", section.coupling, metric)
    moment += np.einsum("km...,m...->k...", section.bending, curvature)
    return section.force + force, section.moment + moment


class _HessianVectors(NamedTuple):
    """Vectors from which the entries of the Hessian are assembled."""

    metric: list[tuple[tuple[int, Array], ...]]  # da as (direction, vector) terms
    membrane: Array  # psi_aa da / d(x,c)_j, (3, 2, 3, ...)
    twist: Array  # (x,k).n against (x,c)_j, (3, 2, 3, ...)
    turn: Array  # turn[d, c, i] n_j + n_i turn[c, d, j] in the entry (x,c)_i (x,d)_j


def _hessian_vectors(surface: SurfaceGeometry, section: SectionDerivatives) -> _HessianVectors:
    normal, gamma = surface.normal, surface.christoffel
    terms = _metric_variation(surface)
    membrane = np.zeros((3, *surface.tangents.shape))
    coupled = np.zeros((3, *surface.tangents.shape))
    for k in range(3):
        for m, parts in enumerate(terms):
            for direction, vector in parts:
                membrane[k, direction] += section.stretching[k, m] * vector
                coupled[k, direction] += section.coupling[m, k] * vector
    pull = np.einsum("k...,ck...->c...", section.moment, gamma)
    inner = np.einsum("km...,cm...->ck...", section.bending, gamma)
    work = dot(section.moment, surface.curvature)
    turn = np.empty((2, 2, *normal.shape))
    for d in range(2):
        for c in range(2):
            inverse = surface.inverse[c if c == d else 2]
            along = 0.5 * (dot(gamma[c], inner[d]) - work * inverse)
            turn[d, c] = pull[c] * surface.dual[d] + along * normal
            for k in range(3):
                turn[d, c] -= gamma[d, k] * coupled[k, c]
    twist = coupled
    for k in range(3):
        for c in range(2):
            twist[k, c] -= inner[c, k] * normal
    return _HessianVectors(terms, membrane, twist, turn)


def hessian(surface: SurfaceGeometry, section: SectionDerivatives) -> list[Array]:
    """Return the second derivatives of the energy density for `Assembler.tangent`.

    The second variations are d2a11 = 2 |dx,1|^2 (and so on) and
    d2b_k = 2 (dx,k - Gamma^c_k dx,c).dn - b_k |dn|^2 with dn = -a^c (n.dx,c).

    Returns
    -------
    list of six arrays
        Pairs of components (0,0) (0,1) (0,2) (1,1) (1,2) (2,2); 15 rows (a <= b) for equal
        components, 25 rows for unequal ones.
    """
    parts = _hessian_vectors(surface, section)
    blocks = []
    for i in range(3):
        for j in range(i, 3):
            entries = [(a, b) for a in range(5) for b in range(a if i == j else 0, 5)]
            block = np.empty((len(entries), *surface.normal.shape[1:]))
            for row, (a, b) in enumerate(entries):
                _entry(surface, section, parts, (a, i), (b, j), block[row])
            blocks.append(block)
    return blocks


def _entry(
    surface: SurfaceGeometry,
    section: SectionDerivatives,
    parts: _HessianVectors,
    first: tuple[int, int],
    second: tuple[int, int],
    out: Array,
) -> None:
    """Write the second derivative with respect to (derivative, component) pairs."""
    (a, i), (b, j) = first, second
    normal = surface.normal
    if a >= 2 and b >= 2:
        np.multiply(normal[i], normal[j], out=out)
        out *= section.bending[a - 2, b - 2]
    elif a >= 2:
        np.multiply(normal[i], parts.twist[a - 2, b, j], out=out)
        out -= section.moment[a - 2] * surface.dual[b, i] * normal[j]
    elif b >= 2:
        _entry(surface, section, parts, second, first, out)
    else:
        np.multiply(parts.turn[b, a, i], normal[j], out=out)
        out += normal[i] * parts.turn[a, b, j]
        for k, terms in enumerate(parts.metric):
            for direction, vector in terms:
                if direction == a:
                    out += vector[i] * parts.membrane[k, b, j]
        if i == j and not (surface.linear_in_plane and i < 2):
            out += section.force[2] if a != b else 2.0 * section.force[a]


def deflection(
    law: Law, bending: str, derivatives: Array, relative: Array | float = 1.0
) -> tuple[Array, Array]:
    """Return the Hessians S and B for small deflections of a flat, stretched sheet.

    The energy of a deflection w on the flat state is t/2 w.S w + t^3/2 w.B w with S (stress) and B
    (bending) independent of t: S from psi_a w,a w,b and B from (t^3/3) lambda3^2 d2W/dg2 acting on
    w,k - Gamma^c_k w,c.

    Parameters
    ----------
    law : Law
        Dimensionless material law.
    bending : str
        The bending law, a name in `BENDING_LAWS`.
    derivatives : (5, 3, ...) array
        x,1 x,2 x,11 x,22 x,12 of the flat state.
    relative : (...) array or float
        Thickness of an uneven sheet over its mean t, which is then the t of the energy.

    Returns
    -------
    stress, bending : (15, ...) arrays
        Rows (a <= b) as in `Assembler.entries`.
    """
    section = Section(law, 1.0, bending)
    surface = section.surface(derivatives)
    flat = section.derivatives(surface.metric, np.zeros_like(surface.metric))
    entries = [(a, b) for a in range(5) for b in range(a, 5)]
    stress = np.zeros((15, *surface.metric.shape[1:]))
    force = section.law.derivatives(surface.metric)[0]
    stress[entries.index((0, 0))] = 2.0 * force[0]
    stress[entries.index((1, 1))] = 2.0 * force[1]
    stress[entries.index((0, 1))] = force[2]
    # Rows of the curvature variation on (w,1 w,2 w,11 w,22 w,12)
    rows = np.zeros((3, 5, *surface.metric.shape[1:]))
    for k in range(3):
        rows[k, 2 + k] = 1.0
        rows[k, 0], rows[k, 1] = -surface.christoffel[0, k], -surface.christoffel[1, k]
    full = np.einsum("ka...,km...,mb...->ab...", rows, flat.bending, rows, optimize=True)
    bent = np.stack([full[a, b] for a, b in entries])
    return relative * stress, relative**3 * bent
