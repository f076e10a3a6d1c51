"""A pin that keeps the pattern of wrinkles from sliding across the sheet.

Without a mirror at Y = 0 the pattern slides almost freely: the softest eigenvalue of the tangent is
some 1e-8 of the bending stiffness, so that Newton's method walks along the valley for ever although
the residual is rounding. One degree of freedom at the centre is therefore held: the deflection of
an odd pattern, its slope across for an even one. What force the pin carries, and the eigenvalue
without it, are reported with the state.
"""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium.energy import EnergyExpansion
from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.problem import PlateProblem, Predicting
from wrinklestudy.equilibrium.quartic import relaxations
from wrinklestudy.fem.factorisation import Solver
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.upper_triangle import multiply
from wrinklestudy.typing import Array, Mask
from wrinklestudy.vocabulary import Parity

_RESIDUAL, _MAX_STEPS = 1.0e-7, 10


def pinned_dof(space: Space, parity: Parity) -> int:
    """Return the degree of freedom of the deflection that a pin at the centre holds."""
    numbers = space.nodes_from_field(np.arange(space.size, dtype=np.float64))
    i, j = (int(np.abs(lines).argmin()) for lines in (space.grid.x, space.grid.y))
    return int(numbers[0 if parity == "antisymmetric" else 2, i, j])


class Pinned:
    """A plate problem with one unknown held at its value; all else as in `Predicting`.

    The row and column of the pin are emptied rather than left out, so that the sparsity and its
    ordering serve both families of wrinkles and the sheet without a pin.

    Parameters
    ----------
    problem : PlateProblem
    unknown : int
        Number of the unknown that is held.
    """

    def __init__(self, problem: PlateProblem, unknown: int) -> None:
        self.problem, self.unknown = problem, unknown
        self.energy = problem.energy
        self._predicting = Predicting(problem)
        pattern = problem.assembler.sparsity.pattern
        start, stop = pattern.indptr[unknown], pattern.indptr[unknown + 1]
        self._crossed: Mask = pattern.indices == unknown
        self._crossed[start:stop] = True
        self._diagonal = start + int(np.flatnonzero(pattern.indices[start:stop] == unknown)[0])

    def derivatives(self, unknowns: Array) -> EnergyExpansion:
        """Return the energy, the residual and the upper triangle of the predicted tangent."""
        here = self._predicting.derivatives(unknowns)
        return EnergyExpansion(here.energy, self._held(here.residual), self.held(here.tangent, 1.0))

    def residual(self, unknowns: Array) -> Array:
        """Return the residual alone, zero at the pin."""
        return self._held(self.problem.residual(unknowns))

    def shift(self) -> sparse.csr_array:
        """Return the matrix of shifts, empty at the pin."""
        return self.held(self.problem.shift(), 0.0)

    def held(self, upper: sparse.csr_array, diagonal: float) -> sparse.csr_array:
        """Return a matrix with the row and column of the pin emptied but for its diagonal."""
        data = np.where(self._crossed, 0.0, upper.data)
        data[self._diagonal] = diagonal
        return sparse.csr_array((data, upper.indices, upper.indptr), shape=upper.shape)

    def _held(self, residual: Array) -> Array:
        residual = residual.copy()
        residual[self.unknown] = 0.0
        return residual


def further(
    flat: Flat, bent: sparse.csr_array, position: Array, unwrinkled: Array, direction: Array
) -> Array:
    """Return a first guess (3, size) of the state whose pattern is a quarter of a wave further.

    Its wrinkles are the direction in which the pattern slides, with as much bending energy as those
    of the state. In its plane the sheet gives way to them as it does to those of the state.

    Parameters
    ----------
    flat : Flat
    bent : sparse array
        B on the free deflections.
    position : (3, size) array
        The state.
    unwrinkled : (3, size) array
        The sheet without wrinkles.
    direction : (n,) array
        See `Slide`.
    """
    free = flat.symmetry.free(flat.space)[2]
    wrinkles = np.zeros((2, flat.space.size))
    wrinkles[0, free] = (position - unwrinkled)[2, free]
    wrinkles[1, free] = direction[-bent.shape[0] :]
    own, other = (float(w @ multiply(bent, w)) for w in wrinkles[:, free])
    wrinkles[1] *= np.sqrt(own / other)
    guess = position.copy()
    guess[2] = unwrinkled[2] + wrinkles[1]
    here, there = relaxations(flat, np.stack([position[2], guess[2]]))
    guess[:2] += there - here
    return guess


class Slide(NamedTuple):
    """What the pin holds, and what the sheet would be like without it.

    Parameters
    ----------
    reaction : float
        What the pin carries, as a part of the largest contribution of the elements around it: the
        residual of the unknown that is held over its diagonal of the tangent, in units of t.
    softest : float
        NaN if the direction is not known to the digits that it needs, otherwise the smallest mu of
        K v = mu t^3 B v without the pin, with the tangent K and the bending matrix B
        of the flat state: the stiffness against sliding over that against bending.
    direction : (n,) array
        How the sheet slides: the deflection is a pattern a quarter of a wave further.
    """

    reaction: float
    softest: float
    direction: Array


def slide(pinned: Pinned, unknowns: Array, bent: sparse.csr_array, solver: Solver) -> Slide:
    """Return what a pin carries at an equilibrium and the softest eigenvalue without it.

    The softest direction is what the sheet does when the pin is moved, v = (-K^-1 k, 1), up to the
    square of its small eigenvalue.

    Parameters
    ----------
    pinned : Pinned
    unknowns : (n,) array
        The equilibrium.
    bent : sparse array
        t^3 B on the free deflections, the last of the unknowns.
    solver : Solver
        With the pinned tangent at the last iterate of Newton's method, which is close to that at
        the equilibrium.
    """
    here, pin = pinned.problem.derivatives(unknowns), pinned.unknown
    unit = np.zeros(len(unknowns))
    unit[pin] = 1.0
    column = multiply(here.tangent, unit)
    stiffness = float(column[pin])
    column[pin] = 0.0
    moved, exact = _solve(pinned.held(here.tangent, 1.0), column, solver)
    direction = unit - moved
    work = float(direction @ multiply(here.tangent, direction))
    bending = direction[-bent.shape[0] :]
    softest = work / float(bending @ multiply(bent, bending)) if exact else float("nan")
    thickness = pinned.problem.thickness
    return Slide(float(here.residual[pin]) / (stiffness * thickness), softest, direction)


def _solve(upper: sparse.csr_array, rhs: Array, solver: Solver) -> tuple[Array, bool]:
    """Solve K x = b by conjugate gradients, with a factorisation of a matrix that is close to K.

    Returns
    -------
    x : (n,) array
    exact : bool
        Whether the residual is as small as it should be.
    """
    from scipy.sparse.linalg import LinearOperator, cg

    def operator(action: Callable[[Array], Array]) -> LinearOperator:
        return LinearOperator(upper.shape, matvec=action, dtype=np.float64)

    solution, failed = cg(
        operator(partial(multiply, upper)),
        rhs,
        x0=solver.solve(rhs),
        rtol=_RESIDUAL,
        maxiter=_MAX_STEPS,
        M=operator(solver.solve),
    )
    return solution, failed == 0
