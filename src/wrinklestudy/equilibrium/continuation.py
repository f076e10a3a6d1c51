"""Branches of wrinkled states over strain, by pseudo-arclength continuation.

No study needs them, because each state is found on its own. They show that those states do not
depend on a path, and whether wrinkles appear and vanish without a jump. Points u =
(position, eps) satisfy R(u) = 0; from one to the next the corrector prescribes

    s = <dw/ds, w - w0> / (n t^2) + (deps/ds) (eps - eps0) / eps_scale^2

(w: deflections at the n nodes), so that it passes folds, where the strain reverses.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from wrinklestudy.equilibrium.planar import Planar
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.equilibrium.wrinkled import Equilibrium
from wrinklestudy.fem.factorisation import IndefiniteSolver, make_indefinite_solver
from wrinklestudy.typing import Array

# An amplitude over t below this means the flat state
_ZERO = 1.0e-3


class PathPoint(NamedTuple):
    """Unknowns and strain of a sheet, or a direction in which both change."""

    unknowns: Array
    strain: float

    def moved(self, along: "PathPoint", length: float = 1.0) -> "PathPoint":
        """Return the point after a step in a direction."""
        return PathPoint(
            self.unknowns + length * along.unknowns, self.strain + length * along.strain
        )

    def minus(self, other: "PathPoint") -> "PathPoint":
        """Return the direction from another point to this one."""
        return PathPoint(self.unknowns - other.unknowns, self.strain - other.strain)


class Corrected(NamedTuple):
    """A point that the corrector converged to."""

    point: PathPoint
    iterations: int
    unstable: int  # negative eigenvalues of the tangent


class SpecialPoint(NamedTuple):
    """A point of a branch at which something happens."""

    kind: str  # 'fold', 'vanishing' or 'stability', see `Branch`
    strain: float


class BranchPoint(NamedTuple):
    """One point of a branch as a row of its table."""

    strain: float
    amplitude: float  # largest |z| at the nodes over t, with the sign of the first point's peak
    energy: float  # of the part that is solved, mu W^3
    unstable: int  # negative eigenvalues of the tangent
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
        Largest number of points.
    tolerance : float
        A point has converged when the correction of the deflection is below this fraction of t.
    max_iterations : int
        Newton iterations per point before the step is halved.
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
    points : tuple of BranchPoint
    special : tuple of SpecialPoint
        'fold' where the strain reverses, 'vanishing' where the amplitude passes zero (a pitchfork
        of the flat state), 'stability' where the number of unstable directions changes.
    reason : str
        Why the branch ends.
    positions : tuple of arrays
        Position (3, size) of each point.
    """

    points: tuple[BranchPoint, ...]
    special: tuple[SpecialPoint, ...]
    reason: str
    positions: tuple[Array, ...] = field(repr=False)


class ExtendedSystem:
    """The system R(u, eps) = 0 of a sheet, with the measure of the arclength along its branches.

    Parameters
    ----------
    planar : Planar
        The planar state at any strain of the sheet.
    thickness : float
        t/W.
    options : ContinuationOptions

    Raises
    ------
    ValueError
        If there is no flat state.
    """

    def __init__(self, planar: Planar, thickness: float, options: ContinuationOptions) -> None:
        if planar.flat is None or planar.modes is None:
            raise ValueError(f"no flat state to start from: {planar.reason}")
        self.options, self.thickness = options, thickness
        self.space, self.clamp = planar.flat.space, planar.modes.symmetry.clamp
        self.problem = PlateProblem.of_flat(planar.flat, planar.modes, thickness)
        self.free = self.problem.assembler.free
        self.solver: IndefiniteSolver = make_indefinite_solver()
        at_nodes = np.zeros((3, self.space.size), dtype=bool)
        at_nodes[2, self.space.dofs.nodal_dofs[0]] = True
        self.deflections = at_nodes[self.free]  # deflections at the nodes

    def at(self, strain: float) -> PlateProblem:
        """Return the problem with the clamp moved to a strain, always the same object."""
        self.problem.prescribe(self.clamp.position(self.space, strain))
        return self.problem

    def load(self, point: PathPoint, step: float = 1e-5) -> Array:
        """Return dR/deps by a central difference; the residual depends smoothly on the clamp."""
        below, above = (
            self.at(point.strain + k * step).reactions(point.unknowns)[self.free] for k in (-1, 1)
        )
        return (above - below) / (2.0 * step)

    def product(self, a: PathPoint, b: PathPoint) -> float:
        """Return the inner product of two directions in the measure of the arclength."""
        w = self.deflections
        mean = float(a.unknowns[w] @ b.unknowns[w]) / (w.sum() * self.thickness**2)
        return mean + a.strain * b.strain / self.options.strain_scale**2

    def unit(self, direction: PathPoint) -> PathPoint:
        """Return a direction of unit length."""
        size = np.sqrt(self.product(direction, direction))
        return PathPoint(direction.unknowns / size, direction.strain / size)

    def tangent(self, point: PathPoint, upward: bool) -> PathPoint:
        """Return the unit tangent of the branch at a point, towards larger or smaller strains."""
        self.solver.factorise(self.at(point.strain).derivatives(point.unknowns).tangent)
        sign = 1.0 if upward else -1.0
        return self.unit(PathPoint(-sign * self.solver.solve(self.load(point)), sign))

    def correct(self, guess: PathPoint, along: PathPoint) -> Corrected | None:
        """Return the point of the branch from a guess, by a correction normal to a direction.

        None if Newton's method does not converge or leaves the positive strains.
        """
        point = guess
        for iteration in range(1, self.options.max_iterations + 1):
            here = self.at(point.strain).derivatives(point.unknowns)
            self.solver.factorise(here.tangent)
            columns = np.column_stack([-here.residual, -self.load(point)])
            change, response = self.solver.solve(columns).T
            missing = -self.product(along, point.minus(guess)) - self.product(
                along, PathPoint(change, 0.0)
            )
            shift = missing / self.product(along, PathPoint(response, 1.0))
            step = PathPoint(change + shift * response, shift)
            point = point.moved(step)
            if not (np.isfinite(point.strain) and point.strain > 0.0):
                return None
            largest = np.abs(step.unknowns[self.deflections]).max()
            if largest < self.options.tolerance * self.thickness:
                return Corrected(point, iteration, self.solver.negative_eigenvalues)
        return None

    def advance(
        self, last: PathPoint, along: PathPoint, step: float
    ) -> tuple[Corrected | None, float]:
        """Return the next point and the step that led to it; None if every step failed."""
        while step >= self.options.smallest_step:
            corrected = self.correct(last.moved(along, step), along)
            if corrected is not None:
                return corrected, step
            step /= 2.0
        return None, step

    def row(self, point: PathPoint, iterations: int, unstable: int) -> BranchPoint:
        """Return the row of the table, with the amplitude unsigned."""
        amplitude = float(np.abs(point.unknowns[self.deflections]).max()) / self.thickness
        energy = self.at(point.strain).energy(point.unknowns)
        return BranchPoint(point.strain, amplitude, energy, unstable, iterations)


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
        Whether to start towards larger strains.
    options : ContinuationOptions, optional

    Raises
    ------
    ValueError
        If the start is not a wrinkled state.
    """
    if start.status != "wrinkled" or start.position is None:
        raise ValueError(f"start: status {start.status!r}, must be a wrinkled state")
    options = options or ContinuationOptions()
    system = ExtendedSystem(start.planar, start.thickness, options)
    point = PathPoint(start.position[system.free], start.planar.strain)
    first = point.unknowns[system.deflections]
    along = system.tangent(point, upward)
    rows = [system.row(point, 0, system.solver.negative_eigenvalues)]
    positions, step, reason = [start.position], options.step, ""
    while not reason and len(rows) < options.max_points:
        corrected, step = system.advance(point, along, step)
        if corrected is None:
            reason = "the step became too small"
            break
        along = system.unit(corrected.point.minus(point))
        point, iterations, unstable = corrected
        row = system.row(point, iterations, unstable)
        sign = np.sign(float(point.unknowns[system.deflections] @ first))
        rows.append(row._replace(amplitude=sign * row.amplitude))
        positions.append(system.at(point.strain).position(point.unknowns))
        reason = _end(rows[-1], strains)
        step = min(options.largest_step, step * (1.5 if iterations <= 4 else 0.8))
    reason = reason or f"{options.max_points} points"
    return Branch(tuple(rows), special_points(rows), reason, tuple(positions))


def _end(row: BranchPoint, strains: tuple[float, float]) -> str:
    """Return why a branch ends at a point; empty if it goes on."""
    if row.amplitude <= _ZERO:
        return "the amplitude vanishes"
    if not strains[0] <= row.strain <= strains[1]:
        return "end of the range of strains"
    return ""


def special_points(points: Sequence[BranchPoint]) -> tuple[SpecialPoint, ...]:
    """Return the special points of a branch, see `Branch`."""
    special: list[SpecialPoint] = []
    wrinkled = [p for p in points if p.amplitude > _ZERO]
    if len(points) >= 3 and points[-1].amplitude <= _ZERO:
        special.append(SpecialPoint("vanishing", _vanishing(wrinkled)))
    for k in range(1, len(wrinkled)):
        last, now = wrinkled[k - 1], wrinkled[k]
        if k >= 2 and (now.strain - last.strain) * (last.strain - wrinkled[k - 2].strain) < 0:
            special.append(SpecialPoint("fold", last.strain))
        if now.unstable != last.unstable:
            special.append(SpecialPoint("stability", 0.5 * (last.strain + now.strain)))
    return tuple(special)


def _vanishing(points: Sequence[BranchPoint]) -> float:
    """Return where A^2 vanishes, which is linear in the strain near a pitchfork."""
    a, b = points[-2], points[-1]
    return b.strain + b.amplitude**2 * (b.strain - a.strain) / (a.amplitude**2 - b.amplitude**2)
