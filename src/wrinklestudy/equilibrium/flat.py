"""The flat state of the stretched sheet; it does not depend on the thickness."""

from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium import newton
from wrinklestudy.equilibrium.energy import EnergyExpansion
from wrinklestudy.fem.assembly import Assembler, shared_assembler
from wrinklestudy.fem.boundary import QUARTER, Symmetry
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
    """Flat equilibrium of the part of the sheet that is solved.

    Parameters
    ----------
    space : Space
    law : Law
    strain : float
        eps = (L' - L)/L of the clamps.
    position : (2, size) array
        In-plane position x, y as dof vectors, in units of W.
    energy : float
        Energy of that part for each unit of thickness, in units of mu W^2.
    force : float
        Nominal stress at the clamp, force / (W t), in units of mu.
    history : tuple of newton.Iteration
    symmetry : Symmetry
        Mirrors and clamps of x and y; what it says of z is not used.
    """

    space: Space
    law: Law
    strain: float
    position: Array
    energy: float
    force: float
    history: tuple[newton.Iteration, ...]
    symmetry: Symmetry = QUARTER

    @property
    def sheet_position(self) -> Array:
        """Position with the deflection z = 0 as the third component, (3, size)."""
        return np.concatenate([self.position, np.zeros((1, self.space.size))])


class MembraneProblem:
    """Energy of the flat sheet, for each unit of thickness, over its free dofs.

    Parameters
    ----------
    space : Space
    law : MetricEnergy
    prescribed : (2, size) array
        A position; its values at the dofs that are not free hold.
    symmetry : Symmetry
    """

    def __init__(
        self,
        space: Space,
        law: membrane.MetricEnergy,
        prescribed: Array,
        symmetry: Symmetry = QUARTER,
    ) -> None:
        self.law = law
        self.prescribed = prescribed
        self.symmetry = symmetry
        self.assembler = membrane_assembler(space, symmetry)

    @property
    def volume(self) -> Array:
        """Reference volume that each Gauss point stands for, over the mean thickness."""
        volume: Array = self.assembler.space.measure * self.assembler.space.relative_thickness
        return volume

    def position(self, unknowns: Array) -> Array:
        """Return the dof vectors (2, size) with the prescribed values in place."""
        return self.assembler.filled(self.prescribed, unknowns)

    def energy(self, unknowns: Array) -> float:
        """Return the energy, infinite where a cell is turned inside out."""
        space = self.assembler.space
        gradient = space.derivatives(self.position(unknowns), 2)
        if np.any(gradient[0, 0] * gradient[1, 1] <= gradient[0, 1] * gradient[1, 0]):
            return np.inf
        return float((membrane.energy(self.law, gradient) * self.volume).sum())

    def derivatives(self, unknowns: Array) -> EnergyExpansion:
        """Return the energy, the residual and the upper triangle of the tangent."""
        space, assembler = self.assembler.space, self.assembler
        density, slope, blocks = membrane.expansion(
            self.law, space.derivatives(self.position(unknowns), 2)
        )
        energy = float((density * self.volume).sum())
        residual = assembler.residual(slope * space.relative_thickness)[assembler.free]
        blocks = [block * space.relative_thickness for block in blocks]
        return EnergyExpansion(energy, residual, assembler.tangent(blocks))

    def residual(self, unknowns: Array) -> Array:
        """Return the residual alone."""
        return self.reactions(unknowns)[self.assembler.free]

    def reactions(self, unknowns: Array) -> Array:
        """Return the residual at every dof, (2, size); the reactions are at the prescribed ones."""
        tangents = self.assembler.space.derivatives(self.position(unknowns), 2)
        slope = membrane.gradient(
            membrane.force(self.law, tangents), membrane.frame(self.law, tangents)
        )
        return self.assembler.residual(slope * self.assembler.space.relative_thickness)

    def shift(self) -> sparse.csr_array | None:
        """Return nothing: the flat problem needs no shift."""
        return None

    def force(self, unknowns: Array) -> float:
        """Return the nominal stress at the clamp in units of mu."""
        return self.symmetry.clamp.force(self.assembler.space, self.reactions(unknowns))


def membrane_assembler(space: Space, symmetry: Symmetry) -> Assembler:
    """Return the assembler of energies of the in-plane position."""
    return shared_assembler(space, symmetry.free(space)[:2], 2)


def stretched(space: Space, strain: float, symmetry: Symmetry = QUARTER) -> Array:
    """Return a first guess of the flat state: uniaxial stretch that is held at the clamp.

    Where the clamps are perfect x = (1 + eps) X and y = c(X) Y with
    c = 1 + ((1 + eps)^(-1/2) - 1)(1 - exp(-d/l)) at the distance d from the next clamp. Prescribed
    degrees of freedom have their exact values.
    """
    clamp = symmetry.clamp
    held_position = clamp.position(space, strain)[:2]
    values = space.nodes_from_field(held_position)
    x, y = space.grid.x[:, None], space.grid.y[None, :]
    far = (1.0 + strain) ** -0.5 - 1.0
    side = np.where(x < 0.0, -1.0, 1.0) if len(clamp.ends) > 1 else 1.0
    decay = np.exp(-(space.grid.x[-1] - side * x) / _CLAMP_ZONE)
    values[1, 0] += far * (1.0 - decay) * y
    values[1, 1] -= side * far * decay / _CLAMP_ZONE * y
    values[1, 2] += far * (1.0 - decay)
    values[1, 3] -= side * far * decay / _CLAMP_ZONE
    guess = space.field_from_nodes(values)
    held = ~symmetry.free(space)[:2]
    guess[held] = held_position[held]
    return guess


def solve(
    grid: Grid | Space,
    law: Law,
    strain: float,
    options: newton.NewtonOptions | None = None,
    symmetry: Symmetry = QUARTER,
    observer: newton.Observer | None = None,
    start: Array | None = None,
) -> Flat:
    """Return the flat equilibrium of a clamped sheet stretched by a strain.

    Parameters
    ----------
    grid : Grid or Space
        Grid of the part of the sheet that is solved.
    law : Law
        Dimensionless material law.
    strain : float
        eps of the clamps, > -1.
    options : newton.NewtonOptions, optional
    symmetry : Symmetry
        Mirrors that bound the grid.
    observer : newton.Observer, optional
        Is told of each iteration.
    start : (2, size) array, optional
        A position near the equilibrium, say from a coarser grid; only its free values count.

    Raises
    ------
    NotConvergedError
        If Newton's method fails; the message says why.
    """
    space = grid if isinstance(grid, Space) else Space(grid)
    options = options or newton.NewtonOptions(noise=ROUNDING)
    problem = MembraneProblem(space, law, stretched(space, strain, symmetry), symmetry)
    if observer is not None:
        options = replace(options, observe=partial(observer, "flat state"))
    minimum = _load(problem, strain, options, problem.prescribed if start is None else start)
    if not minimum.converged:
        raise NotConvergedError(f"flat state at strain {strain:g}: {minimum.reason}")
    position, force = problem.position(minimum.unknowns), problem.force(minimum.unknowns)
    return Flat(space, law, strain, position, minimum.energy, force, minimum.history, symmetry)


def _load(
    problem: MembraneProblem, strain: float, options: newton.NewtonOptions, start: Array
) -> newton.Minimum:
    """Minimise from a first guess; where that fails approach the strain in steps."""
    free, space = problem.assembler.free, problem.assembler.space
    solver, symmetry = problem.assembler.solver, problem.symmetry
    at_once = newton.minimise(problem, start[free], solver, options)
    if at_once.converged:
        return at_once
    reached, step, correction = 0.0, 0.5 * strain, np.zeros_like(problem.prescribed)
    while abs(step) >= _SMALLEST_LOAD:
        last = abs(strain - reached) <= 1.5 * abs(step)
        target = strain if last else reached + step
        loaded = problem
        if not last:
            guess = stretched(space, target, symmetry)
            loaded = MembraneProblem(space, problem.law, guess, symmetry)
        # What the load so far did to the sheet beyond the first guess of its strain
        guess = loaded.prescribed + correction
        minimum = newton.minimise(loaded, guess[free], solver, options)
        if not minimum.converged:
            step *= 0.5
        elif last:
            return minimum
        else:
            reached = target
            correction = loaded.position(minimum.unknowns) - loaded.prescribed
    return at_once
