"""The plate energy: exact derivatives, objectivity and bending stiffness of a stretched strip."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from wrinklestudy.mechanics import membrane, plate
from wrinklestudy.mechanics.bending import BENDING_LAWS
from wrinklestudy.mechanics.laws import (
    mooney_rivlin,
    neo_hookean,
    ogden,
    saint_venant_kirchhoff,
    yeoh,
)
from wrinklestudy.mechanics.section import Section

LAWS = {
    "mooney-rivlin": mooney_rivlin(6.21e4, 1.58e5).law,
    "neo-hookean": neo_hookean(1.0).law,
    "svk": saint_venant_kirchhoff(1.0, 0.4).law,
    "yeoh": yeoh(2.0e5, -2.0e4, 4.0e3).law,
    "ogden": ogden(6.3e5, 1.3, -1.0e4, -2.0).law,
}
CASES = [(law, bending) for law in LAWS.values() for bending in BENDING_LAWS]
IDS = [f"{law}-{bending}" for law in LAWS for bending in BENDING_LAWS]


def state(seed, size=0.25):
    """A point with large stretch, rotation and curvature, shape (5, 3, 1)."""
    values = np.zeros((5, 3))
    values[0, 0], values[1, 1] = 1.2, 0.9
    values += size * np.random.default_rng(seed).standard_normal((5, 3))
    return values[..., None]


def gradient(section, values):
    return plate.gradient(*plate.respond(section, values))


def difference(function, values, step=1e-3):
    """Sixth-order central differences of a function of (5, 3, 1) arrays."""
    rows = []
    for a in range(5):
        for i in range(3):
            unit = np.zeros_like(values)
            unit[a, i] = step
            f = [function(values + k * unit) - function(values - k * unit) for k in (1, 2, 3)]
            rows.append((45 * f[0] - 9 * f[1] + f[2]) / (60 * step))
    return np.array(rows)


@pytest.mark.parametrize(("law", "bending"), CASES, ids=IDS)
@given(seed=st.integers(0, 10**6))
@settings(max_examples=5, deadline=None)
def test_gradient_is_the_derivative_of_the_energy(law, bending, seed):
    section, values = Section(law, 0.05, bending), state(seed, 0.15)
    assume(np.isfinite(plate.energy(section, values)))  # SVK may have no thickness left
    expected = difference(lambda x: plate.energy(section, x), values).reshape(5, 3, 1)
    found = gradient(section, values)
    assert np.allclose(found, expected, atol=1e-10, rtol=1e-8)


@pytest.mark.parametrize(("law", "bending"), CASES, ids=IDS)
@given(seed=st.integers(0, 10**6))
@settings(max_examples=5, deadline=None)
def test_hessian_is_the_derivative_of_the_gradient(law, bending, seed):
    section, values = Section(law, 0.05, bending), state(seed, 0.15)
    expected = difference(lambda x: gradient(section, x), values).reshape(5, 3, 5, 3)
    assume(np.isfinite(expected).all())  # SVK may have no thickness left
    blocks = plate.hessian(*plate.respond(section, values))
    scale = np.abs(expected).max()
    pairs = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)]
    for (i, j), block in zip(pairs, blocks, strict=True):
        entries = [(a, b) for a in range(5) for b in range(a if i == j else 0, 5)]
        for row, (a, b) in zip(block, entries, strict=True):
            assert row[0] == pytest.approx(expected[a, i, b, j], abs=1e-9 * scale)


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
@pytest.mark.parametrize("bending", ["thinning", "fixed-thickness"])
def test_energy_does_not_change_with_rotation(law, bending):
    """A rotation of space turns x,a and x,ab; fvk is left out: it is tied to the direction z."""
    section, values = Section(law, 0.05, bending), state(7)
    turned = np.einsum("ij,ajp->aip", Rotation.random(rng=8).as_matrix(), values)
    assert plate.energy(section, turned) == pytest.approx(plate.energy(section, values), rel=1e-13)


@pytest.mark.parametrize("bending", BENDING_LAWS)
def test_flat_undeformed_sheet_has_no_energy_and_no_forces(bending):
    values = np.zeros((5, 3, 1))
    values[0, 0] = values[1, 1] = 1.0
    for law in LAWS.values():
        section = Section(law, 0.05, bending)
        assert plate.energy(section, values) == pytest.approx(0.0, abs=1e-17)
        assert np.allclose(gradient(section, values), 0.0, atol=1e-17)


@pytest.mark.parametrize("bending", BENDING_LAWS)
@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_bending_stiffness_of_the_undeformed_sheet(law, bending):
    """D = E t^3 / 12 (1 - nu^2) = mu t^3 / 6 (1 - nu); Poisson's ratio couples the curvatures."""
    thickness, flat = 0.02, np.array([1.0, 1.0, 0.0])[:, None]
    stiffness = Section(law, thickness, bending).derivatives(flat, 0 * flat).bending[..., 0]
    d = thickness**3 / (6 * (1 - law.poisson))
    nu = law.poisson
    expected = d * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, 2 * (1 - nu)]])
    assert np.allclose(stiffness, expected, rtol=1e-12, atol=1e-12 * d)


@pytest.mark.parametrize("stretch", [1.0, 1.2, 1.5])
def test_bending_stiffness_of_a_stretched_neo_hookean_strip(stretch):
    """Across the pull, with g = diag(l^2, 1/l), d2W/dg22^2 = mu l: (t^3/3) l lambda3^2 = t^3/3.

    Along the pull d2W/dg11^2 = mu l^-5 and (t^3/3) l^-5 lambda3^2 with lambda3^2 = 1/l; without
    thinning the factor lambda3^2 is missing.
    """
    law, thickness = LAWS["neo-hookean"], 0.01
    metric = np.array([stretch**2, 1 / stretch, 0.0])[:, None]
    for bending, squared in (("thinning", 1 / stretch), ("fixed-thickness", 1.0)):
        section = Section(law, thickness, bending)
        stiffness = section.derivatives(metric, 0 * metric).bending[..., 0] / (thickness**3 / 3)
        assert stiffness[1, 1] == pytest.approx(stretch * squared, rel=1e-12)
        assert stiffness[0, 0] == pytest.approx(stretch**-5 * squared, rel=1e-12)


@pytest.mark.parametrize("bending", BENDING_LAWS)
@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_small_deflections_of_a_flat_state(law, bending):
    """t S + t^3 B is the part of the full Hessian that belongs to the deflection."""
    values, thickness = state(11), 0.03
    values[:, 2] = 0.0
    stress, bent = plate.deflection(law, bending, values)
    section = Section(law, thickness, bending)
    full = plate.hessian(*plate.respond(section, values))
    assert np.allclose(full[5], thickness * stress + thickness**3 * bent, rtol=1e-10, atol=1e-15)
    assert np.allclose(full[2], 0.0, atol=1e-17)  # in-plane and deflection do not couple


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_membrane_is_the_plate_without_curvature(law):
    values, thickness = state(12), 0.03
    values[2:], values[:, 2] = 0.0, 0.0
    section = Section(law, thickness)
    full = plate.hessian(*plate.respond(section, values))
    energy, slope, blocks = membrane.expansion(law, values[:2, :2])
    assert thickness * energy == pytest.approx(plate.energy(section, values), rel=1e-13)
    assert np.allclose(thickness * slope, gradient(section, values)[:2, :2], rtol=1e-12)
    rows5 = {True: [0, 1, 5], False: [0, 1, 5, 6]}  # the membrane's rows among those of the plate
    for block, pair, same in ((blocks[0], 0, True), (blocks[1], 1, False), (blocks[2], 3, True)):
        assert np.allclose(thickness * block, full[pair][rows5[same]], rtol=1e-12)


def test_refuses_an_unknown_bending_law():
    with pytest.raises(ValueError, match="bending = 'thin': must be one of thinning"):
        Section(LAWS["svk"], 0.01, "thin")


@pytest.mark.parametrize(("law", "bending"), CASES, ids=IDS)
def test_predicted_force_and_moment_are_right_to_first_order(law, bending):
    """Their error falls with the square of the step."""
    section, values = Section(law, 0.05, bending), state(3, 0.15)
    step = 1e-3 * np.random.default_rng(4).standard_normal(values.shape)

    errors = []
    for part in (step, 0.5 * step):
        force, moment = plate.predict(*plate.respond(section, values), part)
        exact = plate.respond(section, values + part)[1]
        error = [force - exact.force, (moment - exact.moment) / section.thickness]
        errors.append(np.concatenate(error).ravel())
    norms = [np.linalg.norm(error) for error in errors]
    assert norms[0] / norms[1] == pytest.approx(4.0, rel=0.02)
