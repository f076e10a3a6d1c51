"""Branches of wrinkled states over strain, by pseudo-arclength continuation.

The study does not need them: each of its states is found on its own. They show that those states
do not depend on a path, and whether wrinkles appear and vanish without a jump. Points u =
(position, eps) satisfy R(u) = 0; from one to the next the corrector keeps

    s = <dw/ds, w - w0> / (n t^2) + (deps/ds) (eps - eps0) / eps_scale^2

(w: deflections at the n nodes), so that it passes folds, where the strain turns back.
"""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from wrinklestudy.equilibrium.planar import Planar
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.equilibrium.wrinkled import Equilibrium
from wrinklestudy.fem.factorisation import IndefiniteSolver, make_indefinite_solver
from wrinklestudy.typing import Array

# Amplitudes over t below this are the flat state
_ZERO = 1.0e-3


class BranchPoint(NamedTuple):
    """One point of a branch."""

    strain: float
    amplitude: float  # largest |z| at the nodes over t, with the sign of the first point's peak
    energy: float  # of the quarter sheet, mu W^3
    unstable: int  # negative eigenvalues of the tangent at this strain
    iterations: int


@dataclass(frozen=True)
class ContinuationOptions:
    """Options of the continuation.

    Parameters
    ----------
    step : float
        First step of arclength; amplitudes count in units of t, strains in units of `strain_scale`.
    largest_step, smallest_step : float
        Bounds of the step.
    strain_scale : float
        Strain that counts as much as a mean deflection of one thickness.
    max_points : int
        Limit of points.
    tolerance : float
        Converged when the correction of the deflection falls below this part of t.
    max_iterations : int
        Newton iterations for each point before the step is halved.
    """

    step: float = 0.1
    largest_step: float = 0.4
    smallest_step: float = 1.0e-4
    strain_scale: float = 0.05
    max_points: int = 200
    tolerance: float = 1.0e-8
    max_iterations: int = 8


@dataclass(frozen=True)
class Branch:
    """A branch as a table, with its special points.

    Parameters
    ----------
    points : tuple of Point
    special : tuple of (kind, strain)
        'fold' where the strain turns back, 'vanishing' where the amplitude passes zero (a pitchfork
        of the flat state), 'stability' where the number of unstable directions changes.
    reason : str
        Why the branch ends.
    positions : tuple of arrays
        Position (3, size) of each point.
    """

    points: tuple[BranchPoint, ...]
    special: tuple[tuple[str, float], ...]
    reason: str
    positions: tuple[Array, ...] = field(repr=False)


class _Tracer:
    """The extended system R(u, eps) = 0 on the dofs of one quarter sheet."""

    def __init__(self, planar: Planar, thickness: float, options: ContinuationOptions) -> None:
        if planar.flat is None or planar.modes is None:
            raise ValueError(f"no flat state to start from: {planar.reason}")
        self.options, self.thickness = options, thickness
        self.space = planar.flat.space
        self.problem = PlateProblem(planar.flat, planar.modes, thickness)
        self.free = self.problem.assembler.free
        self.solver: IndefiniteSolver = make_indefinite_solver()
        values = np.zeros((3, self.space.size), dtype=bool)
        values[2, self.space.dofs.nodal_dofs[0]] = True
        self.deflections = values[self.free]

    def at(self, strain: float) -> PlateProblem:
        """Return the problem with the clamp at a strain."""
        clamped = self.space.coordinates[0].copy() * (1.0 + strain)
        edge = self.space.edge_dofs("clamp", ["u"])
        self.problem.prescribe(0, edge, clamped[edge])
        return self.problem

    def load(self, unknowns: Array, strain: float, step: float = 1e-5) -> Array:
        """Return dR/deps by a central difference (the clamp's part of the residual is smooth)."""
        residuals = [self.at(strain + k * step).reactions(unknowns)[self.free] for k in (-1, 1)]
        return (residuals[1] - residuals[0]) / (2.0 * step)

    def product(self, a: tuple[Array, float], b: tuple[Array, float]) -> float:
        """Return the inner product of two directions in the measure of the arclength."""
        w = self.deflections
        mean = float(a[0][w] @ b[0][w]) / (w.sum() * self.thickness**2)
        return mean + a[1] * b[1] / self.options.strain_scale**2

    def tangent(
        self, unknowns: Array, strain: float, along: tuple[Array, float]
    ) -> tuple[Array, float]:
        """Return the unit tangent of the branch that points along a direction."""
        _, _, matrix = self.at(strain).derivatives(unknowns)
        self.solver.factorise(matrix)
        direction = (-self.solver.solve(self.load(unknowns, strain)), 1.0)
        size = np.sqrt(self.product(direction, direction))
        sign = np.sign(self.product(direction, along)) or 1.0
        return sign * direction[0] / size, sign / size

    def correct(
        self, start: tuple[Array, float], along: tuple[Array, float]
    ) -> tuple[Array, float, int, int] | None:
        """Return unknowns, strain, iterations and unstable directions, or None if it fails."""
        unknowns, strain = start[0].copy(), start[1]
        w = self.deflections
        for iteration in range(1, self.options.max_iterations + 1):
            _, residual, matrix = self.at(strain).derivatives(unknowns)
            self.solver.factorise(matrix)
            load = self.load(unknowns, strain)
            change, response = self.solver.solve(np.column_stack([-residual, -load])).T
            ahead = (unknowns - start[0], strain - start[1])
            missing = -self.product(along, ahead) - self.product(along, (change, 0.0))
            shift = missing / self.product(along, (response, 1.0))
            step = change + shift * response
            unknowns, strain = unknowns + step, strain + shift
            if not (np.isfinite(strain) and strain > 0.0):
                return None
            if np.abs(step[w]).max() < self.options.tolerance * self.thickness:
                return unknowns, strain, iteration, self.solver.negative
        return None

    def advance(
        self, last: tuple[Array, float], along: tuple[Array, float], step: float
    ) -> tuple[tuple[Array, float, int, int] | None, float]:
        """Return the next point, None if every step failed, and the step that led to it."""
        while step >= self.options.smallest_step:
            guess = (last[0] + step * along[0], last[1] + step * along[1])
            if found := self.correct(guess, along):
                return found, step
            step /= 2.0
        return None, step

    def secant(self, last: tuple[Array, float], now: tuple[Array, float]) -> tuple[Array, float]:
        """Return the unit direction from one point to the next."""
        ahead = (now[0] - last[0], now[1] - last[1])
        size = np.sqrt(self.product(ahead, ahead))
        return ahead[0] / size, ahead[1] / size

    def point(self, unknowns: Array, strain: float, iterations: int, unstable: int) -> BranchPoint:
        """Return the row of the table."""
        deflection = unknowns[self.deflections]
        largest = float(deflection[np.abs(deflection).argmax()])
        energy = self.at(strain).energy(unknowns)
        return BranchPoint(strain, largest / self.thickness, energy, unstable, iterations)


def trace(
    start: Equilibrium,
    strains: tuple[float, float],
    upward: bool = True,
    options: ContinuationOptions | None = None,
) -> Branch:
    """Follow a branch of wrinkled states from an equilibrium.

    Parameters
    ----------
    start : Equilibrium
        A converged state with wrinkles.
    strains : (float, float)
        Smallest and largest strain; the branch ends beyond them or where the amplitude passes zero.
    upward : bool
        Toward larger strains first.
    options : Options, optional

    Raises
    ------
    ValueError
        If the start is not a wrinkled state.
    """
    if start.status != "wrinkled" or start.position is None:
        raise ValueError(f"start: status {start.status!r}, must be a wrinkled state")
    options = options or ContinuationOptions()
    tracer = _Tracer(start.planar, start.thickness, options)
    unknowns, strain = start.position[tracer.free], start.planar.strain
    first = unknowns[tracer.deflections]
    along = tracer.tangent(unknowns, strain, (np.zeros_like(unknowns), 1.0 if upward else -1.0))
    row = tracer.point(unknowns, strain, 0, tracer.solver.negative)
    points = [row._replace(amplitude=abs(row.amplitude))]
    positions, step = [start.position], options.step
    reason = f"{options.max_points} points"
    while len(points) < options.max_points:
        found, step = tracer.advance((unknowns, strain), along, step)
        if found is None:
            reason = "the step became too small"
            break
        along = tracer.secant((unknowns, strain), found[:2])
        unknowns, strain, iterations, unstable = found
        row = tracer.point(unknowns, strain, iterations, unstable)
        sign = np.sign(float(unknowns[tracer.deflections] @ first))
        points.append(row._replace(amplitude=sign * abs(row.amplitude)))
        positions.append(tracer.at(strain).position(unknowns))
        if points[-1].amplitude <= _ZERO:
            reason = "the amplitude vanishes"
            break
        if not strains[0] <= strain <= strains[1]:
            reason = "end of the range of strains"
            break
        step = min(options.largest_step, step * (1.5 if iterations <= 4 else 0.8))
    return Branch(tuple(points), _special(points), reason, tuple(positions))


def _special(points: list[BranchPoint]) -> tuple[tuple[str, float], ...]:
    """Return folds, the pitchfork where the amplitude vanishes, and changes of stability."""
    found: list[tuple[str, float]] = []
    wrinkled = [p for p in points if p.amplitude > _ZERO]
    if len(points) >= 3 and points[-1].amplitude <= _ZERO:
        found.append(("vanishing", _vanishing(wrinkled)))
    for k in range(1, len(wrinkled)):
        last, now = wrinkled[k - 1], wrinkled[k]
        if k >= 2 and (now.strain - last.strain) * (last.strain - wrinkled[k - 2].strain) < 0:
            found.append(("fold", last.strain))
        if now.unstable != last.unstable:
            found.append(("stability", 0.5 * (last.strain + now.strain)))
    return tuple(found)


def _vanishing(points: list[BranchPoint]) -> float:
    """Return where A^2, which is linear in the strain at a pitchfork, vanishes."""
    a, b = points[-2], points[-1]
    return b.strain + b.amplitude**2 * (b.strain - a.strain) / (a.amplitude**2 - b.amplitude**2)
