"""Birth and decay from known curves tau_1(eps)."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.equilibrium.critical_curve import critical_curve, guided_curve
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.stability import find, of_sheet
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import mooney_rivlin, neo_hookean, saint_venant_kirchhoff


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
    limits = find(hill, thickness)
    assert limits.birth_strain == pytest.approx(exact(thickness, 0, 0.1), abs=5e-5)
    assert limits.decay_strain == pytest.approx(exact(thickness, 0.1, 1.0), abs=5e-5)


@given(st.floats(1e-6, 3e-4))
def test_birth_of_a_thin_sheet_is_known_in_parts_of_itself(thickness):
    """A sheet of small strain is linear: tau_1 goes like the root of eps, birth like t^2."""
    limits = find(lambda strain: 7e-3 * math.sqrt(strain) * math.exp(-strain / 0.2), thickness)
    assert limits.birth_strain == pytest.approx((thickness / 7e-3) ** 2, rel=0.02)
    tau = 7e-3 * math.sqrt(limits.birth_strain) * math.exp(-limits.birth_strain / 0.2)
    assert tau == pytest.approx(thickness, rel=1e-3)


def test_a_root_that_cannot_be_computed_is_an_error():
    known = [(e, hill(e)) for e in (0.05, 0.1, 0.15, 0.2, 0.4)]
    with pytest.raises(ArithmeticError, match=r"tau_1 at strain 0\.0\d+, .* decay: no thickness"):
        find(nowhere, 1e-3, known)


def nowhere(_):
    raise ArithmeticError("no thickness is left")


def test_a_sheet_of_which_nothing_can_be_computed_is_an_error():
    with pytest.raises(ArithmeticError, match="no thickness is left"):
        find(nowhere, 1e-3)


def test_the_search_ends_where_the_law_does_and_says_so():
    def ending(strain):
        return nowhere(strain) if strain > 0.35 else hill(strain)

    for guide in (None, hill, ending):
        limits = find(ending, 4e-4, guide=guide)
        assert limits.birth_strain == pytest.approx(exact(4e-4, 0, 0.1), abs=1e-5)
        assert limits.decay_strain is None
        assert 0.32 <= limits.largest_strain <= 0.35
        assert limits.reason == "no thickness is left"


def test_a_thick_sheet_never_wrinkles():
    limits = find(hill, 1.51e-3)
    assert limits.birth_strain is None
    assert limits.decay_strain is None


def test_a_narrow_range_between_known_strains_is_found():
    """All known strains are stable, but tau_1 rises above t between two of them."""
    known = [(e, hill(e)) for e in (0.02, 0.07, 0.14, 0.3)]
    thickness = 1.48e-3
    assert max(tau for _, tau in known) < thickness
    limits = find(hill, thickness, known)
    assert limits.birth_strain == pytest.approx(exact(thickness, 0, 0.1), abs=5e-5)
    assert limits.decay_strain == pytest.approx(exact(thickness, 0.1, 1.0), abs=5e-5)


def test_the_search_goes_on_beyond_the_last_known_strain():
    calls = []

    def counted(strain):
        calls.append(strain)
        return hill(strain)

    known = [(e, hill(e)) for e in (0.02, 0.05, 0.1, 0.15)]
    limits = find(counted, 5e-4, known)
    assert limits.decay_strain == pytest.approx(exact(5e-4, 0.1, 1.0), abs=5e-5)
    assert len(calls) < 15


def test_wrinkles_that_never_vanish_have_no_decay():
    limits = find(lambda strain: 2e-3 * (1 - math.exp(-strain / 0.05)), 1e-3)
    assert limits.birth_strain == pytest.approx(0.05 * math.log(2), abs=5e-5)
    assert limits.decay_strain is None
    assert limits.largest_strain == pytest.approx(1.0)


def test_known_values_are_not_computed_again():
    known = [(k / 50, hill(k / 50)) for k in range(1, 26)]
    calls = []

    def counted(strain):
        calls.append(strain)
        return hill(strain)

    find(counted, 1e-3, known)
    assert len(calls) <= 10
    assert not {e for e, _ in known} & set(calls)


@given(st.floats(0.02, 0.6))
def test_the_maximum_is_found_wherever_it_lies_between_the_strains_of_the_survey(place):
    limits = find(lambda strain: 1.5e-3 * math.e * strain / place * math.exp(-strain / place), 1e-3)
    assert limits.max_critical_thickness == pytest.approx(1.5e-3, rel=1e-5)
    assert limits.strain_at_max == pytest.approx(place, rel=1e-2)


def two_humps(strain):
    """Two smooth tau_i, of which the larger counts: 1.2e-3 at 0.08 and 1.35e-3 at 0.47."""

    def hump(height, place, width):
        return height * math.exp(-(((strain - place) / width) ** 2))

    return max(hump(1.2e-3, 0.08, 0.05), hump(1.35e-3, 0.47, 0.11)) * strain / (strain + 1e-3)


@pytest.mark.parametrize("guide", [None, lambda strain: (0.99 + 0.02 * strain) * two_humps(strain)])
def test_of_two_humps_both_ranges_and_the_higher_maximum_are_found(guide):
    limits = find(two_humps, 1e-3, guide=guide)
    scan = np.linspace(1e-4, 1.0, 100_001)
    tau = np.array([two_humps(strain) for strain in scan])
    ends = scan[1:][np.diff(tau > 1e-3)]
    assert len(ends) == 4
    assert [end for pair in limits.ranges for end in pair] == pytest.approx(list(ends), abs=2e-5)
    assert (limits.birth_strain, limits.decay_strain) == (limits.ranges[0][0], limits.ranges[1][1])
    assert limits.max_critical_thickness == pytest.approx(tau.max(), rel=1e-5)
    assert limits.strain_at_max == pytest.approx(scan[tau.argmax()], abs=2e-3)


def test_a_valley_between_the_strains_of_the_survey_parts_two_ranges():
    """tau_1 dips below t only near strain 0.27, where one mode takes over from another."""

    def dipping(strain):
        return 1.4e-3 * min(1.0, strain / 0.01) * max(1 - 1.6 * strain, 1 - 1.6 * (0.54 - strain))

    limits = find(dipping, 0.83e-3)
    edge = (1 - 0.83 / 1.4) / 1.6
    assert len(limits.ranges) == 2
    assert limits.ranges[0][1] == pytest.approx(edge, abs=2e-5)
    assert limits.ranges[1][0] == pytest.approx(0.54 - edge, abs=2e-5)


def test_a_decay_just_below_the_end_of_the_law_is_found():
    """tau_1 ends at 0.38, between two strains of the survey, and t is passed at 0.36."""

    def ending(strain):
        return nowhere(strain) if strain > 0.38 else hill(strain)

    limits = find(ending, hill(0.36))
    assert limits.decay_strain == pytest.approx(0.36, abs=1e-5)
    assert 0.375 < limits.largest_strain <= 0.38


def test_a_maximum_with_a_kink_is_found_too():
    """No tau_1 has one, but what interpolates it may."""

    def roof(strain):
        return 1.5e-3 * min(strain / 0.137, math.exp((0.137 - strain) / 0.3))

    limits = find(roof, 1e-3)
    assert limits.max_critical_thickness == pytest.approx(1.5e-3, rel=1e-5)
    assert limits.birth_strain == pytest.approx(0.137 / 1.5, abs=1e-5)


def test_a_guide_spares_the_curve_and_changes_no_answer():
    """The guide is off by up to 8%, as a coarse mesh is where the wrinkles are many."""
    calls = []

    def counted(strain):
        calls.append(strain)
        return hill(strain)

    def guide(strain):
        return hill(strain) / (1 + 1e-3 + 2e-9 / (hill(strain) ** 2 + 2.5e-8))

    thickness = 2e-4
    limits = find(counted, thickness, guide=guide)
    assert len(calls) <= 7
    assert limits.birth_strain == pytest.approx(exact(thickness, 0, 0.1), rel=1e-3)
    assert limits.decay_strain == pytest.approx(exact(thickness, 0.1, 1.0), abs=1e-5)
    assert limits.max_critical_thickness == pytest.approx(1.5e-3, rel=2e-5)
    table = np.array(limits.critical_thickness)
    assert table[:, 1] == pytest.approx([hill(e) for e in table[:, 0]], rel=0.1)


def test_a_guide_that_is_much_too_low_hides_no_wrinkles():
    """The coarse mesh gives no tau_1 above t, that of the sheet does."""
    limits = find(hill, 1.48e-3, guide=lambda strain: 0.95 * hill(strain))
    assert limits.birth_strain == pytest.approx(exact(1.48e-3, 0, 0.1), abs=1e-5)
    assert limits.decay_strain == pytest.approx(exact(1.48e-3, 0.1, 1.0), abs=1e-5)


def test_a_sheet_that_no_thickness_wrinkles_costs_no_fine_value():
    limits = find(nowhere, 1e-4, guide=lambda _: 0.0)
    assert limits.ranges == ()
    assert limits.max_critical_thickness == 0.0
    assert limits.largest_strain == 1.0


@pytest.mark.parametrize(
    ("material", "aspect", "bending"),
    [
        (mooney_rivlin(6.21e4, 1.58e5), 2.0, "thinning"),
        (saint_venant_kirchhoff(1e6, 0.4), 3.0, "fvk"),
        (neo_hookean(1e5), 2.2, "fixed-thickness"),
    ],
    ids=["mooney-rivlin", "svk", "neo-hookean"],
)
def test_the_limits_of_a_sheet_are_those_of_a_dense_scan_on_its_mesh(material, aspect, bending):
    space = Space(make_grid(aspect, settings=MeshSettings(20, 30)))
    settings = PlanarSettings(bending)
    assert guided_curve(space, material, settings).guide is not None
    thickness = 7e-4
    limits = of_sheet(space, material, settings, thickness)
    curve = critical_curve(space, material, settings)
    assert limits.birth_strain is not None
    assert limits.decay_strain is not None
    for end in (limits.birth_strain, limits.decay_strain):
        assert (curve(end - 1e-5) > thickness) != (curve(end + 1e-5) > thickness)
    top = 1.2 * limits.decay_strain
    tau = [curve(strain) for strain in np.linspace(top / 12, top, 12)]
    near = np.linspace(limits.strain_at_max - 0.006, limits.strain_at_max + 0.006, 9)
    highest = max(*tau, *(curve(strain) for strain in near))
    assert limits.max_critical_thickness == pytest.approx(highest, rel=3e-5)


def test_without_poisson_contraction_nothing_wrinkles():
    """With nu = 0 nothing contracts: uniaxial tension everywhere, no compression, tau_1 = 0."""
    space = Space(make_grid(2.0, settings=MeshSettings(16, 30)))
    limits = of_sheet(space, saint_venant_kirchhoff(1e6, 0.0), PlanarSettings(), 1e-4)
    assert limits.birth_strain is None
    assert limits.max_critical_thickness == 0.0
    assert limits.largest_strain == 1.0
