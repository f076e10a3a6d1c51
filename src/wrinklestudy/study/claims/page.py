"""The claims as one HTML page that needs no other file."""

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.catalogue import Catalogue
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.finding import VERDICTS, Claim, Finding, Verdict
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number, render

_CLASSES: dict[Verdict, str] = {
    "agree": "agree",
    "disagree": "disagree",
    "depends on": "depends",
    "not computed": "missing",
}

_FOOTNOTE = (
    "Each tolerance is stated with its claim; every verdict follows from the computed numbers by "
    "the rule of the claim. “Depends on”: the verdict differs between versions of the model or of "
    "a definition, which are named. “Not computed”: the study lacks a case or a measurement, "
    "which is named. Strains of birth and decay come from the eigenvalue problem of the flat "
    "sheet, maxima over strain from a parabola through the computed states. What only an "
    "experiment can tell (plasticity, scatter, errors, agreement with measured profiles) is not "
    "listed."
)


@dataclass(frozen=True)
class PageTable:
    """A table on the page besides the claims.

    Parameters
    ----------
    title : str
        Heading.
    columns : sequence of str
    rows : sequence of sequences of str
        May be empty: the note then says what is missing.
    note : str
        Text below the table.
    """

    title: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
    note: str = ""


def html_page(
    catalogue: Catalogue,
    study: StudyTables,
    judged: Sequence[tuple[Claim, Finding]],
    tables: Sequence[ExtraTable],
) -> str:
    """Return the page of the claims.

    Parameters
    ----------
    catalogue : Catalogue
        What the page is about.
    study : StudyTables
    judged : sequence of (Claim, Finding)
        In the order of the publication.
    tables : sequence of ExtraTable
        Those of the catalogue, in its order.
    """
    number = Counter(finding.verdict for _, finding in judged)
    name, aspect, thickness = study.wanted
    return render(
        "claims.html.j2",
        title=f"Claims of “{catalogue.title}” against the computed study",
        source=f"{catalogue.citation} The sheet of the text is {name}, L/W = {aspect:g}, "
        f"t/W = {thickness:g}.".lstrip(),
        counts={verdict: number[verdict] for verdict in VERDICTS},
        classes=_CLASSES,
        claims=[_entry(k, claim, finding) for k, (claim, finding) in enumerate(judged, 1)],
        tables=[
            *(
                PageTable(entry.title, table.head, table.cells, table.note)
                for entry, table in zip(catalogue.tables, tables, strict=True)
            ),
            _sheets(study.sheets),
        ],
        footnote=_FOOTNOTE,
    )


def _entry(number: int, claim: Claim, finding: Finding) -> dict[str, Any]:
    """Return a claim as the template needs it."""
    return {
        "number": number,
        "key": claim.key,
        "place": claim.place,
        "statement": claim.statement,
        "reading": claim.reading,
        "tolerance": claim.tolerance,
        "kind": _CLASSES[finding.verdict],
        "verdict": finding.verdict,
        "depends_on": finding.depends_on,
        "computed": finding.values,
        "explanation": finding.explanation,
        "sheets": finding.sheets,
    }


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
