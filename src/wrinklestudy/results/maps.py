"""The rows of a map: tau_1 with its mode at one strain of one model and L/W."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from wrinklestudy.results.rows import Row, described
from wrinklestudy.vocabulary import MAP_STATUSES, MapStatus

if TYPE_CHECKING:  # to read a table needs no finite elements
    from wrinklestudy.equilibrium.critical_map import CriticalState
    from wrinklestudy.fem.grid import Grid


@dataclass(frozen=True)
class MapRow(Row):
    """Small wrinkles of one parity on the flat state of one model, L/W and strain."""

    material: str = described("name of the material, or of a variant of one", identifies=True)
    law: str = described("law of the strain energy", identifies=True)
    bending: str = described("bending law", identifies=True)
    parity: str = described(
        "of z across the width: antisymmetric or symmetric", identifies=True, shown=True
    )
    aspect: float = described("L/W", identifies=True, shown=True)
    strain: float = described("eps = (L' - L)/L of the clamps", identifies=True, shown=True)
    status: MapStatus = described(  # noqa: RUF009 (a field with metadata, like all the others)
        "unstable, stable (no thickness wrinkles) or not-converged",
        allowed=MAP_STATUSES,
        shown=True,
    )
    critical_thickness: float | None = described(
        "tau_1/W: thinner sheets wrinkle; 0 if no sheet does", shown=True
    )
    half_waves: int | None = described(
        "crests and troughs of the critical mode across the whole width, where it is largest, that "
        "reach a hundredth of its largest",
        shown=True,
    )
    largest_at: float | None = described(
        "X/L of the largest |z| of the critical mode, 0 at the centre, 1/2 at the clamp; the mode "
        "is as large at -X/L",
        shown=True,
    )
    quartic: float | None = described(
        "g of wrinkles of a sheet a little thinner than tau_1, A^2 = (tau_1^2 - t^2)/(2 g) with A "
        "the largest |z| of the sheet: supercritical if > 0, subcritical if < 0",
        shown=True,
    )
    corner_thickness: float | None = described(
        "largest critical thickness over W of a mode of the corners, if above tau_1; such modes "
        "are no wrinkles",
        shown=True,
    )
    cells_along: int = described("cells of the quarter along the pull")
    cells_across: int = described("cells of the quarter across")
    reason: str = described("why nothing is known; empty if something is", shown=True)


def map_row(state: "CriticalState", material: str, law: str, grid: "Grid") -> MapRow:
    """Return what is known at one strain as a row.

    Parameters
    ----------
    state : CriticalState
    material, law : str
        Names of the model and of its law.
    grid : Grid
        The mesh of the map.
    """
    along, across = grid.cells
    return MapRow(
        material=material,
        law=law,
        aspect=grid.aspect,
        cells_along=along,
        cells_across=across,
        **vars(state),
    )
