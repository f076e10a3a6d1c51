"""Maps of the explorer: what is computed stays as it is, what is not known stays a hole."""

import numpy as np
import pytest

from wrinklestudy.explorer.content import map_of_curves, map_of_points

CURVES = {
    1.0: [(0.1, 0.5e-3), (0.3, 0.4e-3), (0.5, 0.3e-3)],
    2.0: [(0.1, 1.5e-3), (0.2, 1.4e-3)],
    4.0: [(0.1, 1.0e-3), (0.3, 0.8e-3), (0.5, 0.5e-3)],
}


def test_of_both_parities_the_thicker_counts_and_none_is_a_hole():
    points = [(2.0, 0.1, 1e-3), (2.0, 0.1, 2e-3), (3.0, 0.1, None), (3.0, 0.1, 5e-4)]
    shown = map_of_points("latex", [*points, (2.0, 0.2, None), (3.0, 0.2, 0.0)])
    assert list(shown.aspects) == [2.0, 3.0]
    assert list(shown.strains) == [0.1, 0.2]
    np.testing.assert_array_equal(shown.values, [[2e-3, np.nan], [5e-4, 0.0]])


def test_a_map_of_curves_goes_through_what_was_computed():
    shown = map_of_curves("latex", CURVES, 0.6)
    for strain, aspect in shown.computed:
        row = shown.values[list(shown.aspects).index(aspect)]
        known = dict(CURVES[aspect])[strain]
        assert row[np.argmin(np.abs(shown.strains - strain))] == pytest.approx(known, rel=1e-12)
    assert len(shown.computed) == sum(map(len, CURVES.values()))


def test_nothing_wrinkles_without_strain_and_tau_grows_like_its_root_there():
    shown = map_of_curves("latex", CURVES, 0.6)
    np.testing.assert_array_equal(shown.values[:, 0], 0.0)
    low = shown.values[:, 1:3]
    assert (low[:, 1] / low[:, 0] < 1.6).all()  # 2 if it were a straight line


def test_beyond_its_curve_a_length_follows_its_neighbours_and_the_ends_are_holes():
    shown = map_of_curves("latex", CURVES, 0.6)
    beyond = shown.strains > 0.5 + 1e-9
    assert np.isnan(shown.values[:, beyond]).all()
    between = shown.values[1, ~beyond]
    assert np.isfinite(between).all()
    near_the_end = shown.strains[~beyond] > 0.15
    assert np.abs(np.diff(between[near_the_end])).max() < 3e-5  # its own curve ends without a step
    continued = (shown.strains > 0.2 + 1e-9) & ~beyond
    low, middle, high = shown.values[:, continued]
    ratio = middle / ((2.0 * low + high) / 3.0)
    np.testing.assert_allclose(ratio, ratio[0], rtol=1e-12)


def test_a_map_ends_where_it_is_told_to():
    shown = map_of_curves("latex", CURVES, 0.25)
    assert shown.strains[-1] == 0.25
    assert max(strain for strain, _ in shown.computed) == 0.2


def test_no_curve_is_no_map():
    assert map_of_curves("latex", {}, 0.3) is None
