"""The tips of the islands of each model at fixed t/W and at fixed t/L."""

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond.tips import tips
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number

COLUMNS = (
    "material",
    "bending",
    "held",
    "thickness",
    "end",
    "aspect",
    "strain",
    "aspect_interpolated",
    "last_correction",
)
_HEAD = ("model", "held", "end", "L/W", "strain there", "L/W between those of the map")


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each tip; none without maps."""
    try:
        every = tips(study)
    except MissingError as lack:
        return ExtraTable(COLUMNS, (), note=f"Not in the study: {lack}.")
    rows = tuple(
        (t.model, t.bending, t.held, t.thickness, t.end, t.aspect, t.strain, t.between, t.change)
        for t in every
    )
    cells = tuple(
        (
            t.model,
            f"{t.held} = {t.thickness:g}",
            t.end,
            number(t.aspect, ".4f"),
            number(t.strain, ".3f"),
            f"{t.between:.4f}",
        )
        for t in every
    )
    note = (
        "L/W solved directly on the default mesh; last correction at most "
        f"{number(float(np.nanmax([0.0, *(abs(t.change) for t in every)])), '.2%')} of L/W."
    )
    return ExtraTable(COLUMNS, rows, _HEAD, cells, note)
