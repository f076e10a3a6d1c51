"""The tension field of the paper's sheet, as far as the study has it."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.typing import Array

_SAME = 1e-9  # of a strain


@dataclass(frozen=True, eq=False)
class SheetField:
    """What tension field theory says of the paper's sheet, arrays over its strains, (n,).

    Parameters
    ----------
    strain : array
    arc_width, projected_width : array
        Over W, on the mid-line.
    phi_squared : array
        (W_act - W_proj)/W_proj.
    """

    strain: Array
    arc_width: Array
    projected_width: Array
    phi_squared: Array

    def at(self, name: str, strain: Array) -> Array:
        """Return a quantity at strains, NaN where the field was not solved."""
        values = np.full(len(strain), np.nan)
        for k, wanted in enumerate(strain):
            same = np.flatnonzero(np.abs(self.strain - wanted) <= _SAME)
            if len(same):
                values[k] = getattr(self, name)[same[0]]
        return values


def sheet_field(study: StudyTables) -> SheetField:
    """Return the tension field of the paper's sheet at all strains where it converged.

    Raises
    ------
    MissingError
        If the study has none, or lacks the sheet.
    """
    sheet = study.sheet
    try:
        table = study.table("tension")
    except MissingError:
        raise MissingError(f"tension fields of {_name(study)}") from None
    own = table[(table["material"] == sheet.material) & (table["aspect"] == sheet.aspect)]
    # what is left of the law in the energy is no tension field theory
    solved = own[(own["status"] != "not-converged") & (own["remainder"] == 0.0)]
    if not len(solved):
        raise MissingError(f"tension fields of {_name(study)}")
    names = ["strain", "arc_width_over_width", "projected_width_over_width", "phi_squared"]
    return SheetField(*solved.sort_values("strain")[names].to_numpy(float).T)


def _name(study: StudyTables) -> str:
    return f"{study.sheet.material}, L/W = {study.sheet.aspect:g}"
