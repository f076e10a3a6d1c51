"""How sheets come to the tension field as they get thinner."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.studies.beyond.power_law import PowerLaw, power_law
from wrinklestudy.typing import Array

if TYPE_CHECKING:
    import pandas as pd

LEAST = 3  # thicknesses from which a rate is told
_SAME = 1e-9  # of a strain


@dataclass(frozen=True, eq=False)
class Approach:
    """Phi^2 of sheets of several thicknesses at one strain, and of the tension field.

    Parameters
    ----------
    strain : float
    thickness, phi_squared : ndarray, shape (n,)
        Of the wrinkled sheets, the thinnest first.
    field : float
        Phi^2 of the tension field.
    field_error : float
        Error of its mesh.
    """

    strain: float
    thickness: Array
    phi_squared: Array
    field: float
    field_error: float

    @property
    def deficit(self) -> Array:
        """What the sheets lack, as a part of the tension field's Phi^2."""
        return 1.0 - self.phi_squared / self.field

    @property
    def law(self) -> PowerLaw:
        """The deficit as a power of t/W, through the thinnest sheets."""
        return power_law(self.deficit[:LEAST], thickness=self.thickness[:LEAST])

    @property
    def extrapolated(self) -> float:
        """Phi^2 at t = 0 of the parabola through the three thinnest sheets, over the field's."""
        parabola = np.polynomial.Polynomial.fit(
            self.thickness[:LEAST], self.phi_squared[:LEAST], LEAST - 1
        )
        return float(parabola(0.0)) / self.field


def approaches(
    sheets: Iterable[SheetStates], fields: "pd.DataFrame", like: SheetStates
) -> list[Approach]:
    """Return the approach at each strain with a tension field and at least three wrinkled sheets.

    Parameters
    ----------
    sheets : iterable of SheetStates
    fields : DataFrame
        The table of the stage ``tension``.
    like : SheetStates
        Its model and L/W are meant.
    """
    own = [
        sheet
        for sheet in sheets
        if (sheet.material, sheet.aspect) == (like.material, like.aspect)
        and "wrinkled" in sheet.status
    ]
    own.sort(key=lambda sheet: sheet.thickness)
    states = [(sheet.thickness, sheet.wrinkled("strain", "phi_squared")) for sheet in own]
    rows = fields[(fields["material"] == like.material) & (fields["aspect"] == like.aspect)]
    wrinkled = rows[rows["status"] == "wrinkled"]
    approached = []
    for at, field, error in wrinkled[["strain", "phi_squared", "phi_squared_error"]].to_numpy(
        float
    ):
        points = [
            (thickness, float(phi_squared[k]))
            for thickness, (strain, phi_squared) in states
            for k in np.flatnonzero(np.abs(strain - at) <= _SAME)
        ]
        if len(points) >= LEAST:
            thickness, phi_squared = np.array(points).T
            approached.append(Approach(at, thickness, phi_squared, field, error))
    return approached
