"""How well energy, residual and tangent belong together, and what rigid motions cost."""

import warnings
from collections.abc import Callable

import numpy as np
from scipy import sparse
from scipy.spatial.transform import Rotation

from verification.tools.problem import VALUE, LoadedSheet, nodes
from wrinklestudy.equilibrium.flat import MembraneProblem
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.upper_triangle import multiply
from wrinklestudy.mechanics import membrane, plate
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

THICKNESS = 0.05
CURVATURE = 0.15  # largest entry of t x,ab
POINTS = 200
STEP = 4.0e-3
ROLL = 1.6  # angle in radians over the half width of the curved state
TURN = (0.7, 1.1, -2.0)  # rotation vector of the rigid motion
SHIFT = (3.0, -1.0, 2.0)
_COMPLEX_STEP = 1.0e-30
_LARGEST_MOVE = 2.0  # of a twist dof; all others move less
_WEIGHTS = (4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0)  # of an eighth-order difference
# x,11 x,22 x,12 are varied in units of 1/t, so that bending counts as much as stretching.
_SCALE = np.array([1.0, 1.0, *[1.0 / THICKNESS] * 3])[:, None, None]


def difference(function: Callable[[Array], Array], at: Array, direction: Array) -> Array:
    """Return the derivative of a function along a direction, to eighth order in `STEP`."""
    total = np.zeros(())
    for k, weight in enumerate(_WEIGHTS, start=1):
        move = k * STEP * direction
        total = total + weight * (function(at + move) - function(at - move))
    return total / STEP


def states(stretches: tuple[float, float]) -> Array:
    """Return x,1 x,2 x,11 x,22 x,12 with large stretch, curvature and rotation, (5, 3, POINTS)."""
    rng = np.random.default_rng(1)
    rotation = Rotation.random(POINTS, rng=2).as_matrix()
    principal = rng.uniform(*stretches, (POINTS, 2))
    turn = rng.uniform(0.0, np.pi, POINTS)
    axes = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    stretch = np.einsum("iap,pa,jap->pij", axes, principal, axes)
    values = np.empty((5, 3, POINTS))
    values[:2] = np.einsum("pia,pab->bip", rotation[:, :, :2], stretch)
    values[2:] = rng.uniform(-1.0, 1.0, (3, 3, POINTS)) * CURVATURE / THICKNESS
    return values


def _gradient(section: Section, values: Array) -> Array:
    return plate.gradient(*plate.respond(section, values))


def _full_hessian(section: Section, values: Array) -> Array:
    """Return the Hessian (5, 3, 5, 3, ...) from its blocks."""
    blocks = plate.hessian(*plate.respond(section, values))
    full = np.empty((5, 3, 5, 3, *values.shape[2:]))
    pairs = [(i, j) for i in range(3) for j in range(i, 3)]
    for (i, j), block in zip(pairs, blocks, strict=True):
        entries = [(a, b) for a in range(5) for b in range(a if i == j else 0, 5)]
        for (a, b), row in zip(entries, block, strict=True):
            full[a, i, b, j] = full[b, j, a, i] = row
    return full


def _complex_energy(section: Section, values: Array) -> Array:
    """Return the energy density of complex derivatives."""
    with warnings.catch_warnings():
        # SVK fills a second derivative that the energy does not use into a real array
        warnings.simplefilter("ignore", np.exceptions.ComplexWarning)
        return plate.energy(section, values)


def point_errors(section: Section, values: Array) -> tuple[float, float]:
    """Return the largest relative error of gradient and Hessian over the points.

    The gradient is compared with complex steps in the energy, the Hessian with eighth-order
    differences of the gradient.
    """
    gradient, hessian = _gradient(section, values), _full_hessian(section, values)
    errors = np.zeros((2, values.shape[2]))
    for a in range(5):
        for i in range(3):
            unit = np.zeros_like(values)
            unit[a, i] = _SCALE[a, 0, 0]
            stepped = _complex_energy(section, values + 1j * _COMPLEX_STEP * unit)
            slope = stepped.imag / _COMPLEX_STEP
            wrong = np.abs(slope - gradient[a, i] * _SCALE[a, 0, 0])
            errors[0] = np.maximum(errors[0], wrong)
            row = difference(lambda at: _gradient(section, at), values, unit)
            wrong = np.abs((row - hessian[a, i] * _SCALE[a, 0, 0]) * _SCALE).max(axis=(0, 1))
            errors[1] = np.maximum(errors[1], wrong)
    first = np.abs(gradient * _SCALE).max(axis=(0, 1))
    second = np.abs(hessian * _SCALE[:, :, None, None] * _SCALE).max(axis=(0, 1, 2, 3))
    return float((errors[0] / first).max()), float((errors[1] / second).max())


def curved(space: Space) -> Array:
    """Return a stretched, rolled up and rippled sheet, turned in space: (3, size)."""
    x, y = space.grid.x[:, None], space.grid.y[None, :]
    along, across = 1.08, 0.97
    radius = 0.5 * across / ROLL
    angle = across * y / radius + 0.1 * np.sin(2 * x)
    by_x, by_y = 0.2 * np.cos(2 * x), across / radius
    sine, cosine = radius * np.sin(angle), radius * np.cos(angle)
    values = np.array([nodes(space)] * 3)
    values[0] = [
        along * x + 0.02 * np.sin(4 * x) * np.cos(5 * y),
        along + 0.08 * np.cos(4 * x) * np.cos(5 * y),
        -0.1 * np.sin(4 * x) * np.sin(5 * y),
        -0.4 * np.cos(4 * x) * np.sin(5 * y),
    ]
    values[1] = [sine, cosine * by_x, cosine * by_y, -sine * by_x * by_y]
    values[2] = [cosine, -sine * by_x, -sine * by_y, -cosine * by_x * by_y]
    turn = Rotation.from_rotvec((0.3, -0.5, 0.8)).as_matrix()
    return turn @ space.field_from_nodes(values)


def assembled_errors(
    derivatives: Callable[[Array], tuple[float, Array, sparse.csr_array]],
    slope: Callable[[Array], float],
    start: Array,
) -> tuple[float, float, float]:
    """Return relative errors of residual and tangent, and the asymmetry of the residual's slope.

    The directions are random, and every dof counts alike (the tangent's diagonal becomes 1).

    Parameters
    ----------
    derivatives : callable
        Energy, residual and upper triangle of the tangent.
    slope : callable
        Derivative of the energy along a direction, without the residual.
    start : (n,) array
        The unknowns at which to compare.
    """
    _, residual, tangent = derivatives(start)
    scale = 1.0 / np.sqrt(np.abs(tangent.diagonal()))
    directions = scale * np.random.default_rng(3).standard_normal((2, len(start)))
    directions *= _LARGEST_MOVE / np.abs(directions).max()
    first, second, changes = 0.0, 0.0, []
    for direction in directions:
        size = np.linalg.norm(residual * scale) * np.linalg.norm(direction / scale)
        first = max(first, abs(slope(direction) - float(residual @ direction)) / float(size))
        change = difference(lambda at: derivatives(at)[1], start, direction)
        product = multiply(tangent, direction)
        wrong = np.abs((change - product) * scale).max()
        second = max(second, float(wrong / np.abs(product * scale).max()))
        changes.append(change)
    crossed = directions[0] @ changes[1] - directions[1] @ changes[0]
    size = np.linalg.norm(directions[0] / scale) * np.linalg.norm(changes[1] * scale)
    return first, second, float(abs(crossed) / size)


def plate_errors(problem: PlateProblem, start: Array) -> tuple[float, float, float]:
    """Return `assembled_errors` of a plate problem."""
    space, free = problem.assembler.space, problem.assembler.free

    def slope(direction: Array) -> float:
        field = problem.position(start).astype(complex)
        field[free] += 1j * _COMPLEX_STEP * direction
        density = _complex_energy(problem.section, space.derivatives(field))
        return float((density.imag * space.measure).sum()) / _COMPLEX_STEP

    return assembled_errors(problem.derivatives, slope, start)


def membrane_errors(problem: MembraneProblem, start: Array) -> tuple[float, float, float]:
    """Return `assembled_errors` of a flat problem."""
    space, free = problem.assembler.space, problem.assembler.free

    def slope(direction: Array) -> float:
        field = problem.position(start).astype(complex)
        field[free] += 1j * _COMPLEX_STEP * direction
        density = membrane.energy(problem.law, space.derivatives(field, 2))
        return float((density.imag * space.measure).sum()) / _COMPLEX_STEP

    return assembled_errors(problem.derivatives, slope, start)


def rigid_errors(section: Section, space: Space) -> tuple[float, float, float]:
    """Return what a rigid motion does to energy and residual of a curved state.

    Returns
    -------
    energy, residual : float
        Relative change of the energy, and of the residual turned back.
    work : float
        Largest work of the residual in a rigid velocity, in parts of the sum of its moduli.
    """
    turn = Rotation.from_rotvec(TURN).as_matrix()
    if section.bending == "fvk":  # tied to the direction z
        turn = Rotation.from_rotvec((0.0, 0.0, TURN[2])).as_matrix()
    ones = nodes(space)
    ones[VALUE] = 1.0
    uniform = space.field_from_nodes(ones)
    before = curved(space)
    after = turn @ before + np.outer(SHIFT, uniform)
    everything = np.ones(before.shape, dtype=bool)
    energies, residuals = [], []
    for position in (before, after):
        problem = LoadedSheet(space, section, everything, position)
        energy, residual, _ = problem.derivatives(position.ravel())
        energies.append(energy)
        residuals.append(residual.reshape(3, -1))
    drift = np.linalg.norm(residuals[1] - turn @ residuals[0]) / np.linalg.norm(residuals[0])
    axes = np.eye(3) if section.bending != "fvk" else np.eye(3)[2:]
    spins = [np.cross(axis, before, axis=0) for axis in axes]
    velocities = [np.outer(axis, uniform) for axis in np.eye(3)] + spins
    terms = [residuals[0] * velocity for velocity in velocities]
    work = max(abs(float(term.sum())) / float(np.abs(term).sum()) for term in terms)
    return abs(energies[1] / energies[0] - 1.0), float(drift), work


def at_rest(section: Section, space: Space) -> tuple[float, float]:
    """Return energy and largest residual per t of the undeformed sheet, moved rigidly."""
    turn = Rotation.from_rotvec(TURN if section.bending != "fvk" else (0, 0, 1)).as_matrix()
    position = turn @ space.coordinates
    problem = LoadedSheet(space, section, np.ones(position.shape, dtype=bool), position)
    energy, residual, _ = problem.derivatives(position.ravel())
    thickness = float(section.thickness)
    return abs(energy) / thickness, float(np.abs(residual).max()) / thickness
