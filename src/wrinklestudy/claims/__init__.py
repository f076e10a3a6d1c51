"""Claims stage: every statement of the paper that a simulation can test, with a verdict.

`registry.CLAIMS` holds the statements in the order of the paper, each with its words, the
reading that is tested, a tolerance and a rule from the tables of the study to a `Finding`; the
rules are in one module per topic. Nothing but the tables and the material files is read. Importing
this package loads nothing else.
"""

from collections.abc import Sequence
from os import PathLike

Path = str | PathLike[str]


def run(
    states: Path,
    stability: Path,
    peaks: Path,
    materials: Sequence[Path],
    sheet: tuple[str, float, float],
    output: Path,
    page: Path,
    table: Path,
) -> None:
    """Judge all claims and write the table of claims, a page to read and the paper's Table I.

    A claim for which the study lacks a case is written with the verdict ``not computed`` and what
    is missing. The same inputs give the same bytes.

    Parameters
    ----------
    states, stability, peaks : path-like
        Tables of the summary stage.
    materials : sequence of path-like
        Files of the material stage.
    sheet : tuple of (str, float, float)
        Model, L/W and t/W of the sheet that the paper's text is about.
    output : path-like
        CSV file of the claims, columns `write.CLAIM_COLUMNS`.
    page : path-like
        HTML page, complete in itself.
    table : path-like
        CSV file of Table I, columns `table1.COLUMNS`.

    Raises
    ------
    ValueError
        If an input lacks a column or a key, or a cell is no number; one line that names the file.
    """
    from wrinklestudy.claims import table1, write
    from wrinklestudy.claims.page import html_page
    from wrinklestudy.claims.registry import CLAIMS
    from wrinklestudy.claims.study import load

    study = load(states, stability, peaks, materials, sheet)
    found = [(claim, claim.found(study)) for claim in CLAIMS]
    lines = table1.rows(study)
    text = html_page(study, found, lines)
    write.claims(output, found)
    write.table1(table, lines)
    write.text(page, text)
