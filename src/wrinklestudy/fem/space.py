"""Hermite fields on a tensor grid: degrees of freedom, quadrature and evaluation."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from skfem import MeshQuad
from skfem.assembly.dofs import Dofs
from skfem.quadrature import get_quadrature

from wrinklestudy.fem.element import CORNERS, ORDERS, ElementQuadHermite, reference_basis
from wrinklestudy.fem.grid import Edge, Grid
from wrinklestudy.fem.thickness import UNIFORM, ThicknessField
from wrinklestudy.typing import Array, Indices

# The derivatives of the plate energy, in the order used everywhere: x,1  x,2  x,11  x,22  x,12
DERIVATIVES = ((1, 0), (0, 1), (2, 0), (0, 2), (1, 1))


@dataclass(frozen=True, eq=False)
class Space:
    """Bicubic Hermite functions on a tensor grid.

    Parameters
    ----------
    grid : Grid
        Grid lines in units of W.
    order : int
        Degree, in each direction, up to which the Gauss rule integrates polynomials exactly. Degree
        5 (3 x 3 points) keeps the order of convergence, and on the same mesh brings the amplitude
        of wrinkles nearer to its limit than degree 7, which is a little too stiff.
    unevenness : ThicknessField
        How the thickness of the sheet varies over it.
    """

    grid: Grid
    order: int = 5
    unevenness: ThicknessField = UNIFORM
    # Sparsity of tangents by unknowns, see `assembly.shared_assembler`. Nothing in it may refer to
    # the space: then all memory of a sheet is free with the last reference to its space.
    shared: dict[bytes, Any] = field(default_factory=dict, init=False, repr=False)

    @cached_property
    def mesh(self) -> MeshQuad:
        """The scikit-fem mesh, local axes along x and y, vertices in the order of the grid."""
        nodes = np.array(np.meshgrid(self.grid.x, self.grid.y, indexing="ij")).reshape(2, -1)
        numbers = np.arange(nodes.shape[1]).reshape(len(self.grid.x), len(self.grid.y))
        corners = (numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:])
        return MeshQuad(nodes, np.stack([corner.ravel() for corner in corners]))

    @cached_property
    def dofs(self) -> Dofs:
        """The scikit-fem numbering of the degrees of freedom of one component."""
        return Dofs(self.mesh, ElementQuadHermite())

    @property
    def size(self) -> int:
        """Number of degrees of freedom of one component."""
        return int(self.dofs.N)

    @cached_property
    def cell_sizes(self) -> Array:
        """Width and height of each cell, shape (2, ne)."""
        sides = np.meshgrid(np.diff(self.grid.x), np.diff(self.grid.y), indexing="ij")
        return np.array(sides).reshape(2, -1)

    @cached_property
    def quadrature(self) -> tuple[Array, Array]:
        """Points (2, nq) and weights (nq,) of the Gauss rule on the unit square."""
        points, weights = get_quadrature(ElementQuadHermite.refdom, self.order)
        return points, weights

    @cached_property
    def basis(self) -> Array:
        """Derivatives of the local functions at the Gauss points of a unit cell, (5, nq, 16)."""
        points, _ = self.quadrature
        return np.array([reference_basis(points, d).T for d in DERIVATIVES])

    @cached_property
    def dof_scale(self) -> Array:
        """Factors from global dofs to those of a unit cell, shape (16, ne)."""
        wide, high = self.cell_sizes
        return np.array([wide ** o[0] * high ** o[1] for _ in CORNERS for o in ORDERS])

    @cached_property
    def derivative_scale(self) -> Array:
        """Factors from derivatives on a unit cell to those in x and y, shape (5, ne)."""
        wide, high = self.cell_sizes
        return np.array([wide ** -d[0] * high ** -d[1] for d in DERIVATIVES])

    @cached_property
    def measure(self) -> Array:
        """Area that each Gauss point stands for, shape (nq, ne)."""
        _, weights = self.quadrature
        return np.outer(weights, self.cell_sizes.prod(axis=0))

    @cached_property
    def points(self) -> Array:
        """Reference coordinates of the Gauss points, (2, nq, ne)."""
        local, _ = self.quadrature
        corner = self.mesh.p[:, self.mesh.t[0]]
        return corner[:, None, :] + local[:, :, None] * self.cell_sizes[:, None, :]

    @cached_property
    def relative_thickness(self) -> Array | float:
        """t(x, y) over the mean thickness at the Gauss points, (nq, ne); 1 for a uniform sheet."""
        if self.unevenness.uniform:
            return 1.0
        x, y = self.points
        return self.unevenness.relative(x, y, self.grid.aspect)

    @cached_property
    def values(self) -> Array:
        """Local functions at the Gauss points of a unit cell, (nq, 16)."""
        return reference_basis(self.quadrature[0], (0, 0)).T

    def derivatives(self, field: Array, count: int = 5) -> Array:
        """Evaluate derivatives x,1 x,2 x,11 x,22 x,12 at the Gauss points.

        Parameters
        ----------
        field : (ncomp, size) array
            Degrees of freedom of the components.
        count : int
            How many of the five derivatives to return: 2 for a membrane.

        Returns
        -------
        (count, ncomp, nq, ne) array
        """
        components, (points, cell_count) = len(field), self.measure.shape
        local = field[:, self.dofs.element_dofs] * self.dof_scale
        basis = self.basis[:count].reshape(-1, 16)
        values = np.matmul(basis, local).reshape(components, count, points, cell_count)
        values *= self.derivative_scale[:count, None]
        return np.ascontiguousarray(values.swapaxes(0, 1))

    def field_from_nodes(self, values: Array) -> Array:
        """Return dof vectors (..., size) from grid arrays (..., 4, nx + 1, ny + 1)."""
        field = np.empty((*values.shape[:-3], self.size))
        field[..., self.dofs.nodal_dofs] = values.reshape(*values.shape[:-2], self.mesh.nvertices)
        return field

    def nodes_from_field(self, field: Array) -> Array:
        """Return grid arrays (..., 4, nx + 1, ny + 1) from dof vectors (..., size)."""
        shape = (len(self.grid.x), len(self.grid.y))
        nodal: Array = field[..., self.dofs.nodal_dofs]
        return nodal.reshape(*field.shape[:-1], 4, *shape)

    @cached_property
    def coordinates(self) -> Array:
        """The undeformed position X, Y, 0 as a field, shape (3, size)."""
        values = np.zeros((3, 4, len(self.grid.x), len(self.grid.y)))
        values[0, 0], values[0, 1] = self.grid.x[:, None], 1.0
        values[1, 0], values[1, 2] = self.grid.y, 1.0
        return self.field_from_nodes(values)

    def edge_dofs(self, edge: Edge, names: Sequence[str]) -> Indices:
        """Return the dofs of the given names (of u, u_x, u_y, u_xy) on an edge of the grid."""
        axis, position = {
            "left": (0, self.grid.x[0]),
            "right": (0, self.grid.x[-1]),
            "lower": (1, self.grid.y[0]),
            "upper": (1, self.grid.y[-1]),
        }[edge]
        tolerance = 1e-9 * float(self.grid.x[-1])
        facets = self.mesh.facets_satisfying(
            lambda x: np.abs(x[axis] - position) < tolerance, boundaries_only=True
        )
        return np.asarray(self.dofs.get_facet_dofs(facets).all(list(names)), dtype=np.int64)
