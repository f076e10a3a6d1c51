"""The tangent with predicted stresses: the same equilibria, in fewer iterations."""

import numpy as np
import pytest

from wrinklestudy.equilibrium import newton, planar
from wrinklestudy.equilibrium.problem import PlateProblem, Predicting
from wrinklestudy.equilibrium.seeds import seed_position, seeds
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import mooney_rivlin

THICKNESS = 4.0e-4


@pytest.fixture(scope="module")
def flat_state():
    space = Space(make_grid(2.0, THICKNESS, MeshSettings(8, 18)))
    return planar.solve(space, mooney_rivlin(6.21e4, 1.58e5), 0.1)


@pytest.fixture(scope="module")
def exact(flat_state):
    return PlateProblem.of_flat(flat_state.flat, flat_state.modes, THICKNESS)


@pytest.fixture(scope="module")
def minima(flat_state, exact):
    """Of a sheet so thin that its flat state has many unstable modes."""
    amplitudes = seeds(flat_state.modes, THICKNESS)[0]
    start = seed_position(flat_state.flat, flat_state.modes, amplitudes)[exact.assembler.free]
    shift, ceiling = 0.25 * flat_state.modes.squared[0], THICKNESS * flat_state.flat.energy
    plain = newton.NewtonOptions(1e-22, 300, shift)
    rising = newton.NewtonOptions(1e-22, 300, shift, rise=10.0, ceiling=ceiling)
    solver = exact.assembler.solver
    return (
        newton.minimise(exact, start, solver, plain),
        newton.minimise(Predicting(exact), start, solver, rising),
    )


def test_the_minimum_is_that_of_the_exact_tangent(minima, flat_state):
    assert [minimum.reason for minimum in minima] == ["", ""]
    saved = THICKNESS * flat_state.flat.energy - minima[0].energy
    assert abs(minima[1].energy - minima[0].energy) < 1e-8 * saved


def test_thin_sheets_need_fewer_iterations(minima):
    plain, predicting = (newton.count(minimum.history) for minimum in minima)
    assert predicting < 0.8 * plain


def test_the_tangents_agree_where_the_last_step_was_small(minima, exact):
    """The prediction is off by the square of the step."""
    point, rng = minima[1].unknowns, np.random.default_rng(0)
    direction = rng.standard_normal(point.size)
    reference = exact.derivatives(point).tangent
    errors = []
    for size in (2e-6, 1e-6):
        problem = Predicting(exact)
        problem.derivatives(point - size * direction)
        tangent = problem.derivatives(point).tangent
        errors.append(np.linalg.norm((tangent - reference).data) / np.linalg.norm(reference.data))
    assert errors[1] < 1e-3
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)


def test_the_first_tangent_is_the_exact_one(minima, exact):
    point = minima[0].unknowns
    found, expected = (problem.derivatives(point) for problem in (Predicting(exact), exact))
    assert found.energy == expected.energy
    assert np.array_equal(found.residual, expected.residual)
    assert np.array_equal(found.tangent.data, expected.tangent.data)


def test_a_step_may_rise_but_not_above_the_ceiling(minima, flat_state):
    energies = [row.energy for row in minima[1].history]
    assert max(energies[1:]) < THICKNESS * flat_state.flat.energy
    assert max(np.diff(energies)) > 0
    plain = np.diff([row.energy for row in minima[0].history])
    assert max(plain) <= 1e-12 * energies[0]
