"""Birth and decay from known curves tau_1(eps)."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.equilibrium.stability import find


def hill(strain):
    """tau_1 = 1.5e-3 x exp(1) (eps/0.1) exp(-eps/0.1): one maximum, 1.5e-3 at eps = 0.1."""
    return 1.5e-3 * math.e * (strain / 0.1) * math.exp(-strain / 0.1)


def exact(thickness, low, high):
    for _ in range(200):
        middle = 0.5 * (low + high)
        if (hill(middle) > thickness) == (hill(high) > thickness):
            high = middle
        else:
            low = middle
    return low


@given(st.floats(3e-4, 1.49e-3))
def test_roots_to_the_tolerance(thickness):
    found = find(hill, thickness)
    assert found.birth_strain == pytest.approx(exact(thickness, 0, 0.1), abs=5e-5)
    assert found.decay_strain == pytest.approx(exact(thickness, 0.1, 1.0), abs=5e-5)


@given(st.floats(1e-6, 3e-4))
def test_birth_of_a_thin_sheet_is_known_in_parts_of_itself(thickness):
    """A sheet of small strain is linear: tau_1 goes like the root of eps, birth like t^2."""
    found = find(lambda strain: 7e-3 * math.sqrt(strain) * math.exp(-strain / 0.2), thickness)
    assert found.birth_strain == pytest.approx((thickness / 7e-3) ** 2, rel=0.02)
    tau = 7e-3 * math.sqrt(found.birth_strain) * math.exp(-found.birth_strain / 0.2)
    assert tau == pytest.approx(thickness, rel=1e-3)


def test_a_root_that_cannot_be_computed_is_an_error():
    known = [(e, hill(e)) for e in (0.05, 0.1, 0.15, 0.2, 0.4)]
    with pytest.raises(ArithmeticError, match=r"tau_1 at strain 0\.0\d+, near birth"):
        find(lambda _: math.nan, 1e-3, known)


def test_a_thick_sheet_never_wrinkles():
    found = find(hill, 1.51e-3)
    assert found.birth_strain is None
    assert found.decay_strain is None


def test_a_narrow_range_between_known_strains_is_found():
    """All known strains are stable, but tau_1 rises above t between two of them."""
    known = [(e, hill(e)) for e in (0.02, 0.07, 0.14, 0.3)]
    thickness = 1.48e-3
    assert max(tau for _, tau in known) < thickness
    found = find(hill, thickness, known)
    assert found.birth_strain == pytest.approx(exact(thickness, 0, 0.1), abs=5e-5)
    assert found.decay_strain == pytest.approx(exact(thickness, 0.1, 1.0), abs=5e-5)


def test_the_search_goes_on_beyond_the_last_known_strain():
    calls = []

    def counted(strain):
        calls.append(strain)
        return hill(strain)

    known = [(e, hill(e)) for e in (0.02, 0.05, 0.1, 0.15)]
    found = find(counted, 5e-4, known)
    assert found.decay_strain == pytest.approx(exact(5e-4, 0.1, 1.0), abs=5e-5)
    assert len(calls) < 15


def test_wrinkles_that_never_vanish_have_no_decay():
    found = find(lambda strain: 2e-3 * (1 - math.exp(-strain / 0.05)), 1e-3)
    assert found.birth_strain == pytest.approx(0.05 * math.log(2), abs=5e-5)
    assert found.decay_strain is None
    assert found.largest_strain == pytest.approx(1.0)


def test_known_values_are_not_computed_again():
    known = [(k / 50, hill(k / 50)) for k in range(1, 26)]
    calls = []

    def counted(strain):
        calls.append(strain)
        return hill(strain)

    find(counted, 1e-3, known)
    assert len(calls) <= 8
    assert not {e for e, _ in known} & set(calls)
