"""Where compression at the centre ends, for each L/W and C01/C10."""

from wrinklestudy.studies.beyond.claims.compression import study_endings
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number

COLUMNS = ("aspect", "ratio", "strain", "error", "returns", "least", "last")
_HEAD = (
    *("L/W", "C01/C10", "compression ends at ε", "error", "is back at ε"),
    *("smallest n/√b - 1 beyond its largest", "looked at up to ε"),
)
_FORMS = ("g", ".3g", ".4f", ".1g", ".3f", ".2g", "g")


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each L/W and ratio; compression that lasts has no strain."""
    rows = tuple(
        tuple(float(getattr(ending, name)) for name in COLUMNS) for ending in study_endings(study)
    )
    cells = tuple(
        tuple(number(value, form, missing="") for value, form in zip(row, _FORMS, strict=True))
        for row in rows
    )
    note = "Strains beyond those looked at are empty: compression lasts. "
    note += "n: natural width under uniaxial tension, b: smaller squared stretch, of flat sheets."
    return ExtraTable(COLUMNS, rows, _HEAD, cells, note)
