"""The plate problem of the library with boundary conditions of one's own and a dead load."""

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium import newton
from wrinklestudy.equilibrium.energy import EnergyExpansion
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.fem.factorisation import make_solver
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array, Mask

VALUE, SLOPE_X, SLOPE_Y, TWIST = range(4)

_TOLERANCE = 1e-14  # of the Newton decrement, in parts of the energy
_MAX_STEPS = 12


class LoadedSheet(PlateProblem):
    """Energy of a sheet over its free dofs less the work of a dead load, in units of mu W^3.

    Energy, residual and tangent are those of `problem.PlateProblem`; only the boundary conditions
    and the load differ.

    Parameters
    ----------
    space : Space
    section : section.Section
    free : (3, size) array of bool
        The unknowns.
    position : (3, size) array
        First guess; its values at the other dofs are prescribed.
    load : (3, size) array, optional
        Force on every dof.
    """

    def __init__(
        self,
        space: Space,
        section: Section,
        free: Mask,
        position: Array,
        load: Array | None = None,
    ) -> None:
        super().__init__(space, section, free, position)
        self._load = np.zeros(self.assembler.size) if load is None else load[free]
        self._lift: sparse.csr_array | None = None

    def energy(self, unknowns: Array) -> float:
        """Return the potential energy, infinite where the surface degenerates."""
        return super().energy(unknowns) - float(self._load @ unknowns)

    def derivatives(self, unknowns: Array) -> EnergyExpansion:
        """Return the potential energy, the residual and the upper triangle of the tangent."""
        energy, residual, tangent = super().derivatives(unknowns)
        work = float(self._load @ unknowns)
        return EnergyExpansion(energy - work, residual - self._load, tangent)

    def shift(self) -> sparse.csr_array:
        """Return t^3 times the squares of the second derivatives of all components."""
        if self._lift is None:
            blocks = []
            for c, d in self.assembler.pairs:
                entries = self.assembler.entries(c == d)
                block = np.zeros((len(entries), *self.assembler.space.measure.shape))
                for k in (2, 3, 4) if c == d else ():
                    block[entries.index((k, k))] = self.section.thickness**3
                blocks.append(block)
            self._lift = self.assembler.tangent(blocks)
        return self._lift

    def solve(self, rough: float = 1e-6) -> Array:
        """Return the position of least energy from the first guess, (3, size).

        The safeguarded minimisation goes down to the given part of the energy; plain Newton steps
        do the rest, because the energy of an unstretched, slightly bent sheet is lost in the
        rounding of W(a), so that no line search on it can end.

        Raises
        ------
        ArithmeticError
            If no equilibrium is reached.
        """
        start = self.prescribed[self.assembler.free]
        solver = make_solver()
        options = newton.NewtonOptions(tolerance=rough)
        minimum = newton.minimise(self, start, solver, options)
        if not minimum.converged:
            raise ArithmeticError(f"no equilibrium: {minimum.reason}")
        unknowns = minimum.unknowns
        for _ in range(_MAX_STEPS):
            energy, residual, tangent = self.derivatives(unknowns)
            solver.factorise(tangent)
            step = -solver.solve(residual)
            unknowns = unknowns + step
            if -float(residual @ step) <= _TOLERANCE * abs(energy):
                return self.position(unknowns)
        raise ArithmeticError(f"no equilibrium in {_MAX_STEPS} plain Newton steps")


def nodes(space: Space) -> Array:
    """Return a field of zeros in the layout of the grid, (4, nx + 1, ny + 1)."""
    return np.zeros((4, len(space.grid.x), len(space.grid.y)))


def affine(space: Space, along: float, across: float) -> Array:
    """Return the position x = along X, y = across Y, z = 0 as a field, (3, size)."""
    return space.coordinates * np.array([[along], [across], [0.0]])


def held(
    space: Space,
    middle: tuple[str, str, str],
    clamp: tuple[str, str, str],
    midline: tuple[str, str, str],
    edge: tuple[str, str, str],
) -> Mask:
    """Return which dofs are free, from what each line of the quarter does to x, y and z.

    Parameters
    ----------
    space : Space
    middle, clamp, midline, edge : (str, str, str)
        For the lines X = 0, X = L/2, Y = 0 and Y = 1/2 and the components x, y, z: 'free', 'odd'
        (value held, as on a mirror line of an odd component), 'even' (normal slope held) or
        'both'.

    Returns
    -------
    (3, size) array of bool
    """
    fixed = np.zeros((3, *nodes(space).shape))
    lines = (
        (middle, (slice(None), 0, slice(None)), SLOPE_X, SLOPE_Y),
        (clamp, (slice(None), -1, slice(None)), SLOPE_X, SLOPE_Y),
        (midline, (slice(None), slice(None), 0), SLOPE_Y, SLOPE_X),
        (edge, (slice(None), slice(None), -1), SLOPE_Y, SLOPE_X),
    )
    for kinds, place, normal, along in lines:
        for component, kind in enumerate(kinds):
            line = fixed[component][place]
            if kind in ("odd", "both"):
                line[[VALUE, along]] = 1.0
            if kind in ("even", "both"):
                line[[normal, TWIST]] = 1.0
    free: Mask = space.field_from_nodes(fixed) == 0.0
    return free
