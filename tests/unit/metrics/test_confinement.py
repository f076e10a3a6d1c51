"""What is measured on tension fields, on fields that are made by hand."""

import math

import numpy as np
import pytest
from closed_forms import mooney_rivlin_basis

from wrinklestudy.equilibrium.tension_field import TensionField
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.metrics.confinement import confined_widths, confinement, sample

LAW = mooney_rivlin(6.21e4, 1.58e5).law
SPACE = Space(make_grid(2.0, settings=MeshSettings(6, 10)))
STRETCH = 1.2
NATURAL = STRETCH**-0.5  # of an incompressible law


def field_of(nodes):
    """The tension field whose position has these values and derivatives at the nodes."""
    position = SPACE.field_from_nodes(nodes)
    return TensionField(SPACE, LAW, STRETCH - 1.0, "", position, 0.0, 0.0, 0.0, ())


def affine(gradient):
    """The field of a homogeneous deformation with a gradient, (2, 2)."""
    x, y = np.meshgrid(SPACE.grid.x, SPACE.grid.y, indexing="ij")
    nodes = np.zeros((2, 4, *x.shape))
    for component, (along, across) in enumerate(gradient):
        nodes[component, 0] = along * x + across * y
        nodes[component, 1], nodes[component, 2] = along, across
    return field_of(nodes)


def narrow_in_the_middle(least, bend):
    """The field x = lambda X, y = least Y + bend Y^3/3: its width stretch is least + bend Y^2."""
    x, y = np.meshgrid(SPACE.grid.x, SPACE.grid.y, indexing="ij")
    nodes = np.zeros((2, 4, *x.shape))
    nodes[0, 0], nodes[0, 1] = STRETCH * x, STRETCH
    nodes[1, 0], nodes[1, 2] = least * y + bend * y**3 / 3.0, least + bend * y**2
    return field_of(nodes)


def test_a_sheet_that_is_too_narrow_throughout_hides_what_it_lacks():
    width = 0.85
    measured = confinement(affine(np.diag([STRETCH, width])))
    assert measured.arc_width == pytest.approx(NATURAL, rel=1e-12)
    assert measured.projected_width == pytest.approx(width, rel=1e-12)
    for value in (measured.phi_squared, measured.phi_squared_central):
        assert value == pytest.approx(NATURAL / width - 1.0, rel=1e-10)
    assert measured.wrinkled_width == pytest.approx(1.0)
    assert measured.wrinkled_length_over_length == pytest.approx(1.0)


def test_a_sheet_that_is_wide_enough_hides_nothing():
    measured = confinement(affine(np.diag([STRETCH, 0.95])))
    assert measured.arc_width == measured.projected_width == pytest.approx(0.95, rel=1e-12)
    assert measured.phi_squared == measured.phi_squared_central == 0.0
    assert measured.wrinkled_width == measured.wrinkled_length_over_length == 0.0


def test_hidden_width_and_region_of_a_sheet_that_is_wrinkled_in_the_middle():
    """Wrinkled where least + bend Y^2 < n, |Y| < end; hidden is the integral of n less that."""
    least, bend = 0.88, 0.8
    field = narrow_in_the_middle(least, bend)
    end = math.sqrt((NATURAL - least) / bend)
    assert end < 0.4
    hidden = 2.0 * ((NATURAL - least) * end - bend * end**3 / 3.0)
    projected = 2.0 * (0.5 * least + bend * 0.5**3 / 3.0)
    x = np.array([0.0, 0.4, 0.9])
    arc, found = confined_widths(field, x)
    np.testing.assert_allclose(found, projected, rtol=1e-6)
    np.testing.assert_allclose(arc - found, hidden, rtol=1e-4)
    measured = confinement(field)
    assert measured.phi_squared == pytest.approx(hidden / projected, rel=1e-4)
    assert measured.phi_squared_central == pytest.approx(NATURAL / least - 1.0, rel=1e-10)
    # the end is where the excess has fallen to a twentieth of its largest
    excess = 0.05 * (NATURAL / least - 1.0)
    counted = 2.0 * math.sqrt((NATURAL / (1.0 + excess) - least) / bend)
    assert measured.wrinkled_width == pytest.approx(counted, abs=2.0 / 50 / 10)
    assert counted == pytest.approx(2.0 * end, rel=0.03)


@pytest.mark.parametrize("angle", [-1.2, -0.3, 0.0, 0.4, 1.5])
def test_fibres_have_the_direction_of_the_larger_stretch_in_the_undeformed_sheet(angle):
    """Whatever rotation follows the stretch."""
    c, s = math.cos(angle), math.sin(angle)
    axes = np.array([[c, -s], [s, c]])
    turn = np.array([[math.cos(0.7), -math.sin(0.7)], [math.sin(0.7), math.cos(0.7)]])
    field = affine(turn @ axes @ np.diag([STRETCH, 0.8]) @ axes.T)
    points = sample(field, np.array([0.1, 0.7]), np.array([0.0, 0.2, 0.4]))
    assert points.wrinkled.all()
    np.testing.assert_allclose(points.direction, angle, atol=1e-10)


@pytest.mark.parametrize("width", [0.6, 0.8, 0.9])
def test_the_tension_of_a_fibre_is_that_of_uniaxial_tension(width):
    """However much the sheet is gathered across it."""
    field = affine(np.diag([STRETCH, width]))
    points = sample(field, np.array([0.3]), np.array([0.1, 0.45]))
    expected = mooney_rivlin_basis(STRETCH) @ [LAW.c10, LAW.c01]
    np.testing.assert_allclose(points.tension, expected, rtol=1e-12)


def test_a_taut_sheet_pulls_along_the_larger_stretch_as_its_law_says():
    """In pure shear T = 2 (lambda - lambda^-3) (C10 + C01)."""
    points = sample(affine(np.diag([STRETCH, 1.0])), np.array([0.3]), np.array([0.1]))
    expected = mooney_rivlin_basis(STRETCH, "shear") @ [LAW.c10, LAW.c01]
    np.testing.assert_allclose(points.tension, expected, rtol=1e-12)
    assert not points.wrinkled.any()


def test_a_sheet_that_is_shorter_in_both_directions_is_slack():
    points = sample(affine(np.diag([0.95, 0.9])), np.array([0.3]), np.array([0.1]))
    assert points.slack.all()
    assert not points.wrinkled.any()
