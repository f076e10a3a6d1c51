"""The Hermite element reproduces bicubics on fine meshes and for any orientation of a cell."""

import numpy as np
import pytest
from skfem import Basis, MeshQuad

from wrinklestudy.fem.element import ElementQuadHermite

FINE = np.linspace(0.0, 2.5, 161), np.linspace(0.0, 1.0, 65)
GRADED = 2.5 * (1 - np.linspace(1, 0, 161) ** 1.5), FINE[1]


def bicubic(x, y, dx=0, dy=0):
    """A polynomial with all 16 monomials, and its derivatives."""
    total = 0.0
    for i in range(4):
        for j in range(4):
            p = np.polynomial.Polynomial.basis(i).deriv(dx)
            q = np.polynomial.Polynomial.basis(j).deriv(dy)
            total = total + (1 + i + 2 * j) / 7 * p(x - 0.3) * q(y + 0.1)
    return total


def nodal_values(basis):
    x, y = basis.doflocs
    kinds = np.arange(basis.N) % 4
    return np.choose(kinds, [bicubic(x, y, dx, dy) for dx, dy in ((0, 0), (1, 0), (0, 1), (1, 1))])


@pytest.mark.parametrize("lines", [FINE, GRADED], ids=["uniform", "graded"])
def test_reproduces_bicubics_with_second_derivatives(lines):
    basis = Basis(MeshQuad.init_tensor(*lines), ElementQuadHermite(), intorder=3)
    field = basis.interpolate(nodal_values(basis))
    x, y = basis.global_coordinates()
    smallest = min(np.diff(line).min() for line in lines)
    for found, (dx, dy) in (
        (field, (0, 0)),
        (field.grad[0], (1, 0)),
        (field.grad[1], (0, 1)),
        (field.hess[0, 0], (2, 0)),
        (field.hess[0, 1], (1, 1)),
        (field.hess[1, 1], (0, 2)),
    ):
        exact = bicubic(x, y, dx, dy)
        # A derivative of order k of nodal values with rounding eps cannot be better than eps / h^k:
        # this shows in second derivatives in the thinnest cells of the graded mesh only.
        rounding = 4 * np.finfo(float).eps * np.abs(field).max() / smallest ** (dx + dy)
        assert np.abs(found - exact).max() < max(1e-10, rounding) * max(1.0, np.abs(exact).max())


def test_orientation_of_the_cell_does_not_matter():
    nodes = np.array([[0.0, 2.0, 2.0, 0.0], [0.0, 0.0, 0.5, 0.5]])
    for turn in range(4):
        for order in (np.arange(4), np.array([0, 3, 2, 1])):
            mesh = MeshQuad(nodes, np.roll(order, turn)[:, None])
            basis = Basis(mesh, ElementQuadHermite(), intorder=3)
            x, y = basis.global_coordinates()
            found = basis.interpolate(nodal_values(basis))
            assert np.allclose(found, bicubic(x, y), rtol=0, atol=1e-13)
            assert np.allclose(found.hess[0, 1], bicubic(x, y, 1, 1), rtol=0, atol=1e-12)


def test_refuses_a_cell_that_is_not_a_rectangle():
    nodes = np.array([[0.0, 1.0, 1.2, 0.0], [0.0, 0.0, 1.0, 1.0]])
    mesh = MeshQuad(nodes, np.arange(4)[:, None])
    with pytest.raises(ValueError, match="rectangles"):
        Basis(mesh, ElementQuadHermite(), intorder=3)
