"""Clamps that are off, and an uneven thickness: where they hold, what symmetry is left."""

import numpy as np
import pytest

from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.clamps import Clamps
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.thickness import Ripple, ThicknessField, ThicknessTable
from wrinklestudy.fem.upper_triangle import symmetric
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.mechanics.section import Section

ALL = Clamps(shear=0.02, rotate=0.05, twist=0.2, pitch=0.1, lift=0.03)
UNEVEN = ThicknessField(0.1, 0.05, (Ripple(0.05, 0.4),))


def whole(clamps, unevenness=None):
    symmetry = Symmetry.of_part("whole", clamps=clamps)
    grid = symmetry.lines(make_grid(2.0, settings=MeshSettings(2, 2)))
    return symmetry, Space(grid, unevenness=unevenness or ThicknessField())


def test_perfect_clamps_hold_the_stretched_sheet():
    symmetry, space = whole(Clamps())
    position = symmetry.clamp.position(space, 0.3)
    assert np.allclose(position[0], 1.3 * space.coordinates[0])
    assert np.array_equal(position[1:], space.coordinates[1:])
    assert symmetry.clamp.slopes(space) is None


def test_ends_lie_where_the_clamps_are():
    """Each end is a straight line of length W through the middle of its clamp, turned as it is."""
    symmetry, space = whole(ALL)
    nodes = space.nodes_from_field(symmetry.clamp.position(space, 0.1))[:, 0]
    for column, side in ((0, -1), (-1, 1)):
        line = nodes[:, column]
        assert np.linalg.norm(line[:, -1] - line[:, 0]) == pytest.approx(1.0)
        middle = line[:, len(space.grid.y) // 2]
        assert np.allclose(middle, 0.5 * side * np.array([2.2, ALL.shear, ALL.lift]))
        end = ALL.end(side, 2.2)
        assert end.line @ end.normal == pytest.approx(0.0, abs=1e-15)
    left = ALL.end(-1, 2.2)
    assert np.arctan2(left.line[2], left.line[1]) == pytest.approx(-0.5 * ALL.twist)
    turned = Clamps(rotate=ALL.rotate).end(1, 2.2)
    assert np.allclose(turned.line, [-np.sin(ALL.rotate), np.cos(ALL.rotate), 0.0])


@pytest.mark.parametrize("bending", ["thinning", "fixed-thickness", "fvk"])
def test_tangent_is_the_derivative_of_the_residual_with_tied_slopes(bending):
    """The slope condition, the uneven thickness and the weight enter energy and tangent alike."""
    symmetry, space = whole(ALL, UNEVEN)
    position = symmetry.clamp.position(space, 0.1)
    problem = PlateProblem(
        space,
        Section(mooney_rivlin(6.21e4, 1.58e5).law, 0.02, bending),
        symmetry.free(space),
        position,
        slopes=symmetry.clamp.slopes(space),
        weight=0.3,
    )
    rng = np.random.default_rng(0)
    unknowns = position[problem.assembler.free]
    unknowns = unknowns + 1e-3 * rng.standard_normal(unknowns.size)
    step = rng.standard_normal(unknowns.size)
    step *= 1e-6 / np.linalg.norm(step)
    here = problem.derivatives(unknowns)
    energy = problem.energy(unknowns + step) - problem.energy(unknowns - step)
    assert energy / 2 == pytest.approx(here.residual @ step, rel=1e-5)
    change = problem.residual(unknowns + step) - problem.residual(unknowns - step)
    expected = symmetric(here.tangent) @ step
    assert np.abs(change / 2 - expected).max() < 1e-7 * np.abs(expected).max()


def test_weight_is_the_integral_of_the_thickness():
    """A sheet of mean thickness t weighs rho g t L W, however its thickness varies along."""
    symmetry, space = whole(Clamps(), ThicknessField(along=0.3))
    position = symmetry.clamp.position(space, 0.0)
    section = Section(mooney_rivlin(6.21e4, 1.58e5).law, 0.01)
    problem = PlateProblem(space, section, symmetry.free(space), position, weight=0.2)
    nodes = np.zeros((4, len(space.grid.x), len(space.grid.y)))
    nodes[0] = 1.0  # a lift of the whole sheet by W
    assert problem.load @ space.field_from_nodes(nodes) == pytest.approx(0.2 * 0.01 * 2.0)


def test_clamps_and_thickness_keep_the_symmetries_that_they_have():
    assert Clamps(shear=0.1).keep((-1, -1, 1))
    assert not Clamps(shear=0.1).keep((1, -1, 1))
    assert Clamps(twist=0.1).keep((-1, 1, -1))
    assert not Clamps(twist=0.1).keep((1, 1, -1))
    assert Clamps(pitch=0.1).keep((1, -1, 1))
    assert not Clamps(pitch=0.1).keep((-1, 1, -1))
    assert ThicknessField(along=0.1).keeps(False, True, 2.0)
    assert not ThicknessField(along=0.1).keeps(True, False, 2.0)
    assert ThicknessField(along=0.1, across=0.1).keeps(False, False, 2.0)


def test_a_table_is_a_thickness_in_any_unit():
    """A table of 0.14 mm at one end and 0.16 mm at the other is a gradient of 2/15 along."""
    x, y = (-1.0, 0.0, 1.0), (-0.5, 0.5)
    table = ThicknessTable(x, y, ((0.14, 0.14), (0.15, 0.15), (0.16, 0.16)))
    points = np.linspace(-1.0, 1.0, 5), np.zeros(5)
    measured = ThicknessField(table=table).relative(*points, 2.0)
    assert np.allclose(measured, ThicknessField(along=2 / 15).relative(*points, 2.0))
    with pytest.raises(ValueError, match="reaches from -1 to 1"):
        ThicknessField(table=table).relative(*points, 3.0)


@pytest.mark.parametrize("name", ["shear", "rotate", "twist", "pitch", "lift"])
def test_clamps_refuse_what_is_no_imperfection(name):
    for value in (0.51, float("nan"), float("inf")):
        with pytest.raises(ValueError, match=f"{name} = .*must be"):
            Clamps(**{name: value})
