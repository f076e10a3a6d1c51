"""States of a stretched solid sheet: flat ones, where they lose stability, and wrinkled ones."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from verification.tools.solid_element import ORDER, Part
from verification.tools.solid_law import SolidLaw
from verification.tools.solid_space import Clamp, SolidSpace, solid_space
from wrinklestudy.equilibrium import flat
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.factorisation import make_indefinite_solver
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.results.solved import State
from wrinklestudy.typing import Array

_TOLERANCE = 1.0e-9  # of a step, relative to the largest displacement
_MOST_STEPS = 25
_ROOT_TOLERANCE = 2.0e-6  # of a strain
_MOST_ROOT_STEPS = 12
_CORNER = (0.8, 0.6)  # parts of half the length and width beyond which a mode is of the corner


class SolidState(NamedTuple):
    """An equilibrium of the solid."""

    displacement: Array
    pressure: Array  # coefficients, (m, cells)
    unstable: int  # eigenvalues of the tangent below zero


class SolidMode(NamedTuple):
    """The lowest mode that bends a flat solid."""

    eigenvalue: float  # below zero where the flat sheet is unstable
    unstable: int  # eigenvalues below zero
    corner: float  # part of its w^2 in the corner of clamp and free edge
    shape: Array  # w of the middle surface, (nodes along, nodes across)


@dataclass(frozen=True, eq=False)
class SolidSheet:
    """The quarter of a sheet as a solid.

    Parameters
    ----------
    material : Material
        Mooney-Rivlin or neo-Hookean.
    thickness : float
        t/W.
    cells : (int, int)
        Along and across.
    bulk : float
        K/mu.
    layers : {1, 2}
    clamp : {'line', 'face'}
    aspect : float
        L/W.
    """

    material: Material
    thickness: float
    cells: tuple[int, int]
    bulk: float = 1.0e4
    layers: int = 1
    clamp: Clamp = "line"
    aspect: float = 2.0
    known: dict[float, SolidState] = field(default_factory=dict, repr=False)

    @cached_property
    def law(self) -> SolidLaw:
        """The law at points."""
        return SolidLaw.of(self.material)

    @cached_property
    def spaces(self) -> dict[Part, SolidSpace]:
        """Displacements that keep the sheet flat, and those that bend it."""
        grid = make_grid(self.aspect, 1.0e-3, MeshSettings(*self.cells))
        parts: tuple[Part, Part] = ("even", "odd")
        return {
            part: solid_space(grid, self.thickness, part, self.layers, self.clamp) for part in parts
        }

    @cached_property
    def whole(self) -> SolidSpace:
        """All displacements."""
        grid = self.spaces["even"].grid
        return solid_space(grid, self.thickness, "both", self.layers, self.clamp)

    def flat(self, strain: float) -> SolidState:
        """Return the flat state, from that of the plate and what the nearest one had beside it."""
        if strain not in self.known:
            space = self.spaces["even"]
            start = self._raised(space, self._plate(strain), strain)
            if self.known:
                nearest = min(self.known, key=lambda other: abs(other - strain))
                known = self.known[nearest]
                lacking = known.displacement - self._raised(space, self._plate(nearest), nearest)
                start = start + np.where(space.free, lacking, 0.0)
            self.known[strain] = self._solve(space, start)
        return self.known[strain]

    def wrinkled(self, plate: State) -> SolidState:
        """Return the wrinkled state near that of a plate."""
        return self._solve(self.whole, self._raised(self.whole, plate.shape, plate.strain))

    def deflection(self, state: SolidState, y: Array) -> Array:
        """Return the deflection of the middle surface on x = 0, at reference points y >= 0."""
        space = self.whole
        nodes = space.nodes(state.displacement)[space.blocks.index((2, 0, True))]
        return cubic(space.lines[1], nodes[0], y)

    def _plate(self, strain: float) -> DeformedSheet:
        """Return the flat state of the plate."""
        space = self._plate_space
        state = flat.solve(space, self.material.law, strain)
        nodes = space.nodes_from_field(state.sheet_position)
        return DeformedSheet(space.grid, nodes, Symmetry.mirrored())

    @cached_property
    def _plate_space(self) -> Space:
        return Space(make_grid(self.aspect, 1.0e-3, MeshSettings(16, 24)))

    def _raised(self, space: SolidSpace, plate: DeformedSheet, strain: float) -> Array:
        """Return the displacement of a plate's state, its normals stretched without any volume."""
        x, y = space.lines
        position = plate.evaluate(x, y)
        area = np.cross(plate.evaluate(x, y, dx=1), plate.evaluate(x, y, dy=1), axis=0)
        director = area / (area**2).sum(axis=0)  # lambda3 n, lambda3 = 1/|x,1 x x,2|
        values = np.zeros((len(space.blocks), *space.shape))
        undeformed = (x[:, None], y, 0.0)
        for number, (component, power, even) in enumerate(space.blocks):
            if power == 0 and even:
                values[number] = position[component] - undeformed[component]
            elif power == 1 and not even:
                thicker = director[component] - (component == 2)
                values[number] = 0.5 * self.thickness * thicker
        values[~space.free.reshape(values.shape)] = 0.0
        values[space.blocks.index((0, 0, True)), -1] = x[-1] * strain
        return values.ravel()

    def _solve(self, space: SolidSpace, displacement: Array) -> SolidState:
        """Return the equilibrium near a start, by Newton's method.

        Raises
        ------
        ArithmeticError
            If it does not converge.
        """
        pressure = space.plane_stress(self.law, displacement)
        solver = make_indefinite_solver()
        for _ in range(_MOST_STEPS):
            at = space.element.pressure.T @ pressure
            gradient = space.deformation(displacement)
            problem = space.condensed(self.law, self.bulk, gradient, pressure, at)
            solver.factorise(problem.tangent)
            step = np.zeros(space.size)
            step[space.free] = -solver.solve(problem.residual)
            pressure = pressure + space.pressure_step(problem, step, self.bulk)
            displacement = displacement + step
            if np.abs(step).max() <= _TOLERANCE * np.abs(displacement).max():
                return SolidState(displacement, pressure, solver.negative_eigenvalues)
        raise ArithmeticError(f"no equilibrium of the solid in {_MOST_STEPS} steps")

    def mode(self, strain: float) -> SolidMode:
        """Return the lowest mode of the flat state among displacements that bend it."""
        from scipy.sparse.linalg import LinearOperator, eigsh

        state = self.flat(strain)
        even, odd = self.spaces["even"], self.spaces["odd"]
        gradient = even.deformation(state.displacement)
        at = even.element.pressure.T @ state.pressure
        nothing = np.zeros((len(odd.element.pressure), len(odd.volume)))
        tangent = odd.condensed(self.law, self.bulk, gradient, nothing, at).tangent
        solver = make_indefinite_solver()
        solver.factorise(tangent)
        size = tangent.shape[0]
        # w of the middle surface measures a mode, each node by the area around it
        middle = [block == (2, 0, True) for block in odd.blocks]
        mass = np.zeros((len(odd.blocks), *odd.shape))
        x, y = odd.lines
        mass[middle] = np.outer(np.gradient(x), np.gradient(y))
        weights = mass.ravel()[odd.free]
        root = np.sqrt(weights)
        inverse = LinearOperator(
            (size, size), matvec=lambda v: root * solver.solve(root * v), dtype=np.float64
        )
        # root K^-1 root has the eigenvalues 1/kappa
        start = root * np.random.default_rng(0).standard_normal(size)
        values, vectors = eigsh(
            inverse, k=1, which="SA" if solver.negative_eigenvalues else "LA", v0=start, tol=1e-9
        )
        shape = np.zeros(odd.size)
        shape[odd.free] = solver.solve(root * vectors[:, 0])
        middle_shape = odd.nodes(shape)[middle][0]
        return SolidMode(
            1.0 / float(values[0]) / self.thickness**3,
            solver.negative_eigenvalues,
            _corner_part(middle_shape**2 * mass[middle][0], x, y),
            middle_shape,
        )


def _corner_part(energy: Array, x: Array, y: Array) -> float:
    corner = (x[:, None] > _CORNER[0] * x[-1]) & (y > _CORNER[1] * y[-1])
    return float(energy[corner].sum() / energy.sum())


def cubic(lines: Array, values: Array, at: Array) -> Array:
    """Return a function of order 3 in each cell from its values at the nodes.

    Parameters
    ----------
    lines, values : (3 n + 1,) arrays
        Nodes, three for each cell and the last one.
    at : (m,) array
        Points between the first and the last node.
    """
    cell = np.clip(
        np.searchsorted(lines[::ORDER], at, side="right") - 1, 0, len(lines) // ORDER - 1
    )
    nodes = ORDER * cell[:, None] + np.arange(ORDER + 1)
    place = (at[:, None] - lines[nodes][:, :1]) / (lines[nodes][:, -1:] - lines[nodes][:, :1])
    result = np.zeros(len(at))
    for a in range(ORDER + 1):
        others = [b for b in range(ORDER + 1) if b != a]
        factors = [(ORDER * place[:, 0] - b) / (a - b) for b in others]
        result += values[nodes[:, a]] * np.prod(factors, axis=0)
    return result
