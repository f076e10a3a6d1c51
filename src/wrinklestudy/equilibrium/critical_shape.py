"""The look of a critical mode: how many half-waves it has, and where along the sheet it is largest.

Beyond L/W of about 3.5 a mode is largest in two zones near the ends, not at the middle.
"""

from typing import NamedTuple

import numpy as np

from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.element import reference_basis
from wrinklestudy.fem.space import Space
from wrinklestudy.typing import Array

_SAMPLES = 9  # on each side of a cell, its ends included
_LEAST = 0.01  # of the largest |w|: lower crests and troughs are not counted


class ModeShape(NamedTuple):
    """What is seen of a mode.

    Parameters
    ----------
    largest : float
        Largest |phi| over the sheet.
    largest_at : float
        X/L of that point, 0 at the centre and 1/2 at the clamp.
    half_waves : int
        Crests and troughs across the whole width at that X that reach a hundredth of the largest.
    """

    largest: float
    largest_at: float
    half_waves: int


def mode_shape(space: Space, shape: Array, symmetry: Symmetry) -> ModeShape:
    """Return what is seen of a mode, from its interpolant on the quarter sheet.

    Parameters
    ----------
    space : Space
    shape : (size,) array
        The mode as a dof vector.
    symmetry : Symmetry
        Of the sheet with this deflection; it needs both mirrors.
    """
    values = _samples(space, shape)
    line, _ = np.unravel_index(np.abs(values).argmax(), values.shape)
    along = _lines(space.grid.x)
    return ModeShape(
        float(np.abs(values).max()),
        float(0.5 * along[line] / space.grid.x[-1]),
        _half_waves(values[line], symmetry),
    )


def _samples(space: Space, shape: Array) -> Array:
    """Return a field at points of all cells, along and across; the sides of cells come twice."""
    side = np.linspace(0.0, 1.0, _SAMPLES)
    points = np.stack(np.meshgrid(side, side, indexing="ij")).reshape(2, -1)
    local = shape[space.dofs.element_dofs] * space.dof_scale
    along, across = space.grid.cells
    values = reference_basis(points, (0, 0)).T @ local
    values = values.reshape(_SAMPLES, _SAMPLES, along, across).transpose(2, 0, 3, 1)
    return values.reshape(along * _SAMPLES, across * _SAMPLES)


def _lines(lines: Array) -> Array:
    """Return the positions of the samples along one direction."""
    side = np.linspace(0.0, 1.0, _SAMPLES)
    return (lines[:-1, None] + np.diff(lines)[:, None] * side).ravel()


def _half_waves(profile: Array, symmetry: Symmetry) -> int:
    """Count the runs of one sign across the whole width, from the mid-line to the free edge."""
    odd = symmetry.odd_across is not None and symmetry.odd_across[2]
    high = np.abs(profile) >= _LEAST * np.abs(profile).max()
    signs = np.sign(profile[high])
    runs = 1 + int(np.sum(signs[1:] != signs[:-1]))
    return 2 * runs if odd else 2 * runs - 1
