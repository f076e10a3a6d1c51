"""What the page keeps of a shape is the shape, to what the eye and the table see."""

from base64 import b64decode

import numpy as np
import pytest

from wrinklestudy.explorer.sampling import PROFILE_POINTS, SAMPLES, packed_shape
from wrinklestudy.metrics.profile import profile_from_state


def table_of(packed):
    whole = np.frombuffer(b64decode(packed["whole"]), dtype="<i2").reshape(packed["shape"])
    return packed["step"] * whole


def singles(packed):
    return np.frombuffer(b64decode(packed["single"]), dtype="<f4")


@pytest.mark.parametrize("samples", SAMPLES)
def test_heights_are_those_of_the_interpolant_to_a_step_of_16_bits(made_up, samples):
    shape = made_up().shape(0.1)
    packed = packed_shape(shape, False, samples)["height"][0]
    x, y = np.linspace(0.0, 1.0, samples.along), np.linspace(0.0, 0.5, samples.across)
    exact = shape.evaluate(x, y)[2]
    assert np.abs(exact).max() > 0.0
    np.testing.assert_allclose(table_of(packed), exact, atol=np.abs(exact).max() / 65000)
    assert len(packed["whole"]) == samples.letters


def test_the_profile_is_half_of_the_mid_line(made_up):
    shape = made_up().shape(0.1)
    y, z = map(singles, packed_shape(shape, False, SAMPLES[0])["profile"])
    whole = profile_from_state(shape)
    assert len(y) == PROFILE_POINTS
    assert (y[0], y[-1]) == pytest.approx((0.0, whole.y[-1]), abs=1e-7)
    np.testing.assert_allclose(z, np.interp(y, whole.y, whole.z), atol=1e-3 * np.ptp(whole.z))


def test_a_flat_state_keeps_no_heights(made_up):
    shape = made_up().shape(0.1)  # what is left of a seed
    packed = packed_shape(shape, True, SAMPLES[0])
    assert "height" not in packed
    assert not singles(packed["profile"][1]).any()


def test_x_and_y_of_the_quarter_are_kept(made_up):
    x, y = map(table_of, packed_shape(made_up().shape(0.1), False, SAMPLES[0])["plane"])
    assert (x[0, 0], x[-1, -1]) == pytest.approx((0.0, 1.1))
    assert y[-1, -1] == pytest.approx(0.5 * 1.1**-0.5, rel=1e-4)
