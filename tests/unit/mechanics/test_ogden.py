"""The Ogden law against its eigenvalues in 60 digits, above all where they coincide."""

from decimal import Decimal, localcontext

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.mechanics.laws import Ogden, mooney_rivlin, ogden

LAWS = [
    ogden(6.3e5, 1.3, -1.0e4, -2.0).law,
    Ogden(0.1, 6.0, 1.4, 1.0),
    Ogden(2.0 / 3.3, 3.0, -0.2, -1.0),
    Ogden(1.5e-4, 11.7, -1.2, -1.66),
]
# (g11, g22, g12): eigenvalues that coincide, nearly do, and do not
GAPS = [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.5]
METRICS = [
    *([1.0 + gap, 1.0, 0.0] for gap in GAPS),
    *([1.7 - gap, 1.7 + 2 * gap, 3 * gap] for gap in GAPS[:7]),
    *([1.0, 1.0, gap] for gap in GAPS[1:7]),
    [2.25, 0.62, 0.3],
    [9.0, 0.4, 0.0],
    [0.4, 0.9, -0.25],
]


def _energy(law, metric):
    """W in decimals from the eigenvalues of the metric."""
    a, b, c = metric
    half, trace = (((a - b) / 2) ** 2 + c * c).sqrt(), a + b
    squares = (trace / 2 + half, trace / 2 - half, 1 / (a * b - c * c))
    total = Decimal(0)
    for modulus, exponent in law.terms:
        s = Decimal(exponent) / 2
        total += Decimal(modulus) / Decimal(exponent) * (sum(g**s for g in squares) - 3)
    return total


def _reference(law, metric):
    """Energy, gradient and Hessian from differences of steps 1e-14 in 60 digits."""
    step = Decimal(10) ** -14
    with localcontext() as context:
        context.prec = 60
        at = [Decimal(value) for value in metric]

        def moved(*directions):
            place = list(at)
            for index, sign in directions:
                place[index] += sign * step
            return _energy(law, place)

        middle = moved()
        gradient = [(moved((i, 1)) - moved((i, -1))) / (2 * step) for i in range(3)]
        hessian = np.empty((3, 3))
        for i in range(3):
            for j in range(3):
                if i == j:
                    second = moved((i, 1)) - 2 * middle + moved((i, -1))
                else:
                    corners = [(p, q) for p in (1, -1) for q in (1, -1)]
                    second = sum(p * q * moved((i, p), (j, q)) for p, q in corners) / 4
                hessian[i, j] = float(second / step**2)
        return float(middle), np.array([float(value) for value in gradient]), hessian


@pytest.mark.parametrize("law", LAWS, ids=lambda law: f"{law.alpha1:g},{law.alpha2:g}")
@pytest.mark.parametrize("metric", METRICS, ids=str)
def test_energy_stress_and_tangent_are_exact_to_rounding(law, metric):
    energy, gradient, hessian = _reference(law, metric)
    found = np.array(metric)
    stress, tangent = law.derivatives(found)
    # What rounding may do is measured by the moduli, and by how much the powers differ.
    scale = max(1.0, float(np.abs(hessian).max()))
    assert law.energy(found) == pytest.approx(energy, abs=2e-15 * scale)
    np.testing.assert_allclose(stress, gradient, rtol=0, atol=4e-15 * scale)
    np.testing.assert_allclose(tangent, hessian, rtol=0, atol=2e-14 * scale)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: f"{law.alpha1:g},{law.alpha2:g}")
@pytest.mark.parametrize("metric", METRICS, ids=str)
def test_complex_steps_in_the_energy_give_the_stress(law, metric):
    step = 1e-30
    at = np.array(metric)
    exact = [law.energy(at + 1j * step * axis).imag / step for axis in np.eye(3)]
    np.testing.assert_allclose(law.derivatives(at)[0], exact, rtol=1e-12, atol=1e-13)


def test_series_and_powers_agree_where_one_follows_the_other():
    """Both are taken left and right of one ratio of the eigenvalues; nothing jumps there."""
    for law in LAWS:
        ratio = np.sqrt(0.1 * (1.0 + np.array([-1e-12, 1e-12])))
        metric = np.stack([1.3 * (1.0 + ratio), 1.3 * (1.0 - ratio), 0.0 * ratio])
        for values in (law.energy(metric), *law.derivatives(metric)):
            scale = np.abs(values).max()
            np.testing.assert_allclose(values[..., 0], values[..., 1], rtol=0, atol=1e-11 * scale)


@given(st.floats(0.3, 3.0), st.floats(0.3, 3.0), st.floats(0.0, np.pi), st.floats(0.0, 1.0))
def test_exponents_two_and_minus_two_are_mooney_rivlin(first, second, angle, part):
    c10, c01 = 1e5 * (1.0 - part), 1e5 * part
    c, s = np.cos(angle), np.sin(angle)
    a, b = first**2, second**2
    metric = np.array([a * c * c + b * s * s, a * s * s + b * c * c, (a - b) * c * s])
    one, other = ogden(2 * c10, 2.0, -2 * c01, -2.0), mooney_rivlin(c10, c01)
    assert one.shear_modulus == pytest.approx(other.shear_modulus, rel=1e-15)
    expected = (other.law.energy(metric), *other.law.derivatives(metric))
    found = (one.law.energy(metric), *one.law.derivatives(metric))
    for values, wanted in zip(found, expected, strict=True):
        # det g of a turned metric is known to rounding of its two products
        scale = np.abs(wanted).max() * max(1.0, a * b, a / b, b / a)
        np.testing.assert_allclose(values, wanted, rtol=0, atol=1e-13 * scale + 1e-14)


def test_the_order_of_the_terms_does_not_matter_to_the_law_but_is_settled_for_fits():
    values = {"mu1": -1e4, "alpha1": -2.0, "mu2": 6e5, "alpha2": 1.3}
    order = Ogden.canonical_order(values)
    settled = dict(zip(values, (values[name] for name in order), strict=True))
    assert settled == {"mu1": 6e5, "alpha1": 1.3, "mu2": -1e4, "alpha2": -2.0}
    assert Ogden.canonical_order(settled) == tuple(settled)
    metric = np.array([1.5, 0.8, 0.2])
    one, other = Ogden.material(**values), Ogden.material(**settled)
    assert one.law.energy(metric) == pytest.approx(other.law.energy(metric), rel=1e-14)


@pytest.mark.parametrize("strain", [1e-5, 1e-4, 1e-3])
def test_the_energy_of_a_small_strain_keeps_its_digits(strain):
    """mu_p/alpha_p is many times the shear modulus; Newton's method compares such energies."""
    law = ogden(4939.63, 4.45149, -1.67034e6, -0.464803).law
    metric = [1.0 + 2.0 * strain, 1.0 - strain, 0.3 * strain]
    with localcontext() as context:
        context.prec = 60
        exact = float(_energy(law, [Decimal(value) for value in metric]))
    assert law.energy(np.array(metric)) == pytest.approx(exact, rel=0.0, abs=1e-15)


def test_a_term_of_exponent_zero_is_the_limit_of_small_exponents():
    """(mu/alpha)(l1^alpha + l2^alpha + l3^alpha - 3) goes to mu ln(l1 l2 l3) = 0."""
    metric = np.array([1.7, 0.7, 0.2])
    zero, small = Ogden(1.0, 2.0, 0.8, 0.0), Ogden(1.0, 2.0, 0.8, 1e-9)
    assert zero.energy(metric) == pytest.approx(small.energy(metric), rel=1e-8)
    for mine, near in zip(zero.derivatives(metric), small.derivatives(metric), strict=True):
        np.testing.assert_allclose(mine, near, rtol=1e-7, atol=1e-8)
