"""The stresses of the test modes against closed forms and the energies that they come from."""

import numpy as np
import pytest
from closed_forms import mooney_rivlin_basis, saint_venant_kirchhoff_stress
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

from wrinklestudy.material.homogeneous import MODES, nominal_stress
from wrinklestudy.mechanics.laws import (
    Material,
    mooney_rivlin,
    neo_hookean,
    ogden,
    saint_venant_kirchhoff,
    yeoh,
)

LATEX = mooney_rivlin(6.21e4, 1.58e5)
MATERIALS = [
    LATEX,
    neo_hookean(1.8e5),
    mooney_rivlin(0.0, 2.0e5),
    yeoh(2.0e5, -4.0e3, 5.0e2),
    ogden(6.3e5, 1.3, -1.0e4, -2.0),
    saint_venant_kirchhoff(1.3e6),
    saint_venant_kirchhoff(1.3e6, 0.3),
]
materials = st.sampled_from(MATERIALS)
stretches = st.floats(0.75, 1.5)


@given(materials, stretches)
def test_uniaxial_is_the_energy_minimised_over_the_width(material: Material, lam: float) -> None:
    def across(width: float) -> float:
        return float(material.law.derivatives(np.array([lam**2, width**2, 0.0]))[0][1])

    width = brentq(across, 0.3, 2.0, xtol=1e-14)
    stress = material.law.derivatives(np.array([lam**2, width**2, 0.0]))[0]
    # the width is at its optimum, so that only the explicit dependence on lambda is left
    expected = 2.0 * lam * float(stress[0]) * material.shear_modulus
    assert nominal_stress(material, lam) == pytest.approx(expected, rel=1e-9, abs=1e-5)


@given(materials, stretches)
def test_biaxial_is_half_the_derivative_of_the_energy(material: Material, lam: float) -> None:
    square = (lam + 1e-30j) ** 2
    slope = material.law.energy(np.array([square, square, 0.0])).imag / 1e-30
    expected = 0.5 * slope * material.shear_modulus
    assert nominal_stress(material, lam, "biaxial") == pytest.approx(expected, rel=1e-11, abs=1e-7)


@given(materials, stretches)
def test_shear_is_the_derivative_of_the_energy_at_fixed_width(
    material: Material, lam: float
) -> None:
    square = (lam + 1e-30j) ** 2
    slope = material.law.energy(np.array([square, 1.0, 0.0])).imag / 1e-30
    expected = slope * material.shear_modulus
    assert nominal_stress(material, lam, "shear") == pytest.approx(expected, rel=1e-11, abs=1e-7)


@given(st.sampled_from(MATERIALS[:5]), stretches)
def test_biaxial_tension_is_uniaxial_compression_of_the_thickness(
    material: Material, lam: float
) -> None:
    # An incompressible solid does not feel pressure: stretching both sides by lambda is pressing
    # the thickness to lambda^-2, and the true stresses differ in sign only.
    biaxial = lam * nominal_stress(material, lam, "biaxial")
    thickness = lam**-2
    compression = thickness * nominal_stress(material, thickness, "uniaxial")
    assert biaxial == pytest.approx(-compression, rel=1e-11, abs=1e-7)


@pytest.mark.parametrize("material", MATERIALS)
def test_initial_slopes_are_those_of_hooke(material: Material) -> None:
    nu, young, step = material.law.poisson, material.young_modulus, 1e-5
    hooke = {"uniaxial": 1.0, "biaxial": 1.0 / (1.0 - nu), "shear": 1.0 / (1.0 - nu**2)}
    for mode in MODES:
        ends = nominal_stress(material, [1.0 + step, 1.0 - step], mode)
        assert (ends[0] - ends[1]) / (2.0 * step) == pytest.approx(hooke[mode] * young, rel=1e-8)
        assert nominal_stress(material, 1.0, mode) == pytest.approx(0.0, abs=1e-15 * young)


def test_a_mode_per_point_mixes_the_single_modes() -> None:
    stretch = np.array([[1.1, 1.2, 1.3], [1.4, 1.5, 1.6]])
    modes = np.array([MODES, MODES[::-1]])
    mixed = nominal_stress(LATEX, stretch, modes)
    for at in np.ndindex(2, 3):
        single = nominal_stress(LATEX, stretch[at], modes[at])
        assert mixed[at] == pytest.approx(single, rel=1e-14)


@pytest.mark.parametrize("mode", MODES)
@given(st.floats(0.5, 4.0))
def test_mooney_rivlin_has_its_closed_form(mode: str, lam: float) -> None:
    expected = mooney_rivlin_basis(lam, mode) @ [6.21e4, 1.58e5]
    scale = 1e6 * max(lam, 1.0 / lam) ** 4
    assert nominal_stress(LATEX, lam, mode) == pytest.approx(expected, rel=1e-13, abs=1e-14 * scale)


@pytest.mark.parametrize("mode", MODES)
@given(st.floats(0.5, 1.4), st.floats(0.0, 0.5))
def test_saint_venant_kirchhoff_has_its_closed_form(mode: str, lam: float, nu: float) -> None:
    expected = 1.3e6 * saint_venant_kirchhoff_stress(lam, mode, nu)
    stress = nominal_stress(saint_venant_kirchhoff(1.3e6, nu), lam, mode)
    assert stress == pytest.approx(expected, rel=1e-13, abs=1e-8)


def test_a_strip_without_width_has_no_stress() -> None:
    stress = nominal_stress(saint_venant_kirchhoff(1.3e6, 0.5), [1.7, 1.8])
    np.testing.assert_array_equal(np.isnan(stress), [False, True])  # nu (lambda^2 - 1) = 1 between


def test_shear_cannot_tell_the_constants_apart() -> None:
    stretch = np.linspace(1.0, 2.0, 5)
    one, other = (
        nominal_stress(mooney_rivlin(*constants), stretch, "shear")
        for constants in ((1e5, 0.0), (0.0, 1e5))
    )
    np.testing.assert_allclose(one, other, rtol=1e-14, atol=1e-10)


def test_an_unknown_mode_is_named() -> None:
    with pytest.raises(ValueError, match=r"'planar'.*uniaxial, biaxial, shear"):
        nominal_stress(LATEX, [1.1, 1.2], ["uniaxial", "planar"])
