"""Birth and decay of the paper's sheet as a solid, without any theory of plates.

The numbers are in ``solid.csv``, which ``make verify-solid`` writes: extrapolated in the mesh and
in K/mu, with what both extrapolations add as the error bar.
"""

import csv
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.claims.tables import FittedMaterial

FILE = Path(__file__).with_name("solid.csv")
COLUMNS = ("end", "strain", "bar", "aspect", "thickness", "c10_pa", "c01_pa", "date", "felupe")
# Constants that are fitted have a few digits only; decay changes by 2e-4 over this much of C01/C10
_SAME_RATIO = 0.01


@dataclass(frozen=True)
class SolidEnd:
    """A strain of the solid: of birth or of decay.

    Parameters
    ----------
    strain, bar : float
        The strain and its error bar.
    aspect, thickness, ratio : float
        L/W, t/W and C01/C10 of the sheet.
    """

    strain: float
    bar: float
    aspect: float
    thickness: float
    ratio: float

    def is_of(self, sheet: SheetStates, material: FittedMaterial) -> bool:
        """Return whether this is a strain of a sheet: of its size and constants."""
        constants = material.fit.constants
        if sheet.size != (self.aspect, self.thickness) or {*constants} != {"c10", "c01"}:
            return False
        ratio = constants["c01"] / constants["c10"] if constants["c10"] > 0.0 else float("inf")
        return abs(ratio / self.ratio - 1.0) <= _SAME_RATIO


@cache
def solid_ends() -> dict[str, SolidEnd]:
    """Return birth and decay of the solid."""
    return dict(_rows())


def _rows() -> Iterator[tuple[str, SolidEnd]]:
    with open(FILE, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            yield (
                row["end"],
                SolidEnd(
                    strain=float(row["strain"]),
                    bar=float(row["bar"]),
                    aspect=float(row["aspect"]),
                    thickness=float(row["thickness"]),
                    ratio=float(row["c01_pa"]) / float(row["c10_pa"]),
                ),
            )
