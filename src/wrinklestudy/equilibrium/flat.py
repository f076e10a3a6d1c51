"""The flat state of the stretched sheet; it does not depend on the thickness."""

from dataclasses import dataclass

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium import newton
from wrinklestudy.fem.assembly import shared_assembler
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import membrane
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.typing import Array

# Length, in units of W, over which the lateral contraction sets in from the clamp: first guess only
_CLAMP_ZONE = 0.25
_SMALLEST_LOAD = 0.05
# Rounding error of the energy for each unit of thickness, in units of mu W^2: the energy of a small
# strain is a difference of numbers near 1.
ROUNDING = 1.0e-17


class NotConvergedError(ArithmeticError):
    """No flat state was found."""


@dataclass(frozen=True)
class Flat:
    """Flat equilibrium of the quarter sheet.

    Parameters
    ----------
    space : Space
    law : Law
    strain : float
        eps = (L' - L)/L of the clamps.
    position : (2, size) array
        In-plane position x, y as dof vectors, in units of W.
    energy : float
        Energy of the quarter for each unit of thickness, in units of mu W^2.
    force : float
        Nominal stress at the clamp, force / (W t), in units of mu.
    history : tuple of newton.Iteration
    """

    space: Space
    law: Law
    strain: float
    position: Array
    energy: float
    force: float
    history: tuple[newton.Iteration, ...]


class MembraneProblem:
    """Energy of the flat sheet, for each unit of thickness, over its free dofs."""

    def __init__(self, space: Space, law: Law, prescribed: Array) -> None:
        self.law = law
        self.prescribed = prescribed
        self.assembler = shared_assembler(space, space.free()[:2], 2)

    def position(self, unknowns: Array) -> Array:
        """Return the dof vectors (2, size) with the prescribed values in place."""
        field = self.prescribed.copy()
        field[self.assembler.free] = unknowns
        return field

    def energy(self, unknowns: Array) -> float:
        """Return the energy, infinite where a cell is turned inside out."""
        space = self.assembler.space
        gradient = space.derivatives(self.position(unknowns), 2)
        if np.any(gradient[0, 0] * gradient[1, 1] <= gradient[0, 1] * gradient[1, 0]):
            return np.inf
        return float((membrane.energy(self.law, gradient) * space.measure).sum())

    def derivatives(self, unknowns: Array) -> tuple[float, Array, sparse.csr_array]:
        """Return the energy, the residual and the upper triangle of the tangent."""
        space, assembler = self.assembler.space, self.assembler
        density, slope, blocks = membrane.expansion(
            self.law, space.derivatives(self.position(unknowns), 2)
        )
        energy = float((density * space.measure).sum())
        residual = assembler.residual(slope)[assembler.free]
        return energy, residual, assembler.tangent(blocks)

    def residual(self, unknowns: Array) -> Array:
        """Return the residual alone."""
        return self.reactions(unknowns)[self.assembler.free]

    def reactions(self, unknowns: Array) -> Array:
        """Return the residual at every dof, (2, size); the reactions are at the prescribed ones."""
        tangents = self.assembler.space.derivatives(self.position(unknowns), 2)
        slope = membrane.gradient(membrane.force(self.law, tangents), tangents)
        return self.assembler.residual(slope)

    def shift(self) -> sparse.csr_array | None:
        """Return nothing: the flat problem needs no shift."""
        return None

    def force(self, unknowns: Array) -> float:
        """Return the nominal stress at the clamp in units of mu: twice the quarter's reaction."""
        clamp = self.assembler.space.edge_dofs("clamp", ["u"])
        return 2.0 * float(self.reactions(unknowns)[0, clamp].sum())


def stretched(space: Space, strain: float) -> Array:
    """Return a first guess of the flat state: uniaxial stretch that is held at the clamp.

    x = (1 + eps) X and y = c(X) Y with c = 1 + ((1 + eps)^(-1/2) - 1)(1 - exp(-d/l)) at the
    distance d from the clamp. Prescribed degrees of freedom have their exact values.
    """
    values = np.zeros((2, 4, len(space.grid.x), len(space.grid.y)))
    x, y = space.grid.x[:, None], space.grid.y[None, :]
    far = (1.0 + strain) ** -0.5 - 1.0
    decay = np.exp(-(space.grid.x[-1] - x) / _CLAMP_ZONE)
    values[0, 0], values[0, 1] = (1.0 + strain) * x, 1.0 + strain
    values[1, 0] = (1.0 + far * (1.0 - decay)) * y
    values[1, 1] = -far * decay / _CLAMP_ZONE * y
    values[1, 2] = 1.0 + far * (1.0 - decay)
    values[1, 3] = -far * decay / _CLAMP_ZONE
    guess = space.field_from_nodes(values)
    fixed = ~space.free()[:2]
    clamped = space.coordinates[:2].copy()
    clamped[0] *= 1.0 + strain
    guess[fixed] = clamped[fixed]
    return guess


def solve(
    grid: Grid | Space,
    law: Law,
    strain: float,
    options: newton.NewtonOptions | None = None,
) -> Flat:
    """Return the flat equilibrium of a clamped sheet stretched by a strain.

    Parameters
    ----------
    grid : Grid or Space
        Grid of the quarter sheet.
    law : Law
        Dimensionless material law.
    strain : float
        eps of the clamps, > -1.
    options : newton.NewtonOptions, optional

    Raises
    ------
    NotConvergedError
        If Newton's method fails; the message says why.
    """
    space = grid if isinstance(grid, Space) else Space(grid)
    options = options or newton.NewtonOptions(noise=ROUNDING)
    problem = MembraneProblem(space, law, stretched(space, strain))
    found = _load(problem, strain, options)
    if not found.converged:
        raise NotConvergedError(f"flat state at strain {strain:g}: {found.reason}")
    position, force = problem.position(found.unknowns), problem.force(found.unknowns)
    return Flat(space, law, strain, position, found.energy, force, found.history)


def _load(problem: MembraneProblem, strain: float, options: newton.NewtonOptions) -> newton.Minimum:
    """Minimise from the first guess; where that fails approach the strain in steps."""
    free, space = problem.assembler.free, problem.assembler.space
    solver = problem.assembler.solver
    found = newton.minimise(problem, problem.prescribed[free], solver, options)
    done, step, correction = 0.0, 0.5 * strain, np.zeros_like(problem.prescribed)
    while not found.converged and abs(step) >= _SMALLEST_LOAD:
        last = abs(strain - done) <= 1.5 * abs(step)
        target = strain if last else done + step
        part = problem
        if not last:
            part = MembraneProblem(space, problem.law, stretched(space, target))
        # What the load so far did to the sheet beyond the first guess of its strain
        guess = (part.prescribed + correction)[free]
        there = newton.minimise(part, guess, solver, options)
        if not there.converged:
            step *= 0.5
        elif last:
            return there
        else:
            done, correction = target, part.position(there.unknowns) - part.prescribed
    return found
