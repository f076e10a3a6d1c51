"""Series are told apart by eyes without one kind of cones."""

from itertools import combinations

import numpy as np
import pytest
from matplotlib.colors import to_rgb

from wrinklestudy.study.figures import style

# What people without L or M cones see, in linear RGB: G. M. Machado, M. M. Oliveira,
# L. A. F. Fernandes,
# IEEE Trans. Vis. Comput. Graph. 15, 1291 (2009), severity 1.0.
SEEN = {
    "normal": np.eye(3),
    "protanopia": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    "deuteranopia": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
}
# linear sRGB to XYZ over the white of D65 (IEC 61966-2-1)
XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
XYZ = XYZ / XYZ.sum(axis=1, keepdims=True)


def lab(colour, vision):
    """CIELAB coordinates of a colour as it is seen."""
    rgb = np.array(to_rgb(colour))
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    x, y, z = XYZ @ np.clip(np.asarray(SEEN[vision]) @ linear, 0.0, 1.0)
    f = [c ** (1 / 3) if c > (6 / 29) ** 3 else c / (3 * (6 / 29) ** 2) + 4 / 29 for c in (x, y, z)]
    return np.array([116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])])


def test_the_simulations_keep_grey_and_merge_red_with_green():
    for vision in SEEN:
        assert np.abs(lab("#808080", vision) - lab("#808080", "normal")).max() < 0.5
    confused = ("#b02020", "#4d6600")  # dark red, olive
    distance = {v: np.linalg.norm(lab(confused[0], v) - lab(confused[1], v)) for v in SEEN}
    assert distance["deuteranopia"] < 0.5 * distance["normal"]


@pytest.mark.parametrize("vision", SEEN)
def test_any_two_colours_of_the_palette_differ(vision):
    """By 10 in CIELAB, several times a difference that is just seen (about 2.3)."""
    looks = [look.color for look in style._CYCLE]
    for one, other in combinations(looks, 2):
        assert np.linalg.norm(lab(one, vision) - lab(other, vision)) > 10.0, (one, other)


@pytest.mark.parametrize("vision", SEEN)
def test_an_ordered_series_runs_from_dark_to_light(vision):
    lightness = [lab(look.color, vision)[0] for look in style.ordered(7)]
    assert np.diff(lightness).min() > 3.0


def test_colour_is_never_all_that_tells_two_series_apart():
    looks = {(look.marker, look.line) for look in style._CYCLE}
    assert len(looks) == len(style._CYCLE)
