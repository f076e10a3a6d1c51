"""Maps of tau_1: against stability, between parities, laws and meshes, and its quartic part."""

import numpy as np
import pytest

from wrinklestudy.equilibrium import flat, modes, planar, quartic, stability, wrinkled
from wrinklestudy.equilibrium.critical_map import critical_states, map_grid
from wrinklestudy.equilibrium.critical_shape import mode_shape
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import mooney_rivlin, neo_hookean, saint_venant_kirchhoff
from wrinklestudy.sheet import Sheet

LATEX = mooney_rivlin(6.21e4, 1.58e5)
COARSE = MeshSettings(10, 20)
STRAINS = (0.02, 0.1, 0.3, 0.6)


@pytest.fixture(scope="module")
def states():
    """The states of the paper's rubber at L/W = 2, both parities."""
    return critical_states(map_grid(2.0, COARSE), LATEX.law, STRAINS)


def test_a_state_that_is_continued_has_the_tau_1_of_one_that_is_not(states):
    """Where the last flat state and mode came from must not show in the next."""
    space = Space(map_grid(2.0, COARSE))
    assert [(state.strain, state.parity) for state in states] == [
        (strain, parity) for strain in STRAINS for parity in ("antisymmetric", "symmetric")
    ]
    for state in states:
        alone = flat.solve(space, LATEX.law, state.strain)
        symmetry = Symmetry.mirrored(state.parity)
        assert state.status == "unstable"
        assert state.critical_thickness == pytest.approx(
            modes.critical_thickness(alone, "thinning", symmetry), rel=1e-8
        )


def test_the_map_has_the_tau_1_of_stability_on_its_own_mesh():
    """Half of the cells along cost less than the mesh across does."""
    sheet = Sheet(2.0, 1e-3, LATEX)
    table = dict(sheet.stability().critical_thickness)
    strains = sorted(table)[4:12:2]
    found = critical_states(map_grid(2.0), LATEX.law, strains, parities=["antisymmetric"])
    for state in found:
        assert state.critical_thickness == pytest.approx(table[state.strain], rel=1e-3)


def test_one_flat_state_serves_all_bending_laws():
    laws = ("thinning", "fvk")
    grid = map_grid(2.0, COARSE)
    both = critical_states(grid, LATEX.law, [0.1, 0.3], laws, ["symmetric"])
    for k, bending in enumerate(laws):
        alone = critical_states(grid, LATEX.law, [0.1, 0.3], [bending], ["symmetric"])
        assert [s.critical_thickness for s in both[k::2]] == pytest.approx(
            [s.critical_thickness for s in alone], rel=1e-9
        )


def test_the_pattern_slides_freely_where_many_waves_end_before_the_edges(states):
    """Both parities then have one tau_1, up to what the edges see of the mode.

    The mode of more waves is the narrower one: the difference falls with the strain.
    """
    odd, even = states[::2], states[1::2]
    apart = [
        abs(a.critical_thickness / b.critical_thickness - 1.0)
        for a, b in zip(odd, even, strict=True)
    ]
    assert apart[0] < 1e-4
    assert apart[-1] < 1e-9
    assert all(abs(a.half_waves - b.half_waves) == 1 for a, b in zip(odd, even, strict=True))
    assert all(
        a.half_waves % 2 == 0 and b.half_waves % 2 == 1 for a, b in zip(odd, even, strict=True)
    )


def test_mooney_rivlin_without_its_second_constant_is_neo_hookean():
    grid = map_grid(2.0, COARSE)
    mr, nh = (
        critical_states(grid, material.law, STRAINS)
        for material in (mooney_rivlin(1e5, 0.0), neo_hookean(1e5))
    )
    for a, b in zip(mr, nh, strict=True):
        assert a.critical_thickness == pytest.approx(b.critical_thickness, rel=1e-7)
        assert a.quartic == pytest.approx(b.quartic, rel=1e-5)
        assert (a.half_waves, a.largest_at) == (b.half_waves, b.largest_at)


def test_a_sheet_that_does_not_contract_is_stable_at_any_thickness():
    law = saint_venant_kirchhoff(1e6, 0.0).law
    for state in critical_states(map_grid(2.0, COARSE), law, [0.1, 0.2]):
        assert (state.status, state.critical_thickness) == ("stable", 0.0)
        assert (state.quartic, state.half_waves, state.largest_at) == (None, None, None)


def test_a_flat_state_that_fails_is_a_hole_with_a_reason_and_not_the_end(monkeypatch):
    from wrinklestudy.equilibrium import critical_map

    def solve(space, law, strain, start=None):
        if strain == 0.1:
            raise flat.NotConvergedError("flat state at strain 0.1: made up")
        return flat.solve(space, law, strain, start=start)

    monkeypatch.setattr(critical_map, "solve_flat", solve)
    found = critical_states(map_grid(2.0, COARSE), LATEX.law, STRAINS[:3])
    assert [state.status for state in found] == ["unstable"] * 2 + ["not-converged"] * 2 + [
        "unstable"
    ] * 2
    assert {s.reason for s in found if s.strain == 0.1} == {"flat state at strain 0.1: made up"}
    assert all(s.critical_thickness is None for s in found if s.strain == 0.1)


def test_long_sheets_wrinkle_in_two_zones_near_the_ends():
    """Where the clamps are far apart, the middle is in uniaxial tension, which does not buckle."""
    found = {
        aspect: critical_states(map_grid(aspect, COARSE), LATEX.law, [0.1])[0]
        for aspect in (2.0, 5.0)
    }
    assert found[2.0].largest_at == 0.0
    assert 0.25 < found[5.0].largest_at < 0.4


def test_waves_are_counted_across_the_whole_width():
    """sin(6 pi y) has three waves across the width of 1, cos(6 pi y) as many and both edges."""
    space = Space(make_grid(2.0, settings=MeshSettings(6, 40)))
    x, y = space.grid.x[:, None], space.grid.y[None, :]
    k = 6.0 * np.pi
    along, slope = np.exp(-((x - 0.6) ** 2)), -2.0 * (x - 0.6) * np.exp(-((x - 0.6) ** 2))
    for parity, wave, change, count in (
        ("antisymmetric", np.sin(k * y), k * np.cos(k * y), 6),
        ("symmetric", np.cos(k * y), -k * np.sin(k * y), 7),
    ):
        nodes = np.stack([along * wave, slope * wave, along * change, slope * change])
        seen = mode_shape(space, space.field_from_nodes(nodes), Symmetry.mirrored(parity))
        assert seen.half_waves == count
        assert seen.largest_at == pytest.approx(0.3, abs=0.01)
        assert seen.largest == pytest.approx(1.0, rel=1e-2)


def test_coefficients_of_single_modes_are_the_diagonal_of_the_quartic_form():
    state = flat.solve(make_grid(2.0, settings=MeshSettings(8, 16)), LATEX.law, 0.1)
    shapes = modes.spectrum(state, count=3).shapes
    whole, _ = quartic.quartic_form(state, shapes)
    squares = [quartic.pairs(3).index((i, i)) for i in range(3)]
    alone = quartic.quartic_coefficients(state, list(shapes))
    assert alone == pytest.approx(np.diag(whole)[squares], rel=1e-10)


@pytest.mark.parametrize("aspect", [2.0, 2.5])
@pytest.mark.parametrize("end", ["birth_strain", "decay_strain"])
def test_wrinkles_just_beyond_birth_and_decay_are_as_high_as_the_quartic_part_says(aspect, end):
    """A pitchfork: (A/t)^2 = ((tau_1/t)^2 - 1)/(2 g) to first order in (tau_1/t)^2 - 1.

    In the limit there remains what bending adds to the quartic part, of the order of (t k)^2: with
    wavelengths of 0.07 to 0.15 W some parts in a thousand to a hundredth.
    """
    thickness = 1e-3
    space = Space(map_grid(aspect, MeshSettings(12, 24)))
    settings = planar.PlanarSettings()
    root = getattr(stability.of_sheet(space, LATEX, settings, thickness), end)
    inside = 1.0 if end == "birth_strain" else -1.0
    off = []
    for distance in (0.02, 0.01):
        strain = root * (1.0 + inside * distance)
        (mode,) = critical_states(space, LATEX.law, [strain], parities=["antisymmetric"])
        excess = (mode.critical_thickness / thickness) ** 2 - 1.0
        assert excess > 0.0
        assert mode.quartic > 0.0
        found = wrinkled.solve(planar.solve(space, LATEX, strain, settings), thickness)
        assert found.status == "wrinkled"
        height = mode_shape(space, found.position[2], settings.symmetry).largest / thickness
        off.append(height**2 / (excess / (2.0 * mode.quartic)) - 1.0)
    assert abs(2.0 * off[1] - off[0]) < 0.015
    assert abs(off[1] - off[0]) < 0.003
