"""The centre of the flat sheet: compressed or not, against the laws and against tension fields."""

import numpy as np
import pytest

from wrinklestudy.equilibrium import tension_field
from wrinklestudy.equilibrium.compression import central_excess, central_states
from wrinklestudy.equilibrium.critical_map import map_grid
from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import mooney_rivlin, saint_venant_kirchhoff
from wrinklestudy.metrics.confinement import confinement

COARSE = MeshSettings(cells_across=12, cells_along=8)
NEO_HOOKEAN, PAPER = mooney_rivlin(1.0, 0.0).law, mooney_rivlin(1.0, 2.544).law


def uniform(law, along, across):
    """Return a sheet that is stretched alike everywhere, in equilibrium or not."""
    space = Space(make_grid(2.0, settings=COARSE))
    values = np.zeros((2, 4, len(space.grid.x), len(space.grid.y)))
    values[0, 0], values[0, 1] = along * space.grid.x[:, None], along
    values[1, 0], values[1, 2] = across * space.grid.y[None, :], across
    position = space.field_from_nodes(values)
    return Flat(space, law, along - 1.0, position, np.nan, np.nan, ())


@pytest.mark.parametrize("stretch", [1.1, 2.0, 4.0])
def test_an_incompressible_strip_in_simple_tension_is_neither_compressed_nor_taut(stretch):
    for law in (NEO_HOOKEAN, PAPER):
        assert central_excess(uniform(law, stretch, stretch**-0.5)) == pytest.approx(0.0, abs=1e-12)
        narrower = central_excess(uniform(law, stretch, 0.9 * stretch**-0.5))
        assert narrower == pytest.approx(1.0 / 0.9 - 1.0, rel=1e-12)


def test_the_natural_width_of_another_law_is_its_own():
    law = saint_venant_kirchhoff(1.0, 0.3).law
    width = (1.0 - 0.3 * (1.2**2 - 1.0)) ** 0.5  # E22 = -nu E11
    assert central_excess(uniform(law, 1.2, width)) == pytest.approx(0.0, abs=1e-12)


def test_compression_ends_on_a_neo_hookean_sheet_and_lasts_with_the_paper_s_ratio():
    strains = [0.2, 0.5, 0.75, 1.0, 2.0, 3.0]
    grid = map_grid(2.0, COARSE)
    ends = [state.excess > 0.0 for state in central_states(grid, NEO_HOOKEAN, strains)]
    assert ends == [True, True, False, False, False, False]
    assert all(state.excess > 0.0 for state in central_states(grid, PAPER, strains))


def test_half_the_cells_tell_the_error_of_the_mesh():
    strains = [0.3]
    coarse, fine = (
        central_states(map_grid(2.0, MeshSettings(n, m)), PAPER, strains)[0]
        for n, m in ((12, 8), (48, 32))
    )
    off = abs(coarse.excess - fine.excess)
    assert 0.0 < abs(fine.excess - fine.coarse_excess) < off
    assert off < abs(coarse.excess - coarse.coarse_excess)


def test_a_strain_without_a_flat_state_says_why_and_the_others_go_on(monkeypatch):
    def fail(*_):
        raise ArithmeticError("no flat state")

    monkeypatch.setattr("wrinklestudy.equilibrium.compression.FlatPath.solve", fail)
    (state,) = central_states(map_grid(2.0, COARSE), PAPER, [0.1])
    assert (state.excess, state.coarse_excess, state.reason) == (None, None, "no flat state")


@pytest.mark.parametrize(("strain", "wrinkled"), [(0.5, True), (0.75, False)])
def test_the_tension_field_is_wrinkled_at_the_centre_where_the_flat_state_is_compressed(
    strain, wrinkled
):
    """On both sides of the end for a neo-Hookean sheet, at strain 0.634."""
    field = tension_field.solve(tension_field.tension_grid(2.0, COARSE), NEO_HOOKEAN, strain)
    assert field.converged
    assert (confinement(field).phi_squared_central > 0.0) == wrinkled
