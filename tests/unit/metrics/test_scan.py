"""Scans with noise, gaps, spikes, tilt and ripple: the true values within the stated errors."""

import numpy as np
import pytest

from wrinklestudy.metrics.measure import measure
from wrinklestudy.metrics.profile import Profile
from wrinklestudy.metrics.scan import dominant_wavelength, measure_scan, robust_line, usable

WIDTH, HEIGHT, WAVELENGTH = 132.0, 0.4, 17.0
Y = np.linspace(-0.5 * WIDTH, 0.5 * WIDTH, 900)


def wrinkle(y):
    """An odd packet in the middle half of the sheet, flat outside."""
    return HEIGHT * np.sin(2.0 * np.pi * y / WAVELENGTH) * np.exp(-((y / 25.0) ** 2))


TRUE = measure(Profile(np.linspace(Y[0], Y[-1], 4000), wrinkle(np.linspace(Y[0], Y[-1], 4000))))


def within(scan, factor=3.0):
    """Whether A, lambda and Phi^2 are within a number of standard errors of the true values."""
    return [
        abs(getattr(scan.measures, name) - getattr(TRUE, name))
        <= factor * getattr(scan, f"{name}_error")
        for name in ("amplitude", "wavelength", "phi_squared")
    ]


def test_a_clean_scan_is_measured_to_a_thousandth():
    scan = measure_scan(Y, wrinkle(Y))
    assert scan.wrinkled
    assert scan.left_out == 0
    assert scan.measures.amplitude == pytest.approx(TRUE.amplitude, rel=2e-3)
    assert scan.measures.wavelength == pytest.approx(TRUE.wavelength, rel=2e-3)
    assert scan.measures.phi_squared == pytest.approx(TRUE.phi_squared, rel=5e-3)


@pytest.mark.parametrize("seed", range(3))
def test_noise_tilt_gaps_spikes_and_ripple_are_covered_by_the_errors(seed):
    rng = np.random.default_rng(seed)
    z = wrinkle(Y) + 2.0 + 0.01 * Y + 0.02 * rng.standard_normal(len(Y))
    z += 0.03 * np.sin(2.0 * np.pi * Y / 1.9)
    z = np.round(z, 2)
    z[rng.integers(0, len(Y), 30)] = np.nan
    z[rng.integers(0, len(Y), 5)] += 3.0
    z[300:306] = -9999.0
    scan = measure_scan(Y, z)
    assert scan.wrinkled
    assert 35 <= scan.left_out <= 55
    assert all(within(scan))
    assert 0.015 < scan.noise < 0.05
    assert scan.amplitude_error < 0.15 * HEIGHT


def test_errors_grow_with_the_noise():
    rng = np.random.default_rng(0)
    noise = rng.standard_normal(len(Y))
    quiet, loud = (measure_scan(Y, wrinkle(Y) + s * noise) for s in (0.01, 0.04))
    ratio = loud.amplitude_error / quiet.amplitude_error
    assert 2.5 < ratio < 6.0


def test_noise_alone_is_no_wrinkle():
    rng = np.random.default_rng(1)
    scans = [measure_scan(Y, 0.05 * rng.standard_normal(len(Y)), seed=k) for k in range(5)]
    assert not any(scan.wrinkled for scan in scans)
    assert {scan.reason for scan in scans} == {"nothing stands out of the noise"}


def test_too_few_points_for_a_wavelength_are_said():
    y = Y[::18]
    scan = measure_scan(y, wrinkle(y))
    assert (scan.wrinkled, scan.measures) == (False, None)
    assert "points per wavelength; at least 8 are needed" in scan.reason


def test_a_gap_in_the_middle_is_said():
    z = wrinkle(Y)
    z[np.abs(Y - 3.0) < 3.0] = np.nan
    scan = measure_scan(Y, z)
    assert scan.measures is None
    assert scan.reason.startswith(("a gap of 6", "a gap of 7"))


def test_the_line_is_that_of_the_flat_part():
    """An odd wrinkle has a slope of its own, which least squares would take for tilt."""
    offset, tilt = robust_line(Y, wrinkle(Y) + 0.7 - 0.004 * Y)
    assert tilt == pytest.approx(-0.004, abs=2e-5)
    assert offset == pytest.approx(0.7, abs=1e-3)


def test_quantised_points_are_no_spikes():
    assert usable(np.round(wrinkle(Y), 2)).all()


def test_the_periodogram_finds_the_wavelength_between_gaps():
    keep = np.ones(len(Y), dtype=bool)
    keep[100:160] = keep[600:640] = False
    found, alarm = dominant_wavelength(Y[keep], wrinkle(Y[keep]) + 1.0 + 0.02 * Y[keep])
    assert found == pytest.approx(WAVELENGTH, rel=0.08)
    assert alarm < 1e-9


def test_the_same_scan_gives_the_same_errors():
    first, second = (measure_scan(Y, wrinkle(Y)) for _ in range(2))
    assert first.amplitude_error == second.amplitude_error
