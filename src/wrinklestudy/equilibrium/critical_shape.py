"""The look of a critical mode: how many half-waves it has, and where along the sheet it is largest.

Beyond L/W of about 3.5 a mode is largest in two zones near the ends, not at the middle.
"""

from dataclasses import dataclass
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike

from wrinklestudy.equilibrium import flat
from wrinklestudy.equilibrium.modes import critical_mode
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.element import reference_basis
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.typing import Array

_SAMPLES = 9  # on each side of a cell, its ends included
_ZOOMS = 8  # rounds of the search for the largest value, each on a quarter of the one before
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


@dataclass(frozen=True, eq=False)
class WrinkleMode:
    """The critical mode of a flat sheet: the wrinkle that the thickest unstable sheet has.

    Parameters
    ----------
    critical_thickness : float
        tau_1 in units of W; modes of the corners are passed over.
    space : Space
        On the quarter sheet.
    shape : (size,) array
        The deflection as a dof vector, scaled to a largest value of 1.
    symmetry : Symmetry
        Of the sheet with this deflection; it needs both mirrors.
    """

    critical_thickness: float
    space: Space
    shape: Array
    symmetry: Symmetry

    @classmethod
    def scaled(cls, thickness: float, space: Space, shape: Array, symmetry: Symmetry) -> Self:
        """Return a mode scaled to a largest value of 1, whatever size and sign `shape` has."""
        return cls(thickness, space, shape / _extreme(space, shape), symmetry)

    def deflection(self, x: ArrayLike, y: ArrayLike) -> Array:
        """Return the deflection at points of the whole reference sheet.

        Parameters
        ----------
        x, y : array_like
            Along the pull and across, from the centre, in units of W; they are broadcast.

        Returns
        -------
        ndarray
            Largest value on the quarter x, y >= 0 is 1; elsewhere as the parity has it.

        Raises
        ------
        ValueError
            If a point lies outside the sheet; one line.
        """
        x, y = np.broadcast_arrays(np.asarray(x, np.float64), np.asarray(y, np.float64))
        for name, values, lines in (("x", x, self.space.grid.x), ("y", y, self.space.grid.y)):
            outside = ~(np.abs(values) <= lines[-1] * (1.0 + 1e-12))
            if outside.any():
                message = f"must be >= {-lines[-1]:g} and <= {lines[-1]:g} (in units of W)"
                raise ValueError(f"{name} = {values[outside].flat[0]:g}: {message}")
        odd = self.symmetry.odd_across is not None and self.symmetry.odd_across[2]
        values = _values(self.space, self.shape, np.abs(x).ravel(), np.abs(y).ravel())
        values = values.reshape(x.shape)
        return np.where(y < 0, -values, values) if odd else values


def wrinkle_mode(
    space: Space, law: Law, strain: float, settings: PlanarSettings | None = None
) -> WrinkleMode:
    """Return the critical mode of a sheet at a strain.

    Parameters
    ----------
    space : Space
        On the quarter sheet.
    law : Law
        Dimensionless material law.
    strain : float
        eps = (L' - L)/L of the clamps.
    settings : PlanarSettings, optional
        Bending law and parity.

    Raises
    ------
    ArithmeticError
        If there is no flat state, or no thickness wrinkles; one line.
    """
    settings = settings or PlanarSettings()
    symmetry = settings.symmetry
    state = flat.solve(space, law, strain, symmetry=symmetry)
    first = critical_mode(state, settings.bending, symmetry)
    if first.shape is None:
        raise ArithmeticError(f"strain {strain:g}: wrinkles at no thickness, has no mode")
    return WrinkleMode.scaled(first.thickness, space, first.shape, symmetry)


def _values(space: Space, shape: Array, x: Array, y: Array) -> Array:
    """Return a field at points (n,) of the quarter sheet."""
    lines = (space.grid.x, space.grid.y)
    cell, local = [], []
    for place, line in zip((x, y), lines, strict=True):
        number = np.clip(np.searchsorted(line, place, side="right") - 1, 0, len(line) - 2)
        cell.append(number)
        local.append((place - line[number]) / np.diff(line)[number])
    element = cell[0] * space.grid.cells[1] + cell[1]
    dofs = shape[space.dofs.element_dofs[:, element]] * space.dof_scale[:, element]
    values: Array = (reference_basis(np.array(local), (0, 0)) * dofs).sum(axis=0)
    return values


def _extreme(space: Space, shape: Array) -> float:
    """Return the value of a field where its absolute value is largest, with its sign."""
    samples = _samples(space, shape)
    place = np.unravel_index(np.abs(samples).argmax(), samples.shape)
    centre = [_lines(space.grid.x)[place[0]], _lines(space.grid.y)[place[1]]]
    reach = space.cell_sizes.max(axis=1) / (_SAMPLES - 1)
    steps = np.stack(np.meshgrid(*[np.linspace(-1.0, 1.0, 9)] * 2, indexing="ij"))
    highest = float(samples[place])
    for _ in range(_ZOOMS):
        x, y = (
            np.clip(c + r * step.ravel(), 0.0, line[-1])
            for c, r, step, line in zip(
                centre, reach, steps, (space.grid.x, space.grid.y), strict=True
            )
        )
        values = _values(space, shape, x, y)
        best = int(np.abs(values).argmax())
        centre, reach, highest = [x[best], y[best]], reach / 4.0, float(values[best])
    return highest
