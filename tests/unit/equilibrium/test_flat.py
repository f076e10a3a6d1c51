"""The flat state: equilibrium, work of the clamps, load path and failure."""

from dataclasses import replace

import numpy as np
import pytest

from wrinklestudy.equilibrium import flat
from wrinklestudy.equilibrium.newton import NewtonOptions
from wrinklestudy.fem.boundary import NO_MIRRORS, QUARTER
from wrinklestudy.fem.grid import Grid, MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import mooney_rivlin, neo_hookean, ogden, saint_venant_kirchhoff

LATEX = mooney_rivlin(6.21e4, 1.58e5).law


@pytest.fixture(scope="module")
def space():
    return Space(make_grid(2.0, settings=MeshSettings(8, 6)))


@pytest.mark.parametrize(
    "law", [LATEX, neo_hookean(1.0).law, saint_venant_kirchhoff().law], ids=["mr", "nh", "svk"]
)
def test_the_work_of_the_clamps_is_the_energy(space, law):
    """dE/deps of the quarter is force x L/2 x 1/2, so the nominal stress is (4/L) dE/deps."""
    strain, step = 0.2, 1e-3
    energies = [flat.solve(space, law, strain + k * step).energy for k in (-2, -1, 1, 2)]
    slope = (energies[0] - 8 * energies[1] + 8 * energies[2] - energies[3]) / (12 * step)
    found = flat.solve(space, law, strain).force
    assert found == pytest.approx(4 / space.grid.aspect * slope, rel=1e-8)


def test_force_lies_between_uniaxial_and_pure_shear(space):
    """A clamped sheet is stiffer than a free strip and softer than one that keeps its width."""
    stretch = 1.2
    c10, c01 = LATEX.c10, LATEX.c01
    uniaxial = 2 * (stretch - stretch**-2) * (c10 + c01 / stretch)
    shear = 2 * (c10 + c01) * (stretch - stretch**-3)
    assert uniaxial < flat.solve(space, LATEX, 0.2).force < shear


@pytest.mark.parametrize("strain", [0.001, 0.5, 1.0])
def test_converges_at_small_and_large_strains(space, strain):
    found = flat.solve(space, LATEX, strain)
    assert found.history[-1].decrement <= 1e-20 * found.energy


def test_small_strains_are_linear_down_to_rounding():
    """The stress over the strain changes by a part of the order of the strain, on a fine mesh too.

    The corner cells are so small that rounding keeps the decrement above the tolerance.
    """
    space = Space(make_grid(2.0, settings=MeshSettings(24, 24, 3.0)))
    strains = np.array([1e-6, 1e-5, 1e-4, 1e-3])
    stiffness = [flat.solve(space, LATEX, strain).force / strain for strain in strains]
    bent = np.abs(np.diff(stiffness)) / stiffness[0]
    assert np.all(bent < 3 * strains[1:])
    assert bent[2] == pytest.approx(10 * bent[1], rel=0.05)


def test_a_long_sheet_of_ogden_converges_at_a_small_strain():
    """Treloar's rubber, whose moduli over exponents are nine times the shear modulus."""
    law = ogden(4939.63, 4.45149, -1.67034e6, -0.464803).law
    grid = make_grid(8.0, settings=MeshSettings(9, 28))
    assert len(flat.solve(grid, law, 6.23571e-4).history) <= 6


def test_a_load_that_fails_at_once_is_approached_in_steps(space, monkeypatch):
    """The state does not depend on how the load is applied."""
    direct = flat.solve(space, LATEX, 1.0)
    calls = []

    def reluctant(problem, start, solver, options):
        end = problem.prescribed[0].max() / (0.5 * space.grid.aspect) - 1.0
        calls.append(end)
        few = len(calls) in (1, 3)  # the whole, and the second half
        return minimise(problem, start, solver, replace(options, max_iterations=1 if few else 60))

    minimise = flat.newton.minimise
    monkeypatch.setattr(flat.newton, "minimise", reluctant)
    stepped = flat.solve(space, LATEX, 1.0)
    assert calls == pytest.approx([1.0, 0.5, 1.0, 0.75, 1.0])
    assert stepped.force == pytest.approx(direct.force, rel=1e-12)
    assert np.abs(stepped.position - direct.position).max() < 1e-9


def test_failure_says_why(space):
    with pytest.raises(flat.NotConvergedError, match=r"flat state at strain 0\.04: no convergence"):
        flat.solve(space, LATEX, 0.04, NewtonOptions(max_iterations=1))


def test_width_contracts_most_in_the_middle(space):
    width = space.nodes_from_field(flat.solve(space, LATEX, 0.3).position)[1, 0, :, -1]
    assert np.all(np.diff(width) > 0)
    assert width[-1] == pytest.approx(0.5)
    assert width[0] == pytest.approx(0.5 * 1.3**-0.5, rel=0.02)


def test_the_sheet_without_mirrors_is_the_quarter_unfolded(space):
    """Four times the energy, the same force and the same position, from both clamped ends."""
    quarter = flat.solve(space, LATEX, 0.2)
    y, nodes = QUARTER.unfold_across(space.grid.y, space.nodes_from_field(quarter.sheet_position))
    x, nodes = QUARTER.unfold_along(space.grid.x, nodes)
    whole = flat.solve(Grid(x, y), LATEX, 0.2, symmetry=NO_MIRRORS)
    assert whole.energy == pytest.approx(4 * quarter.energy, rel=1e-12)
    assert whole.force == pytest.approx(quarter.force, rel=1e-9)
    position = whole.space.nodes_from_field(whole.sheet_position)
    assert np.abs(position - nodes)[:, 0].max() < 1e-9
