"""Sheets of all sizes, rubbers, strains and meshes: solved with finite numbers, or with a reason.

The meshes are the coarsest there are: what is wanted is an answer, and not that it is a good one.
"""

import math
import warnings

import pytest
from fuzzing import fuzzed
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.mechanics.laws import LAWS, law_of, mooney_rivlin
from wrinklestudy.sheet import Sheet
from wrinklestudy.vocabulary import ASPECT, PARITIES, STATUSES

CONSTANTS = {
    "mooney-rivlin": {"c10": 0.2, "c01": 0.3},
    "neo-hookean": {"c10": 0.5},
    "yeoh": {"c10": 0.5, "c20": -0.02, "c30": 0.01},
    "ogden": {"mu1": 0.6, "alpha1": 1.5, "mu2": -0.2, "alpha2": -2.0},
    "svk": {"young": 3.0},
    "foppl-von-karman": {"young": 3.0},
}


def powers(low, high):
    """Return a strategy for numbers whose logarithms are alike."""
    return st.floats(math.log(low), math.log(high)).map(
        lambda power: min(max(math.exp(power), low), high)
    )


@st.composite
def sheets(draw):
    """Draw a sheet."""
    law = law_of(draw(st.sampled_from(sorted(LAWS))))
    modulus = draw(powers(1e-3, 1e12))
    values = {
        constant.name: CONSTANTS[law.name][constant.name] * (modulus if constant.unit else 1.0)
        for constant in law.constants
        if constant.name in CONSTANTS[law.name]
    }
    bending = "fvk" if law.name == "foppl-von-karman" else "thinning"
    if law.name != "foppl-von-karman":
        bending = draw(st.sampled_from(["thinning", "fixed-thickness", "fvk"]))
    return Sheet(
        draw(powers(ASPECT.lowest, ASPECT.highest)),
        draw(powers(3e-5, 0.05)),
        law.material(**values),
        bending,
        draw(st.sampled_from(PARITIES)),
        MeshSettings(cells_along=draw(st.integers(4, 6)), cells_across=draw(st.integers(4, 6))),
    )


@fuzzed(0.03)
@given(sheets(), powers(1e-6, 1.0))
def test_sheets_are_solved_or_have_a_reason(sheet, strain):
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        state = sheet.solve(strain)
    values = state.as_dict()
    assert state.status in STATUSES
    numbers = [value for value in values.values() if isinstance(value, float)]
    assert all(map(math.isfinite, numbers)), values
    if state.status == "not-converged":
        assert state.equilibrium.reason
        assert values["amplitude_over_thickness"] is None
        return
    assert values["nominal_stress_pa"] > 0.0
    assert values["amplitude_over_thickness"] >= 0.0
    known = [values[name] is not None for name in ("cells_per_wavelength", "wavelength_over_width")]
    assert known[0] == known[1]
    assert state.status == "wrinkled" or not known[0]


@pytest.mark.parametrize("modulus", [1e-3, 1.0, 1e12])
def test_how_stiff_the_rubber_is_changes_no_shape(modulus):
    """A, lambda and the stress over the modulus are those of any other rubber of that ratio."""
    mesh = MeshSettings(8, 12)
    ours = Sheet(2.0, 1e-3, mooney_rivlin(modulus, 2.5 * modulus), mesh=mesh).solve(0.12)
    other = Sheet(2.0, 1e-3, mooney_rivlin(6e4, 15e4), mesh=mesh).solve(0.12)
    assert ours.status == other.status == "wrinkled"
    assert ours.measures.amplitude == pytest.approx(other.measures.amplitude, rel=1e-9)
    assert ours.measures.wavelength == pytest.approx(other.measures.wavelength, rel=1e-9)
    stresses = [state.as_dict()["nominal_stress_pa"] for state in (ours, other)]
    assert stresses[0] / modulus == pytest.approx(stresses[1] / 6e4, rel=1e-9)


@pytest.mark.parametrize("modulus", [0.0, 5e-324, 1e-20, 1e30, 1.7e308, math.inf, math.nan])
def test_a_rubber_that_no_number_describes_well_is_refused(modulus):
    with pytest.raises(ValueError, match=r"^c10 = .*must be"):
        mooney_rivlin(modulus, modulus)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 5e-324, 0.0, -1.0])
@pytest.mark.parametrize("name", ["aspect", "thickness", "strain"])
def test_a_size_that_is_none_is_refused(name, value):
    given = {"aspect": 2.0, "thickness": 1e-3, "strain": 0.1} | {name: value}
    with pytest.raises(ValueError, match=rf"^{name} = .*: must be"):
        Sheet(given["aspect"], given["thickness"], mooney_rivlin(1e5, 2e5)).solve(given["strain"])


def test_a_section_that_folds_over_itself_is_no_state():
    """Linear strains let cells turn inside out: on the coarsest mesh y falls along X = 0."""
    law = law_of("foppl-von-karman").material(young=3.0)
    state = Sheet(1.0, 1e-5, law, "fvk", mesh=MeshSettings(4, 4)).solve(1.0)
    assert state.status == "not-converged"
    assert "folds over itself" in state.equilibrium.reason
    assert state.as_dict()["amplitude_over_thickness"] is None
