"""BFGS updates against the dense inverse formula and on a quadratic energy."""

import numpy as np
import pytest
from scipy import sparse

from wrinklestudy.equilibrium.bfgs import Update, inverse_times
from wrinklestudy.fem.factorisation import make_solver


def spd(rng, size):
    root = rng.standard_normal((size, size))
    return root @ root.T + size * np.eye(size)


@pytest.fixture
def case():
    """A factorised matrix and updates that belong to another one, so that y.s > 0."""
    rng = np.random.default_rng(0)
    first, true = spd(rng, 6), spd(rng, 6)
    solver = make_solver()
    solver.factorise(sparse.csr_array(np.triu(first)))
    updates = [Update(step, true @ step) for step in rng.standard_normal((3, 6))]
    return first, updates, solver


def test_is_the_dense_update_of_the_inverse(case):
    first, updates, solver = case
    inverse, one = np.linalg.inv(first), np.eye(6)
    for s, y in updates:
        turn = one - np.outer(s, y) / (y @ s)
        inverse = turn @ inverse @ turn.T + np.outer(s, s) / (y @ s)
    vector = np.arange(6.0)
    assert inverse_times(vector, updates, solver) == pytest.approx(inverse @ vector, rel=1e-10)


def test_the_last_step_is_met_exactly(case):
    """The secant condition: the inverse takes the change of the residual to the step."""
    _, updates, solver = case
    step, change = updates[-1]
    assert inverse_times(change, updates, solver) == pytest.approx(step, rel=1e-10)
