"""The curve tau_1(eps) of a sheet: its critical thickness at each strain, on one mesh."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

from wrinklestudy.equilibrium.flat import solve as solve_flat
from wrinklestudy.equilibrium.modes import critical_thickness
from wrinklestudy.equilibrium.planar import PlanarSettings
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
    settings : PlanarSettings
    guide : CriticalCurve, optional
        The curve on a coarser mesh. Its flat states are where those of this curve start from, which
        takes a fifth of the time at large strains.
    report : callable, optional
        Called with each strain that is computed and its tau_1/W.
    """

    space: Space
    law: Law
    settings: PlanarSettings
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
        thickness = critical_thickness(flat, self.settings.bending, symmetry, near)
        return CriticalPoint(thickness, flat.position)

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
    settings: PlanarSettings,
    report: Callable[[float, float], None] | None = None,
) -> CriticalCurve:
    """Return the curve tau_1(eps)/W of a sheet on a grid, with a guide if its cells are many.

    The guide reports as the curve itself does.
    """
    space = grid if isinstance(grid, Space) else Space(grid)
    along, across = space.grid.cells
    coarse = coarsened(space.grid, max(_GUIDE_ALONG, int(_LONG * along)), across)
    lowest = float(coarse.x[-1] - coarse.x[-2])  # of cells that are no wider than high
    most = max(_GUIDE_ACROSS, min(int(_THIN * across), int(coarse.y[-1] / lowest)))
    coarse = coarsened(coarse, along, most)
    guide = None
    if coarse.cells[0] * coarse.cells[1] <= _WORTH * along * across:
        guide = CriticalCurve(Space(coarse), material.law, settings, report=report)
    return CriticalCurve(space, material.law, settings, guide, report)
