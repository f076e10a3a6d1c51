"""One layer of hexahedra over the quarter sheet: unknowns, boundary conditions, assembly."""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from scipy import sparse

from verification.tools.solid_element import ORDER, Part, SolidElement
from verification.tools.solid_law import SolidLaw
from wrinklestudy.fem.grid import Grid
from wrinklestudy.typing import Array, Indices, Mask

# What the clamp holds of the thickness: w of the middle line alone, or of the whole face
Clamp = Literal["line", "face"]


class Condensed(NamedTuple):
    """The linear problem of one Newton step, without the pressure."""

    tangent: sparse.csr_array  # upper triangle on the unknowns
    residual: Array  # on the unknowns
    coupling: Array  # D, of pressure and local displacements, (cells, m, n)
    mismatch: Array  # of the volume, (m, cells)


@dataclass(frozen=True, eq=False)
class SolidSpace:
    """Displacements of the quarter sheet.

    A field is a vector over components, functions through the thickness, nodes in the plane.

    Parameters
    ----------
    grid : Grid
        Sides of the cells in the plane.
    thickness : float
    element : SolidElement
    clamp : {'line', 'face'}
    odd_across : bool
        Whether deflections of the middle surface are odd in y.
    """

    grid: Grid
    thickness: float
    element: SolidElement
    clamp: Clamp = "line"
    odd_across: bool = True

    @cached_property
    def lines(self) -> tuple[Array, Array]:
        """Positions of the nodes in x and y, equally spaced within each cell."""
        x, y = (np.interp(*_refined(line)) for line in (self.grid.x, self.grid.y))
        return x, y

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of nodes along and across."""
        return len(self.lines[0]), len(self.lines[1])

    @cached_property
    def blocks(self) -> list[tuple[int, int, bool]]:
        """Component, power of zeta and evenness of each block of a field."""
        return [
            (component, function.power, function.even)
            for component in range(3)
            for function in self.element.through(component)
        ]

    @property
    def size(self) -> int:
        """Number of degrees of freedom, held ones included."""
        return len(self.blocks) * self.shape[0] * self.shape[1]

    def nodes(self, field: Array) -> Array:
        """Return a field as (blocks, nodes along, nodes across)."""
        return field.reshape(len(self.blocks), *self.shape)

    @cached_property
    def free(self) -> Mask:
        """Which degrees of freedom neither mirrors nor clamps hold."""
        free = np.ones((len(self.blocks), *self.shape), dtype=bool)
        for number, (component, power, even) in enumerate(self.blocks):
            if component == 0:
                free[number, 0] = False
            # Under y -> -y, w of the middle surface changes its sign or not, and with it u and v.
            flat = even == (component < 2)
            odd = (component == 1) if flat else (component == 1) != self.odd_across
            if odd:
                free[number, :, 0] = False
            if component < 2 or self.clamp == "face" or (power == 0 and even):
                free[number, -1] = False
        return free.ravel()

    @cached_property
    def _cells(self) -> Indices:
        """Numbers of the 16 nodes of each cell, (16, cells)."""
        along, across = self.grid.cells
        i, j = np.meshgrid(np.arange(along), np.arange(across), indexing="ij")
        return np.array(
            [
                ((ORDER * i + a) * self.shape[1] + ORDER * j + b).ravel()
                for a, b in self.element.in_plane
            ]
        )

    @cached_property
    def _dofs(self) -> list[Indices]:
        """Degrees of freedom of the local functions of each component, (n_i, cells)."""
        plane = self.shape[0] * self.shape[1]
        numbers: list[list[Indices]] = [[], [], []]
        for number, (component, _, _) in enumerate(self.blocks):
            numbers[component].append(number * plane + self._cells)
        return [np.concatenate(rows) for rows in numbers]

    @cached_property
    def _scale(self) -> Array:
        """Factors from derivatives in the element to those in space, (3, cells)."""
        wide, high = np.meshgrid(np.diff(self.grid.x), np.diff(self.grid.y), indexing="ij")
        deep = np.full(wide.size, self.thickness / self.element.layers)
        return 2.0 / np.array([wide.ravel(), high.ravel(), deep])

    @cached_property
    def volume(self) -> Array:
        """Volume of the column of each cell, (cells,)."""
        volume: Array = 8.0 / self._scale.prod(axis=0) * self.element.layers
        return volume

    @cached_property
    def measure(self) -> Array:
        """Volume that each point stands for, (q, cells)."""
        weights = self.element.weights
        return np.outer(weights / weights.sum(), self.volume)

    @cached_property
    def _gradients(self) -> list[Array]:
        return [self.element.gradient(component) for component in range(3)]

    def deformation(self, field: Array) -> Array:
        """Return F = 1 + grad u at the points, (9, q, cells)."""
        rows = []
        for component in range(3):
            local, gradient = field[self._dofs[component]], self._gradients[component]
            for axis in range(3):
                row = gradient[:, axis].T @ local * self._scale[axis]
                rows.append(row + 1.0 if axis == component else row)
        return np.array(rows)

    def plane_stress(self, law: SolidLaw, field: Array) -> Array:
        """Return the pressure that leaves the least stress on the faces, (m, cells).

        P e_3 = S e_3 + p cof F e_3 with the stress S where p = 0.
        """
        gradient = self.deformation(field)
        points = law.points(gradient, np.zeros(gradient.shape[1:]))
        stress, cofactor = points.stress[2::3], points.cofactor[2::3]
        pressure = -(stress * cofactor).sum(axis=0) / (cofactor**2).sum(axis=0)
        mean: Array = self.element.pressure @ (pressure * self.measure) / self.volume
        return mean

    def condensed(
        self, law: SolidLaw, bulk: float, gradient: Array, pressure: Array, at: Array
    ) -> Condensed:
        """Return tangent and residual at F with the pressure eliminated in each element.

        Parameters
        ----------
        law, bulk : SolidLaw, float
            In units of the shear modulus.
        gradient : (9, q, cells) array
        pressure : (m, cells) array
            Coefficients of the pressure.
        at : (q, cells) array
            The pressure at the points; another space can have it, see `solid_states`.
        """
        points = law.points(gradient, at)
        coupling = self._coupling(points.cofactor)
        mismatch = self.element.pressure @ ((points.volume - 1.0) * self.measure)
        mismatch -= self.volume * pressure / bulk
        over = bulk / self.volume
        local = self._local_residual(points.stress)
        local += np.einsum("cmn,mc->nc", coupling, over * mismatch)
        residual = np.zeros(self.size)
        np.add.at(residual, np.concatenate(self._dofs), local)
        entries = self._entries(law.tangent(gradient, at), coupling * np.sqrt(over)[:, None, None])
        return Condensed(self._scatter(entries), residual[self.free], coupling, mismatch)

    def pressure_step(self, problem: Condensed, step: Array, bulk: float) -> Array:
        """Return the change of the pressure that belongs to a step of all degrees of freedom."""
        local = step[np.concatenate(self._dofs)]
        change = problem.mismatch + np.einsum("cmn,nc->mc", problem.coupling, local)
        return bulk / self.volume * change

    def _local_residual(self, stress: Array) -> Array:
        rows = []
        for component in range(3):
            weighted = stress[3 * component : 3 * component + 3] * self.measure
            weighted *= self._scale[:, None]
            gradient = self._gradients[component]
            rows.append(
                gradient.reshape(len(gradient), -1) @ weighted.reshape(-1, len(self.volume))
            )
        return np.concatenate(rows)

    def _coupling(self, cofactor: Array) -> Array:
        """Return D, the derivative of the mean volumes, (cells, m, n)."""
        pressure, rows = self.element.pressure, []
        for component in range(3):
            gradient = self._gradients[component]
            products = pressure[:, None, None] * gradient
            weighted = cofactor[3 * component : 3 * component + 3] * self.measure
            weighted *= self._scale[:, None]
            size = len(pressure) * len(gradient)
            block = products.reshape(size, -1) @ weighted.reshape(-1, len(self.volume))
            rows.append(block.reshape(len(pressure), len(gradient), -1))
        return np.ascontiguousarray(np.concatenate(rows, axis=1).transpose(2, 0, 1))

    @cached_property
    def _pairs(self) -> list[tuple[int, int]]:
        return [(i, k) for i in range(3) for k in range(i, 3)]

    def _entries(self, tangent: Array, coupling: Array) -> Array:
        """Return the blocks i <= k of all element tangents, one after the other."""
        starts = np.cumsum([0, *(len(rows) for rows in self._dofs)])
        blocks = []
        for i, k in self._pairs:
            left, right = self._gradients[i], self._gradients[k]
            weighted = tangent[3 * i : 3 * i + 3, 3 * k : 3 * k + 3] * self.measure
            weighted *= self._scale[:, None, None] * self._scale[:, None]
            products = left[:, None, :, None] * right[None, :, None]
            size = len(left) * len(right)
            block = products.reshape(size, -1) @ weighted.reshape(-1, len(self.volume))
            first = coupling[:, :, starts[i] : starts[i + 1]].transpose(0, 2, 1)
            second = coupling[:, :, starts[k] : starts[k + 1]]
            block += (first @ second).reshape(len(self.volume), size).T
            blocks.append(block.ravel())
        return np.concatenate(blocks)

    @cached_property
    def _pattern(self) -> tuple[sparse.csr_array, Indices, Indices]:
        """Sparsity of the upper triangle, order of the entries, where each sum starts."""
        count = int(self.free.sum())
        numbers = np.full(self.size, -1, dtype=np.int64)
        numbers[self.free] = np.arange(count)
        keys = []
        for i, k in self._pairs:
            left = numbers[self._dofs[i]][:, None, :]
            right = numbers[self._dofs[k]][None, :, :]
            row, column = np.minimum(left, right), np.maximum(left, right)
            key = np.where(row >= 0, row * count + column, -1)
            if i == k:
                key = np.where(left <= right, key, -1)
            keys.append(key.ravel())
        key = np.concatenate(keys)
        order = np.argsort(key, kind="stable")
        order = order[np.searchsorted(key[order], 0) :]
        key = key[order]
        starts = np.flatnonzero(np.diff(key, prepend=-1))
        row, column = np.divmod(key[starts], count)
        indptr = np.searchsorted(row, np.arange(count + 1)).astype(np.int32)
        pattern = sparse.csr_array(
            (np.zeros(len(starts)), column.astype(np.int32), indptr), shape=(count, count)
        )
        return pattern, order, starts

    def _scatter(self, entries: Array) -> sparse.csr_array:
        pattern, order, starts = self._pattern
        data = np.add.reduceat(entries[order], starts)
        return sparse.csr_array((data, pattern.indices, pattern.indptr), shape=pattern.shape)


def solid_space(
    grid: Grid, thickness: float, part: Part, layers: int = 1, clamp: Clamp = "line"
) -> SolidSpace:
    """Return a space of displacements; see `SolidSpace`."""
    return SolidSpace(grid, thickness, SolidElement(part, layers), clamp)


def _refined(lines: Array) -> tuple[Array, Array, Array]:
    cells = len(lines) - 1
    return np.arange(ORDER * cells + 1) / ORDER, np.arange(cells + 1.0), lines
