"""The claims as one HTML page that needs nothing else."""

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from wrinklestudy.studies.panaitescu2019.table1 import TENSION_FIELD, Table1Row
from wrinklestudy.study.claims.finding import VERDICTS, Claim, Finding, Verdict
from wrinklestudy.study.claims.sheet import SheetStates
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number, render

_CLASSES: dict[Verdict, str] = {
    "agree": "agree",
    "disagree": "disagree",
    "depends on": "depends",
    "not computed": "missing",
}

_TITLE = (
    "Claims of “Birth and decay of tensional wrinkles in hyperelastic sheets” against the computed "
    "study"
)
_PAPER = (
    "A. Panaitescu, M. Xin, B. Davidovitch, J. Chopin, A. Kudrolli, Phys. Rev. E 100, 053003 "
    "(2019)."
)
_FOOTNOTE = (
    "Tolerances are stated with each claim and stand beside its rule in the program; every verdict "
    "follows from the computed numbers by that rule. “Depends on”: the verdict is another one for "
    "another version of the model or of the definition, which is named. “Not computed”: the study "
    "lacks a case or a measurement, which is named. Strains of birth and decay come from the "
    "eigenvalue problem of the flat sheet, maxima over strain from a parabola through the "
    "computed states. What only an experiment can tell (plasticity, scatter, errors, agreement "
    "with measured profiles) is not listed."
)


@dataclass(frozen=True)
class PageTable:
    """A table of the page besides the claims.

    Parameters
    ----------
    title : str
        Its heading.
    columns : sequence of str
    rows : sequence of sequences of str
        May be empty: the note then says what is missing.
    note : str
        What stands below.
    """

    title: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
    note: str = ""


def html_page(
    study: StudyTables, found: Sequence[tuple[Claim, Finding]], table1: Sequence[Table1Row]
) -> str:
    """Return the page.

    Parameters
    ----------
    study : StudyTables
    found : sequence of (Claim, Finding)
        In the order of the paper.
    table1 : sequence of Table1Row
        Table I; may be empty.
    """
    number = Counter(finding.verdict for _, finding in found)
    name, aspect, thickness = study.wanted
    return render(
        "claims.html.j2",
        title=_TITLE,
        source=f"{_PAPER} The sheet of the text is {name}, L/W = {aspect:g}, t/W = {thickness:g}.",
        counts={verdict: number[verdict] for verdict in VERDICTS},
        classes=_CLASSES,
        claims=[_entry(k, claim, finding) for k, (claim, finding) in enumerate(found, 1)],
        tables=[_table1(table1), _sheets(study.sheets)],
        footnote=_FOOTNOTE,
    )


def _entry(number: int, claim: Claim, finding: Finding) -> dict[str, Any]:
    """Return what the template says of a claim."""
    return {
        "number": number,
        "key": claim.key,
        "place": claim.place,
        "statement": claim.quotation,
        "reading": claim.reading,
        "tolerance": claim.tolerance,
        "kind": _CLASSES[finding.verdict],
        "verdict": finding.verdict,
        "depends_on": finding.depends_on,
        "computed": finding.values,
        "explanation": finding.explanation,
        "sheets": finding.sheets,
    }


def _table1(rows: Sequence[Table1Row]) -> PageTable:
    title = "Table I with computed values"
    if not rows:
        lack = "Not computed: the study lacks wrinkled states of the sheet of the text."
        return PageTable(title, (), (), lack)
    head = (
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
    body = [
        (
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
        for row in rows
    ]
    formulas = "; ".join(
        sorted({f"{row.quantity} = {row.current} ({row.original})" for row in rows})
    )
    note = (
        "Widths over W on the mid-line, ν = 1/2. Current version (original model): "
        f"{formulas}. {TENSION_FIELD.capitalize()} has no closed form here and is not solved by "
        "the study."
    )
    return PageTable(title, head, body, note)


def _signed(value: float) -> str:
    return "" if math.isnan(value) else f"{value:+.5f}"


def _sheets(sheets: Iterable[SheetStates]) -> PageTable:
    head = (
        "model",
        "law",
        "bending",
        "parity",
        "L/W",
        "t/W",
        "birth",
        "decay",
        "max τ/W",
        "max A/t",
        "at ε",
        "wrinkled",
        "flat",
        "failed",
        "cells",
    )
    return PageTable("Sheets of the study", head, [_sheet(sheet) for sheet in sheets])


def _sheet(sheet: SheetStates) -> tuple[str, ...]:
    states = Counter(sheet.status)
    cells = [sheet.peak.get(name, math.nan) for name in ("cells_along", "cells_across")]
    return (
        sheet.material,
        sheet.law,
        sheet.bending,
        sheet.parity,
        f"{sheet.aspect:g}",
        f"{sheet.thickness:g}",
        number(sheet.birth, ".4f", missing=""),
        number(sheet.decay, ".4f", missing=""),
        number(sheet.max_critical_thickness, ".2e", missing=""),
        number(sheet.peak.get("max_amplitude_over_thickness", math.nan), ".3f", missing=""),
        number(sheet.peak.get("strain_at_max_amplitude", math.nan), ".3f", missing=""),
        *(str(states[status]) for status in ("wrinkled", "flat", "not-converged")),
        " x ".join(number(value, ".0f", missing="") for value in cells),
    )
