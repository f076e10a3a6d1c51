"""The claims of a study as a Markdown page, a section for each question of the study."""

from collections.abc import Sequence
from typing import Any

from wrinklestudy.study.catalogue import Catalogue, FigureEntry, SectionEntry
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.finding import Claim, Finding
from wrinklestudy.study.pages import render


def markdown_page(
    catalogue: Catalogue,
    judged: Sequence[tuple[Claim, Finding]],
    tables: Sequence[ExtraTable],
) -> str:
    """Return the page: what was asked, the figures, each claim with its finding, the tables.

    Pictures are linked below a folder with the name of the study, so that page and folder can be
    put side by side.

    Parameters
    ----------
    catalogue : Catalogue
        What the page is about; without sections there is one, with all claims, figures and tables.
    judged : sequence of (Claim, Finding)
        In the order of `Claim.order`.
    tables : sequence of ExtraTable
        Those of the catalogue, in its order.
    """
    by_name = dict(zip((entry.name for entry in catalogue.tables), tables, strict=True))
    sections = catalogue.sections or (_everything(catalogue),)
    return render(
        "claims.md.j2",
        title=catalogue.title,
        source=catalogue.citation,
        folder=catalogue.name,
        sections=[
            {
                "title": section.title,
                "asked": section.asked,
                "figures": [_captioned(catalogue.figure(name)) for name in section.figures],
                "claims": [
                    {
                        "claim": claim,
                        "finding": finding,
                        "computed": [(value.name, value.text) for value in finding.values],
                    }
                    for claim, finding in judged
                    if section.number in (claim.order[0], _ALL)
                ],
                "tables": [
                    {"entry": catalogue.table(name), "content": by_name[name]}
                    for name in section.tables
                ],
            }
            for section in sections
        ],
    )


# No claim begins with this number: the one section of a study without any has all claims.
_ALL = -1


def _everything(catalogue: Catalogue) -> SectionEntry:
    return SectionEntry(
        number=_ALL,
        title="Claims",
        asked="",
        figures=catalogue.figure_names,
        tables=tuple(entry.name for entry in catalogue.tables),
    )


def _captioned(figure: FigureEntry) -> dict[str, Any]:
    return {"name": figure.name, "caption": figure.caption}
