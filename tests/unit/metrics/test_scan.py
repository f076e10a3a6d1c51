"""Scans with noise, gaps, spikes, tilt and ripple: the true values within the stated errors."""

import numpy as np
import pytest

from wrinklestudy.metrics.measure import measure
from wrinklestudy.metrics.profile import Profile
from wrinklestudy.metrics.scan import measure_scan
from wrinklestudy.metrics.scan_points import usable, waves
from wrinklestudy.metrics.smoothing import robust_weights, weighted_line

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
    assert 36 <= scan.left_out <= 50
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
    # what hides in the noise is in the error
    assert all(0.0 < scan.amplitude_error < 0.05 for scan in scans)
    assert all(scan.measures.amplitude == 0.0 for scan in scans)


def test_too_few_points_for_a_wavelength_are_said():
    y = Y[::18]
    scan = measure_scan(y, wrinkle(y))
    assert (scan.wrinkled, scan.measures) == (False, None)
    assert "points per wavelength; at least 10 are needed" in scan.reason


@pytest.mark.parametrize("every", [15, 20, 30, 40])
def test_points_too_few_to_show_a_wave_do_not_tell_that_there_is_none(every):
    scan = measure_scan(Y[::every], wrinkle(Y[::every]))
    assert scan.measures is None
    assert "are needed" in scan.reason


def test_a_gap_in_the_middle_is_said():
    z = wrinkle(Y)
    z[np.abs(Y - 3.0) < 3.0] = np.nan
    scan = measure_scan(Y, z)
    assert scan.measures is None
    assert scan.reason.startswith(("a gap of 6", "a gap of 7"))


def test_the_line_is_that_of_the_flat_part():
    """An odd wrinkle has a slope of its own, which least squares would take for tilt."""
    z = wrinkle(Y) + 0.7 - 0.004 * Y
    offset, tilt = weighted_line(Y, robust_weights(Y, z)) @ z
    assert tilt == pytest.approx(-0.004, abs=2e-5)
    assert offset == pytest.approx(0.7, abs=1e-3)


def test_quantised_points_are_no_spikes():
    assert usable(np.round(wrinkle(Y), 2)).all()


def test_the_periodogram_finds_the_wavelength_between_gaps():
    keep = np.ones(len(Y), dtype=bool)
    keep[100:160] = keep[600:640] = False
    found = waves(Y[keep], wrinkle(Y[keep]) + 1.0 + 0.02 * Y[keep])
    assert found.wavelength == pytest.approx(WAVELENGTH, rel=0.08)
    assert found.alarm < 1e-9
    assert found.second.height == 0.0


def test_false_alarms_of_white_noise_are_as_rare_as_stated():
    """Of 300 scans of noise, one in ten has an alarm below 0.1, at most."""
    rng = np.random.default_rng(4)
    y = Y[::3]
    alarms = np.array([waves(y, rng.standard_normal(len(y))).alarm for _ in range(300)])
    assert np.mean(alarms < 0.1) <= 0.1
    assert np.sum(alarms < 1e-3) <= 2


@pytest.mark.parametrize("sign", [-9999.0, -100.0, 0.0, 50.0])
def test_the_sign_for_a_lost_point_is_known_by_its_distance(sign):
    """Whatever number the scanner writes, in runs that a running median does not see."""
    z = wrinkle(Y) + 3.0
    lost = np.zeros(len(Y), dtype=bool)
    lost[300:312] = lost[700:712] = True
    z[lost] = sign
    assert (usable(z) == ~lost).all()


def test_runs_of_wrong_points_near_the_profile_are_left_out():
    """Eight neighbours off by the height of the wrinkle: more than half of the running median."""
    z = wrinkle(Y) + 0.004 * np.random.default_rng(3).standard_normal(len(Y))
    z[420:428] += HEIGHT
    scan = measure_scan(Y, z)
    assert 8 <= scan.left_out <= 12
    assert not scan.used[420:428].any()
    assert all(within(scan))


def test_a_short_ripple_changes_nothing_and_a_long_one_is_covered_or_refused():
    """The spline follows nothing shorter than a third of the wavelength."""
    for part in (0.08, 0.15, 0.25):
        ripple = 0.1 * HEIGHT * np.sin(2.0 * np.pi * Y / (part * WAVELENGTH) + 1.0)
        scan = measure_scan(Y, wrinkle(Y) + ripple)
        assert scan.measures.phi_squared == pytest.approx(TRUE.phi_squared, rel=0.03)
        assert all(within(scan))
    for part in (0.4, 0.55, 0.7, 0.9):
        for height in (0.05, 0.15):
            ripple = height * HEIGHT * np.sin(2.0 * np.pi * Y / (part * WAVELENGTH) + 1.0)
            scan = measure_scan(Y, wrinkle(Y) + ripple)
            assert scan.measures is None or all(within(scan, 2.5))


def test_two_waves_of_like_height_cannot_be_told_apart():
    scan = measure_scan(Y, wrinkle(Y) + 0.3 * HEIGHT * np.sin(2.0 * np.pi * Y / 9.0))
    assert scan.measures is None
    assert scan.reason.startswith("a second wave of wavelength")


def test_a_bow_is_covered_or_refused():
    small, large = (measure_scan(Y, wrinkle(Y) + b * (Y / 66.0) ** 2) for b in (0.04, 1.2))
    assert abs(small.measures.amplitude - TRUE.amplitude) <= 2.5 * small.amplitude_error
    assert large.measures is None
    assert "bowed" in large.reason


def test_a_scan_that_ends_in_the_wrinkles_says_so():
    inside = Y > -20.0
    scan = measure_scan(Y[inside], wrinkle(Y[inside]))
    assert scan.measures is None or "does not go from edge to edge" in scan.note
    assert not measure_scan(Y, wrinkle(Y)).note


def test_a_hump_and_a_step_have_no_wavelength():
    for z in (HEIGHT * np.exp(-((Y / 8.0) ** 2)), HEIGHT * (Y > 0.0)):
        scan = measure_scan(Y, z)
        assert scan.measures is None
        assert scan.reason.startswith("there are no two neighbouring peaks")


@pytest.mark.parametrize("value", [0.0, 3.0])
def test_a_constant_is_flat(value):
    scan = measure_scan(Y, np.full(len(Y), value))
    assert (scan.wrinkled, scan.measures.amplitude, scan.left_out) == (False, 0.0, 0)


def test_without_points_nothing_is_told():
    scan = measure_scan(Y, np.full(len(Y), np.nan))
    assert (scan.measures, scan.left_out) == (None, len(Y))
    assert scan.reason == "0 usable points; at least 20 are needed"


def test_neither_unit_nor_mirror_nor_spacing_matter():
    """In metres, seen from the other side, and at random places."""
    rng = np.random.default_rng(2)
    places = np.sort(rng.uniform(Y[0], Y[-1], 900))
    places[0], places[-1] = Y[0], Y[-1]
    noise = 0.01 * rng.standard_normal(len(Y))
    here = measure_scan(Y, wrinkle(Y) + noise)
    metres = measure_scan(1e-3 * Y, 1e-3 * (wrinkle(Y) + noise))
    mirrored = measure_scan(Y, -(wrinkle(Y) + noise)[::-1])
    for other, unit in ((metres, 1e-3), (mirrored, 1.0)):
        assert other.measures.amplitude == pytest.approx(unit * here.measures.amplitude, rel=5e-3)
        assert other.measures.phi_squared == pytest.approx(here.measures.phi_squared, rel=5e-3)
    assert metres.amplitude_error == pytest.approx(1e-3 * here.amplitude_error, rel=1e-6)
    assert all(within(measure_scan(places, wrinkle(places) + noise)))


def test_many_points_average_their_noise():
    """100 000 points at a signal-to-noise ratio of 4 tell the height to a percent."""
    y = np.linspace(Y[0], Y[-1], 100_000)
    noise = 0.1 * np.random.default_rng(6).standard_normal(len(y))
    scan = measure_scan(y, wrinkle(y) + noise)
    assert scan.noise == pytest.approx(0.1, rel=0.02)
    assert scan.amplitude_error < 0.015 * HEIGHT
    assert all(within(scan))


def test_errors_are_the_spread_of_repeated_scans():
    """Not much smaller, which would be wrong, nor three times as large, which would say nothing."""
    rng = np.random.default_rng(8)
    y = Y[::3]
    noises = 0.02 * rng.standard_normal((25, len(y)))
    scans = [measure_scan(y, wrinkle(y) + noise) for noise in noises]
    for name in ("amplitude", "wavelength", "phi_squared"):
        spread = np.std([getattr(scan.measures, name) for scan in scans])
        stated = np.median([getattr(scan, f"{name}_error") for scan in scans])
        assert 0.8 < stated / spread < 2.5


def test_the_same_scan_gives_the_same_errors():
    first, second = (measure_scan(Y, wrinkle(Y)) for _ in range(2))
    assert first.amplitude_error == second.amplitude_error
