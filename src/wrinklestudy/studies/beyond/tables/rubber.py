"""Birth, decay and largest amplitude of each rubber."""

import math

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.studies.beyond.claims.sensitivity import size_of
from wrinklestudy.studies.beyond.rubber import NUMBERS, ratio, share
from wrinklestudy.studies.beyond.selections import CHECK, POISSON, RATIO, named
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number

COLUMNS = (
    "material",
    "c01_over_c10",
    "poisson",
    "birth_strain",
    "decay_strain",
    "max_critical_thickness",
    "strain_at_max_amplitude",
    "max_amplitude_over_thickness",
)
_HEAD = ("material", "C01/C10", "ν", "birth", "decay", "max τ₁/W", "at ε", "max A/t")
_FORMS = ("s", ".4g", ".3g", ".4f", ".4f", ".3e", ".3f", ".3f")


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each rubber of the size of the figure sheet."""
    sheets = [s for s in size_of(study) if s.material in study.given]
    own = [s for s in size_of(study) if s.material == study.wanted[0]]
    ratios = [_row(study, sheet) for sheet in [*own, *named(sheets, RATIO, CHECK)]]
    others = [_row(study, sheet) for sheet in named(sheets, POISSON)]
    rows = [*sorted(ratios, key=lambda row: row[1]), *sorted(others, key=lambda row: row[2])]
    cells = tuple(
        tuple(
            value if isinstance(value, str) else number(value, form, missing="")
            for value, form in zip(row, _FORMS, strict=True)
        )
        for row in rows
    )
    return ExtraTable(
        COLUMNS,
        tuple(rows),
        _HEAD,
        cells,
        "Errors of birth and decay come from the mesh (docs/verification.md, some 0.1%); the "
        "largest A/t from a parabola through few strains.",
    )


def _row(study: StudyTables, sheet: SheetStates) -> tuple[str | float, ...]:
    material = study.given.get(sheet.material) or study.material.fit.material()
    poisson = sheet.material.startswith(POISSON)
    constants = (
        (math.nan, material.law.poisson) if poisson else (float(ratio(share(material))), math.nan)
    )
    return (
        sheet.material,
        *constants,
        *(sheet.birth, sheet.decay),
        *(sheet.max_critical_thickness, sheet.peak["strain_at_max_amplitude"]),
        sheet.peak[NUMBERS["largest A/t"]],
    )
