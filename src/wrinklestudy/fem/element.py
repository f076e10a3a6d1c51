"""The Bogner-Fox-Schmit element: bicubic Hermite functions on axis-parallel rectangles.

The basis is written in the coordinates of the cell. scikit-fem's own ``ElementQuadBFS`` (12.0)
inverts a Vandermonde matrix of global monomials and loses all digits on fine meshes.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from skfem import Element
from skfem.element import DiscreteField
from skfem.refdom import RefQuad

from wrinklestudy.fem.hermite import hermite
from wrinklestudy.typing import Array

# Corner of the reference square of each vertex, in scikit-fem's order, and order of the x and y
# derivatives of each dof.
CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))
ORDERS = ((0, 0), (1, 0), (0, 1), (1, 1))


def reference_basis(points: Array, derivative: tuple[int, int]) -> Array:
    """Return one derivative of the 16 local functions on the unit square.

    Parameters
    ----------
    points : (2, nq) array
        Points of the unit square.
    derivative : (int, int)
        Orders of the derivatives in the two directions.

    Returns
    -------
    (16, nq) array
        Local function ``4 * vertex + dof`` with dofs (u, u_x, u_y, u_xy) on a cell of unit size.
    """
    first = hermite(points[0], derivative[0])
    second = hermite(points[1], derivative[1])
    return np.array(
        [first[c[0], o[0]] * second[c[1], o[1]] for c in CORNERS for o in ORDERS], dtype=np.float64
    )


class ElementQuadHermite(Element):
    """Bicubic Hermite element (Bogner-Fox-Schmit) with dofs u, u_x, u_y, u_xy at each vertex.

    The cells must be rectangles with sides along the axes; the local axes may be swapped or
    reversed, as in ``MeshQuad.init_tensor``.
    """

    nodal_dofs = 4
    maxdeg = 6
    dofnames = ["u", "u_x", "u_y", "u_xy"]  # noqa: RUF012 (scikit-fem's interface)
    doflocs = np.repeat(np.array(CORNERS, dtype=float), 4, axis=0)
    refdom = RefQuad

    def gbasis(
        self, mapping: Any, X: Array, i: int, tind: NDArray[np.int_] | None = None
    ) -> tuple[DiscreteField]:
        """Evaluate global basis function ``i`` with its gradient and Hessian.

        Raises
        ------
        ValueError
            If ``i`` is not a local function or a cell is not an axis-parallel rectangle.
        """
        if not 0 <= i < 16:
            raise ValueError(f"local function {i}: must be 0 to 15")
        points = X[:, None] if X.ndim == 2 else X
        jacobian = mapping.DF(X, tind=tind)
        swapped = np.abs(jacobian[0, 1]) > np.abs(jacobian[0, 0])
        skew = np.where(swapped, jacobian[0, 0], jacobian[0, 1])
        if np.any(np.abs(skew) > 1e-9 * np.abs(jacobian).max()):
            raise ValueError("the Hermite element needs rectangles with sides along the axes")
        corner, order = CORNERS[i // 4], ORDERS[i % 4]

        def factor(axis: int, derivative: int) -> Array:
            """Return a derivative of the one-dimensional factor along a global axis."""
            local = np.where(swapped, 1 - axis, axis)
            functions = hermite(np.where(local == 0, points[0], points[1]), derivative)
            end = np.where(local == 0, corner[0], corner[1])
            scale = np.where(swapped, jacobian[axis, 1 - axis], jacobian[axis, axis])
            ends = np.where(end == 0, functions[0, order[axis]], functions[1, order[axis]])
            return ends * scale ** (order[axis] - derivative)

        x, y = ([factor(axis, d) for d in range(3)] for axis in range(2))
        gradient = np.array([x[1] * y[0], x[0] * y[1]])
        hessian = np.array([[x[2] * y[0], x[1] * y[1]], [x[1] * y[1], x[0] * y[2]]])
        return (DiscreteField(value=x[0] * y[0], grad=gradient, hess=hessian),)
