"""The critical thickness at small strain, and the exponent between neighbours."""

import numpy as np

from wrinklestudy.studies.beyond.thresholds import threshold
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number

COLUMNS = ("thickness", "birth_strain", "birth_strain_over_thickness_squared", "exponent")
_HEAD = ("t/W", "birth strain", "ε/(t/W)²", "exponent from the row before")
_FORMS = (".4e", ".3g", ".5g", ".4f")


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each strain below birth of the figure sheet."""
    found = threshold(study.sheet)
    slopes = np.diff(np.log(found.strain)) / np.diff(np.log(found.thickness))
    rows = tuple(
        zip(
            found.thickness.tolist(),
            found.strain.tolist(),
            (found.strain / found.thickness**2).tolist(),
            [float("nan"), *slopes.tolist()],
            strict=True,
        )
    )
    cells = tuple(
        tuple(number(value, form, missing="") for value, form in zip(row, _FORMS, strict=True))
        for row in rows
    )
    return ExtraTable(COLUMNS, rows, _HEAD, cells)
