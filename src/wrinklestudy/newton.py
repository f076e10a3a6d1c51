"""Safeguarded Newton minimisation of an energy.

Plain Newton steps near the minimum; away from it the tangent is shifted until it is positive
definite and the step is shortened until the energy falls. The factorisation tells which of the two
it is.
"""

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from wrinklestudy.fem.linear import NotPositiveDefiniteError, Solver

Array = NDArray[np.float64]


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
class Options:
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
        How far a step may raise the energy, in units of the decrement: 0 for a descent.
    ceiling : float
        Energy that a step may not rise to.
    """

    tolerance: float = 1.0e-20
    max_iterations: int = 60
    first_shift: float = 1.0
    rise: float = 0.0
    ceiling: float = np.inf

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


def minimise(problem: Problem, start: Array, solver: Solver, options: Options) -> Minimum:
    """Minimise an energy from a start, by Newton's method with shifts and a line search.

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
    unknowns, shift = start.copy(), 0.0
    history: list[Iteration] = []
    energy, tangent, reason = np.inf, None, f"no convergence in {options.max_iterations} iterations"
    for _ in range(options.max_iterations):
        energy, residual, tangent = problem.derivatives(unknowns)
        if not np.isfinite(energy):
            reason = "the energy is not finite"
            break
        factor_shift = _factorise(problem, tangent, solver, shift, options.first_shift)
        if factor_shift is None:
            reason = "the tangent stays indefinite under every shift"
            break
        shift = factor_shift
        direction = -solver.solve(residual)
        decrement = -float(residual @ direction)
        scaled = float(np.abs(residual / np.sqrt(np.abs(tangent.diagonal()))).max())
        allowed = max(min(options.rise * decrement, options.ceiling - energy), 0.0)
        step, gain = _line_search(problem, unknowns, energy, direction, decrement, allowed)
        history.append(Iteration(energy, scaled, decrement, step, shift, 1.0))
        if shift == 0.0 and 0.0 <= decrement <= options.tolerance * abs(energy):
            reason = ""
            break
        if step == 0.0:
            reason = "the line search found no lower energy"
            break
        unknowns = unknowns + step * direction
        energy += gain
        if shift == 0.0 and step == 1.0 and decrement <= _QUASI_DECREMENT * abs(energy):
            unknowns, done = _finish(
                problem, unknowns, solver, options, history, (residual, direction)
            )
            if done:
                reason = ""
                energy = problem.energy(unknowns)
                break
        shift = 0.0 if shift < 1e-3 * options.first_shift else shift / 8.0
    return Minimum(unknowns, energy, tangent, tuple(history), reason)


def _finish(
    problem: Problem,
    unknowns: Array,
    solver: Solver,
    options: Options,
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


def _factorise(
    problem: Problem, tangent: sparse.csr_array, solver: Solver, shift: float, first: float
) -> float | None:
    """Factorise tangent + shift M with the smallest tried shift that makes it definite."""
    for _ in range(_MAX_SHIFTS):
        try:
            solver.factorise(tangent if shift == 0.0 else _shifted(problem, tangent, shift))
        except NotPositiveDefiniteError:
            if problem.shift() is None:
                return None
            shift = first if shift == 0.0 else 4.0 * shift
            continue
        return shift
    return None


def _shifted(problem: Problem, tangent: sparse.csr_array, shift: float) -> sparse.csr_array:
    matrix = problem.shift()
    if matrix is None:
        raise ValueError("this problem has no matrix for shifts")
    data = tangent.data + shift * matrix.data
    return sparse.csr_array((data, tangent.indices, tangent.indptr), shape=tangent.shape)


def _line_search(
    problem: Problem,
    unknowns: Array,
    energy: float,
    direction: Array,
    decrement: float,
    allowed: float,
) -> tuple[float, float]:
    """Halve the step until the energy falls enough; return the step and the change of energy.

    It may be higher than that by `allowed`.
    """
    rounding = 1e-14 * abs(energy)
    if decrement <= rounding:  # the energy cannot tell: a step of plain Newton
        return 1.0, 0.0
    step = 1.0
    for _ in range(_MAX_HALVINGS):
        change = problem.energy(unknowns + step * direction) - energy
        if change <= allowed - _ARMIJO * step * decrement + rounding:
            return step, change
        step /= 2.0
    return 0.0, 0.0
