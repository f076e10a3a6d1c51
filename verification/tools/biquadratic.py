"""Flat sheets on biquadratic elements of scikit-fem: another discretisation of the same energies.

Nothing of the library's elements, quadrature or assembly is used, only the energy at a point and
Newton's method. Local coordinates may be Cartesian, or a radius and an angle: then derivatives are
taken along the radius and around it, and the metric is that in these directions.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy import sparse
from skfem import Basis, ElementQuad2, FacetBasis, MeshQuad

from wrinklestudy.equilibrium import flat, newton
from wrinklestudy.equilibrium.energy import EnergyExpansion
from wrinklestudy.fem.factorisation import Solver, make_solver
from wrinklestudy.mechanics import membrane
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.mechanics.relaxed import RelaxedLaw
from wrinklestudy.typing import Array, Indices, Mask

REMAINDERS = (0.1, 0.01, 1e-3, 0.0)
# Those that the tension field of the library needs as well: steps are bounded by shifts.
OPTIONS = newton.NewtonOptions(
    tolerance=1e-18, max_iterations=400, first_shift=1e-5, rise=1.0, noise=flat.ROUNDING
)
_GAUSS = 7  # exact degree: 4 x 4 points


@dataclass(frozen=True, eq=False)
class Elements:
    """Biquadratic elements on a tensor grid.

    Parameters
    ----------
    first, second : (n,) arrays
        Grid lines of the two coordinates.
    polar : bool
        Whether they are a radius and an angle.
    """

    first: Array
    second: Array
    polar: bool = False

    @cached_property
    def mesh(self) -> MeshQuad:
        """The rectangles."""
        return MeshQuad.init_tensor(self.first, self.second)

    @cached_property
    def basis(self) -> Basis:
        """Functions of one component with 4 x 4 Gauss points."""
        return Basis(self.mesh, ElementQuad2(), intorder=_GAUSS)

    @property
    def nodes(self) -> Array:
        """Coordinates of the degrees of freedom, (2, n)."""
        places: Array = self.basis.doflocs
        return places

    @cached_property
    def slopes(self) -> Array:
        """Derivatives of the local functions at the Gauss points, (2, 9, ne, nq)."""
        slopes = np.stack([functions[0].grad for functions in self.basis.basis], axis=1)
        if self.polar:
            slopes[1] /= self.basis.global_coordinates()[0]
        return slopes

    @cached_property
    def measure(self) -> Array:
        """Area of each Gauss point, (ne, nq)."""
        area: Array = self.basis.dx
        return area * self.basis.global_coordinates()[0] if self.polar else area

    def derivatives(self, position: Array) -> Array:
        """Return the derivatives of a position (2, n), shape (2, 2, ne, nq), direction first."""
        local = position[:, self.basis.element_dofs]
        return np.einsum("dkeq,cke->dceq", self.slopes, local)

    def on_line(self, position: Array, axis: int, value: float, count: int) -> tuple[Array, Array]:
        """Return derivatives at midpoints of equal parts of an outer line, and their lengths.

        Parameters
        ----------
        position : (2, n) array
        axis, value : int, float
            The line: which coordinate has which value.
        count : int
            Parts of each cell.
        """
        facets = self.mesh.facets_satisfying(lambda x: np.isclose(x[axis], value), True)
        points = (np.arange(count) + 0.5) / count
        quadrature = (points[None], np.full(count, 1.0 / count))
        line = FacetBasis(self.mesh, ElementQuad2(), facets=facets, quadrature=quadrature)
        gradients = np.stack([line.interpolate(component).grad for component in position])
        return gradients.swapaxes(0, 1), np.asarray(line.dx)


class FlatProblem:
    """Energy of a flat sheet for each unit of thickness over its free degrees of freedom.

    Parameters
    ----------
    elements : Elements
    law : MetricEnergy
    prescribed : (2, n) array
        A position; its values where it is not free hold.
    free : (2, n) array of bool
    shift : sparse array, optional
        Positive definite matrix for shifts, a tangent of another such problem.
    """

    def __init__(
        self,
        elements: Elements,
        law: membrane.MetricEnergy,
        prescribed: Array,
        free: Mask,
        shift: sparse.csr_array | None = None,
    ) -> None:
        self.elements, self.law, self.prescribed, self.free = elements, law, prescribed, free
        self._shift = shift

    def position(self, unknowns: Array) -> Array:
        """Return the position (2, n)."""
        position = self.prescribed.copy()
        position[self.free] = unknowns
        return position

    def energy(self, unknowns: Array) -> float:
        """Return the energy, infinite where the sheet is turned inside out."""
        gradient = self.elements.derivatives(self.position(unknowns))
        if np.any(gradient[0, 0] * gradient[1, 1] <= gradient[0, 1] * gradient[1, 0]):
            return np.inf
        return float((membrane.energy(self.law, gradient) * self.elements.measure).sum())

    def derivatives(self, unknowns: Array) -> EnergyExpansion:
        """Return the energy, the residual and the upper triangle of the tangent."""
        gradient = self.elements.derivatives(self.position(unknowns))
        density, slope, blocks = membrane.expansion(self.law, gradient)
        energy = float((density * self.elements.measure).sum())
        return EnergyExpansion(energy, self._scattered(slope)[self.free], self._tangent(blocks))

    def residual(self, unknowns: Array) -> Array:
        """Return the residual alone."""
        return self.reactions(unknowns)[self.free]

    def reactions(self, unknowns: Array) -> Array:
        """Return the residual at every degree of freedom, (2, n)."""
        gradient = self.elements.derivatives(self.position(unknowns))
        return self._scattered(membrane.gradient(membrane.force(self.law, gradient), gradient))

    def shift(self) -> sparse.csr_array | None:
        """Return the matrix for shifts."""
        return self._shift

    def _scattered(self, slope: Array) -> Array:
        elements = self.elements
        local = np.einsum("dkeq,dceq->cke", elements.slopes, slope * elements.measure)
        where, size = elements.basis.element_dofs.ravel(), elements.basis.N
        return np.stack([np.bincount(where, part.ravel(), size) for part in local])

    def _tangent(self, blocks: list[Array]) -> sparse.csr_array:
        """Return the upper triangle on the unknowns, all structural entries kept."""
        elements = self.elements
        dofs = elements.basis.element_dofs
        numbers: Indices = np.full(self.free.shape, -1, dtype=np.int64)
        numbers[self.free] = np.arange(self.free.sum())
        rows, columns, values = [], [], []
        for (c, d), block in zip(((0, 0), (0, 1), (1, 1)), blocks, strict=True):
            if c == d:
                block = block[[0, 1, 1, 2]]
            moduli = (block * elements.measure).reshape(2, 2, *elements.measure.shape)
            left = np.einsum("abeq,bleq->aleq", moduli, elements.slopes)
            local = np.einsum("akeq,aleq->kle", elements.slopes, left, optimize=True)
            i, j = np.broadcast_arrays(numbers[c][dofs][:, None], numbers[d][dofs][None])
            # One of the two off-diagonal blocks is given, so that its entries count once
            kept = (i >= 0) & (j >= 0) & ((i <= j) | (c != d))
            rows.append(np.minimum(i, j)[kept])
            columns.append(np.maximum(i, j)[kept])
            values.append(local[kept])
        size = int(self.free.sum())
        entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
        return sparse.csr_array(sparse.coo_array(entries, shape=(size, size)))


@dataclass(frozen=True, eq=False)
class Relaxed:
    """A minimum of the relaxed energy on biquadratic elements.

    Parameters
    ----------
    problem : FlatProblem
    unknowns : (n,) array
    energy : float
    """

    problem: FlatProblem
    unknowns: Array
    energy: float

    @property
    def position(self) -> Array:
        """The position (2, n)."""
        return self.problem.position(self.unknowns)

    @property
    def reactions(self) -> Array:
        """The residual at every degree of freedom, (2, n)."""
        return self.problem.reactions(self.unknowns)


def relax(
    elements: Elements,
    law: Law,
    start: Array,
    free: Mask,
    remainders: Sequence[float] = REMAINDERS,
) -> Relaxed:
    """Minimise the law itself, then its relaxed energy with smaller and smaller remainders.

    Parameters
    ----------
    elements : Elements
    law : Law
    start : (2, n) array
        A position; what is not free holds.
    free : (2, n) array of bool
    remainders : sequence of float

    Raises
    ------
    ArithmeticError
        If one of the minimisations fails.
    """
    solver = make_solver()
    taut = FlatProblem(elements, law, start, free)
    options = replace(OPTIONS, rise=0.0)
    unknowns = _minimum(taut, start[free], solver, options, "the law itself").unknowns
    shift = taut.derivatives(unknowns).tangent
    problem, minimum = taut, None
    for remainder in remainders:
        problem = FlatProblem(elements, RelaxedLaw(law, remainder), start, free, shift)
        minimum = _minimum(problem, unknowns, solver, OPTIONS, f"remainder {remainder:g}")
        unknowns = minimum.unknowns
    energy = float("nan") if minimum is None else minimum.energy
    return Relaxed(problem, unknowns, energy)


def _minimum(
    problem: FlatProblem,
    start: Array,
    solver: Solver,
    options: newton.NewtonOptions,
    what: str,
) -> newton.Minimum:
    minimum = newton.minimise(problem, start, solver, options)
    if not minimum.converged:
        raise ArithmeticError(f"biquadratic elements, {what}: {minimum.reason}")
    return minimum
