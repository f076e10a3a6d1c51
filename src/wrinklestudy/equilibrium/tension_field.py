"""Tension field theory of the clamped sheet: its state in the limit of no thickness at all.

The relaxed energy (`mechanics.relaxed`) is minimised over planar positions. It has no stiffness
across the wrinkles, so that the regions, taut, wrinkled or slack, are part of the solution. The
remainder delta of `(1 - delta) W_relaxed + delta W` is lowered to zero on a coarse mesh, whose
solution is where that of the mesh itself starts from; the two together give the error of the mesh.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

from scipy import sparse

from wrinklestudy.equilibrium import flat, newton
from wrinklestudy.fem.boundary import QUARTER, Symmetry
from wrinklestudy.fem.grid import Grid, MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.transfer import coarsened, transferred
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.mechanics.relaxed import RelaxedLaw, check_relaxed
from wrinklestudy.typing import Array

# 4 x 4 Gauss points: with 3 x 3 the number of Newton steps grows as the mesh gets finer across.
_ORDER = 7
_REMAINDERS = (0.01, 0.0)
_SHORTER = (1e-3, 1e-4, 0.0)  # steps for the rest of the way, where the last one was too long
_ON_THE_WAY = 1e-7  # tolerance with a remainder, whose minimum is a first guess
_LEAST_CELLS = 4
_ACROSS = 2.0 / 3.0  # of the cells across that wrinkles need
_OPTIONS = newton.NewtonOptions(
    # Near the minimum single points change between taut and wrinkled again and again, which alters
    # Phi^2 in its seventh digit and takes as many iterations as all before.
    tolerance=1e-11,
    max_iterations=100,
    # Steps are bounded by shifts and not shortened: the regions change within a step, and half a
    # step would have to be halved again many times.
    first_shift=1e-2,
    rise=1.0,
    noise=flat.ROUNDING,
    smooth=False,
)


@dataclass(frozen=True)
class TensionField:
    """State of a sheet without thickness at one strain.

    Parameters
    ----------
    space : Space
    law : Law
        Dimensionless material law.
    strain : float
        eps = (L' - L)/L of the clamps.
    reason : str
        Why it did not converge; empty if it did.
    position : (2, size) array
        In-plane position x, y as dof vectors, in units of W; the last iterate if it did not
        converge.
    energy : float
        Energy of the part that is solved for each unit of thickness, in units of mu W^2.
    force : float
        Nominal stress at the clamp, force / (W t), in units of mu.
    remainder : float
        delta of the energy of this state; 0 unless Newton's method failed on the way there.
    history : tuple of newton.Iteration
        All iterations on this mesh.
    coarser : TensionField or None
        The state on the coarser mesh that this one started from.
    """

    space: Space
    law: Law
    strain: float
    reason: str
    position: Array
    energy: float
    force: float
    remainder: float
    history: tuple[newton.Iteration, ...]
    coarser: "TensionField | None" = None

    @property
    def converged(self) -> bool:
        """Whether it is a minimum of its energy within the tolerance."""
        return not self.reason

    @property
    def nodes(self) -> Array:
        """The position in the layout of the grid, (2, 4, nx + 1, ny + 1)."""
        return self.space.nodes_from_field(self.position)


class RelaxedProblem(flat.MembraneProblem):
    """The relaxed energy of a sheet over its free dofs, for each unit of thickness.

    Parameters
    ----------
    space : Space
    relaxed : RelaxedLaw
    prescribed : (2, size) array
        A position; its values at the dofs that are not free hold.
    taut : (2, size) array
        A position at which the sheet is stretched in both directions or nearly so, the flat state
        for instance: the tangent of the law itself is positive definite there, and serves as the
        matrix for shifts.
    symmetry : Symmetry
    """

    def __init__(
        self,
        space: Space,
        relaxed: RelaxedLaw,
        prescribed: Array,
        taut: Array,
        symmetry: Symmetry = QUARTER,
    ) -> None:
        super().__init__(space, relaxed, prescribed, symmetry)
        self._taut = flat.MembraneProblem(space, relaxed.law, taut, symmetry)
        self._shift: sparse.csr_array | None = None

    def shift(self) -> sparse.csr_array:
        """Return the tangent of the law itself where the sheet is taut."""
        if self._shift is None:
            self._shift = self._taut.derivatives(self._taut.prescribed[self.assembler.free]).tangent
        return self._shift


def tension_grid(aspect: float, settings: MeshSettings) -> Grid:
    """Return the grid for the tension field of a sheet of the given L/W.

    It has two thirds of the cells across that wrinkles need: Phi^2 is then good to some parts in
    ten thousand.
    """
    across = max(2 * _LEAST_CELLS, math.ceil(_ACROSS * settings.cells_across - 1e-9))
    return make_grid(aspect, settings=replace(settings, cells_across=across))


def solve(
    grid: Grid | Space,
    law: Law,
    strain: float,
    symmetry: Symmetry = QUARTER,
    observer: newton.Observer | None = None,
) -> TensionField:
    """Return the tension field of a clamped sheet stretched by a strain.

    Parameters
    ----------
    grid : Grid or Space
        Grid of the part of the sheet that is solved.
    law : Law
        Dimensionless material law.
    strain : float
        eps of the clamps, > 0.
    symmetry : Symmetry
        Mirrors that bound the grid.
    observer : newton.Observer, optional
        Is told of each iteration.

    Returns
    -------
    TensionField
        With `reason` set where it did not converge; nothing is raised for that.

    Raises
    ------
    ValueError
        If the law has a strain that is linear in the plane: its natural width is that of no metric.
    """
    check_relaxed(law)
    lines = grid.grid if isinstance(grid, Space) else grid
    options = _OPTIONS
    if observer is not None:
        options = replace(options, observe=partial(observer, "tension field"))
    along, across = (max(_LEAST_CELLS, count // 2) for count in lines.cells)
    coarse = Space(coarsened(lines, along, across), _ORDER)
    coarser = _from_flat(coarse, law, strain, symmetry, options)
    space = Space(lines, _ORDER)
    if coarser.converged and coarser.remainder == 0.0:
        start = transferred(coarser.position, coarse, space)
        taut = flat.stretched(space, strain, symmetry)
        held = ~symmetry.free(space)[:2]
        start[held] = taut[held]
        state = _lower(space, law, strain, start, taut, symmetry, options, (0.0,))
        if state.converged:
            return replace(state, coarser=coarser)
    return replace(_from_flat(space, law, strain, symmetry, options), coarser=coarser)


def _from_flat(
    space: Space, law: Law, strain: float, symmetry: Symmetry, options: newton.NewtonOptions
) -> TensionField:
    """Return the tension field on a mesh from the flat state."""
    try:
        position = flat.solve(space, law, strain, symmetry=symmetry).position
    except ArithmeticError as error:
        position = flat.stretched(space, strain, symmetry)
        nan = float("nan")
        return TensionField(space, law, strain, str(error), position, nan, nan, 1.0, ())
    state = _lower(space, law, strain, position, position, symmetry, options, _REMAINDERS)
    if not state.converged or state.remainder == 0.0:
        return state
    rest = _lower(space, law, strain, state.position, position, symmetry, options, _SHORTER)
    return replace(rest if rest.converged else state, history=state.history + rest.history)


def _lower(
    space: Space,
    law: Law,
    strain: float,
    start: Array,
    taut: Array,
    symmetry: Symmetry,
    options: newton.NewtonOptions,
    remainders: Sequence[float],
) -> TensionField:
    """Minimise with one remainder after the other; where one fails the last minimum is kept."""
    state: TensionField | None = None
    history: tuple[newton.Iteration, ...] = ()
    for remainder in remainders:
        problem = RelaxedProblem(space, RelaxedLaw(law, remainder), start, taut, symmetry)
        free = problem.assembler.free
        first = (start if state is None else state.position)[free]
        own = options if remainder == 0.0 else replace(options, tolerance=_ON_THE_WAY)
        minimum = newton.minimise(problem, first, problem.assembler.solver, own)
        history += minimum.history
        if state is not None and not minimum.converged:
            return replace(state, history=history)
        state = TensionField(
            space,
            law,
            strain,
            minimum.reason and f"tension field at strain {strain:g}: {minimum.reason}",
            problem.position(minimum.unknowns),
            minimum.energy,
            problem.force(minimum.unknowns),
            remainder,
            history,
        )
        if not minimum.converged:
            break
    if state is None:
        raise ValueError("remainders: none given")
    return state
