"""Batched assembly against scikit-fem's own forms."""

import numpy as np
import pytest
from skfem import Basis, BilinearForm, LinearForm
from skfem.helpers import dd, ddot, dot, grad

from wrinklestudy.fem.assembly import Assembler, shared_assembler
from wrinklestudy.fem.element import ElementQuadHermite
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space


@pytest.fixture(scope="module")
def space():
    return Space(make_grid(1.5, settings=MeshSettings(3, 4)))


def test_derivatives_agree_with_scikit_fem(space):
    basis = Basis(space.mesh, ElementQuadHermite(), quadrature=space.quadrature)
    field = np.random.default_rng(1).standard_normal(space.size)
    exact = basis.interpolate(field)
    found = space.derivatives(field[None])[:, 0].swapaxes(1, 2)
    for row, expected in zip(
        found,
        (exact.grad[0], exact.grad[1], exact.hess[0, 0], exact.hess[1, 1], exact.hess[0, 1]),
        strict=True,
    ):
        assert np.allclose(row, expected, rtol=1e-12, atol=1e-10)


def test_scalar_tangent_agrees_with_bilinear_form(space):
    """A plate under tension: int w,a u,a + 0.3 w,ab u,ab."""
    basis = Basis(space.mesh, ElementQuadHermite(), quadrature=space.quadrature)
    form = BilinearForm(lambda u, v, _: dot(grad(u), grad(v)) + 0.3 * ddot(dd(u), dd(v)))
    exact = form.assemble(basis).toarray()
    assembler = Assembler(space, np.ones((1, space.size), dtype=bool))
    rows = {(0, 0): 1.0, (1, 1): 1.0, (2, 2): 0.3, (3, 3): 0.3, (4, 4): 0.6}
    block = np.array(
        [np.full(space.measure.shape, rows.get(pair, 0.0)) for pair in assembler.entries(True)]
    )
    upper = assembler.tangent([block]).toarray()
    assert np.allclose(upper, np.triu(exact), rtol=1e-12, atol=1e-12 * np.abs(exact).max())


def test_residual_agrees_with_linear_form(space):
    basis = Basis(space.mesh, ElementQuadHermite(), quadrature=space.quadrature)
    form = LinearForm(lambda v, w: np.sin(w.x[0]) * grad(v)[0] + w.x[1] ** 2 * dd(v)[0, 1])
    x, y = np.asarray(basis.global_coordinates()).swapaxes(1, 2)
    gradient = np.zeros((5, 1, *space.measure.shape))
    gradient[0, 0], gradient[4, 0] = np.sin(x), y**2
    assembler = Assembler(space, np.ones((1, space.size), dtype=bool))
    assert np.allclose(assembler.residual(gradient)[0], form.assemble(basis), atol=1e-13)


def test_unequal_components_are_coupled_symmetrically(space):
    """The full matrix of a form with all couplings against finite differences of its residual."""
    free = np.random.default_rng(2).random((3, space.size)) < 0.5
    assembler = Assembler(space, free)
    rng = np.random.default_rng(3)
    full = rng.standard_normal((5, 3, 5, 3))
    full = full + full.transpose(2, 3, 0, 1)
    blocks = [
        np.array(
            [np.full(space.measure.shape, full[a, c, b, d]) for a, b in assembler.entries(c == d)]
        )
        for c, d in assembler.pairs
    ]
    upper = assembler.tangent(blocks).toarray()
    field = rng.standard_normal((3, space.size)) * free
    gradient = np.einsum("acbd,bd...->ac...", full, space.derivatives(field))
    symmetric = upper + upper.T - np.diag(upper.diagonal())
    expected = assembler.residual(gradient)[free]
    assert np.allclose(symmetric @ field[free], expected, atol=1e-10 * np.abs(expected).max())


def test_area_and_coordinates(space):
    assert space.measure.sum() == pytest.approx(0.75 * 0.5, rel=1e-14)
    gradient = space.derivatives(space.coordinates)
    identity = np.zeros((5, 3))
    identity[0, 0] = identity[1, 1] = 1.0
    assert np.allclose(gradient, identity[:, :, None, None], atol=1e-11)


def test_nodes_and_fields_are_inverse(space):
    field = np.random.default_rng(4).standard_normal((2, space.size))
    assert np.array_equal(space.field_from_nodes(space.nodes_from_field(field)), field)
    none = field[:0]  # the modes of a sheet that no thickness makes unstable
    assert space.field_from_nodes(space.nodes_from_field(none)).shape == none.shape


def test_what_is_assembled_is_left_as_it_is(space):
    """A second tangent from the same blocks is the same."""
    assembler = Assembler(space, np.ones((2, space.size), dtype=bool))
    rng = np.random.default_rng(6)
    blocks = [
        rng.standard_normal((len(assembler.entries(c == d)), *space.measure.shape))
        for c, d in assembler.pairs
    ]
    copies = [block.copy() for block in blocks]
    first, second = assembler.tangent(blocks), assembler.tangent(blocks)
    assert all(map(np.array_equal, blocks, copies))
    assert np.array_equal(first.data, second.data)


def test_assemblers_of_the_same_unknowns_share_pattern_and_ordering(space):
    free = np.random.default_rng(5).random((2, space.size)) < 0.5
    first, second = (shared_assembler(space, free.copy(), order) for order in (2, 5))
    assert first.sparsity is second.sparsity
    assert first.solver is second.solver
    assert Assembler(space, free).sparsity is not first.sparsity
