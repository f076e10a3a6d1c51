"""The files of the claims stage."""

import csv
import json
import math
from collections.abc import Iterable, Sequence
from typing import Any

from wrinklestudy.files.storage import atomic_path
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.finding import Claim, Finding
from wrinklestudy.typing import AnyPath

CLAIM_COLUMNS: dict[str, str] = {
    "number": "in the order of the publication",
    "key": "short name",
    "place": "section, figure or table where it is claimed",
    "statement": "what is claimed there, in the words of this project",
    "reading": "how the statement is understood for the test, if it leaves that open",
    "computed": "what was computed, rounded",
    "tolerance": "when the study counts as agreeing",
    "verdict": "agree, disagree, depends on or not computed",
    "depends_on": "on what, empty otherwise",
    "explanation": "with computed numbers, or what is missing",
    "sheets": "where the numbers come from",
    "values": "what was computed, with all digits (JSON; null: none or beyond the range)",
}


def claims(output: AnyPath, judged: Sequence[tuple[Claim, Finding]]) -> None:
    """Write the table of claims, one row each, columns `CLAIM_COLUMNS`."""
    _table(output, CLAIM_COLUMNS, (_claim(k, *pair) for k, pair in enumerate(judged, 1)))


def _claim(number: int, claim: Claim, finding: Finding) -> list[Any]:
    values = {v.name: v.number if math.isfinite(v.number) else None for v in finding.values}
    return [
        number,
        claim.key,
        claim.place,
        claim.statement,
        claim.reading,
        "; ".join(f"{value.name}: {value.text}" for value in finding.values),
        claim.tolerance,
        finding.verdict,
        finding.depends_on,
        finding.explanation,
        "; ".join(sheet.label for sheet in finding.sheets),
        json.dumps(values, ensure_ascii=False),
    ]


def extra_table(output: AnyPath, table: ExtraTable) -> None:
    """Write a further table; an empty cell means that there is no number."""
    _table(output, table.columns, ([_cell(value) for value in row] for row in table.rows))


def _cell(value: str | float) -> str | float:
    return "" if isinstance(value, float) and math.isnan(value) else value


def _table(output: AnyPath, columns: Iterable[str], rows: Iterable[Sequence[Any]]) -> None:
    with (
        atomic_path(output) as path,
        open(path, "w", newline="", encoding="utf-8") as file,
    ):
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(rows)


def text(output: AnyPath, content: str) -> None:
    """Write a text file, whole or not at all."""
    with atomic_path(output) as path:
        path.write_text(content, encoding="utf-8")
