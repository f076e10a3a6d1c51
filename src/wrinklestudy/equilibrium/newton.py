"""Safeguarded Newton minimisation of an energy.

Plain Newton steps near the minimum; away from it the tangent is shifted until it is positive
definite and the energy falls, by a shorter step or, as in Levenberg's and Marquardt's method, by a
larger shift. The factorisation tells whether it is definite.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium.bfgs import Update, inverse_times
from wrinklestudy.equilibrium.energy import EnergyExpansion, Problem
from wrinklestudy.fem.factorisation import (
    InaccurateSolutionError,
    NotPositiveDefiniteError,
    Solver,
)
from wrinklestudy.typing import Array


class Iteration(NamedTuple):
    """One row of the history of a minimisation."""

    energy: float
    residual: float  # largest entry, after a Jacobi scaling: sqrt(energy)
    decrement: float  # residual . tangent^-1 residual
    step: float
    shift: float
    fresh: float  # 1 for a new tangent, 0 for a step with the last one


class Observer(Protocol):
    """Who wants to know how a solve goes on."""

    def __call__(self, stage: str, last: Iteration | None) -> None:
        """Be told of the stage that runs, and of its last iteration if it has any."""


# Near the minimum a step with the last tangent, updated by BFGS, costs a sixth of one with a new
# tangent. Such steps begin when the decrement is this part of the energy.
_QUASI_DECREMENT = 1.0e-8


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
    smooth : bool
        Whether the energy has a continuous second derivative; otherwise no step is taken with an
        old tangent, which tells nothing of the other side of a jump.
    eager : bool
        Whether a step after one with a shift tries none first, rather than an eighth of it.
    quasi : float
        Part of the energy from which on a step with the last tangent, updated by BFGS, follows a
        plain one.
    observe : callable, optional
        Is told of each iteration with a new tangent.
    """

    tolerance: float = 1.0e-20
    max_iterations: int = 60
    first_shift: float = 1.0
    rise: float = 0.0
    ceiling: float = np.inf
    noise: float = 0.0
    smooth: bool = True
    eager: bool = False
    quasi: float = _QUASI_DECREMENT
    observe: Callable[[Iteration], None] | None = None

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
# Such steps go on while each divides the decrement by this.
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
    options : NewtonOptions
        Tolerance and limits.

    Returns
    -------
    Minimum
        With `reason` set where it did not converge; nothing is raised for that.
    """
    unknowns, shifts = start.copy(), _Shifts(0.0, options.first_shift)
    history: list[Iteration] = []
    energy, tangent, reason = np.inf, None, f"no convergence in {options.max_iterations} iterations"
    for _ in range(options.max_iterations):
        here = problem.derivatives(unknowns)
        energy, tangent = here.energy, here.tangent
        if not np.isfinite(energy):
            reason = "the energy is not finite"
            break
        step = _step(problem, unknowns, here, solver, shifts, options)
        if isinstance(step, str):
            reason = step
            break
        scaled = float(np.abs(here.residual / np.sqrt(np.abs(tangent.diagonal()))).max())
        history.append(Iteration(energy, scaled, step.decrement, step.length, step.shift, 1.0))
        if options.observe is not None:
            options.observe(history[-1])
        if step.shift == 0.0 and _converged(history, options):
            reason = ""
            break
        unknowns = unknowns + step.length * step.direction
        energy += step.gain
        if options.smooth and step.is_plain and step.decrement <= options.quasi * abs(energy):
            finish = _finish(
                problem, unknowns, here.residual, step.direction, solver, options, history
            )
            unknowns = finish.unknowns
            if finish.converged:
                energy, reason = problem.energy(unknowns), ""
                break
        shifts = shifts.after(step.shift, options)
    return Minimum(unknowns, energy, tangent, tuple(history), reason)


def _converged(history: list[Iteration], options: NewtonOptions) -> bool:
    """Return whether the last decrement is within the tolerance, or rounding and nothing else."""
    energy, decrement = history[-1].energy, history[-1].decrement
    if 0.0 <= decrement <= options.tolerance * abs(energy):
        return True
    before = [abs(row.decrement) for row in history[:-1] if row.fresh and row.shift == 0.0]
    return bool(before) and before[-1] < _ROUNDED * abs(decrement) <= _ROUNDED * options.noise


class _Shifts(NamedTuple):
    """Shifts of the tangent that a step begins with."""

    first: float  # tried first
    least: float  # the least positive one

    def larger(self, shift: float) -> float:
        """Return the shift to try after one that was too small."""
        return max(4.0 * shift, self.least)

    def after(self, shift: float, options: NewtonOptions) -> "_Shifts":
        """Return the shifts of the next step after a step with a shift."""
        small = options.eager or shift < 1e-3 * options.first_shift
        first = 0.0 if small else shift / 8.0
        return _Shifts(first, shift / 8.0 if shift > 0.0 else self.least)


class _Step(NamedTuple):
    """A step that was accepted: length times direction, and the change of energy."""

    direction: Array
    decrement: float
    length: float
    shift: float
    gain: float

    @property
    def is_plain(self) -> bool:
        """Whether it is a full step of plain Newton."""
        return self.shift == 0.0 and self.length == 1.0


def _step(
    problem: Problem,
    unknowns: Array,
    here: EnergyExpansion,
    solver: Solver,
    shifts: _Shifts,
    options: NewtonOptions,
) -> _Step | str:
    """Return a step that lowers the energy enough, or why there is none.

    The shift grows until the tangent is definite. If the full step is not acceptable, the step is
    halved, or the shift grows further where steps may rise: a curved valley leaves no room for long
    straight steps.
    """
    energy, residual, tangent = here
    shift, failed = shifts.first, "the tangent stays indefinite under every shift"
    for _ in range(_MAX_SHIFTS):
        try:
            solver.factorise(tangent if shift == 0.0 else _shifted(problem, tangent, shift))
            direction = -solver.solve(residual)
        except InaccurateSolutionError as error:
            return str(error)
        except NotPositiveDefiniteError:
            if problem.shift() is None:
                return failed
            shift = shifts.larger(shift)
            continue
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
        shift = shifts.larger(shift)
    return failed


def _shifted(problem: Problem, tangent: sparse.csr_array, shift: float) -> sparse.csr_array:
    matrix = problem.shift()
    if matrix is None:
        raise ValueError("this problem has no matrix for shifts")
    data = tangent.data + shift * matrix.data
    return sparse.csr_array((data, tangent.indices, tangent.indptr), shape=tangent.shape)


class _Finish(NamedTuple):
    """Where steps with the last tangent ended."""

    unknowns: Array
    converged: bool


def _finish(
    problem: Problem,
    unknowns: Array,
    residual: Array,
    step: Array,
    solver: Solver,
    options: NewtonOptions,
    history: list[Iteration],
) -> _Finish:
    """Take BFGS steps from the last tangent while they gain much; they join the history.

    The unknowns are those after the last step of Newton's method, the residual that before it.
    """
    updates: list[Update] = []
    newton = history[-1]
    for _ in range(_MAX_QUASI):
        before, residual = residual, problem.residual(unknowns)
        updates.append(Update(step, residual - before))
        try:
            step = -inverse_times(residual, updates, solver)
        except InaccurateSolutionError:
            break
        decrement = -float(residual @ step)
        if abs(decrement) > history[-1].decrement:  # away from the minimum
            break
        history.append(newton._replace(decrement=decrement, fresh=0.0))
        unknowns = unknowns + step
        if abs(decrement) <= options.tolerance * abs(newton.energy):
            return _Finish(unknowns, True)
        if decrement * _QUASI_GAIN > history[-2].decrement:
            break
    return _Finish(unknowns, False)
