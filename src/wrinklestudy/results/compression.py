"""The rows of the compression stage: the centre of the flat sheet at one strain."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from wrinklestudy.results.rows import Row, described

if TYPE_CHECKING:  # to read a table needs no finite elements
    from wrinklestudy.equilibrium.compression import CentralState
    from wrinklestudy.fem.grid import Grid


@dataclass(frozen=True)
class CompressionRow(Row):
    """Whether the flat state of one material, L/W and strain is compressed at the centre."""

    material: str = described("name of the material", identifies=True)
    law: str = described("law of the strain energy", identifies=True)
    aspect: float = described("L/W", identifies=True)
    strain: float = described("eps = (L' - L)/L of the clamps", identifies=True)
    central_excess: float | None = described(
        "natural over actual width at the centre of the flat state, less one: compressed if > 0"
    )
    coarse_central_excess: float | None = described(
        "the same on a mesh with half the cells in each direction"
    )
    cells_along: int = described("cells of the quarter along the pull")
    cells_across: int = described("cells of the quarter across")
    reason: str = described("why there is no flat state; empty if there is one")


def compression_row(state: "CentralState", material: str, law: str, grid: "Grid") -> CompressionRow:
    """Return what is known at one strain as a row.

    Parameters
    ----------
    state : CentralState
    material, law : str
        Names of the material and of its law.
    grid : Grid
        The finer of the two meshes.
    """
    along, across = grid.cells
    return CompressionRow(
        material=material,
        law=law,
        aspect=grid.aspect,
        strain=state.strain,
        central_excess=state.excess,
        coarse_central_excess=state.coarse_excess,
        cells_along=along,
        cells_across=across,
        reason=state.reason,
    )
