"""Stretches, stresses and bending energy of deformations with closed forms."""

import numpy as np
import pytest

from wrinklestudy import MeshSettings, Sheet, foppl_von_karman, mooney_rivlin
from wrinklestudy.fem.boundary import NO_MIRRORS
from wrinklestudy.fem.grid import Grid
from wrinklestudy.material.homogeneous import dimensionless_stress
from wrinklestudy.mechanics.bending import BENDING_LAWS
from wrinklestudy.mechanics.section import Section
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.stress import sampled_stress

MATERIAL = mooney_rivlin(6.21e4, 1.58e5)
GRID = Grid(np.linspace(-1.0, 1.0, 5), np.linspace(-0.5, 0.5, 4))


def affine(gradient):
    """The sheet with x = F X."""
    nodes = np.zeros((3, 4, len(GRID.x), len(GRID.y)))
    gradient = np.asarray(gradient, dtype=float)
    nodes[:, 0] = gradient[:, 0, None, None] * GRID.x[:, None] + gradient[:, 1, None, None] * GRID.y
    nodes[:, 1], nodes[:, 2] = gradient[:, 0, None, None], gradient[:, 1, None, None]
    return DeformedSheet(GRID, nodes, NO_MIRRORS)


def sampled(sheet, bending="thinning", thickness=1e-3):
    return sampled_stress(sheet, Section(MATERIAL.law, thickness, bending), (2, 3))


def test_a_uniform_stretch_has_its_stretches_and_the_stress_of_the_test_machine():
    """Under uniaxial tension the Cauchy stress is the stretch times the nominal stress."""
    stretch = 1.3
    fields = sampled(affine([[stretch, 0], [0, stretch**-0.5], [0, 0]]))
    np.testing.assert_allclose(fields.principal_stretches[0], stretch, rtol=1e-12)
    np.testing.assert_allclose(fields.principal_stretches[1], stretch**-0.5, rtol=1e-12)
    np.testing.assert_allclose(fields.thickness_stretch, stretch**-0.5, rtol=1e-12)
    (nominal,) = dimensionless_stress(MATERIAL.law, np.array([stretch]), np.array(["uniaxial"]))
    np.testing.assert_allclose(fields.cauchy[0], stretch * nominal, rtol=1e-12)
    np.testing.assert_allclose(fields.cauchy[1:], 0.0, atol=1e-14)
    np.testing.assert_allclose(fields.bending_energy, 0.0, atol=1e-12)


def test_a_simple_shear_has_the_shear_stress_of_its_amount():
    """For I1 and I2 laws in simple shear sigma_xy = 2 (W1 + W2) k = mu k, here mu = 1."""
    amount = 0.4
    fields = sampled(affine([[1.0, amount], [0.0, 1.0], [0.0, 0.0]]))
    np.testing.assert_allclose(fields.cauchy[2], amount, rtol=1e-12)
    product = fields.principal_stretches.prod(axis=0)
    np.testing.assert_allclose(product, 1.0, rtol=1e-12)


def test_a_turned_sheet_has_the_same_stresses():
    turn = np.linalg.qr(np.random.default_rng(3).standard_normal((3, 3)))[0]
    gradient = np.array([[1.2, 0.3], [0.1, 0.9], [0.0, 0.0]])
    here, there = sampled(affine(gradient)), sampled(affine(turn @ gradient))
    np.testing.assert_allclose(there.cauchy, here.cauchy, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(there.principal_cauchy, here.principal_cauchy, rtol=1e-12)
    trace = here.cauchy[0] + here.cauchy[1]
    np.testing.assert_allclose(here.principal_cauchy.sum(axis=0), trace, rtol=1e-12)


@pytest.mark.parametrize("bending", BENDING_LAWS)
def test_a_weak_curvature_has_the_energy_of_a_plate(bending):
    """E t^2 k^2 / 24 (1 - nu^2) per volume: with mu = 1 and nu = 1/2 it is t^2 k^2 / 6."""
    curvature, thickness = 0.02, 0.01
    nodes = affine([[1, 0], [0, 1], [0, 0]]).nodes
    nodes[2, 0], nodes[2, 2] = 0.5 * curvature * GRID.y**2, curvature * GRID.y
    fields = sampled(DeformedSheet(GRID, nodes, NO_MIRRORS), bending, thickness)
    middle = fields.bending_energy[:, len(fields.reference_y) // 2]
    np.testing.assert_allclose(middle, thickness**2 * curvature**2 / 6.0, rtol=1e-3)


def test_a_long_flat_sheet_is_in_uniaxial_tension_in_its_middle():
    sheet = Sheet(8.0, 0.04, MATERIAL, mesh=MeshSettings(8, 10))
    state = sheet.solve(0.3)
    fields = sampled(state.shape, thickness=0.04)
    middle = len(fields.reference_x) // 2
    nominal = state.equilibrium.nominal_stress
    stretch = fields.principal_stretches[0, middle]
    np.testing.assert_allclose(fields.cauchy[0, middle], stretch * nominal, rtol=1e-3)
    np.testing.assert_allclose(fields.cauchy[1:, middle], 0.0, atol=1e-3 * nominal)
    # the mirrors of the sheet are those of the fields
    for field in (fields.cauchy[0], fields.bending_energy, fields.thickness_stretch):
        np.testing.assert_allclose(field, field[::-1], rtol=1e-9, atol=1e-13)
        np.testing.assert_allclose(field, field[:, ::-1], rtol=1e-9, atol=1e-13)


def test_a_linear_strain_has_stretches_and_stresses_of_hooke():
    """At any strain lambda = 1 + E and, in uniaxial tension, sigma = Y E with Y = 2 (1 + nu) mu."""
    nu, strain = 0.3, 0.4
    section = Section(foppl_von_karman(1.0e6, nu).law, 1e-3, "fvk")
    sheet = affine([[1.0 + strain, 0.2], [0.0, 1.0 - nu * strain], [0.0, 0.0]])
    fields = sampled_stress(sheet, section, (2, 3))
    np.testing.assert_allclose(fields.cauchy[0], 2.0 * (1.0 + nu) * strain, rtol=1e-12)
    np.testing.assert_allclose(fields.cauchy[1], 0.0, atol=1e-12)
    np.testing.assert_allclose(fields.cauchy[2], 0.2, rtol=1e-12)  # mu gamma
    mean = 1.0 + 0.5 * (1.0 - nu) * strain
    np.testing.assert_allclose(fields.principal_stretches.mean(axis=0), mean, rtol=1e-12)
    radius = np.hypot(0.5 * (1.0 + nu) * strain, 0.1)
    np.testing.assert_allclose(fields.principal_stretches[0], mean + radius, rtol=1e-12)
