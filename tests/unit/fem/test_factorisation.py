"""Both factorisations: solutions, definiteness and inertia against dense linear algebra."""

import importlib.util

import numpy as np
import pytest
from scipy import sparse

from wrinklestudy.fem import factorisation
from wrinklestudy.fem.upper_triangle import backward_error, multiply

NEEDS_PARDISO = pytest.mark.skipif(
    importlib.util.find_spec("pypardiso") is None, reason="pypardiso has wheels for x86-64 only"
)
SOLVERS = [
    pytest.param(factorisation.PardisoSolver, marks=NEEDS_PARDISO),
    factorisation.SuperLUSolver,
]
INDEFINITE = [
    pytest.param(factorisation.PardisoIndefinite, marks=NEEDS_PARDISO),
    factorisation.SuperLUIndefinite,
]


SHIFTS = [-1.0, 0.01, 0.5, 1.2, 5.0]


def matrix(shift, size=80, seed=0):
    """A symmetric matrix with rows of very different size, like bending beside stretching."""
    rng = np.random.default_rng(seed)
    random = sparse.random_array((size, size), density=0.05, rng=rng)
    full = (random + random.T).toarray() + shift * np.eye(size)
    scale = np.where(np.arange(size) < size // 2, 1.0, 1e-4)
    return scale[:, None] * full * scale


def upper(full):
    return sparse.csr_array(sparse.triu(sparse.csr_array(full), format="csr"))


@pytest.mark.parametrize("solver", SOLVERS)
def test_solves_one_and_several_right_hand_sides(solver):
    full = matrix(5.0)
    assert np.linalg.eigvalsh(full).min() > 0
    factor = solver()
    factor.factorise(upper(full))
    rhs = np.random.default_rng(1).standard_normal((len(full), 3))
    for block in (rhs, rhs[:, 0]):
        solution = factor.solve(block)
        # every row in its own scale: the soft ones count as much as the stiff ones
        assert np.allclose(full @ solution, block, atol=1e-10)


@pytest.mark.parametrize("solver", SOLVERS)
def test_reuses_the_pattern_for_new_numbers(solver):
    factor = solver()
    for shift in (5.0, 8.0):
        full = matrix(shift)
        factor.factorise(upper(full))
        assert np.allclose(full @ factor.solve(np.ones(len(full))), 1.0, atol=1e-10)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("shift", SHIFTS)
def test_only_definite_matrices_are_factorised(solver, shift):
    full = matrix(shift)
    if np.linalg.eigvalsh(full).min() < 0:
        with pytest.raises(factorisation.NotPositiveDefiniteError):
            solver().factorise(upper(full))
    else:
        solver().factorise(upper(full))


@pytest.mark.parametrize("solver", INDEFINITE)
@pytest.mark.parametrize("shift", SHIFTS)
def test_indefinite_matrices_are_solved_and_their_negative_eigenvalues_counted(solver, shift):
    full = matrix(shift)
    negative = int(np.sum(np.linalg.eigvalsh(full) < 0))
    factor = solver()
    factor.factorise(upper(full))
    assert factor.negative_eigenvalues == negative
    assert factorisation.count_negative_eigenvalues(upper(full)) == negative
    rhs = np.random.default_rng(1).standard_normal((len(full), 2))
    for block in (rhs, rhs[:, 0]):
        assert np.allclose(full @ factor.solve(block), block, atol=1e-8)


def test_multiply_uses_both_triangles():
    full = matrix(0.3)
    block = np.random.default_rng(2).standard_normal((len(full), 2))
    assert np.allclose(multiply(upper(full), block), full @ block)
    assert np.allclose(multiply(upper(full), block[:, 0]), full @ block[:, 0])


@pytest.mark.parametrize("solver", SOLVERS + INDEFINITE)
def test_a_solution_that_does_not_satisfy_its_equations_is_refused(solver):
    """Factors of one matrix for the equations of another, and numbers that are none."""
    factor = solver()
    changed = upper(matrix(5.0))
    factor.factorise(changed)
    rhs = np.ones(changed.shape[0])
    with pytest.raises(factorisation.InaccurateSolutionError, match="not finite"):
        factor.solve(np.where(np.arange(len(rhs)) == 3, np.nan, rhs))
    factor.solve(rhs)
    changed.data *= 3.0
    with pytest.raises(factorisation.InaccurateSolutionError, match="a relative error of 0"):
        factor.solve(rhs)


@pytest.mark.parametrize("solver", SOLVERS)
def test_solutions_that_are_slightly_wrong_are_refined(solver):
    """Where the factors are those of a matrix that is close, a step of refinement mends it."""
    factor = solver()
    changed = upper(matrix(5.0))
    factor.factorise(changed)
    changed.data *= 1.0 + 1e-6
    rhs = np.ones(changed.shape[0])
    assert backward_error(changed, factor.solve(rhs), rhs) < 1e-11


def test_the_backward_error_counts_soft_rows_as_much_as_stiff_ones():
    full = matrix(5.0)
    rhs = np.ones(len(full))
    solution = np.linalg.solve(full, rhs)
    assert backward_error(upper(full), solution, rhs) < 1e-14
    for row in (3, len(full) - 3):  # stiff, soft
        wrong = rhs.copy()
        wrong[row] *= 1.001
        error = backward_error(upper(full), np.linalg.solve(full, wrong), rhs)
        assert error > 1e-9
    assert backward_error(upper(full), 0.0 * rhs, 0.0 * rhs) == 0.0
    assert np.isnan(backward_error(upper(full), np.nan * rhs, rhs))
