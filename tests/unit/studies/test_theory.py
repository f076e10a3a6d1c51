"""Closed forms against their own derivations and against statements of the paper."""

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from wrinklestudy.studies.panaitescu2019 import theory

C10, C01 = 6.21e4, 1.58e5
YOUNG = 6.0 * (C10 + C01)


def _slope(curve: Callable[[np.ndarray], np.ndarray]) -> float:
    ends = curve(np.array([1e-5, -1e-5]))
    return float(ends[0] - ends[1]) / 2e-5


def _mooney_rivlin(strain: np.ndarray) -> np.ndarray:
    stretch = 1.0 + strain
    return 2.0 * (stretch - stretch**-2) * (C10 + C01 / stretch)


def test_initial_slope_is_the_derivative_at_zero_strain() -> None:
    assert _slope(_mooney_rivlin) == pytest.approx(theory.initial_slope(C10, C01), rel=1e-8)


def test_hookean_curves_start_with_young_modulus() -> None:
    assert _slope(lambda strain: theory.uniaxial_svk(strain, YOUNG)) == pytest.approx(YOUNG)
    assert _slope(lambda strain: theory.uniaxial_hookean(strain, YOUNG)) == pytest.approx(YOUNG)


def test_incompressible_hookean_has_a_straight_line_of_true_stress() -> None:
    strain = np.linspace(0.0, 0.5, 11)
    section = theory.uniaxial_width(strain) ** 2  # width and thickness shrink alike
    true = theory.uniaxial_hookean(strain, YOUNG) / section
    np.testing.assert_allclose(true, YOUNG * strain, rtol=1e-13, atol=1e-9)


def test_the_paper_s_law_is_nonlinear_above_ten_percent_and_svk_on_the_other_side() -> None:
    # section II: a straight line up to about 0.1 only, and SVK off to one side
    strain = np.linspace(0.1, 0.5, 9)
    line = YOUNG * strain
    rubber = _mooney_rivlin(strain)
    assert (rubber < 0.9 * line).all()
    assert (theory.uniaxial_svk(strain, YOUNG) > 1.1 * line).all()


def test_width_law_is_the_tangent_of_simple_tension() -> None:
    strain = np.linspace(0.0, 0.1, 11)
    gap = theory.uniaxial_width(strain) - theory.actual_width(strain)
    assert (gap >= 0.0).all()
    assert (gap <= 0.375 * strain**2 + 1e-15).all()  # next term of (1 + eps)^(-1/2)
    assert theory.actual_width(0.2, 0.3) == pytest.approx(1.0 - 0.06)


def test_wavelength_minimises_bending_and_tension_at_fixed_excess_length() -> None:
    # w = A cos(k y) cos(pi x / L) with A k given by the excess length: energy per area is
    # proportional to B k^2 + T (pi / L)^2 / k^2, B = Y t^3 / (12 (1 - nu^2)), T = Y t eps.
    aspect, thickness, strain, nu = 2.3, 8e-4, 0.07, 0.4
    bending, tension = thickness**3 / (12.0 * (1.0 - nu**2)), thickness * strain

    def energy(log_wavelength: float) -> float:
        k = 2.0 * np.pi / np.exp(log_wavelength)
        return float(np.log(bending * k**2 + tension * (np.pi / aspect) ** 2 / k**2))

    best = minimize_scalar(energy, bounds=(-5.0, 0.0), method="bounded", options={"xatol": 1e-10})
    expected = theory.cm_wavelength(strain, aspect, thickness, nu)
    assert np.exp(best.x) == pytest.approx(expected, rel=1e-6)


def test_wavelength_curve_of_the_paper_lies_in_the_range_it_reports() -> None:
    # Fig. 5b and the text: 0.8 x CM at nu = 1/2, data in the interval (0.09, 0.17)
    strain = np.linspace(0.04, 0.4, 19)
    curve = theory.cm_wavelength(strain, 2.0, 1e-3, factor=theory.WAVELENGTH_FACTOR)
    assert (np.diff(curve) < 0.0).all()
    assert curve.max() < 0.17
    assert curve.min() > 0.09


def test_sinusoid_constant_is_that_of_its_arc_length() -> None:
    amplitude, wavelength = 1e-3, 0.1
    y = np.linspace(0.0, wavelength, 401)[:-1]
    k = 2.0 * np.pi / wavelength
    arc = np.mean(np.sqrt(1.0 + (amplitude * k * np.sin(k * y)) ** 2))
    phi = np.sqrt(arc - 1.0)
    # the relation is the limit of small slope; the next term is of the order slope^2
    slope = amplitude * k
    assert theory.SINUSOID_CONSTANT * wavelength * phi == pytest.approx(amplitude, rel=slope**2)


def test_original_model_assumes_the_full_width_over_the_contracted_one() -> None:
    strain = 1e-4
    projected = theory.actual_width(strain)
    assert theory.cm_confinement(strain) == pytest.approx((1.0 - projected) / projected, rel=1e-4)


@pytest.mark.parametrize(
    "call",
    [
        lambda: theory.cm_wavelength([0.1, 0.0], 2.0, 1e-3),
        lambda: theory.cm_wavelength(-0.1, 2.0, 1e-3),
        lambda: theory.uniaxial_svk([0.0, -1.0]),
        lambda: theory.uniaxial_width(float("nan")),
    ],
)
def test_strains_outside_the_formula_are_refused(call: Callable[[], object]) -> None:
    with pytest.raises(ValueError, match="strain: must be"):
        call()
