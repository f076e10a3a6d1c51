"""The curve tau_1(eps) of a sheet: its critical thickness at each strain, on one mesh."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol

import numpy as np

from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.flat import solve as solve_flat
from wrinklestudy.equilibrium.modes import critical_mode
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.transfer import coarsened, transferred
from wrinklestudy.mechanics.laws import Law, Material
from wrinklestudy.typing import Array

# Least cells of a guide. They give tau_1 to some parts in a thousand; where it is far smaller than
# its maximum, so that the modes have many waves, to some parts in a hundred. Cells that are wider
# than high at the corner would have modes there that no finer mesh has.
_GUIDE_ACROSS = 24
_GUIDE_ALONG = 12
_LONG, _THIN = 0.4, 0.25  # parts of the cells of long sheets, along, and of thin ones, across
_WORTH = 0.5  # part of the cells of the sheet above which a guide saves nothing
_ABOVE = 1.02  # tau_1 of a guide is that near to tau_1


class CurveSettings(Protocol):
    """What a curve needs to know of the settings of states."""

    @property
    def symmetry(self) -> Symmetry:
        """Mirrors and clamps."""

    @property
    def bending(self) -> str:
        """The bending law."""


class CriticalPoint(NamedTuple):
    """What a curve knows at one strain."""

    thickness: float  # tau_1/W
    position: Array  # of the flat state, (2, size)


@dataclass(frozen=True, eq=False)
class CriticalCurve:
    """tau_1(eps)/W of a sheet on one mesh, a function of the strain that forgets nothing.

    Parameters
    ----------
    space : Space
    law : Law
    settings : PlanarSettings or WholeSettings
        Symmetry and bending law.
    guide : CriticalCurve, optional
        The curve on a coarser mesh. Its flat states are where those of this curve start from, which
        takes a fifth of the time at large strains.
    report : callable, optional
        Called with each strain that is computed and its tau_1/W.
    """

    space: Space
    law: Law
    settings: CurveSettings
    guide: "CriticalCurve | None" = None
    report: Callable[[float, float], None] | None = None
    points: dict[float, CriticalPoint] = field(default_factory=dict, init=False, repr=False)

    def __call__(self, strain: float) -> float:
        """Return tau_1/W at a strain > 0.

        Raises
        ------
        ArithmeticError
            If there is no flat state or the bending law has no value there; one line.
        """
        if strain not in self.points:
            self.points[strain] = self._point(strain)
            if self.report is not None:
                self.report(strain, self.points[strain].thickness)
        return self.points[strain].thickness

    def _point(self, strain: float) -> CriticalPoint:
        start = near = None
        if self.guide is not None:
            near = _ABOVE * self.guide(strain) or None
            start = self._start(self.guide, strain)
        symmetry = self.settings.symmetry
        flat = solve_flat(self.space, self.law, strain, symmetry=symmetry, start=start)
        return CriticalPoint(self._critical(flat, near), flat.position)

    def _critical(self, flat: Flat, near: float | None) -> float:
        """Return tau_1/W of a flat state."""
        start = None
        if flat.symmetry.odd_across is None:  # else the search sees one parity alone
            start = np.random.default_rng(0).standard_normal(self.space.size)
        return critical_mode(flat, self.settings.bending, flat.symmetry, near, start).thickness

    def _start(self, guide: "CriticalCurve", strain: float) -> Array:
        """Return a position near the flat state, from the guide and the nearest state known.

        What the guide lacks grows like the strain.
        """

        def guided(strain: float) -> Array:
            return transferred(guide.points[strain].position, guide.space, self.space)

        start = guided(strain)
        if self.points:
            nearest = min(self.points, key=lambda other: abs(other - strain))
            lacking = self.points[nearest].position - guided(nearest)
            start += strain / nearest * lacking
        return start


def critical_curve(
    grid: Grid | Space, material: Material, settings: PlanarSettings
) -> CriticalCurve:
    """Return the curve tau_1(eps)/W of a sheet on a grid, without a guide."""
    space = grid if isinstance(grid, Space) else Space(grid)
    return CriticalCurve(space, material.law, settings)


def guided_curve(
    grid: Grid | Space,
    material: Material,
    settings: CurveSettings,
    report: Callable[[float, float], None] | None = None,
) -> CriticalCurve:
    """Return the curve tau_1(eps)/W of a sheet on a grid, with a guide if its cells are many.

    The guide reports as the curve itself does.
    """
    space = grid if isinstance(grid, Space) else Space(grid)
    coarse = guide_space(space)
    guide = None
    if coarse is not None:
        guide = CriticalCurve(coarse, material.law, settings, report=report)
    return CriticalCurve(space, material.law, settings, guide, report)


def guide_space(space: Space) -> Space | None:
    """Return a space of fewer cells for a guide; None where it would save nothing."""
    along, across = space.grid.cells
    sides = [1 if lines[0] == 0.0 else 2 for lines in (space.grid.x, space.grid.y)]
    coarse = coarsened(space.grid, max(sides[0] * _GUIDE_ALONG, int(_LONG * along)), across)
    lowest = float(coarse.x[-1] - coarse.x[-2])  # of cells that are no wider than high
    wide = sides[1] * int(coarse.y[-1] / lowest)
    most = max(sides[1] * _GUIDE_ACROSS, min(int(_THIN * across), wide))
    coarse = coarsened(coarse, along, most)
    if coarse.cells[0] * coarse.cells[1] > _WORTH * along * across:
        return None
    return Space(coarse, unevenness=space.unevenness)
