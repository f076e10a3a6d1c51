"""Tension fields: known values, work of the clamps, mirrors, scales, failure."""

from dataclasses import replace

import numpy as np
import pytest

from wrinklestudy.equilibrium import flat, newton, tension_field
from wrinklestudy.equilibrium.tension_field import RelaxedProblem, solve, tension_grid
from wrinklestudy.fem.boundary import NO_MIRRORS, QUARTER
from wrinklestudy.fem.grid import Grid, MeshSettings, make_grid
from wrinklestudy.mechanics.laws import (
    mooney_rivlin,
    neo_hookean,
    ogden,
    saint_venant_kirchhoff,
    yeoh,
)
from wrinklestudy.mechanics.relaxed import RelaxedLaw
from wrinklestudy.metrics.confinement import confinement, sample

LATEX = mooney_rivlin(6.21e4, 1.58e5).law
LAWS = {
    "mooney-rivlin": LATEX,
    "neo-hookean": neo_hookean(1.8e5).law,
    "svk": saint_venant_kirchhoff(1.3e6, 0.5).law,
    "yeoh": yeoh(2.0e5, -4.0e3, 5.0e2).law,
    "ogden": ogden(6.3e5, 1.3, -1.0e4, -2.0).law,
}
GRID = make_grid(2.0, settings=MeshSettings(8, 14))
STRAIN = 0.12


@pytest.fixture(scope="module")
def coarse():
    return solve(GRID, LATEX, STRAIN)


@pytest.mark.parametrize(
    ("strain", "phi_squared"),
    [(0.02, 0.001800), (0.06, 0.003392), (0.12, 0.004342), (0.20, 0.004539), (0.30, 0.004171)],
)
def test_the_paper_s_sheet_hides_what_quadratic_elements_found(strain, phi_squared):
    """Phi^2 of an independent discretisation, triangles with a tangent in invariants."""
    field = solve(tension_grid(2.0, MeshSettings()), LATEX, strain)
    assert (field.reason, field.remainder) == ("", 0.0)
    assert confinement(field).phi_squared == pytest.approx(phi_squared, rel=0.003)


@pytest.mark.parametrize("strain", [0.02, 0.12, 0.3])
@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_each_law_gets_to_its_own_relaxed_energy_below_that_of_the_flat_state(law, strain):
    field = solve(GRID, law, strain)
    assert (field.reason, field.remainder) == ("", 0.0)
    assert field.energy < flat.solve(field.space, law, strain).energy
    problem = RelaxedProblem(field.space, RelaxedLaw(law), field.position, field.position)
    unknowns = field.position[problem.assembler.free]
    assert problem.energy(unknowns) == pytest.approx(field.energy, rel=1e-14)
    rng = np.random.default_rng(0)
    for size in (1e-6, 1e-5, 1e-4):
        nearby = unknowns + size * rng.standard_normal(unknowns.shape)
        assert problem.energy(nearby) > field.energy


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_the_work_of_the_clamps_is_the_energy(law):
    """The regions move with the strain, but the energy is smooth: force = (4/L) dE/deps."""
    step = 1e-3
    energies = [solve(GRID, law, STRAIN + k * step).energy for k in (-2, -1, 1, 2)]
    slope = (energies[0] - 8 * energies[1] + 8 * energies[2] - energies[3]) / (12 * step)
    assert solve(GRID, law, STRAIN).force == pytest.approx(4 / GRID.aspect * slope, rel=1e-6)


def test_a_quarter_is_a_quarter_of_the_whole(coarse):
    """The wrinkled region is not told of the mirrors; the whole sheet finds the same."""
    nodes = np.concatenate([coarse.nodes, np.zeros((1, *coarse.nodes.shape[1:]))])
    y, nodes = QUARTER.unfold_across(GRID.y, nodes)
    x, nodes = QUARTER.unfold_along(GRID.x, nodes)
    whole = solve(Grid(x, y), LATEX, STRAIN, NO_MIRRORS)
    assert whole.energy == pytest.approx(4 * coarse.energy, rel=1e-10)
    assert whole.force == pytest.approx(coarse.force, rel=1e-7)
    assert np.abs(whole.nodes - nodes[:2])[:, 0].max() < 1e-6


def test_fibres_are_straight_and_hold_a_constant_pull_where_the_sheet_is_wrinkled(coarse):
    """Along the mid-line a fibre lies: its tension changes by the little that others spread."""
    points = sample(coarse, np.linspace(0.02, 0.3, 8), np.zeros(1))
    assert points.wrinkled.all()
    np.testing.assert_allclose(points.direction, 0.0, atol=1e-12)
    assert np.ptp(points.tension) < 0.02 * points.tension.mean()


def test_regions_lie_where_the_paper_s_sheets_wrinkle(coarse):
    """In the middle away from the clamps and from the free edges; nothing is slack."""
    x, y = np.array([0.02, 0.3, 0.9]), np.array([0.02, 0.1, 0.45])
    points = sample(coarse, x, y)
    assert points.wrinkled[:2, :2].all()
    assert not points.wrinkled[2].any()
    assert not sample(coarse, np.linspace(0, 1, 41), np.linspace(0, 0.5, 41)).slack.any()


def test_a_short_sheet_is_taut_and_a_long_one_wrinkled_up_to_its_clamps():
    """To be narrower than natural costs nothing: what the clamps need is passed on along fibres.

    So wrinkles of a long sheet end at a distance from the clamps that does not depend on its
    length, and hide a width that does not either.
    """
    short, long, longer = (
        confinement(solve(make_grid(aspect, settings=MeshSettings(8, 14)), LATEX, STRAIN))
        for aspect in (1.0, 6.0, 10.0)
    )
    assert short.phi_squared == short.wrinkled_length_over_length == 0.0
    margins = [
        aspect * (1.0 - found.wrinkled_length_over_length)
        for aspect, found in ((6.0, long), (10.0, longer))
    ]
    assert margins[1] == pytest.approx(margins[0], rel=0.02)
    assert 0.8 < margins[0] < 1.2
    assert longer.phi_squared == pytest.approx(long.phi_squared, rel=0.01)


def test_finer_meshes_agree_within_the_error_that_is_told(coarse):
    fine = confinement(solve(make_grid(2.0, settings=MeshSettings(24, 28)), LATEX, STRAIN))
    told = abs(confinement(coarse).phi_squared - confinement(coarse.coarser).phi_squared)
    assert abs(confinement(coarse).phi_squared - fine.phi_squared) < told
    assert coarse.coarser.space.grid.cells == (4, 7)


def test_what_fails_says_why_and_raises_nothing(monkeypatch):
    few = replace(tension_field._OPTIONS, max_iterations=1)
    monkeypatch.setattr(tension_field, "_OPTIONS", few)
    field = solve(GRID, LATEX, STRAIN)
    assert not field.converged
    assert field.reason.startswith("tension field at strain 0.12: ")
    assert isinstance(field.history[0], newton.Iteration)


def test_a_flat_state_that_fails_is_named_in_the_reason(monkeypatch):
    def fail(*_, **__):
        raise flat.NotConvergedError("flat state at strain 0.12: made up")

    monkeypatch.setattr(flat, "solve", fail)
    field = solve(GRID, LATEX, STRAIN)
    assert field.reason == "flat state at strain 0.12: made up"
    assert field.remainder == 1.0


def test_where_the_remainder_cannot_be_lowered_the_last_minimum_is_kept(monkeypatch):
    """A state with a remainder lies between the tension field and the flat state."""
    minimise = newton.minimise

    def reluctant(problem, start, solver, options):
        lowest = isinstance(problem, RelaxedProblem) and problem.law.remainder < 1e-3
        return minimise(
            problem, start, solver, replace(options, max_iterations=1) if lowest else options
        )

    exact = solve(GRID, LATEX, STRAIN)
    monkeypatch.setattr(newton, "minimise", reluctant)
    field = solve(GRID, LATEX, STRAIN)
    assert (field.reason, field.remainder) == ("", 1e-3)
    assert exact.energy < field.energy < flat.solve(exact.space, LATEX, STRAIN).energy
