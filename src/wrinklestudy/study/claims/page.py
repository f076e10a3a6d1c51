"""The claims as one HTML page that needs nothing else."""

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from html import escape

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.catalogue import Catalogue
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.finding import VERDICTS, Claim, Finding, Verdict
from wrinklestudy.study.claims.tables import StudyTables

_CLASSES: dict[Verdict, str] = {
    "agree": "agree",
    "disagree": "disagree",
    "depends on": "depends",
    "not computed": "missing",
}

_STYLE = """
:root { --agree: #00664a; --disagree: #a33b00; --depends: #7a5c00; --missing: #555; }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, sans-serif; color: #1a1a1a; background: #fff;
  max-width: 66rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; line-height: 1.25; margin-bottom: .3rem; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; }
.overview td, .overview th { padding: .2rem .5rem; }
.counts { display: flex; flex-wrap: wrap; gap: .6rem; margin: 1rem 0; padding: 0;
  list-style: none; }
.counts li { border: 1px solid; border-radius: .4rem; padding: .35rem .8rem; font-weight: 600; }
.agree { color: var(--agree); } .disagree { color: var(--disagree); }
.depends { color: var(--depends); } .missing { color: var(--missing); }
article { border: 1px solid #ccc; border-left: .4rem solid; border-radius: .3rem;
  margin: .9rem 0; padding: .6rem .9rem; break-inside: avoid; }
article > * { color: #1a1a1a; }
article header { display: flex; flex-wrap: wrap; gap: .2rem .8rem; align-items: baseline; }
.number { font-weight: 600; min-width: 1.6rem; } .place { color: #555; flex: 1; }
.verdict { font-weight: 700; }
blockquote { margin: .3rem 0 .5rem; font-family: Georgia, serif; font-size: 1.05rem; }
dl { display: grid; grid-template-columns: 6.5rem 1fr; gap: .15rem .8rem; margin: 0; }
dt { color: #555; } dd { margin: 0; }
dd.values { display: grid; grid-template-columns: auto 1fr; column-gap: 1rem; }
table { border-collapse: collapse; width: 100%; font-size: .78rem;
  font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: .2rem .3rem; border-bottom: 1px solid #ddd;
  white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
thead th { border-bottom: 2px solid #999; vertical-align: bottom; }
.overview td { text-align: left; vertical-align: top; white-space: normal; }
.overview td:first-child { text-align: right; } .overview td:last-child { white-space: nowrap; }
.scroll { overflow-x: auto; }
.cases { color: #555; font-size: .88rem; }
footer { margin: 2.5rem 0; border-top: 1px solid #ccc; padding-top: .6rem; color: #444;
  font-size: .9rem; }
@media (max-width: 36rem) { dl, dd.values { grid-template-columns: 1fr; } }
"""

_FOOTNOTE = (
    "Tolerances are stated with each claim and stand beside its rule in the program; every verdict "
    "follows from the computed numbers by that rule. “Depends on”: the verdict is another one for "
    "another version of the model or of the definition, which is named. “Not computed”: the study "
    "lacks a case or a measurement, which is named. Strains of birth and decay come from the "
    "eigenvalue problem of the flat sheet, maxima over strain from a parabola through the "
    "computed states. What only an experiment can tell (plasticity, scatter, errors, agreement "
    "with measured profiles) is not listed."
)


def html_page(
    catalogue: Catalogue,
    study: StudyTables,
    found: Sequence[tuple[Claim, Finding]],
    tables: Sequence[ExtraTable],
) -> str:
    """Return the page.

    Parameters
    ----------
    catalogue : Catalogue
        What the page is about.
    study : StudyTables
    found : sequence of (Claim, Finding)
        In the order of the publication.
    tables : sequence of ExtraTable
        Those of the catalogue, in its order.
    """
    name, aspect, thickness = study.wanted
    sections = [
        f"<h1>Claims of “{escape(catalogue.title)}” against the computed study</h1>",
        f"<p>{escape(f'{catalogue.citation} '.lstrip())}The sheet of the text is {escape(name)}, "
        f"L/W = {aspect:g}, t/W = {thickness:g}.</p>",
        _counts(found),
        "<h2>Overview</h2>",
        _overview(found),
        "<h2>Claims, in the order of the publication</h2>",
        *(_article(k, claim, finding) for k, (claim, finding) in enumerate(found, 1)),
        *(
            f"<h2>{escape(entry.title)}</h2>\n{_extra_table(table)}"
            for entry, table in zip(catalogue.tables, tables, strict=True)
        ),
        "<h2>Sheets of the study</h2>",
        _sheets(study.sheets),
        f"<footer><p>{_FOOTNOTE}</p></footer>",
    ]
    body = "\n".join(sections)
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>Claims and computed values</title>\n<style>{_STYLE}</style>\n</head>\n"
        f"<body>\n{body}\n</body>\n</html>\n"
    )


def _counts(found: Sequence[tuple[Claim, Finding]]) -> str:
    number = Counter(finding.verdict for _, finding in found)
    items = (
        f'<li class="{_CLASSES[verdict]}">{number[verdict]} {verdict}</li>' for verdict in VERDICTS
    )
    return f'<ul class="counts">{"".join(items)}</ul>'


def _overview(found: Sequence[tuple[Claim, Finding]]) -> str:
    rows = "\n".join(
        f"<tr><td>{number}</td><td>{escape(claim.statement)}</td>"
        f'<td class="{_CLASSES[finding.verdict]}">{finding.verdict}</td></tr>'
        for number, (claim, finding) in enumerate(found, 1)
    )
    return f'<table class="overview"><tbody>\n{rows}\n</tbody></table>'


def _article(number: int, claim: Claim, finding: Finding) -> str:
    kind = _CLASSES[finding.verdict]
    verdict = escape(f"{finding.verdict} {finding.depends_on}".strip())
    entries = [("Reading", escape(claim.reading))] if claim.reading else []
    if finding.values:
        cells = "".join(
            f"<span>{escape(value.name)}</span><b>{escape(value.text)}</b>"
            for value in finding.values
        )
        entries.append(("Computed", cells))
    entries.append(("Tolerance", escape(claim.tolerance)))
    if finding.explanation:
        entries.append(("Finding", escape(finding.explanation)))
    if finding.sheets:
        cases = "; ".join(escape(sheet.label) for sheet in finding.sheets)
        entries.append(("Cases", f'<span class="cases">{cases}</span>'))
    rows = "\n".join(
        f"<dt>{name}</dt><dd{_values_class(name)}>{content}</dd>" for name, content in entries
    )
    return (
        f'<article class="{kind}" id="{claim.key}">\n'
        f'<header><span class="number">{number}</span>'
        f'<span class="place">{escape(claim.place)}</span>'
        f'<span class="verdict {kind}">{verdict}</span></header>\n'
        f"<blockquote>{escape(claim.statement)}</blockquote>\n<dl>\n{rows}\n</dl>\n</article>"
    )


def _values_class(name: str) -> str:
    return ' class="values"' if name == "Computed" else ""


def _extra_table(table: ExtraTable) -> str:
    shown = _table(table.head, table.cells) if table.head else ""
    kind = ' class="cases"' if shown else ""
    return f"{shown}<p{kind}>{escape(table.note)}</p>"


def _sheets(sheets: Iterable[SheetStates]) -> str:
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
    return _table(head, (_sheet(sheet) for sheet in sheets))


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
        _number(sheet.birth, ".4f"),
        _number(sheet.decay, ".4f"),
        _number(sheet.max_critical_thickness, ".2e"),
        _number(sheet.peak.get("max_amplitude_over_thickness", math.nan), ".3f"),
        _number(sheet.peak.get("strain_at_max_amplitude", math.nan), ".3f"),
        *(str(states[status]) for status in ("wrinkled", "flat", "not-converged")),
        " x ".join(_number(value, ".0f") for value in cells),
    )


def _number(value: float, form: str) -> str:
    return "" if math.isnan(value) else format(value, form)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    top = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    lines = "\n".join(
        f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows
    )
    return (
        f'<div class="scroll"><table>\n<thead><tr>{top}</tr></thead>\n'
        f"<tbody>\n{lines}\n</tbody></table></div>"
    )
