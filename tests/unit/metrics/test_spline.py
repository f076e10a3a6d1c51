"""The spline through a profile against scipy's, and its sign changes where signs are awkward."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from wrinklestudy.metrics.spline import ProfileSpline

GENERATOR = np.random.default_rng(7)
Y = np.sort(GENERATOR.uniform(-0.5, 0.5, 60))
Z = GENERATOR.normal(size=60)


@pytest.mark.parametrize("derivative", [0, 1, 2])
def test_it_is_the_spline_of_scipy(derivative):
    points = np.linspace(Y[0], Y[-1], 777)
    expected = CubicSpline(Y, Z)(points, derivative)
    curve = ProfileSpline.through(Y, Z)
    assert np.allclose(
        curve(points, derivative), expected, rtol=0.0, atol=1e-11 * abs(expected).max()
    )


def test_a_cubic_is_reproduced():
    cubic = np.polynomial.Polynomial([0.1, -1.0, 0.3, 5.0])
    curve = ProfileSpline.through(Y, cubic(Y))
    assert curve.slope == pytest.approx(cubic.deriv()(Y), abs=1e-12)
    assert curve.turning_points() == pytest.approx(cubic.deriv().roots().real, abs=1e-12)


def test_turning_points_and_zeros_are_the_roots_that_scipy_finds():
    """Of noise, so that many pieces have two of them."""
    curve, spline = ProfileSpline.through(Y, Z), CubicSpline(Y, Z)
    for own, expected in (
        (curve.turning_points(), spline.derivative().roots(extrapolate=False)),
        (curve.zeros(), spline.roots(extrapolate=False)),
    ):
        assert len(own) > 30
        assert own == pytest.approx(np.sort(expected), abs=1e-12)


def test_a_change_at_a_point_is_found_once():
    y = np.linspace(-0.5, 0.5, 401)
    curve = ProfileSpline.through(y, np.sin(8.0 * np.pi * y))
    assert curve.turning_points() == pytest.approx((np.arange(8) - 3.5) / 8.0, abs=1e-9)
    assert curve.zeros() == pytest.approx((np.arange(9) - 4.0)[1:-1] / 8.0, abs=1e-12)


def test_level_pieces_change_no_sign():
    """A wrinkle with margins of zero: one peak, one trough, one zero between them."""
    y = np.arange(-20.0, 21.0)
    wrinkle = np.polynomial.Polynomial([0.0, 625.0, 0.0, -50.0, 0.0, 1.0])  # y (25 - y^2)^2
    inside = abs(y) < 5.0
    curve = ProfileSpline(
        y, np.where(inside, wrinkle(y), 0.0), np.where(inside, wrinkle.deriv()(y), 0.0)
    )
    assert len(curve.turning_points()) == 2
    assert curve.zeros() == pytest.approx([0.0], abs=1e-12)
