"""Half and whole sheets: the states of the quarter, the slide, the unwrinkled sheet, windows."""

import numpy as np
import pytest

from wrinklestudy import Clamps, MeshSettings, Sheet, ThicknessField, mooney_rivlin
from wrinklestudy.equilibrium import pin
from wrinklestudy.equilibrium.imperfections import Imperfections, bifurcation
from wrinklestudy.equilibrium.ranges import search
from wrinklestudy.equilibrium.stability import find
from wrinklestudy.results import whole

LATEX = mooney_rivlin(c10=6.21e4, c01=1.58e5)
COARSE = MeshSettings(8, 18)


def solved(strain=0.12, **options):
    return Sheet(2.0, 1e-3, LATEX, mesh=COARSE, **options).solve(strain).as_dict()


@pytest.fixture(scope="module")
def quarters():
    return {p: solved(parity=p) for p in ("antisymmetric", "symmetric")}


@pytest.mark.parametrize("parity", ["antisymmetric", "symmetric"])
@pytest.mark.parametrize("part", ["half", "half-width", "whole"])
def test_without_mirrors_a_perfect_sheet_has_the_states_of_the_quarter(quarters, part, parity):
    state = solved(symmetry=part, parity=parity)
    expected = quarters[parity]["amplitude_over_thickness"]
    assert state["amplitude_over_thickness"] == pytest.approx(expected, rel=1e-6)
    stress = quarters[parity]["nominal_stress_pa"]
    assert state["nominal_stress_pa"] == pytest.approx(stress, rel=1e-6)
    odd, even = (quarters[p]["amplitude_over_thickness"] for p in quarters)
    assert state["amplitude_low"] == pytest.approx(odd, rel=1e-3)
    assert state["amplitude_high"] == pytest.approx(even, rel=1e-3)
    if part != "half-width":
        assert abs(state["pin_reaction"]) < 1e-9


def test_a_shift_of_the_clamps_tilts_the_wrinkles_its_way():
    """Mirror images have the same amplitude and the opposite tilt."""
    one, other = (solved(symmetry="whole", clamps=Clamps(shear=s)) for s in (0.02, -0.02))
    assert one["tilt"] > 1e-3
    assert other["tilt"] == pytest.approx(-one["tilt"], rel=1e-4)
    assert other["amplitude_low"] == pytest.approx(one["amplitude_low"], rel=1e-6)


def test_a_clamp_that_is_lifted_tilts_no_crest():
    """The sheet itself slopes by 0.05 along the pull, hundreds of times the angle allowed."""
    state = solved(symmetry="whole", clamps=Clamps(lift=0.1))
    assert state["tilt"] == pytest.approx(0.0, abs=2e-4)


def test_too_thick_a_sheet_is_unwrinkled_where_twist_keeps_it_from_being_flat():
    sheet = Sheet(2.0, 5e-3, LATEX, mesh=COARSE, symmetry="whole", clamps=Clamps(twist=0.1))
    state = sheet.solve(0.12)
    assert state.status == "unwrinkled"
    # A quarter of the twist on each side of the middle: z = (twist/2) y at the clamps
    x, y = np.array([1.0]), np.array([0.5])
    assert state.shape.evaluate(x, y)[2, 0, 0] == pytest.approx(0.5 * np.sin(0.05))
    middle = state.shape.evaluate(np.array([0.0]), np.linspace(-0.5, 0.5, 9))[2, 0]
    assert np.abs(middle).max() < 1e-6


@pytest.mark.parametrize(
    ("options", "kind"),
    [
        ({}, "sharp"),
        ({"clamps": Clamps(shear=0.1, rotate=0.1)}, "sharp"),
        ({"thickness": ThicknessField(0.1, 0.1)}, "sharp"),
        ({"clamps": Clamps(twist=0.1)}, "sharp"),  # a turn by pi about y is left
        ({"clamps": Clamps(twist=0.1, pitch=0.1)}, "rounded"),
        ({"weight": 0.01, "thickness": ThicknessField(across=0.1)}, "rounded"),
    ],
)
def test_wrinkles_are_born_at_a_sharp_strain_where_they_break_a_symmetry(options, kind):
    assert bifurcation(Imperfections(**options), 2.0, "antisymmetric").kind == kind


def test_weight_rounds_the_birth_of_even_wrinkles_alone():
    """It pulls an even pattern up or down, and leaves y -> -y for an odd one to break."""
    heavy = Imperfections(weight=0.01)
    assert bifurcation(heavy, 2.0, "symmetric").kind == "rounded"
    assert bifurcation(heavy, 2.0, "antisymmetric").kind == "sharp"


def test_windows_are_found_by_scanning_from_the_least_strain():
    """tau_1 of a sheared sheet is large at small strain: a window without a birth comes first."""

    def curve(strain):
        return 1e-3 * (1.2 - 40.0 * strain if strain < 0.02 else 1.5 - 60.0 * (strain - 0.12) ** 2)

    survey = (0.001, 0.003, 0.01, 0.019, 0.021, 0.05, 0.1, 0.16, 0.24, 0.32, 0.4)
    found = search(curve, 1e-3, (), survey, origin=False)
    assert len(found.ranges) == 2
    (start, first_end), (birth, decay) = found.ranges
    assert start == 0.001
    assert first_end == pytest.approx(0.005, abs=1e-4)
    assert found.birth_strain == birth
    root = np.sqrt(0.5 / 60.0)
    assert (birth, decay) == pytest.approx((0.12 - root, 0.12 + root), abs=1e-4)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"symmetry": "none"}, "symmetry = 'none': must be one of"),
        ({"clamps": Clamps(shear=0.1)}, "clamps that are off need 'whole'"),
        ({"thickness_field": ThicknessField(0.1)}, "both sides of x = 0"),
        ({"symmetry": "half", "weight": 1.0}, "weight = 1: must be"),
        ({"weight": 0.01}, "the weight of the sheet needs"),
    ],
)
def test_a_sheet_refuses_mirrors_that_it_does_not_have(options, message):
    with pytest.raises(ValueError, match=message):
        Sheet(2.0, 1e-3, LATEX, **options)


def test_strains_at_which_a_heavy_sheet_sags_are_passed_over():
    """The curve begins where it can be computed, and its decay is found all the same."""

    def curve(strain):
        if strain < 0.02:
            raise ArithmeticError("sags")
        return 2e-3 - 4e-3 * strain

    survey = (0.001, 0.01, 0.03, 0.1, 0.2, 0.4, 0.6)
    for guide in (None, curve):
        found = find(curve, 1e-3, survey=survey, guide=guide)
        assert found.birth_strain is None
        assert found.ranges[0][0] == 0.03
        assert found.decay_strain == pytest.approx(0.25, abs=1e-5)
        assert found.passed_over == "below strain 0.03 nothing is known: sags"


def test_a_curve_that_can_be_computed_nowhere_says_why():
    def curve(strain):
        raise ArithmeticError(f"sags at {strain:g}")

    with pytest.raises(ArithmeticError, match=r"sags at 0\.001"):
        find(curve, 1e-3)


def test_a_slide_that_is_not_solved_to_its_digits_has_no_eigenvalue(monkeypatch):
    """One step of conjugate gradients to no residual at all is not enough."""
    monkeypatch.setattr(pin, "_RESIDUAL", 0.0)
    monkeypatch.setattr(pin, "_MAX_STEPS", 1)
    state = solved(symmetry="whole")
    assert state["softest_eigenvalue"] is None
    assert state["status"] == "wrinkled"
    assert abs(state["pin_reaction"]) < 1e-9


def test_a_state_without_an_equilibrium_is_still_told_how_its_wrinkles_appear(monkeypatch):
    def fails(*_arguments):
        raise ArithmeticError("no flat state")

    monkeypatch.setattr(whole, "solve", fails)
    sheet = Sheet(2.0, 1e-3, LATEX, mesh=COARSE, symmetry="whole", weight=5e-3)
    state = sheet.solve(0.12)
    assert state.aspect == pytest.approx(2.0)
    row = state.row()
    assert (row.status, row.reason) == ("not-converged", "no flat state")
    assert (row.bifurcation, row.bifurcation_reason) == sheet.bifurcation
