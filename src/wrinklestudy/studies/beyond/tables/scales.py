"""Wavelength and length of the wrinkles of every wrinkled state of the paper's rubber."""

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond.claims.scales import of_the_rubber
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number

COLUMNS = (
    "aspect",
    "thickness",
    "strain",
    "wavelength_over_width",
    "material_wavelength_over_width",
    "wavelength_over_scaled_theory",
    "envelope_length_over_width",
    "deformed_envelope_length_over_width",
    "peak_x_over_length",
)
_HEAD = ("L/W", "t/W", "ε", "λ/W", "λ/W undef.", "λ/0.8 CM", "l/W undef.", "l/W", "X/L of peak")
_FORMS = ("g", "g", "g", ".4f", ".4f", ".3f", ".3f", ".3f", ".2f")


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each wrinkled state."""
    try:
        found = of_the_rubber(study)
    except MissingError as lack:
        return ExtraTable(COLUMNS, (), note=f"Not in the study: {lack}.")
    columns = (
        *(found.aspect, found.thickness, found.strain),
        *(found.wavelength, found.material_wavelength, found.against_theory),
        *(found.material_envelope, found.envelope, found.place),
    )
    rows = tuple(zip(*(column.tolist() for column in columns), strict=True))
    cells = tuple(
        tuple(number(value, form) for value, form in zip(row, _FORMS, strict=True)) for row in rows
    )
    return ExtraTable(COLUMNS, rows, _HEAD, cells)
