"""The claims stage: every statement of a study with a verdict."""

from collections.abc import Mapping, Sequence

from wrinklestudy.typing import AnyPath


def run(
    states: AnyPath,
    stability: AnyPath,
    peaks: AnyPath,
    materials: Sequence[AnyPath],
    sheet: tuple[str, float, float],
    output: Mapping[str, AnyPath],
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
    output : mapping
        Files to write: ``csv``, the claims (columns `write.CLAIM_COLUMNS`), ``page``, an HTML page
        that is complete in itself, and ``table``, Table I as CSV (columns `table1.COLUMNS`).

    Raises
    ------
    ValueError
        If an input lacks a column or a key, or a cell is no number; one line that names the file.
    """
    from wrinklestudy.studies.panaitescu2019 import table1
    from wrinklestudy.studies.panaitescu2019.claims.registry import CLAIMS
    from wrinklestudy.study.claims import write
    from wrinklestudy.study.claims.page import html_page
    from wrinklestudy.study.claims.tables import load

    study = load(states, stability, peaks, materials, sheet)
    found = [(claim, claim.found(study)) for claim in CLAIMS]
    lines = table1.rows(study)
    text = html_page(study, found, lines)
    write.claims(output["csv"], found)
    write.table1(output["table"], lines)
    write.text(output["page"], text)
