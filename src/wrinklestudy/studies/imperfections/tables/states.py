"""Every state of the imperfect sheets."""

from typing import Any

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number

# Column, heading, format of a number.
_SHOWN = (
    ("imperfection", "sheet", ""),
    ("strain", "ε", "g"),
    ("status", "status", ""),
    ("amplitude_low", "A/t, least", ".4f"),
    ("amplitude_high", "A/t, largest", ".4f"),
    ("envelope_amplitude", "envelope/t", ".4f"),
    ("tilt", "tilt (rad)", ".2e"),
    ("shift_along", "shift along/W", ".2e"),
    ("shift_across", "shift across/W", ".2e"),
    ("pin_reaction", "pin", ".1e"),
    ("softest_eigenvalue", "softest", ".1e"),
    ("parity_energy", "odd - even", ".2e"),
    ("newton_iterations", "iterations", ".0f"),
)


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each imperfect sheet and strain."""
    try:
        rows = study.table("imperfection")
    except MissingError as lack:
        return ExtraTable(
            tuple(name for name, _, _ in _SHOWN), (), note=f"Not in the study: {lack}."
        )
    several = len({(r.material, r.aspect, r.thickness) for r in rows.itertuples()}) > 1
    label = ("material", "material", "") if several else None
    shown = (*([label] if label else []), *_SHOWN)
    cells = tuple(
        tuple(_text(row[name], form) for name, _, form in shown) for row in rows.to_dict("records")
    )
    return ExtraTable(
        tuple(str(name) for name in rows.columns),
        tuple(tuple(row) for row in rows.itertuples(index=False)),
        tuple(head for _, head, _ in shown),
        cells,
        "A/t: least and largest over the phase of the pattern, beyond the sheet without wrinkles. "
        "Shift: of the middle of the wrinkles. Pin: what it carries against sliding, over its "
        "stiffness and t. Odd - even: energy of the antisymmetric state less that of the symmetric "
        "one, over that of bending. Iterations: of both.",
    )


def _text(value: Any, form: str) -> str:
    return number(float(value), form, missing="") if form else str(value)
