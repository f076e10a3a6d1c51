"""The critical mode at points of the sheet."""

import numpy as np
import pytest

from wrinklestudy import MeshSettings, Sheet, neo_hookean
from wrinklestudy.equilibrium.critical_shape import WrinkleMode
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space


@pytest.mark.parametrize(("parity", "sign"), [("antisymmetric", -1.0), ("symmetric", 1.0)])
def test_a_cubic_is_evaluated_exactly_and_mirrored(parity, sign):
    """A Hermite field holds x^2 y exactly; its largest value, at the corner, becomes 1."""
    space = Space(Grid(np.array([0.0, 0.3, 1.0]), np.array([0.0, 0.2, 0.5])))
    x, y = space.grid.x[:, None], space.grid.y[None, :]
    nodes = np.stack([x**2 * y, 2 * x * y, x**2 + 0 * y, 2 * x + 0 * y])
    symmetry = Symmetry.mirrored(parity)
    mode = WrinkleMode.scaled(0.1, space, -3.0 * space.field_from_nodes(nodes), symmetry)
    x, y = np.array([[0.1], [-0.7], [1.0]]), np.array([0.05, 0.33, 0.5])
    exact = x**2 * y / 0.5
    np.testing.assert_allclose(mode.deflection(x, y), exact, rtol=1e-13)
    np.testing.assert_allclose(mode.deflection(x, -y), sign * exact, rtol=1e-13)
    assert mode.deflection(1.0, 0.5) == pytest.approx(1.0, rel=1e-13)


@pytest.fixture(scope="module")
def sheet():
    return Sheet(2, 1e-3, neo_hookean(0.5), mesh=MeshSettings(12, 18))


def test_the_mode_of_a_sheet_has_the_thickness_of_its_stability(sheet):
    stability = sheet.stability()
    mode = sheet.mode(stability.birth_strain)
    assert mode.critical_thickness == pytest.approx(1e-3, rel=1e-4)
    x, y = np.linspace(0, 1, 301)[:, None], np.linspace(0, 0.5, 601)
    values = mode.deflection(x, y)
    assert values.max() == pytest.approx(1.0, abs=1e-4)
    assert np.abs(values).max() <= 1.0 + 1e-12
    np.testing.assert_allclose(mode.deflection([-1.0, 1.0], 0.2), 0.0, atol=1e-14)


def test_points_outside_the_sheet_are_refused_in_one_line(sheet):
    mode = sheet.mode(0.1)
    with pytest.raises(
        ValueError, match=r"^y = -0.6: must be >= -0.5 and <= 0.5 \(in units of W\)"
    ):
        mode.deflection(0.0, [0.1, -0.6])
    with pytest.raises(ValueError, match=r"^x = 1.1: must be >= -1 and <= 1"):
        mode.deflection(1.1, 0.0)
    with pytest.raises(ValueError, match=r"^strain = 0: must be"):
        sheet.mode(0.0)


def test_no_mode_where_no_thickness_wrinkles(sheet):
    with pytest.raises(ArithmeticError, match=r"^strain 0.9: wrinkles at no thickness"):
        sheet.mode(0.9)
