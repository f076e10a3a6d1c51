"""The minimiser on an energy with a saddle: it leaves the saddle, and it says when it fails."""

from zlib import crc32

import numpy as np
import pytest
from scipy import sparse

from wrinklestudy.equilibrium.energy import EnergyExpansion
from wrinklestudy.equilibrium.newton import NewtonOptions, minimise
from wrinklestudy.fem.factorisation import make_solver


class DoubleWell:
    """E = 1 + (x^2 - 1)^2 / 4 + 5 (y - x)^2: a saddle at 0, minima at x = y = +-1."""

    def __init__(self, shifts=True):
        self.shifts = shifts

    def energy(self, u):
        x, y = u
        return 1 + (x**2 - 1) ** 2 / 4 + 5 * (y - x) ** 2

    def derivatives(self, u):
        x, y = u
        residual = np.array([x**3 - x - 10 * (y - x), 10 * (y - x)])
        tangent = np.array([[3 * x**2 - 1 + 10, -10], [0.0, 10]])
        return EnergyExpansion(self.energy(u), residual, sparse.csr_array(tangent))

    def residual(self, u):
        return self.derivatives(u).residual

    def shift(self):
        return sparse.csr_array(np.array([[1.0, 1e-300], [0.0, 1.0]])) if self.shifts else None


@pytest.mark.parametrize("start", [(0.01, 0.0), (-0.2, 0.3), (5.0, -3.0)])
def test_finds_a_minimum_from_an_indefinite_start(start):
    minimum = minimise(DoubleWell(), np.array(start), make_solver(), NewtonOptions())
    assert minimum.converged
    assert np.allclose(np.abs(minimum.unknowns), 1.0, atol=1e-9)
    assert minimum.history[-1].shift == 0.0
    energies = [row.energy for row in minimum.history]
    assert np.all(np.diff(energies) <= 1e-12)


class Rounded(DoubleWell):
    """The double well with an error in its residual that never ends, as rounding has."""

    def derivatives(self, u):
        exact = super().derivatives(u)
        error = np.random.default_rng(crc32(u.tobytes())).standard_normal(2)
        return exact._replace(residual=exact.residual + 1e-9 * error)


@pytest.mark.parametrize(("noise", "converged"), [(1e-15, True), (1e-25, False)])
def test_ends_where_only_rounding_is_left(noise, converged):
    options = NewtonOptions(tolerance=1e-22, max_iterations=30, noise=noise)
    minimum = minimise(Rounded(), np.array([0.5, 0.4]), make_solver(), options)
    assert minimum.converged == converged
    assert np.allclose(minimum.unknowns, 1.0, atol=1e-8)


def test_stays_off_the_saddle_even_where_the_residual_vanishes():
    """At the saddle the residual is zero, but the tangent is indefinite: not a minimum."""
    minimum = minimise(DoubleWell(), np.zeros(2), make_solver(), NewtonOptions(max_iterations=5))
    assert not minimum.converged
    assert np.all(minimum.unknowns == 0)


def test_reports_the_limit_of_iterations_with_history():
    minimum = minimise(
        DoubleWell(), np.array([5.0, -3.0]), make_solver(), NewtonOptions(max_iterations=2)
    )
    assert not minimum.converged
    assert minimum.reason == "no convergence in 2 iterations"
    assert len(minimum.history) == 2


def test_reports_an_indefinite_tangent_without_shifts():
    minimum = minimise(DoubleWell(False), np.array([0.01, 0.0]), make_solver(), NewtonOptions())
    assert "indefinite" in minimum.reason


@pytest.mark.parametrize(("key", "value"), [("tolerance", 0.0), ("max_iterations", 0)])
def test_refuses_options_without_sense(key, value):
    with pytest.raises(ValueError, match=key):
        NewtonOptions(**{key: value})


class Misleading(DoubleWell):
    """The double well with a residual alone that is far off, as rounding makes it in thin sheets.

    BFGS steps are made of it.
    """

    def residual(self, u):
        return super().residual(u) + np.array([3.0, -5.0])


def test_takes_no_step_with_an_old_tangent_away_from_the_minimum():
    options = NewtonOptions(tolerance=1e-24)
    minimum = minimise(Misleading(), np.array([1.001, 1.0]), make_solver(), options)
    assert minimum.converged
    assert np.allclose(minimum.unknowns, 1.0, atol=1e-9)
    assert all(row.fresh for row in minimum.history)


class Overflowing(DoubleWell):
    """The double well with a residual that overflows beyond x = 2."""

    def derivatives(self, u):
        exact = super().derivatives(u)
        if u[0] > 2.0:
            return exact._replace(residual=np.array([np.inf, 0.0]))
        return exact


def test_says_that_linear_equations_cannot_be_solved():
    minimum = minimise(Overflowing(), np.array([5.0, -3.0]), make_solver(), NewtonOptions())
    assert minimum.reason == "linear equations have numbers that are not finite"
    assert np.all(minimum.unknowns == (5.0, -3.0))
