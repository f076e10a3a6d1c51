"""The graded tensor grid of the quarter sheet."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from wrinklestudy.typing import Array

# First and last line of constant x, first and last line of constant y.
Edge = Literal["left", "right", "lower", "upper"]

REFERENCE_ASPECT = 2.0
REFERENCE_THICKNESS = 1.0e-3


@dataclass(frozen=True)
class Grid:
    """Grid lines of the part of the sheet that is solved, in units of W.

    With both mirrors this is the quarter 0 <= x <= L/2, 0 <= y <= 1/2.

    Parameters
    ----------
    x : (nx + 1,) array
        From the middle of the sheet to the clamp.
    y : (ny + 1,) array
        From the mid-line to the free edge.
    """

    x: Array
    y: Array

    @property
    def aspect(self) -> float:
        """L/W of the whole sheet."""
        return 2.0 * float(self.x[-1])  # from the centre to the right end, mirror or none

    @property
    def cells(self) -> tuple[int, int]:
        """Number of cells along and across."""
        return len(self.x) - 1, len(self.y) - 1


@dataclass(frozen=True)
class MeshSettings:
    """Numbers of cells for the reference sheet L/W = 2, t/W = 1e-3, and the grading.

    Parameters
    ----------
    cells_along : int
        Cells on half the length of the reference sheet; grows in proportion to L.
    cells_across : int
        Cells on half the width of a sheet with t/W = 1e-3; grows like the number of wrinkles,
        t^(-1/2), for thinner ones.
    grading : float
        Exponent p of the grid lines x = L/2 (1 - (1 - s)^p), s = 0 ... 1: the cells shrink toward
        the clamp, whose corner is singular.
    """

    cells_along: int = 24
    cells_across: int = 36
    grading: float = 1.5


def cells(aspect: float, thickness: float, settings: MeshSettings) -> tuple[int, int]:
    """Return the numbers of cells along and across for the thinnest sheet that a mesh resolves.

    The wavelength of the wrinkles is proportional to sqrt(L t) (Cerda and Mahadevan 2003), so
    that across the sheet the number of cells per wavelength stays that of the reference sheet.
    """
    length = aspect / REFERENCE_ASPECT
    finer = math.sqrt(REFERENCE_THICKNESS / min(thickness, REFERENCE_THICKNESS))
    along = math.ceil(settings.cells_along * length - 1e-9)
    across = math.ceil(settings.cells_across * finer - 1e-9)
    return along, across


def make_grid(
    aspect: float,
    thickness: float = REFERENCE_THICKNESS,
    settings: MeshSettings | None = None,
) -> Grid:
    """Return the graded grid for a sheet of the given L/W and t/W.

    Raises
    ------
    ValueError
        If the aspect or the thickness is not positive, or the settings leave no cells.
    """
    settings = settings or MeshSettings()
    if not (aspect > 0 and thickness > 0):
        raise ValueError(f"aspect = {aspect:g}, thickness = {thickness:g}: both must be > 0")
    if min(settings.cells_along, settings.cells_across) < 2 or settings.grading < 1:
        raise ValueError(f"{settings}: needs at least 2 cells in each direction and grading >= 1")
    along, across = cells(aspect, thickness, settings)
    s = np.linspace(0.0, 1.0, along + 1)
    x = 0.5 * aspect * (1.0 - (1.0 - s) ** settings.grading)
    return Grid(x, np.linspace(0.0, 0.5, across + 1))
