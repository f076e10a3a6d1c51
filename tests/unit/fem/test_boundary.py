"""Mirrors and clamps: what they hold, what they prescribe, and the whole sheet from a part."""

import numpy as np
import pytest

from wrinklestudy.fem.boundary import NO_MIRRORS, QUARTER, Symmetry
from wrinklestudy.fem.grid import Grid, MeshSettings, make_grid
from wrinklestudy.fem.space import Space

ALL = ["u", "u_x", "u_y", "u_xy"]
PARITIES = ["antisymmetric", "symmetric"]


@pytest.fixture(scope="module")
def space():
    return Space(make_grid(1.5, settings=MeshSettings(3, 4)))


@pytest.mark.parametrize("parity", PARITIES)
def test_free_dofs_keep_a_field_of_the_right_parity(space, parity):
    """On the mirror lines free fields are odd or even: what must vanish there does."""
    rng = np.random.default_rng(5)
    field = rng.standard_normal((3, space.size)) * Symmetry.mirrored(parity).free(space)
    nodes = space.nodes_from_field(field)
    value, dx, dy = 0, 1, 2
    assert np.all(nodes[0, value, 0] == 0)  # x odd in x
    assert np.all(nodes[1:, dx, 0] == 0)  # y and z even in x
    assert np.all(nodes[0, dy, :, 0] == 0)  # x even in y
    assert np.all(nodes[1, value, :, 0] == 0)  # y odd in y
    odd = parity == "antisymmetric"
    assert np.all(nodes[2, value if odd else dy, :, 0] == 0)
    assert np.all(nodes[:, [value, dy], -1] == 0)  # clamped
    assert np.all(nodes[2, :, -1] == 0)  # and with z,x = 0
    assert np.any(nodes[0, dx, -1] != 0)


def test_the_parity_classes_are_complementary(space):
    """Every dof on a mirror line is free in exactly one of the two classes of that mirror."""
    lines = {edge: space.edge_dofs(edge, ALL) for edge in ("left", "right", "lower", "upper")}
    keeps = QUARTER.free(space)
    for mirror, other, broken in (
        ("left", "lower", QUARTER.broken(keeps_x=False, keeps_y=True)),
        ("lower", "left", QUARTER.broken(keeps_x=True, keeps_y=False)),
    ):
        inner = np.setdiff1d(lines[mirror], np.union1d(lines["right"], lines[other]))
        assert np.all(keeps[:, inner] ^ broken.free(space)[:, inner])


@pytest.mark.parametrize("parity", PARITIES)
def test_the_unfolded_sheet_has_the_parities_on_both_sides(space, parity):
    """x is odd, y and z are even under X -> -X; y is odd, x even and z either under Y -> -Y."""
    symmetry = Symmetry.mirrored(parity)
    rng = np.random.default_rng(7)
    nodes = space.nodes_from_field(rng.standard_normal((3, space.size)) * symmetry.free(space))
    y, wide = symmetry.unfold_across(space.grid.y, nodes)
    x, whole = symmetry.unfold_along(space.grid.x, wide)
    assert np.array_equal(x, -x[::-1])
    assert np.array_equal(y, -y[::-1])
    assert np.array_equal(whole[:, :, 3:, 4:], nodes)
    of_z = -1 if parity == "antisymmetric" else 1
    for axis, components in ((2, (-1, 1, 1)), (3, (1, -1, of_z))):
        dofs = (1, -1, 1, -1) if axis == 2 else (1, 1, -1, -1)  # a derivative along it turns round
        signs = np.multiply.outer(components, dofs)[:, :, None, None]
        assert np.array_equal(np.flip(whole, axis), signs * whole)


def test_a_sheet_without_mirrors_is_held_at_both_ends_only():
    """It unfolds to itself, and the clamp's force is that of one end."""
    space = Space(Grid(np.linspace(-1.0, 1.0, 5), np.linspace(-0.5, 0.5, 4)))
    free = NO_MIRRORS.free(space)
    ends = np.union1d(space.edge_dofs("left", ["u", "u_y"]), space.edge_dofs("right", ["u", "u_y"]))
    assert np.array_equal(np.flatnonzero(~free[0]), ends)
    assert np.array_equal(free[0], free[1])
    assert int((~free[2]).sum()) == 2 * len(ends)
    nodes = space.nodes_from_field(space.coordinates)
    for unfold, lines in (
        (NO_MIRRORS.unfold_along, space.grid.x),
        (NO_MIRRORS.unfold_across, space.grid.y),
    ):
        same_lines, same_nodes = unfold(lines, nodes)
        assert same_lines is lines
        assert same_nodes is nodes
    reactions = np.zeros((3, space.size))
    reactions[0, space.edge_dofs("right", ["u"])] = 0.25
    assert NO_MIRRORS.clamp.force(space, reactions) == pytest.approx(1.0)
    assert QUARTER.clamp.force(space, reactions) == pytest.approx(2.0)


def test_the_clamp_moves_by_the_strain(space):
    """Its points go to X (1 + eps) and keep Y: the distance of the clamps is L (1 + eps)."""
    nodes = space.nodes_from_field(QUARTER.clamp.position(space, 0.3))
    assert np.allclose(nodes[0, 0, -1], 1.3 * 0.75)
    assert np.allclose(nodes[1, 0, -1], space.grid.y)
    assert np.all(nodes[2] == 0)


def test_another_parity_is_refused():
    with pytest.raises(ValueError, match="parity = 'odd': must be one of antisymmetric, symmetric"):
        Symmetry.mirrored("odd")
