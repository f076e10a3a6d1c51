"""Measures of profiles against closed forms, and what must not change them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import ellipeinc

from wrinklestudy.metrics.measure import measure, prominent
from wrinklestudy.metrics.profile import Profile

sinusoids = {
    "amplitude": st.floats(1e-4, 0.02),
    "wavelength": st.floats(0.06, 0.3),
    "phase": st.floats(0.0, 2.0 * np.pi),
}


def sinusoid(amplitude, wavelength, phase, width=1.0, points=4001):
    y = np.linspace(-0.5 * width, 0.5 * width, points)
    return Profile(y, amplitude * np.sin(2.0 * np.pi * y / wavelength + phase))


def wave_packet(points=3001, shift=0.0):
    """A localised antisymmetric wrinkle like the computed ones."""
    y = np.linspace(-0.47, 0.47, points) + shift
    return Profile(y, 3.1e-3 * np.sin(2.0 * np.pi * y / 0.13) * np.exp(-((y / 0.15) ** 2)))


@settings(max_examples=40, deadline=None)
@given(**sinusoids)
def test_a_sinusoid_has_the_arc_length_of_the_elliptic_integral(amplitude, wavelength, phase):
    measures = measure(sinusoid(amplitude, wavelength, phase))
    k = 2.0 * np.pi / wavelength
    slope = (amplitude * k) ** 2
    modulus = slope / (1.0 + slope)
    ends = ellipeinc(np.array([-0.5, 0.5]) * k + phase, modulus)
    exact = np.sqrt(1.0 + slope) * (ends[1] - ends[0]) / k
    assert measures.arc_width == pytest.approx(exact, rel=1e-9)
    assert measures.phi_squared == pytest.approx(exact - 1.0, rel=1e-5)
    assert measures.projected_width == 1.0


@settings(max_examples=40, deadline=None)
@given(**sinusoids)
def test_a_sinusoid_has_its_amplitude_wavelength_and_constant(amplitude, wavelength, phase):
    measures = measure(sinusoid(amplitude, wavelength, phase))
    assert measures.amplitude == pytest.approx(amplitude, rel=1e-6)
    assert measures.wavelength == pytest.approx(wavelength, rel=1e-6)
    assert measures.wavelength_zero == pytest.approx(wavelength, rel=1e-6)
    # C pi = 1 + 3 s^2/32 + O(s^4) for the largest slope s
    slope = 2.0 * np.pi * amplitude / wavelength
    excess = np.pi * measures.shape_constant_central - 1.0
    assert excess == pytest.approx(3.0 * slope**2 / 32.0, abs=0.1 * slope**4 + 1e-5)


def test_the_constant_of_a_sinusoid_tends_to_one_over_pi():
    """Whole wavelengths over the width, so that both averages are those of the sinusoid."""
    measures = measure(sinusoid(1e-5, 0.125, 0.3))
    assert measures.shape_constant == pytest.approx(1.0 / np.pi, rel=1e-5)
    assert measures.shape_constant_central == pytest.approx(1.0 / np.pi, rel=1e-5)


def test_a_localised_wrinkle_has_a_smaller_phi_over_the_full_width():
    """The averaging decides the constant: the flat margins count in one and not in the other."""
    measures = measure(wave_packet())
    assert measures.phi_squared < 0.5 * measures.phi_squared_central
    assert measures.shape_constant > 1.4 * measures.shape_constant_central


@settings(max_examples=25, deadline=None)
@given(**sinusoids)
def test_mirror_images_measure_the_same(amplitude, wavelength, phase):
    profile = sinusoid(amplitude, wavelength, phase)
    bent = Profile(profile.y, profile.z * (1.2 + np.cos(3.0 * profile.y + 0.4)))
    reference = measure(bent)
    for other in (Profile(bent.y, -bent.z), Profile(-bent.y[::-1], bent.z[::-1])):
        measures = measure(other)
        assert measures.amplitude == pytest.approx(reference.amplitude, rel=1e-9)
        assert measures.phi_squared == pytest.approx(reference.phi_squared, rel=1e-9)
        assert measures.wavelength == pytest.approx(reference.wavelength, rel=1e-7)


def test_neither_sampling_nor_position_nor_unit_matter():
    reference = measure(wave_packet())
    other = wave_packet(points=2417)
    shifted = Profile(1e3 * (other.y + 0.7), 1e3 * other.z)
    measures = measure(shifted)
    assert measures.amplitude == pytest.approx(1e3 * reference.amplitude, rel=1e-7)
    assert measures.wavelength == pytest.approx(1e3 * reference.wavelength, rel=1e-7)
    assert measures.phi_squared == pytest.approx(reference.phi_squared, rel=1e-6)
    assert measures.phi_squared_central == pytest.approx(reference.phi_squared_central, rel=1e-6)


def test_the_wavelength_is_that_of_the_central_peaks():
    """A chirp: far from the centre the peaks are at other distances."""
    y = np.linspace(-0.5, 0.5, 4001)
    measures = measure(Profile(y, 1e-3 * np.sin(2.0 * np.pi * (y / 0.12 + 0.4 * y**3 / 0.12))))
    k = int(np.searchsorted(measures.extrema, 0.0))
    assert measures.wavelength == pytest.approx(
        measures.extrema[k + 1] - measures.extrema[k - 1], rel=1e-9
    )
    assert measures.wavelength > 1.2 * (measures.extrema[2] - measures.extrema[0])


def test_a_flat_profile_has_no_wavelength():
    y = np.linspace(-0.4, 0.4, 50)
    measures = measure(Profile(y, np.full(50, 1e-12)))
    assert (measures.amplitude, measures.phi_squared, measures.phi_squared_central) == (
        0.0,
        0.0,
        0.0,
    )
    assert measures.arc_width == measures.projected_width == pytest.approx(0.8)
    assert np.isnan([measures.wavelength, measures.wavelength_zero, measures.shape_constant]).all()


def test_a_single_hump_has_an_amplitude_but_no_wavelength():
    y = np.linspace(-0.5, 0.5, 201)
    measures = measure(Profile(y, 2e-3 * np.exp(-((y / 0.1) ** 2))))
    assert measures.amplitude == pytest.approx(2e-3, rel=1e-6)
    # the integral of z'^2 / 2 over a width of 1
    assert measures.phi_squared == pytest.approx(2e-3**2 * np.sqrt(np.pi / 2) / (2 * 0.1), rel=1e-3)
    assert np.isnan(
        [measures.wavelength, measures.shape_constant, measures.phi_squared_central]
    ).all()


def test_ripples_are_not_peaks():
    """Extrema of 2% of the amplitude between the wrinkle's own are ironed out."""
    smooth = wave_packet()
    ripple = 6e-5 * np.sin(2.0 * np.pi * smooth.y / 0.011)
    measures = measure(Profile(smooth.y, smooth.z + ripple))
    assert measures.wavelength == pytest.approx(measure(smooth).wavelength, rel=0.05)


@given(st.lists(st.floats(-1.0, 1.0), min_size=2, max_size=40), st.floats(0.01, 1.0))
def test_what_stays_prominent_goes_up_and_down_by_the_threshold(steps, threshold):
    heights = np.cumsum(np.abs(steps) * (-1.0) ** np.arange(len(steps)))  # alternating
    kept = prominent(heights, threshold)
    assert kept[0] == 0
    assert kept[-1] == len(heights) - 1
    rises = np.diff(heights[kept])
    assert len(kept) == 2 or (np.abs(rises) >= threshold).all()
    assert (rises[:-1] * rises[1:] < 0.0).all()


@pytest.mark.parametrize(
    ("y", "z", "message"),
    [
        (np.arange(5.0), np.zeros(5), "5 points"),
        (np.arange(9.0), np.zeros(8), "two columns"),
        (np.arange(9.0) % 5, np.zeros(9), "increase"),
        (np.arange(9.0), np.full(9, np.nan), "finite"),
    ],
)
def test_what_is_no_profile_is_refused(y, z, message):
    with pytest.raises(ValueError, match=message):
        Profile(y, z)
