"""Stability of a wrinkled state in the whole sheet, from the quarter.

The state keeps two mirrors of the sheet. A perturbation of the whole sheet is a sum of four parts
that keep or break each of them, and the tangent does not couple the parts: the state is stable in
the whole sheet if and only if its tangent is positive on all four.
"""

from collections.abc import Callable, Collection
from typing import NamedTuple

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium.deflections import deflection_forms
from wrinklestudy.equilibrium.wrinkled import Equilibrium
from wrinklestudy.fem.assembly import Assembler
from wrinklestudy.fem.factorisation import make_indefinite_solver
from wrinklestudy.fem.upper_triangle import symmetric
from wrinklestudy.mechanics import plate
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

_EIGENVALUE_TOLERANCE = 1.0e-6  # of several vectors; a single one is found to rounding
_LANCZOS = 5  # vectors for each


class MirrorClass(NamedTuple):
    """Perturbations that keep or break each mirror of the state."""

    keeps_x: bool  # X = 0
    keeps_y: bool  # Y = 0


CLASSES = tuple(
    MirrorClass(keeps_x, keeps_y) for keeps_x in (True, False) for keeps_y in (True, False)
)


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
    itself, so that it measures a stiffness against the one that the flat state lacks.

    Parameters
    ----------
    state : Equilibrium
        A wrinkled state.
    kinds : collection of MirrorClass
        The classes, all four by default.
    eigenvalues : collection of MirrorClass
        The classes for which `softest` is computed; it is NaN for the others.

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
    hessian = plate.hessian(surface, slopes)
    stabilities = []
    for kind in kinds:
        perturbations = settings.symmetry.broken(kind.keeps_x, kind.keeps_y)
        free = perturbations.free(flat.space)
        tangent = Assembler(flat.space, free).tangent(hessian)
        solver = make_indefinite_solver()
        solver.factorise(tangent)
        softest = float("nan")
        if kind in eigenvalues:
            bent = deflection_forms(flat, settings.bending, perturbations).bending
            softest = softest_eigenvalue(tangent, state.thickness**3 * bent, solver.solve)
        stabilities.append(ClassStability(*kind, solver.negative_eigenvalues, softest))
    return stabilities


def softest_eigenvalue(
    tangent: sparse.csr_array, bent: sparse.csr_array, solve: Callable[[Array], Array]
) -> float:
    """Return the eigenvalue of K v = mu M v nearest to zero, see `softest_modes`."""
    start = np.ones(tangent.shape[0])
    return float(softest_modes(tangent, bent, solve, 1, 0.0, start)[0][0])


def softest_modes(
    tangent: sparse.csr_array,
    bent: sparse.csr_array,
    solve: Callable[[Array], Array],
    count: int,
    shift: float,
    start: Array,
) -> tuple[Array, Array]:
    """Return eigenvalues of K v = mu M v near a shift, and the vectors; M acts on deflections.

    Parameters
    ----------
    tangent : sparse array
        Upper triangle of K.
    bent : sparse array
        Upper triangle of M on the deflections, the last of the unknowns.
    solve : callable
        Solves with K - shift M.
    count : int
        How many.
    shift : float
    start : (n,) array
        A vector that has something of all that are wanted.

    Raises
    ------
    ArithmeticError
        If they are not found.
    """
    from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigsh

    size, deflections = tangent.shape[0], bent.shape[0]
    whole = symmetric(bent)

    def mass(vector: Array) -> Array:
        product = np.zeros_like(vector)
        product[-deflections:] = whole @ vector[-deflections:]
        return product

    def operator(action: Callable[[Array], Array]) -> LinearOperator:
        return LinearOperator((size, size), matvec=action, dtype=np.float64)

    try:
        values, vectors = eigsh(
            symmetric(tangent),
            k=count,
            M=operator(mass),
            sigma=shift,
            OPinv=operator(solve),
            v0=solve(mass(start)),
            ncv=min(max(_LANCZOS * count, 20), size),
            tol=_EIGENVALUE_TOLERANCE if count > 1 else 0.0,
        )
    except ArpackNoConvergence:
        raise ArithmeticError("the softest eigenvalues are not found") from None
    return values, vectors
