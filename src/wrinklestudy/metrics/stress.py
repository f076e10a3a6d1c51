"""Stretches, stresses and bending energy on the deformed sheet, sampled."""

from dataclasses import dataclass
from itertools import product

import numpy as np

from wrinklestudy.mechanics.section import Section
from wrinklestudy.metrics.interpolant import DeformedSheet, subdivided
from wrinklestudy.typing import Array

# Second derivatives jump from cell to cell: on a line the mean of both sides, this far from it, is
# taken, so that fields have the mirrors of the sheet.
_ASIDE = 1e-6
# x,1 x,2 x,11 x,22 x,12 as orders of d/dX, d/dY
_DERIVATIVES = ((1, 0), (0, 1), (2, 0), (0, 2), (1, 1))


@dataclass(frozen=True)
class SampledStress:
    """The whole deformed sheet as a membrane and as a plate, on a grid of points.

    Parameters
    ----------
    reference_x, reference_y : ndarray, shapes (m,) and (n,)
        Reference coordinates of the points in units of W.
    position : ndarray, shape (3, m, n)
        Deformed x, y, z in units of W.
    principal_stretches : ndarray, shape (2, m, n)
        Of the mid-surface, the larger first.
    thickness_stretch : ndarray, shape (m, n)
        Thickness over thickness at rest.
    cauchy : ndarray, shape (3, m, n)
        True stress of the mid-surface, xx, yy, xy in the tangent plane, in units of mu: x is the
        direction of the material lines Y = const, y is perpendicular to it in the surface. A law of
        small strains makes no difference between this and other stresses, x and X.
    principal_cauchy : ndarray, shape (2, m, n)
        Its principal values, the larger first.
    bending_energy : ndarray, shape (m, n)
        [psi(a, b) - psi(a, 0)]/t: energy of bending per volume at rest, mean over the thickness, in
        units of mu.
    """

    reference_x: Array
    reference_y: Array
    position: Array
    principal_stretches: Array
    thickness_stretch: Array
    cauchy: Array
    principal_cauchy: Array
    bending_energy: Array


def sampled_stress(
    sheet: DeformedSheet, section: Section, per_cell: tuple[int, int]
) -> SampledStress:
    """Return stretches, stresses and bending energy of the whole sheet.

    With the energy W(g) of the material at the metric g = a of the mid-surface the second
    Piola-Kirchhoff stress is S = 2 dW/dg, and the Cauchy stress S^ab x,a x,b / J with
    J = sqrt(det a) lambda3. Of a law whose strain E is linear in the plane, g = 1 + 2 E is no
    metric: its stress is S itself, and its principal stretches are 1 + E.

    Parameters
    ----------
    sheet : DeformedSheet
        In units of W.
    section : Section
        Law, thickness and bending law.
    per_cell : (int, int)
        Samples for each cell along the pull and across.
    """
    whole = sheet.unfolded()
    x, y = subdivided(whole.grid.x, per_cell[0]), subdivided(whole.grid.y, per_cell[1])
    derivatives = np.stack([_beside_lines(whole, x, y, *orders) for orders in _DERIVATIVES])
    surface = section.surface(derivatives)
    metric, law = surface.metric, section.law
    stress = law.derivatives(metric)[0] * np.array([2.0, 2.0, 1.0])[:, None, None]
    thickness_stretch = law.thickness_stretch(metric)[0]
    if law.linear_in_plane:
        stretches = 0.5 * (1.0 + _principal(metric))
    else:
        stretches = np.sqrt(_principal(metric))
        stress = _pushed_forward(stress, metric, thickness_stretch)
    bent = section.energy(metric, surface.curvature)
    unbent = section.energy(metric, np.zeros_like(surface.curvature))
    return SampledStress(
        x,
        y,
        whole.evaluate(x, y),
        stretches,
        thickness_stretch,
        stress,
        _principal(stress),
        (bent - unbent) / section.thickness,
    )


def _pushed_forward(stress: Array, metric: Array, thickness_stretch: Array) -> Array:
    """Return the Cauchy stress of a second Piola-Kirchhoff stress, (11, 22, 12) each."""
    first, second, mixed = stress
    area = np.sqrt(metric[0] * metric[1] - metric[2] ** 2)
    along = np.sqrt(metric[0])
    # x,1 = along e_x and x,2 = shear e_x + (area / along) e_y
    shear, across = metric[2] / along, area / along
    cauchy = np.stack(
        [
            first * along**2 + 2.0 * mixed * along * shear + second * shear**2,
            second * across**2,
            (mixed * along + second * shear) * across,
        ]
    )
    return cauchy / (area * thickness_stretch)


def _principal(tensor: Array) -> Array:
    """Return the eigenvalues of symmetric 2 x 2 tensors (xx, yy, xy), the larger first."""
    mean, half = 0.5 * (tensor[0] + tensor[1]), 0.5 * (tensor[0] - tensor[1])
    radius = np.hypot(half, tensor[2])
    return np.stack([mean + radius, mean - radius])


def _beside_lines(sheet: DeformedSheet, x: Array, y: Array, dx: int, dy: int) -> Array:
    """Return a derivative as the mean of its values on both sides of grid lines."""
    if dx + dy < 2:
        return sheet.evaluate(x, y, dx, dy)
    beside_x, beside_y = _both_sides(x, sheet.grid.x), _both_sides(y, sheet.grid.y)
    values = [sheet.evaluate(a, b, dx, dy) for a, b in product(beside_x, beside_y)]
    return np.mean(values, axis=0)


def _both_sides(points: Array, lines: Array) -> tuple[Array, Array]:
    """Return points moved a little to either side, none of them beyond the last lines."""
    step = _ASIDE * np.diff(lines).min()
    return points - step * (points > lines[0]), points + step * (points < lines[-1])
