"""Stability of a wrinkled state in the whole sheet, from the quarter.

The state keeps two mirrors of the sheet. A perturbation of the whole sheet is a sum of four parts
that keep or break each of them, and the tangent does not couple the parts: the state is stable in
the whole sheet exactly if its tangent is positive on all four.
"""

from collections.abc import Callable, Collection
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from wrinklestudy.equilibrium.modes import deflection_matrices
from wrinklestudy.equilibrium.wrinkled import Equilibrium
from wrinklestudy.fem.assembly import Assembler
from wrinklestudy.fem.factorisation import make_indefinite_solver, symmetric
from wrinklestudy.mechanics import plate
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

# (keeps the mirror x = 0, keeps the mirror y = 0)
MirrorClass = tuple[bool, bool]
CLASSES: tuple[MirrorClass, ...] = ((True, True), (True, False), (False, True), (False, False))


class ClassStability(NamedTuple):
    """Stability against one class of perturbations."""

    keeps_x: bool
    keeps_y: bool
    unstable: int  # negative eigenvalues of the tangent
    softest: float  # smallest eigenvalue against t^3 B, see `classes`


def classes(
    state: Equilibrium,
    kinds: Collection[MirrorClass] = CLASSES,
    eigenvalues: Collection[MirrorClass] = CLASSES,
) -> list[ClassStability]:
    """Return the stability of a state against classes of perturbations.

    The number `softest` is the smallest mu of K v = mu (t^3 B) v with the tangent K and the bending
    matrix B of the flat state, which acts on the deflection: 1 - (tau_1/t)^2 for the flat state
    itself, so that it compares a stiffness to the one that the flat state lacks.

    Parameters
    ----------
    state : Equilibrium
        A wrinkled state.
    kinds : collection of (keeps_x, keeps_y)
        The classes, all four by default.
    eigenvalues : collection of (keeps_x, keeps_y)
        Those for which to compute `softest`; NaN for the others.

    Raises
    ------
    ValueError
        If the state did not converge.
    """
    if state.position is None or state.status == "not-converged":
        raise ValueError(f"status {state.status!r}: only a converged state has a stability")
    flat, settings = state.planar.flat, state.planar.settings
    if flat is None:
        raise ValueError("the state has no flat state")
    section = Section(flat.law, state.thickness, settings.bending)
    surface, slopes = plate.respond(section, flat.space.derivatives(state.position))
    found = []
    for keeps_x, keeps_y in kinds:
        free = flat.space.free(settings.parity, keeps_x, keeps_y)
        tangent = Assembler(flat.space, free, 5).tangent(plate.hessian(surface, slopes))
        solver = make_indefinite_solver()
        solver.factorise(tangent)
        softest = float("nan")
        if (keeps_x, keeps_y) in eigenvalues:
            _, bent, _, _ = deflection_matrices(
                flat, settings.bending, settings.parity, keeps_x, keeps_y
            )
            softest = _softest(tangent, free, state.thickness**3 * bent, solver.solve)
        found.append(ClassStability(keeps_x, keeps_y, solver.negative, softest))
    return found


def _softest(
    tangent: sparse.csr_array,
    free: NDArray[np.bool_],
    bent: sparse.csr_array,
    solve: Callable[[Array], Array],
) -> float:
    """Return the eigenvalue of K v = mu M v nearest to zero, M acting on the deflection only."""
    from scipy.sparse.linalg import LinearOperator, eigsh

    size, deflections = tangent.shape[0], int(free[2].sum())

    whole = symmetric(bent)

    def mass(vector: Array) -> Array:
        result = np.zeros_like(vector)
        result[-deflections:] = whole @ vector[-deflections:]
        return result

    def operator(action: Callable[[Array], Array]) -> LinearOperator:
        return LinearOperator((size, size), matvec=action, dtype=np.float64)

    values = eigsh(
        symmetric(tangent),
        k=1,
        M=operator(mass),
        sigma=0.0,
        OPinv=operator(solve),
        v0=solve(mass(np.ones(size))),
        return_eigenvectors=False,
    )
    return float(values[0])
