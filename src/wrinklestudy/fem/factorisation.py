"""Sparse factorisations of symmetric matrices behind one small interface.

PARDISO (Intel MKL, through pypardiso) where its wheels exist, SuperLU in symmetric mode
elsewhere. Matrices are given by their upper triangle in CSR form. Every solution is put into its
equations before it is returned.
"""

import importlib.util
import os
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from scipy import sparse

from wrinklestudy.fem.upper_triangle import backward_error, multiply, scaled, symmetric
from wrinklestudy.typing import Array

# PARDISO's errors where memory is short: none left, or more than its 32-bit numbers can count.
_NO_MEMORY = (-2, -8)
# Largest backward error of a solution; a sound factorisation leaves some 1e-15.
_LARGEST_ERROR = 1e-10
# Steps of iterative refinement where it is larger.
_REFINEMENTS = 2


class NotPositiveDefiniteError(ArithmeticError):
    """The matrix of a Cholesky factorisation is not positive definite."""


class InaccurateSolutionError(ArithmeticError):
    """A solution of linear equations does not satisfy them."""


class Solver(Protocol):
    """Factorises positive definite matrices; the ordering serves all of one sparsity pattern."""

    def factorise(self, upper: sparse.csr_array) -> None:
        """Factorise a positive definite matrix.

        Raises
        ------
        NotPositiveDefiniteError
            If it is not positive definite.
        """

    def solve(self, rhs: Array) -> Array:
        """Solve for one right-hand side (n,) or several (n, k).

        Raises
        ------
        InaccurateSolutionError
            If the solution does not satisfy the equations, see `backward_error`.
        """


class IndefiniteSolver(Protocol):
    """Factorises symmetric matrices that need not be definite."""

    negative_eigenvalues: int  # of the last factorised matrix, by Sylvester's law of inertia

    def factorise(self, upper: sparse.csr_array) -> None:
        """Factorise a symmetric matrix and count its negative eigenvalues."""

    def solve(self, rhs: Array) -> Array:
        """Solve for one right-hand side (n,) or several (n, k); raises as `Solver.solve`."""


def count_negative_eigenvalues(upper: sparse.csr_array) -> int:
    """Return the number of negative eigenvalues of a symmetric matrix."""
    solver = make_indefinite_solver()
    solver.factorise(upper)
    return solver.negative_eigenvalues


def make_indefinite_solver() -> IndefiniteSolver:
    """Return an L D L^T solver: PARDISO where pypardiso is installed, SuperLU elsewhere."""
    if importlib.util.find_spec("pypardiso") is not None:
        return PardisoIndefinite()
    return SuperLUIndefinite()


def make_solver() -> Solver:
    """Return a PARDISO solver where pypardiso is installed, a SuperLU solver elsewhere."""
    if importlib.util.find_spec("pypardiso") is not None:
        return PardisoSolver()
    return SuperLUSolver()


def _accurate(solve: Callable[[Array], Array], upper: sparse.csr_array, rhs: Array) -> Array:
    """Solve, refine the solution where it is not accurate, and refuse it where that does not help.

    Parameters
    ----------
    solve : callable
        Solves with the factors of the matrix.
    upper : (n, n) sparse array
        The matrix.
    rhs : (n,) or (n, k) array
    """
    solution = solve(rhs)
    for _ in range(_REFINEMENTS):
        if backward_error(upper, solution, rhs) <= _LARGEST_ERROR:
            return solution
        solution = solution + solve(rhs - multiply(upper, solution))
    error = backward_error(upper, solution, rhs)
    if error <= _LARGEST_ERROR:
        return solution
    raise InaccurateSolutionError(
        f"linear equations are solved with a relative error of {error:.1g} only"
        if np.isfinite(error)
        else "linear equations have numbers that are not finite"
    )


def _of_scaled(solve: Callable[[Array], Array], scale: Array, rhs: Array) -> Array:
    """Return S y of S K S y = S b: the solution of K x = b by the factors of the scaled matrix."""
    factor = scale if rhs.ndim == 1 else scale[:, None]
    return factor * solve(np.asfortranarray(factor * rhs))


class PardisoSolver:
    """Cholesky factorisation by PARDISO."""

    def __init__(self) -> None:
        self._cholesky: Any = None
        self._pattern: tuple[Any, Any] | None = None
        self._matrix: sparse.csr_array | None = None

    def factorise(self, upper: sparse.csr_array) -> None:
        """Factorise a positive definite matrix; the ordering is computed once for each pattern."""
        pattern = (upper.indptr, upper.indices)
        same = self._pattern is not None and all(
            a is b or np.array_equal(a, b) for a, b in zip(pattern, self._pattern, strict=True)
        )
        if not same:
            self._release()
            self._cholesky = _new_pardiso(2)
            _call_pardiso(self._cholesky, 11, upper)
            self._pattern = pattern
        self._matrix = upper
        _call_pardiso(self._cholesky, 22, upper)

    def solve(self, rhs: Array) -> Array:
        """Solve with the last factorised matrix."""
        if self._matrix is None:
            raise RuntimeError("solve before factorise")
        return _accurate(self._once, self._matrix, rhs)

    def _once(self, rhs: Array) -> Array:
        self._cholesky.set_phase(33)
        solution: Array = self._cholesky._call_pardiso(self._matrix, np.asfortranarray(rhs))
        return solution

    def _release(self) -> None:
        if self._cholesky is not None and self._matrix is not None:
            _call_pardiso(self._cholesky, -1, self._matrix)
        self._cholesky = self._matrix = self._pattern = None

    def __del__(self) -> None:
        """Free the memory that MKL holds outside Python."""
        if not sys.is_finalizing():
            self._release()


class PardisoIndefinite:
    """L D L^T by PARDISO, on the matrix scaled to a unit diagonal, with one step of refinement."""

    def __init__(self) -> None:
        self.negative_eigenvalues = 0
        self._upper: sparse.csr_array | None = None
        self._scaled: sparse.csr_array | None = None
        self._scale: Array = np.empty(0)
        self._solver: Any = None

    def factorise(self, upper: sparse.csr_array) -> None:
        """Factorise a symmetric matrix and count its negative eigenvalues."""
        self._release()
        self._upper = upper
        self._scaled, self._scale = scaled(upper)
        self._solver = _new_pardiso(-2)
        _call_pardiso(self._solver, 12, self._scaled)
        self.negative_eigenvalues = int(self._solver.get_iparm(23))

    def solve(self, rhs: Array) -> Array:
        """Solve with the last factorised matrix."""
        if self._upper is None:
            raise RuntimeError("solve before factorise")
        return _accurate(self._refined, self._upper, rhs)

    def _refined(self, rhs: Array) -> Array:
        solution = self._once(rhs)
        return solution + self._once(rhs - multiply(self._upper, solution))

    def _once(self, rhs: Array) -> Array:
        self._solver.set_phase(33)
        return _of_scaled(partial(self._solver._call_pardiso, self._scaled), self._scale, rhs)

    def _release(self) -> None:
        if self._solver is not None:
            _call_pardiso(self._solver, -1, self._scaled)
        self._solver = None

    def __del__(self) -> None:
        """Free the memory that MKL holds outside Python."""
        if not sys.is_finalizing():
            self._release()


def _call_pardiso(solver: Any, phase: int, upper: sparse.csr_array) -> None:
    """Run a phase of PARDISO that needs no right-hand side."""
    from pypardiso.pardiso_wrapper import PyPardisoError

    solver.set_phase(phase)
    try:
        solver._call_pardiso(upper, np.zeros(upper.shape[0]))
    except PyPardisoError as error:
        if error.value == -4 and solver.mtype == 2:
            raise NotPositiveDefiniteError("zero or negative pivot") from None
        if error.value in _NO_MEMORY:
            size = f"{upper.shape[0]:,} unknowns"
            raise MemoryError(f"no memory for a factorisation with {size}") from None
        raise


def _new_pardiso(mtype: int) -> Any:
    """Return a PARDISO handle for symmetric matrices (2 positive definite, -2 indefinite)."""
    if "PYPARDISO_MKL_RT" not in os.environ:
        # Otherwise pypardiso calls a compiler and then searches the whole environment.
        libraries = sorted(Path(sys.prefix, "lib").glob("libmkl_rt.so*"))
        if libraries:
            os.environ["PYPARDISO_MKL_RT"] = str(libraries[0])
    from pypardiso.pardiso_wrapper import PyPardisoSolver

    solver = PyPardisoSolver(mtype=mtype)
    # Own values (1), METIS ordering (2), no refinement (8), pivots that are too small replaced by
    # 1e-13 (10), fill-in not counted (18), pivots of 1 x 1 and 2 x 2 (21), the classic
    # factorisation (24), matrix not checked (27).
    for index, value in {1: 1, 2: 2, 8: 0, 10: 13, 18: 0, 21: 1, 24: 0, 27: 0}.items():
        solver.set_iparm(index, value)
    return solver


class SuperLUSolver:
    """LU factorisation by SuperLU in symmetric mode."""

    def __init__(self) -> None:
        self._factor: Any = None
        self._scale: Array = np.empty(0)
        self._upper: sparse.csr_array | None = None

    def factorise(self, upper: sparse.csr_array) -> None:
        """Factorise a positive definite matrix."""
        unit, scale = scaled(upper)
        factor = _without_pivoting(unit)
        if not np.all(factor.U.diagonal() > 0):
            raise NotPositiveDefiniteError("zero or negative pivot")
        self._factor, self._scale, self._upper = factor, scale, upper

    def solve(self, rhs: Array) -> Array:
        """Solve with the last factorised matrix."""
        if self._upper is None:
            raise RuntimeError("solve before factorise")
        return _accurate(self._once, self._upper, rhs)

    def _once(self, rhs: Array) -> Array:
        return _of_scaled(self._factor.solve, self._scale, rhs)


class SuperLUIndefinite:
    """SuperLU: with pivoting to solve, without to count negative eigenvalues."""

    def __init__(self) -> None:
        self.negative_eigenvalues = 0
        self._factor: Any = None
        self._scale: Array = np.empty(0)
        self._upper: sparse.csr_array | None = None

    def factorise(self, upper: sparse.csr_array) -> None:
        """Factorise a symmetric matrix and count its negative eigenvalues."""
        from scipy.sparse.linalg import splu

        unit, self._scale = scaled(upper)
        self.negative_eigenvalues = int(np.sum(_without_pivoting(unit).U.diagonal() < 0))
        self._factor, self._upper = splu(symmetric(unit).tocsc()), upper

    def solve(self, rhs: Array) -> Array:
        """Solve with the last factorised matrix."""
        if self._upper is None:
            raise RuntimeError("solve before factorise")
        return _accurate(self._once, self._upper, rhs)

    def _once(self, rhs: Array) -> Array:
        return _of_scaled(self._factor.solve, self._scale, rhs)


def _without_pivoting(unit: sparse.csr_array) -> Any:
    """Return SuperLU's factor of a scaled matrix; its pivots have the signs of the eigenvalues."""
    from scipy.sparse.linalg import splu

    factor = splu(
        symmetric(unit).tocsc(),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    if not np.array_equal(factor.perm_r, factor.perm_c):
        raise ArithmeticError("SuperLU left the diagonal: a pivot is zero")
    return factor
