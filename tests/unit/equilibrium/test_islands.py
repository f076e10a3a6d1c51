"""Tips of islands: against made-up ridges with known roots, and against a published boundary."""

import math

import numpy as np
import pytest

from wrinklestudy.equilibrium.critical_map import critical_states, map_grid
from wrinklestudy.equilibrium.islands import (
    Ridge,
    RidgeOfLaw,
    Tip,
    corrected,
    interpolated,
    islands,
    ridge_of_table,
)
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.mechanics.laws import mooney_rivlin

ASPECTS = np.arange(1.0, 5.01, 0.4)


def hump(aspect, expected=0.0):
    """A ridge with maximum 1e-3 at L/W = 2.5 and roots of t at 2.5 -+ sqrt(1 - t/1e-3)."""
    del expected
    return Ridge(max(1e-3 * (1.0 - (aspect - 2.5) ** 2), 0.0), 0.1 * aspect)


@pytest.mark.parametrize("thickness", [1e-4, 5e-4])
def test_tips_are_the_roots_of_the_ridge(thickness):
    (island,) = islands({a: hump(a) for a in ASPECTS}, hump, thickness)
    off = math.sqrt(1.0 - thickness / 1e-3)
    assert island.first.aspect == pytest.approx(2.5 - off, rel=2e-3)
    assert island.last.aspect == pytest.approx(2.5 + off, rel=2e-3)
    assert island.last.strain == pytest.approx(0.1 * island.last.aspect, rel=2e-3)


def test_holding_t_over_l_asks_longer_sheets_for_larger_tau_1():
    """The roots of tau = (t/L) L/W are those of 1 - (a - 2.5)^2 = 0.2 a."""
    (island,) = islands({a: hump(a) for a in ASPECTS}, hump, 2e-4, "t/L")
    roots = np.sort(np.roots([1.0, -4.8, 5.25]))
    assert [island.first.aspect, island.last.aspect] == pytest.approx(roots, rel=2e-3)


def test_an_island_that_leaves_the_map_has_no_tip_there_and_a_thick_sheet_has_no_island():
    ridges = {a: hump(a) for a in ASPECTS if a > 2.0}
    (island,) = islands(ridges, hump, 5e-4)
    assert island.first is None
    assert island.last is not None
    assert islands(ridges, hump, 2e-3) == []


def test_a_ridge_between_strains_is_that_of_the_parabola_of_the_square():
    strains = np.array([0.05, 0.1, 0.2, 0.4])
    squared = 1e-6 * (2.0 - (strains - 0.13) ** 2)
    found = ridge_of_table(strains, np.sqrt(squared))
    assert found.strain == pytest.approx(0.13)
    assert found.thickness == pytest.approx(math.sqrt(2e-6))


def test_a_tip_is_corrected_with_the_slope_of_a_map_that_is_a_little_off():
    """The map is a tenth too high; each step leaves the error of its slope times the step."""

    def too_high(aspect, expected):
        return Ridge(1.1 * hump(aspect).thickness, expected)

    root = 2.5 + math.sqrt(0.5)
    guess = Tip(2.5 + math.sqrt(1.0 - 0.5 / 1.1), 0.3)
    found = corrected(guess, hump, too_high, 5e-4)
    assert found.tip.aspect == pytest.approx(root, rel=1e-3)
    assert abs(guess.aspect / root - 1.0) > 5e-3
    assert abs(found.change) < 5e-3
    with pytest.raises(ArithmeticError, match="no tip is found"):
        corrected(guess, hump, too_high, 1e-2)


def test_the_island_of_the_10_to_1_sheet_is_the_published_one():
    """At t/L = 5e-4 and with FvK bending a published boundary ends at L/W = 2.6.

    Where only interpolation between L/W = 1.4, 1.7, 2.4, 2.7 is asked, it is nearly there.
    """
    law, settings = mooney_rivlin(1e6, 1e5).law, PlanarSettings("fvk")
    ridges = {}
    for aspect in (1.2, 1.4, 1.6, 1.8, 2.4, 2.6, 2.8):
        states = critical_states(
            map_grid(aspect), law, [0.03, 0.06, 0.1, 0.15, 0.2], ["fvk"], ["antisymmetric"]
        )
        strains, thicknesses = zip(
            *((state.strain, state.critical_thickness) for state in states), strict=True
        )
        ridges[aspect] = ridge_of_table(strains, thicknesses)
    (island,) = islands(ridges, RidgeOfLaw(law, settings), 5e-4, "t/L")
    assert island.first.aspect == pytest.approx(1.545, rel=5e-3)
    assert island.last.aspect == pytest.approx(2.592, rel=5e-3)
    (rough,) = islands(ridges, interpolated(ridges), 5e-4, "t/L")
    assert rough.first.aspect == pytest.approx(island.first.aspect, rel=5e-3)
    assert rough.last.aspect == pytest.approx(island.last.aspect, rel=5e-3)
