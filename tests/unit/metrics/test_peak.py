"""The maximum between samples is that of the parabola through the highest three."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.metrics.peak import peak


@given(
    st.lists(st.integers(-40, 40), min_size=4, max_size=12, unique=True),
    st.floats(-1.9, 1.9),
    st.floats(0.1, 50.0),
)
def test_a_parabola_is_found_exactly_whatever_the_samples(samples, top, curvature):
    strain = 0.1 * np.array([*samples, -100, 100])  # the ends are the lowest
    value = 7.0 + curvature * (36.0 - (strain - top) ** 2)
    where, highest = peak(strain, value)
    assert where == pytest.approx(top, abs=1e-9)
    assert highest == pytest.approx(7.0 + 36.0 * curvature, rel=1e-12)


def test_the_peak_of_an_asymmetric_curve_is_known_to_a_part_of_the_spacing():
    """eps exp(-eps/0.12), whose maximum 0.12/e is at 0.12, where there is no sample."""
    errors = []
    for spacing in (0.04, 0.02):
        strain = np.arange(0.01, 0.5, spacing)
        where, highest = peak(strain, strain * np.exp(-strain / 0.12))
        assert abs(where - 0.12) < 0.15 * spacing
        errors.append(abs(highest - 0.12 / math.e))
    # the error of a parabola in the height is of third order, at samples of other places
    assert errors[1] < 0.3 * errors[0]
    assert errors[1] < 1e-3 * 0.12 / math.e


@pytest.mark.parametrize(("hole", "known"), [(0, True), (1, False), (3, False), (4, True)])
def test_beside_a_hole_the_peak_is_unknown(hole, known):
    """The state that did not converge may be the highest."""
    strain = np.array([0.0, 0.1, 0.2, 0.3, 0.4])
    value = 9.0 - 100.0 * (strain - 0.22) ** 2
    value[hole] = np.nan
    expected = (0.22, 9.0) if known else (math.nan, math.nan)
    assert peak(strain, value) == pytest.approx(expected, nan_ok=True)
    assert peak(strain[::-1], value[::-1]) == pytest.approx(expected, nan_ok=True)


def test_the_largest_sample_at_an_end_is_taken_as_it_is():
    assert peak([0.1, 0.2, 0.3], [1.0, 2.0, 2.5]) == (0.3, 2.5)
    assert peak([0.1, 0.2, 0.3], [3.0, 2.0, 2.5]) == (0.1, 3.0)
    assert peak([0.1], [3.0]) == (0.1, 3.0)


def test_a_sheet_that_never_wrinkles_has_height_zero_and_no_strain():
    where, highest = peak([0.1, 0.2, 0.3], [0.0, 0.0, 0.0])
    assert math.isnan(where)
    assert highest == 0.0
    assert all(map(math.isnan, peak([0.1, 0.2, 0.3], [0.0, np.nan, 0.0])))


def test_without_any_sample_nothing_is_known():
    assert all(map(math.isnan, peak([0.1, 0.2], [np.nan, np.nan])))
    assert all(map(math.isnan, peak([], [])))


def test_samples_that_make_no_curve_are_refused():
    with pytest.raises(ValueError, match=r"strain \(2,\) and value \(3,\): must be two columns"):
        peak([0.1, 0.2], [1.0, 2.0, 1.0])
    with pytest.raises(ValueError, match="strain: must hold every strain once"):
        peak([0.1, 0.1, 0.2], [1.0, 2.0, 1.0])
