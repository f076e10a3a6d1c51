"""All statements: source, reliability, sheet, what was published, what is computed, verdict."""

from collections.abc import Sequence

from wrinklestudy.mechanics.bending import BENDING_LAWS
from wrinklestudy.studies.literature.statement import RELIABILITIES, Published, Statement
from wrinklestudy.studies.literature.unread import OPEN, OPEN_STATEMENTS
from wrinklestudy.study.claims.discovery import load_claims
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.finding import Value
from wrinklestudy.study.claims.tables import StudyTables

_SHEET = ("law", "aspect", "thickness", "clamps")
COLUMNS = (
    *("number", "key", "source", "where", "reliability", "statement"),
    *(*_SHEET, "published"),
    *(f"computed_{name.replace('-', '_')}" for name in BENDING_LAWS),
    *("computed", "tolerance", "verdict", "depends_on", "explanation"),
)
_HEAD = (
    *("", "source, class", "sheet", "published"),
    *BENDING_LAWS,
    *("other", "verdict"),
)


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each statement, those without a verdict last."""
    rows: list[tuple[str | float, ...]] = []
    cells: list[tuple[str, ...]] = []

    def add(
        key: str,
        text: str,
        published: Published,
        values: Sequence[Value],
        judged: tuple[str, str, str, str],
    ) -> None:
        number = len(rows) + 1
        computed = _computed(values)
        sheet = tuple(getattr(published, name) for name in _SHEET)
        source = (published.source.name, published.where, published.reliability)
        rows.append((number, key, *source, text, *sheet, published.said, *computed, *judged))
        cells.append(
            (
                str(number),
                f"{published.place} ({published.reliability})",
                f"{sheet[0]}; L/W {sheet[1]}; {sheet[2]}",
                published.said,
                *computed,
                " ".join(judged[1:3]).rstrip(),
            )
        )

    for claim in load_claims("literature"):
        if isinstance(claim, Statement):
            found = claim.finding(study)
            judged = (claim.tolerance, found.verdict, found.depends_on, found.explanation)
            add(claim.key, claim.statement, claim.published, found.values, judged)
    for one in OPEN_STATEMENTS:
        add("", one.text, one.published, one.values(study), ("", OPEN, "", one.why))
    classes = "; ".join(f"{name}: {meaning}" for name, meaning in RELIABILITIES.items())
    note = (
        f"Class {classes}. A statement of class M has no verdict, nor has one without a number or "
        "trend that was read: open. Tolerances and explanations are with the statements above."
    )
    return ExtraTable(COLUMNS, tuple(rows), _HEAD, tuple(cells), note)


def _computed(values: Sequence[Value]) -> tuple[str, ...]:
    """Return the values under each bending law, then the others, as texts."""
    texts: dict[str, list[str]] = {name: [] for name in (*BENDING_LAWS, "")}
    for value in values:
        bending = next((name for name in BENDING_LAWS if value.name.endswith(f", {name}")), "")
        what = value.name.removesuffix(f", {bending}") if bending else value.name
        texts[bending].append(f"{what}: {value.text}")
    return tuple("; ".join(each) for each in texts.values())
