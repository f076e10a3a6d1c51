"""Table I of the paper, widths in its version and in the original model, with computed values."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.studies.panaitescu2019.field import SheetField, sheet_field
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.typing import Array

# Strains of the table; the nearest wrinkled states are shown, without repetitions
STRAINS = (0.05, 0.1, 0.2, 0.3)
LARGEST = "largest deviation"

_LINEAR = "W (1 - ν ε)"
TENSION_FIELD = "tension field theory"


@dataclass(frozen=True)
class Table1Row:
    """A line of the table, widths over W, nu = 1/2.

    Parameters
    ----------
    quantity : str
        W_act or W_proj.
    strain : float
        Strain of the state.
    computed : float
        Width of the computed state.
    planar : float
        Width of the flat state of this strain.
    current, original : str
        Formulas of the paper's version and of the original Cerda-Mahadevan model.
    current_value, original_value : float
        Their values; NaN where the tension field that the paper refers to was not solved.
    note : str
        What the line is apart from a comparison with both formulas at one strain.
    """

    quantity: str
    strain: float
    computed: float
    planar: float
    current: str
    current_value: float
    original: str
    original_value: float
    note: str = ""

    @property
    def deviation_from_current(self) -> float:
        """Computed minus current version."""
        return self.computed - self.current_value

    @property
    def deviation_from_original(self) -> float:
        """Computed minus original model."""
        return self.computed - self.original_value


COLUMNS = (
    "quantity",
    "strain",
    "computed",
    "planar",
    "current",
    "current_value",
    "deviation_from_current",
    "original",
    "original_value",
    "deviation_from_original",
    "note",
)
_HEAD = (
    "width",
    "ε",
    "computed",
    "flat state",
    "current version",
    "difference",
    "original CM model",
    "difference",
    "",
)


def table(study: StudyTables) -> ExtraTable:
    """Return the table as the claims stage writes and shows it."""
    lines = rows(study)
    values = tuple(tuple(getattr(line, name) for name in COLUMNS) for line in lines)
    if not lines:
        lack = "Not computed: the study lacks wrinkled states of the sheet of the text."
        return ExtraTable(COLUMNS, values, note=lack)
    return ExtraTable(COLUMNS, values, _HEAD, tuple(map(_cells, lines)), _note(study, lines))


def _cells(row: Table1Row) -> tuple[str, ...]:
    return (
        row.quantity,
        f"{row.strain:g}",
        f"{row.computed:.5f}",
        f"{row.planar:.5f}",
        row.current if math.isnan(row.current_value) else f"{row.current_value:.5f}",
        _signed(row.deviation_from_current),
        f"{row.original_value:.5f}",
        _signed(row.deviation_from_original),
        row.note,
    )


def _note(study: StudyTables, lines: Sequence[Table1Row]) -> str:
    """Return the note on the formulas behind the columns."""
    formulas = "; ".join(
        dict.fromkeys(f"{line.quantity} = {line.current} ({line.original})" for line in lines)
    )
    field = _field(study)
    solved = (
        "has no closed form here and is not solved by the study"
        if field is None
        else "has no closed form here and is solved numerically, for a sheet without thickness, "
        f"at {len(field.strain)} strains"
    )
    return (
        f"Widths over W on the mid-line, ν = 1/2. Current version (original model): {formulas}. "
        f"{TENSION_FIELD.capitalize()} {solved}."
    )


def _signed(value: float) -> str:
    return "" if math.isnan(value) else f"{value:+.5f}"


def rows(study: StudyTables) -> list[Table1Row]:
    """Return the table for the paper's sheet; empty if it has no wrinkled state."""
    try:
        sheet = study.sheet
        strain, arc, projected, planar = sheet.wrinkled(
            "strain",
            "arc_width_over_width",
            "projected_width_over_width",
            "planar_width_over_width",
        )
    except MissingError:
        return []
    linear, whole = theory.actual_width(strain), np.ones_like(strain)
    actual = _quantity("W_act", strain, arc, planar, (_LINEAR, linear), ("W", whole))
    field = _field(study)
    if field is None:
        nothing = np.full_like(strain, np.nan)
        current = (TENSION_FIELD, nothing)
        return [
            *actual,
            *_quantity("W_proj", strain, projected, planar, current, (_LINEAR, linear)),
        ]
    current = (TENSION_FIELD, field.at("projected_width", strain))
    of_field = (TENSION_FIELD, field.at("arc_width", strain))
    return [
        *actual,
        *_quantity("W_act", strain, arc, planar, of_field, ("W", whole), f"with {TENSION_FIELD}"),
        *_quantity("W_proj", strain, projected, planar, current, (_LINEAR, linear)),
    ]


def _field(study: StudyTables) -> SheetField | None:
    try:
        return sheet_field(study)
    except MissingError:
        return None


def _quantity(
    name: str,
    strain: Array,
    computed: Array,
    planar: Array,
    current: tuple[str, Array],
    original: tuple[str, Array],
    instead: str = "",
) -> list[Table1Row]:
    """Return the lines of one quantity: at a few strains, then the largest deviations.

    Parameters
    ----------
    instead : str
        What these lines compare with in place of the paper's version, if anything.
    """

    def row(k: int, note: str) -> Table1Row:
        return Table1Row(
            name,
            float(strain[k]),
            float(computed[k]),
            float(planar[k]),
            current[0],
            float(current[1][k]),
            original[0],
            float(original[1][k]),
            note,
        )

    shown = sorted({int(np.argmin(np.abs(strain - wanted))) for wanted in STRAINS})
    lines = [row(k, instead) for k in shown]
    versions = [(TENSION_FIELD if instead else "current version", current[1])]
    if not instead:
        versions.append(("original model", original[1]))
    for text, value in versions:
        if np.isfinite(value).any():
            largest = int(np.nanargmax(np.abs(computed - value)))
            lines.append(row(largest, f"{LARGEST} from {text}"))
    return lines
