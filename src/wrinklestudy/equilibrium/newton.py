"""Safeguarded Newton minimisation of an energy.

Plain Newton steps near the minimum; away from it the tangent is shifted until it is positive
definite and the energy falls, by a shorter step or, as in Levenberg's and Marquardt's method, by a
larger shift. The factorisation tells whether it is definite.
"""

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from scipy import sparse

from wrinklestudy.fem.factorisation import NotPositiveDefiniteError, Solver
from wrinklestudy.typing import Array


class Problem(Protocol):
    """An energy over a vector of unknowns."""

    def energy(self, unknowns: Array) -> float:
        """Return the energy, or infinity where it is not defined."""

    def derivatives(self, unknowns: Array) -> tuple[float, Array, sparse.csr_array]:
        """Return the energy, the residual and the upper triangle of the tangent."""

    def residual(self, unknowns: Array) -> Array:
        """Return the residual alone."""

    def shift(self) -> sparse.csr_array | None:
        """Return a positive semidefinite matrix of the tangent's pattern that makes it definite."""


class Iteration(NamedTuple):
    """One row of the history of a minimisation."""

    energy: float
    residual: float  # largest entry, after a Jacobi scaling: sqrt(energy)
    decrement: float  # residual . tangent^-1 residual
    step: float
    shift: float
    fresh: float  # 1 for a new tangent, 0 for a step with the last one


@dataclass(frozen=True)
class NewtonOptions:
    """Options of the minimisation.

    Parameters
    ----------
    tolerance : float
        Converged when the Newton decrement r.K^-1 r falls below this part of the energy.
    max_iterations : int
        Largest number of Newton iterations.
    first_shift : float
        First shift that is tried when the tangent is not positive definite.
    rise : float
        How far a step may raise the energy, in units of the decrement; such a step is shortened
        by shifts. 0 for a descent along straight lines.
    ceiling : float
        Energy that a step may not rise to.
    noise : float
        Rounding error of the energy. Steps of a smaller decrement are those of plain Newton, and
        where such a decrement falls no further the minimum is as near as rounding allows.
    """

    tolerance: float = 1.0e-20
    max_iterations: int = 60
    first_shift: float = 1.0
    rise: float = 0.0
    ceiling: float = np.inf
    noise: float = 0.0

    def __post_init__(self) -> None:
        if not 0 < self.tolerance < 1:
            raise ValueError(f"tolerance = {self.tolerance:g}: must lie between 0 and 1")
        if self.max_iterations < 1:
            raise ValueError(f"max_iterations = {self.max_iterations}: must be at least 1")


@dataclass(frozen=True)
class Minimum:
    """Where a minimisation ended.

    Parameters
    ----------
    unknowns : (n,) array
    energy : float
    tangent : sparse array or None
        Upper triangle of the last tangent; it was positive definite if converged.
    history : tuple of Iteration
    reason : str
        Empty if converged, else why not.
    """

    unknowns: Array
    energy: float
    tangent: sparse.csr_array | None
    history: tuple[Iteration, ...]
    reason: str

    @property
    def converged(self) -> bool:
        """Whether the point is a minimum within the tolerance."""
        return not self.reason


def count(history: tuple[Iteration, ...]) -> int:
    """Return the number of Newton iterations: those with a new tangent."""
    return sum(1 for row in history if row.fresh)


_MAX_SHIFTS = 30
_MAX_HALVINGS = 30
_MAX_QUASI = 8
_ARMIJO = 1.0e-4
# Near the minimum a step with the last tangent, updated by BFGS, costs a sixth of one with a new
# tangent. Such steps begin when the decrement is this part of the energy and go on while each
# divides it by this.
_QUASI_DECREMENT = 1.0e-8
_QUASI_GAIN = 10.0
# Newton's method squares the error: where one iteration gains less than this, rounding is left.
_ROUNDED = 10.0


def minimise(problem: Problem, start: Array, solver: Solver, options: NewtonOptions) -> Minimum:
    """Minimise an energy from a start, by Newton's method with shifts of the tangent.

    A minimum is accepted only where the unshifted tangent is positive definite.

    Parameters
    ----------
    problem : Problem
        Energy, residual, tangent and the matrix for shifts.
    start : (n,) array
        First guess of the unknowns.
    solver : Solver
        Sparse factorisation.
    options : Options
        Tolerance and limits.

    Returns
    -------
    Minimum
        With `reason` set where it did not converge; nothing is raised for that.
    """
    unknowns, shift, guess = start.copy(), 0.0, options.first_shift
    history: list[Iteration] = []
    energy, tangent, reason = np.inf, None, f"no convergence in {options.max_iterations} iterations"
    for _ in range(options.max_iterations):
        energy, residual, tangent = problem.derivatives(unknowns)
        if not np.isfinite(energy):
            reason = "the energy is not finite"
            break
        step = _step(
            problem, unknowns, (energy, residual, tangent), solver, (shift, guess), options
        )
        if isinstance(step, str):
            reason = step
            break
        shift = step.shift
        guess = shift / 8.0 if shift > 0.0 else guess
        scaled = float(np.abs(residual / np.sqrt(np.abs(tangent.diagonal()))).max())
        history.append(Iteration(energy, scaled, step.decrement, step.length, shift, 1.0))
        if shift == 0.0 and _converged(history, options):
            reason = ""
            break
        unknowns = unknowns + step.length * step.direction
        energy += step.gain
        if shift == 0.0 and step.length == 1.0 and step.decrement <= _QUASI_DECREMENT * abs(energy):
            unknowns, done = _finish(
                problem, unknowns, solver, options, history, (residual, step.direction)
            )
            if done:
                reason = ""
                energy = problem.energy(unknowns)
                break
        shift = 0.0 if shift < 1e-3 * options.first_shift else shift / 8.0
    return Minimum(unknowns, energy, tangent, tuple(history), reason)


def _converged(history: list[Iteration], options: NewtonOptions) -> bool:
    """Return whether the last decrement is within the tolerance, or rounding and nothing else."""
    energy, decrement = history[-1].energy, history[-1].decrement
    if 0.0 <= decrement <= options.tolerance * abs(energy):
        return True
    before = [abs(row.decrement) for row in history[:-1] if row.fresh and row.shift == 0.0]
    return bool(before) and before[-1] < _ROUNDED * abs(decrement) <= _ROUNDED * options.noise


class _Step(NamedTuple):
    """A step that was accepted: length times direction, and the change of energy."""

    direction: Array
    decrement: float
    length: float
    shift: float
    gain: float


def _step(
    problem: Problem,
    unknowns: Array,
    derivatives: tuple[float, Array, sparse.csr_array],
    solver: Solver,
    shifts: tuple[float, float],
    options: NewtonOptions,
) -> _Step | str:
    """Return a step that lowers the energy enough, or why there is none.

    The shift grows until the tangent is definite. If the full step is not acceptable, the step is
    halved, or the shift grows further where steps may rise: a curved valley leaves no room for long
    straight steps.

    Parameters
    ----------
    derivatives : (energy, residual, tangent)
    shifts : (shift, guess)
        The shift to begin with, and the least positive one.
    """
    (energy, residual, tangent), (shift, guess) = derivatives, shifts
    failed = "the tangent stays indefinite under every shift"
    for _ in range(_MAX_SHIFTS):
        try:
            solver.factorise(tangent if shift == 0.0 else _shifted(problem, tangent, shift))
        except NotPositiveDefiniteError:
            if problem.shift() is None:
                return failed
            shift = max(4.0 * shift, guess)
            continue
        direction = -solver.solve(residual)
        decrement = -float(residual @ direction)
        allowed = max(min(options.rise * decrement, options.ceiling - energy), 0.0)
        noise = max(1e-14 * abs(energy), options.noise)
        allowed += noise
        if decrement <= noise:  # the energy cannot tell: a step of plain Newton
            return _Step(direction, decrement, 1.0, shift, 0.0)
        for halvings in range(1 if options.rise > 0.0 else _MAX_HALVINGS):
            length = 0.5**halvings
            change = problem.energy(unknowns + length * direction) - energy
            if change <= allowed - _ARMIJO * length * decrement:
                return _Step(direction, decrement, length, shift, change)
        failed = "no step lowers the energy"
        if options.rise == 0.0 or problem.shift() is None:
            break
        shift = max(4.0 * shift, guess)
    return failed


def _finish(
    problem: Problem,
    unknowns: Array,
    solver: Solver,
    options: NewtonOptions,
    history: list[Iteration],
    last: tuple[Array, Array],
) -> tuple[Array, bool]:
    """Take BFGS steps from the last tangent while they gain much; return whether they converged.

    Parameters
    ----------
    last : (residual, step)
        Of the Newton step that led to `unknowns`.
    """
    residual, step = last
    pairs: list[tuple[Array, Array]] = []
    row = history[-1]
    for _ in range(_MAX_QUASI):
        new = problem.residual(unknowns)
        pairs.append((step, new - residual))
        residual = new
        step = -_inverse_times(residual, pairs, solver)
        decrement = -float(residual @ step)
        history.append(row._replace(decrement=decrement, fresh=0.0))
        unknowns = unknowns + step
        if abs(decrement) <= options.tolerance * abs(row.energy):
            return unknowns, True
        if decrement * _QUASI_GAIN > history[-2].decrement:
            break
    return unknowns, False


def _inverse_times(vector: Array, pairs: list[tuple[Array, Array]], solver: Solver) -> Array:
    """Apply the inverse of the last tangent with BFGS updates for (step, change of residual)."""
    vector = vector.copy()
    parts = []
    for step, change in reversed(pairs):
        part = float(step @ vector) / float(step @ change)
        vector -= part * change
        parts.append(part)
    result = solver.solve(vector)
    for (step, change), part in zip(pairs, reversed(parts), strict=True):
        result = result + (part - float(change @ result) / float(step @ change)) * step
    return result


def _shifted(problem: Problem, tangent: sparse.csr_array, shift: float) -> sparse.csr_array:
    matrix = problem.shift()
    if matrix is None:
        raise ValueError("this problem has no matrix for shifts")
    data = tangent.data + shift * matrix.data
    return sparse.csr_array((data, tangent.indices, tangent.indptr), shape=tangent.shape)
