"""Stress and bending of small deflections of a flat state, and which of them sit at its corners."""

from typing import NamedTuple

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.fem.assembly import Assembler, shared_assembler
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.mechanics import plate
from wrinklestudy.typing import Array

# A mode is one of the corner when more than half of its bending energy sits beyond these parts of
# half the length and half the width.
_CORNER = (0.8, 0.6)
CORNER_PART = 0.5


class DeflectionForms(NamedTuple):
    """Stress S and bending B of small deflections of a flat state."""

    stress: sparse.csr_array  # upper triangle of S
    bending: sparse.csr_array  # upper triangle of B
    assembler: Assembler  # of the free deflections
    points: Array  # point values of B, (15, nq, ne)

    def shifted(self, sigma: float) -> sparse.csr_array:
        """Return the upper triangle of S + sigma B."""
        data = self.stress.data + sigma * self.bending.data
        pattern = (self.stress.indices, self.stress.indptr)
        return sparse.csr_array((data, *pattern), shape=self.stress.shape)


def deflection_forms(flat: Flat, bending: str, symmetry: Symmetry) -> DeflectionForms:
    """Return S and B of a flat state on the deflections that a symmetry leaves free.

    Raises
    ------
    ArithmeticError
        If the bending law has no value at the flat state.
    """
    space = flat.space
    stress, bent = plate.deflection(
        flat.law, bending, space.derivatives(flat.sheet_position), space.relative_thickness
    )
    if not np.isfinite(bent).all():
        raise ArithmeticError(
            f"flat state at strain {flat.strain:g}: the law leaves no thickness somewhere"
        )
    assembler = shared_assembler(space, symmetry.free(space)[2:])
    matrices = (assembler.tangent([stress]), assembler.tangent([bent]))
    return DeflectionForms(*matrices, assembler, bent)


def corner_part(flat: Flat, bent: Array, shapes: Array) -> Array:
    """Return the part of the bending energy of each mode at the corner of the sheet."""
    space = flat.space
    values = space.derivatives(shapes)
    entries = [(a, b) for a in range(5) for b in range(a, 5)]
    density = np.zeros(values.shape[1:])
    for row, (a, b) in enumerate(entries):
        density += (1.0 if a == b else 2.0) * bent[row] * values[a] * values[b]
    by_cell = (density * space.measure).sum(axis=1)
    x, y = np.meshgrid(_inner(space.grid.x), _inner(space.grid.y), indexing="ij")
    corner = (x > _CORNER[0] * space.grid.x[-1] - 1e-9) & (y > _CORNER[1] * space.grid.y[-1] - 1e-9)
    fraction: Array = by_cell[:, corner.ravel()].sum(axis=1) / by_cell.sum(axis=1)
    return fraction


def _inner(lines: Array) -> Array:
    """Return how far each cell begins from the middle of the sheet along one direction."""
    return np.minimum(np.abs(lines[:-1]), np.abs(lines[1:]))
