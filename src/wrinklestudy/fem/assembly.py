"""Assembly of residuals and tangents by batched matrix products.

An energy enters through its values at points: the gradient of the density with respect to the
derivatives of each component, and the upper triangle of the Hessian. The element tangents B^T D B
are one matrix product per pair of components; a sparse matrix, built once, scatters them into the
upper triangle of the global tangent.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import product
from typing import Any

import numpy as np
from scipy import sparse

from wrinklestudy.fem.factorisation import Solver, make_solver
from wrinklestudy.fem.slopes import TiedSlopes
from wrinklestudy.fem.space import Space
from wrinklestudy.typing import Array, Indices, Mask


@dataclass(frozen=True, eq=False)
class Sparsity:
    """Where the entries of element tangents go, and a factorisation whose ordering serves them all.

    Parameters
    ----------
    pattern : sparse array
        The upper triangle of a tangent.
    scatter : sparse array
        The map from the entries of element tangents to its data.
    """

    pattern: sparse.csr_array
    scatter: sparse.csr_array

    @cached_property
    def solver(self) -> Solver:
        """A factorisation for tangents of this pattern, whose ordering is computed once."""
        return make_solver()


@dataclass(frozen=True, eq=False)
class Assembler:
    """Residual and tangent of an energy over some components of a field.

    Parameters
    ----------
    space : Space
        The Hermite functions.
    free : (ncomp, size) array of bool
        Marks the unknowns; all other degrees of freedom are prescribed.
    derivatives : int
        On how many of the derivatives x,1 x,2 x,11 x,22 x,12 the energy depends: 5, or 2 for a
        membrane.
    known : dict
        Sparsity of tangents by unknowns; what is computed joins it.
    slopes : TiedSlopes, optional
        Degrees of freedom of z, none of them free, that follow from those of x and y.
    """

    space: Space
    free: Mask
    derivatives: int = 5
    known: dict[bytes, Sparsity] = field(default_factory=dict, repr=False)
    slopes: TiedSlopes | None = None

    def filled(self, prescribed: Array, unknowns: Array) -> Array:
        """Return a field (ncomp, size): the unknowns, what is prescribed, and what follows."""
        field = prescribed.copy()
        field[self.free] = unknowns
        return field if self.slopes is None else self.slopes.complete(field)

    def reduced(self, residual: Array) -> Array:
        """Return the derivative of an energy with respect to the unknowns from `residual`."""
        if self.slopes is not None:
            residual = self.slopes.pull_back(residual)
        return residual[self.free]

    @property
    def solver(self) -> Solver:
        """A factorisation for tangents of this pattern, whose ordering is computed once."""
        return self.sparsity.solver

    @property
    def pairs(self) -> list[tuple[int, int]]:
        """Pairs of components c <= d, in the order in which Hessians are given."""
        count = len(self.free)
        return [(c, d) for c in range(count) for d in range(c, count)]

    def entries(self, same: bool) -> list[tuple[int, int]]:
        """Pairs of derivatives (a, b) of a Hessian block; only a <= b for equal components."""
        return [
            (a, b)
            for a in range(self.derivatives)
            for b in range(a if same else 0, self.derivatives)
        ]

    @cached_property
    def size(self) -> int:
        """Number of unknowns."""
        return int(self.free.sum())

    @cached_property
    def _products(self) -> tuple[Array, Array]:
        """Products of basis derivatives for unequal and for equal components, (pairs, points)."""
        basis = self.space.basis
        products = []
        for same in (False, True):
            left, right = np.triu_indices(16) if same else np.indices((16, 16)).reshape(2, -1)
            rows = []
            for a, b in self.entries(same):
                block = basis[a][:, left] * basis[b][:, right]
                if same and a != b:
                    block = block + basis[b][:, left] * basis[a][:, right]
                rows.append(block)
            products.append(np.ascontiguousarray(np.concatenate(rows).T))
        return products[0], products[1]

    @cached_property
    def _scales(self) -> tuple[Array, Array]:
        """Factors from second derivatives in x and y to those on unit cells, (entries, ne)."""
        scale = self.space.derivative_scale
        rows = [np.array(self.entries(same)) for same in (False, True)]
        unequal, equal = (scale[row[:, 0]] * scale[row[:, 1]] for row in rows)
        return unequal, equal

    @cached_property
    def _weighted(self) -> Array:
        """Memory for the largest block of second derivatives, allocated once for all calls."""
        return np.empty((len(self.entries(False)), *self.space.measure.shape))

    @property
    def sparsity(self) -> Sparsity:
        """The pattern of tangents."""
        key = np.packbits(self.free).tobytes() + (self.slopes.key if self.slopes else b"")
        if key not in self.known:
            self.known[key] = self._sparsity()
        return self.known[key]

    def _sparsity(self) -> Sparsity:
        numbers = np.full(self.free.shape, -1, dtype=np.int64)
        numbers[self.free] = np.arange(self.size)
        element_dofs = self.space.dofs.element_dofs
        scale = self.space.dof_scale
        rows, columns, values = [], [], []
        for c, d in self.pairs:
            left, right = np.triu_indices(16) if c == d else np.indices((16, 16)).reshape(2, -1)
            i, j = numbers[c][element_dofs[left]], numbers[d][element_dofs[right]]
            rows.append(np.minimum(i, j).ravel())
            columns.append(np.maximum(i, j).ravel())
            values.append((scale[left] * scale[right]).ravel())
        sources = [np.arange(sum(map(len, values)))]
        entries = len(sources[0])
        if self.slopes is not None:
            lists: tuple[list[Any], ...] = (rows, columns, values, sources)
            for extra in self._tied_entries(numbers, self.slopes):
                for listed, new in zip(lists, extra, strict=True):
                    listed.append(new)
        row, column, source = np.concatenate(rows), np.concatenate(columns), np.concatenate(sources)
        kept = np.flatnonzero(row >= 0)
        # Once sorted by row and then by column, entries to be added up lie side by side.
        kept = kept[_sorted_order(column[kept], self.size)]
        kept = kept[_sorted_order(row[kept], self.size)]
        row, column = row[kept], column[kept]
        new = np.ones(len(kept), dtype=bool)
        new[1:] = (np.diff(row) != 0) | (np.diff(column) != 0)
        starts = np.flatnonzero(new)
        scatter = sparse.csr_array(
            (np.concatenate(values)[kept], source[kept], np.append(starts, len(kept))),
            shape=(len(starts), entries),
        )
        indptr = np.searchsorted(row[starts], np.arange(self.size + 1)).astype(np.int32)
        pattern = sparse.csr_array(
            (np.zeros(len(starts)), column[starts].astype(np.int32), indptr),
            shape=(self.size, self.size),
        )
        return Sparsity(pattern, scatter)

    def _tied_entries(
        self, numbers: Indices, slopes: TiedSlopes
    ) -> Iterator[tuple[Indices, Indices, Array, Indices]]:
        """Yield rows, columns, factors and sources of what element entries of tied dofs add.

        With z = f_x x + f_y y an entry k of a pair of dofs is one of their masters, times the
        factors of both.
        """
        element_dofs, scale = self.space.dofs.element_dofs, self.space.dof_scale
        tied = slopes.masters(self.space.size)
        offset = 0
        for c, d in self.pairs:
            left, right = np.triu_indices(16) if c == d else np.indices((16, 16)).reshape(2, -1)
            first, second = element_dofs[left].ravel(), element_dofs[right].ravel()
            is_tied = ~np.isnan(np.stack([tied[0, first], tied[0, second]]))
            is_tied &= np.array([[c == 2], [d == 2]])
            chosen = np.flatnonzero(is_tied.any(axis=0))
            factor = np.multiply(scale[left], scale[right]).ravel()[chosen]
            pair = (first[chosen], second[chosen])
            same = (pair[0] == pair[1]) & (c == d)
            for one, other in product(range(3), repeat=2):  # components of the two masters
                weights = factor.copy()
                for master, of, dofs, ties in zip(
                    (one, other), (c, d), pair, is_tied[:, chosen], strict=True
                ):
                    own = np.where(ties, 0.0, float(master == of))
                    through = tied[master, dofs] if master < 2 else np.zeros(len(dofs))
                    weights *= np.where(ties, np.nan_to_num(through), own)
                i, j = numbers[one][pair[0]], numbers[other][pair[1]]
                # An entry off the diagonal stands for both of its sides.
                weights *= np.where(same, np.where(i == j, 1.0, 0.5), np.where(i == j, 2.0, 1.0))
                used = np.flatnonzero((weights != 0.0) & (i >= 0) & (j >= 0))
                yield (
                    np.minimum(i, j)[used],
                    np.maximum(i, j)[used],
                    weights[used],
                    offset + chosen[used],
                )
            offset += len(first)

    def residual(self, gradient: Array) -> Array:
        """Return the derivative of the energy with respect to every degree of freedom.

        Parameters
        ----------
        gradient : (derivatives, ncomp, nq, ne) array
            Derivative of the energy density.

        Returns
        -------
        (ncomp, size) array
            At the prescribed degrees of freedom these are the reactions.
        """
        space = self.space
        count, components = gradient.shape[:2]
        weighted = gradient * space.measure * space.derivative_scale[:count, None, None]
        basis = space.basis[:count].reshape(-1, 16).T
        local = np.matmul(basis, weighted.swapaxes(0, 1).reshape(components, basis.shape[1], -1))
        local *= space.dof_scale
        residual = np.empty((components, space.size))
        target = space.dofs.element_dofs.ravel()
        for component in range(components):
            residual[component] = np.bincount(target, local[component].ravel(), space.size)
        return residual

    def tangent(self, hessian: list[Array]) -> sparse.csr_array:
        """Return the upper triangle of the tangent on the unknowns.

        Parameters
        ----------
        hessian : list of (entries, nq, ne) arrays
            One block of second derivatives of the energy density for each of `pairs`, with the
            rows of `entries`.
        """
        return self.scatter(self.element_tangents(hessian))

    def element_tangents(self, hessian: list[Array]) -> Array:
        """Return the entries of all element tangents, in the order of `scatter`; see `tangent`."""
        space = self.space
        cells = space.measure.shape[1]
        kinds = [int(c == d) for c, d in self.pairs]
        ends = np.cumsum([len(self._products[kind]) * cells for kind in kinds])
        elements = np.empty(ends[-1])
        for kind, end, block in zip(kinds, ends, hessian, strict=True):
            products, scale = self._products[kind], self._scales[kind]
            weighted = self._weighted[: len(block)]
            np.multiply(block, scale[:, None], out=weighted)
            weighted *= space.measure
            size = len(products) * cells
            np.matmul(
                products,
                weighted.reshape(products.shape[1], -1),
                out=elements[end - size : end].reshape(len(products), -1),
            )
        return elements

    def scatter(self, elements: Array) -> sparse.csr_array:
        """Add up element entries into the upper triangle of the tangent."""
        sparsity = self.sparsity
        data, pattern = sparsity.scatter @ elements, sparsity.pattern
        return sparse.csr_array((data, pattern.indices, pattern.indptr), shape=pattern.shape)


def shared_assembler(
    space: Space, free: Mask, derivatives: int = 5, slopes: TiedSlopes | None = None
) -> Assembler:
    """Return an assembler for some unknowns of a space that shares its sparsity with the others.

    The sparsity pattern and the ordering of its factorisation then serve all strains and all
    thicknesses that are solved on the space.
    """
    return Assembler(space, free, derivatives, space.shared, slopes)


def _sorted_order(keys: Indices, count: int) -> Indices:
    """Return the stable order that sorts keys below count: the conversion to CSR counts them."""
    size = len(keys)
    listed = sparse.csr_array((np.ones(size, bool), (keys, np.arange(size))), shape=(count, size))
    return listed.indices.astype(np.int64)
