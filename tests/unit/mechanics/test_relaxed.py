"""The relaxed energy: its derivatives in each region, its bounds, its convexity."""

import numpy as np
import pytest

from wrinklestudy.mechanics.laws import (
    LAWS,
    mooney_rivlin,
    neo_hookean,
    ogden,
    saint_venant_kirchhoff,
    yeoh,
)
from wrinklestudy.mechanics.relaxed import RelaxedLaw, principal_stretches

MATERIALS = {
    "mooney-rivlin": mooney_rivlin(6.21e4, 1.58e5).law,
    "neo-hookean": neo_hookean(1.8e5).law,
    "svk": saint_venant_kirchhoff(1.3e6, 0.3).law,
    "yeoh": yeoh(2.0e5, -4.0e3, 5.0e2).law,
    "ogden": ogden(6.3e5, 1.3, -1.0e4, -2.0).law,
}
LARGER = np.linspace(1.08, 1.4, 7)
ANGLES = np.array([0.0, 0.3, 1.1, 1.5])


def metric_of(larger, smaller, angle):
    """The metric with these principal stretches, the larger at an angle from x."""
    a, b = np.asarray(larger) ** 2, np.asarray(smaller) ** 2
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([a * c * c + b * s * s, a * s * s + b * c * c, (a - b) * c * s])


def metrics(law, region):
    """Metrics well within a region, (3, angles, stretches, 3)."""
    larger, part, angle = LARGER[:, None], np.array([0.6, 0.75, 0.9]), ANGLES[:, None, None]
    natural = law.natural_width(larger)
    if region == "taut":
        smaller = natural + part * (larger - natural)
    elif region == "wrinkled":
        smaller = part * natural
    else:
        larger, smaller = larger - 0.45, part * (larger - 0.45)
    return metric_of(*np.broadcast_arrays(larger, smaller, angle))


def difference(function, metric):
    """Derivative by the metric, first axis, from sixth-order central differences."""
    step, slopes = 2e-3, []
    for k in range(3):
        direction = step * np.eye(3)[k].reshape(3, *[1] * (metric.ndim - 1))
        slopes.append(
            sum(
                weight * (function(metric + m * direction) - function(metric - m * direction))
                for m, weight in ((1, 45.0), (2, -9.0), (3, 1.0))
            )
            / (60.0 * step)
        )
    return np.stack(slopes)


def test_every_law_is_tested():
    """All but those whose strain is no metric: `tension_field.solve` refuses them."""
    finite = {name for name, law in LAWS.items() if not law.linear_in_plane}
    assert MATERIALS.keys() == finite


@pytest.mark.parametrize("remainder", [0.0, 0.1])
@pytest.mark.parametrize("region", ["taut", "wrinkled", "slack"])
@pytest.mark.parametrize("law", MATERIALS.values(), ids=MATERIALS)
def test_derivatives_are_those_of_the_energy(law, region, remainder):
    relaxed, metric = RelaxedLaw(law, remainder), metrics(law, region)
    regions = relaxed.regions(principal_stretches(metric))
    assert regions.wrinkled.all() == regions.wrinkled.any() == (region == "wrinkled")
    assert regions.slack.all() == regions.slack.any() == (region == "slack")
    stress, tangent = relaxed.derivatives(metric)
    np.testing.assert_allclose(stress, difference(relaxed.energy, metric), rtol=1e-6, atol=1e-8)
    expected = difference(lambda g: relaxed.derivatives(g)[0], metric)
    np.testing.assert_allclose(tangent, expected, rtol=1e-5, atol=1e-6 * np.abs(tangent).max())


@pytest.mark.parametrize("law", MATERIALS.values(), ids=MATERIALS)
def test_wrinkles_can_only_lower_the_energy(law):
    relaxed = RelaxedLaw(law)
    for region in ("wrinkled", "slack"):
        metric = metrics(law, region)
        assert np.all(relaxed.energy(metric) < law.energy(metric))
        assert np.all(relaxed.energy(metric) >= 0.0)
    taut = metrics(law, "taut")
    np.testing.assert_array_equal(relaxed.energy(taut), law.energy(taut))
    assert not np.any(relaxed.energy(metrics(law, "slack")))


@pytest.mark.parametrize("law", MATERIALS.values(), ids=MATERIALS)
def test_a_wrinkled_sheet_is_under_uniaxial_tension(law):
    """Stress along the fibre is that at the natural width; none across it and no shear."""
    metric = metrics(law, "wrinkled")
    stress = RelaxedLaw(law).derivatives(metric)[0]
    c, s = np.cos(ANGLES)[:, None, None], np.sin(ANGLES)[:, None, None]
    # dW/dg is the stress for work over (dg11, dg22, dg12), so that its shear counts twice
    along = c * c * stress[0] + s * s * stress[1] + c * s * stress[2]
    across = s * s * stress[0] + c * c * stress[1] - c * s * stress[2]
    shear = c * s * (stress[1] - stress[0]) + 0.5 * (c * c - s * s) * stress[2]
    natural = metric_of(LARGER, law.natural_width(LARGER), 0.0)
    uniaxial = np.broadcast_to(law.derivatives(natural)[0][0][:, None], along.shape)
    assert np.all(along > 0.0)
    np.testing.assert_allclose(along, uniaxial, rtol=1e-12)
    np.testing.assert_allclose(across, 0.0, atol=1e-14)
    np.testing.assert_allclose(shear, 0.0, atol=1e-14)


@pytest.mark.parametrize("law", MATERIALS.values(), ids=MATERIALS)
def test_the_energy_is_convex_in_each_stretch_as_the_law_itself_is_not(law):
    """Along one stretch the deformation changes by a rank-one matrix: the relaxed energy is convex.

    The derivative by a stretch does not fall, through slack, wrinkled and taut regions, and is
    nowhere negative: such a sheet bears no compression.
    """
    stretches, held = np.linspace(0.4, 1.4, 201), np.array([0.7, 0.95, 1.02, 1.2, 1.35])
    metric = metric_of(*np.meshgrid(stretches, held, indexing="ij"), 0.0)
    slope = 2.0 * stretches[:, None] * RelaxedLaw(law).derivatives(metric)[0][0]
    assert np.all(np.diff(slope, axis=0) > -1e-13)
    assert slope.min() > -1e-14
    assert law.derivatives(metric)[0][0].min() < -0.1


def test_the_remainder_one_is_the_law_itself():
    law = MATERIALS["mooney-rivlin"]
    for region in ("taut", "wrinkled", "slack"):
        metric = metrics(law, region)
        whole = RelaxedLaw(law, 1.0)
        np.testing.assert_allclose(whole.energy(metric), law.energy(metric), rtol=1e-14)
        for found, expected in zip(whole.derivatives(metric), law.derivatives(metric), strict=True):
            np.testing.assert_allclose(found, expected, rtol=1e-14)
