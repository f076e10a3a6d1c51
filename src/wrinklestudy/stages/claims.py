"""The claims stage: a verdict on every claim of a study."""

from collections.abc import Mapping, Sequence
from typing import Any

from wrinklestudy.typing import AnyPath


def run(
    study: str,
    states: AnyPath,
    stability: AnyPath,
    peaks: AnyPath,
    materials: Sequence[AnyPath],
    sheet: tuple[str, float, float],
    output: Mapping[str, Any],
    **analyses: AnyPath | Sequence[AnyPath],
) -> None:
    """Judge all claims; write the table of claims, a page to read and the further tables.

    A claim for which the study lacks a case is written with the verdict ``not computed`` and what
    is missing. The same inputs give the same bytes.

    Parameters
    ----------
    study : str
        Name of the study as in the config: `study.loading.load_catalogue`.
    states, stability, peaks : path-like
        Tables of the summary stage.
    materials : sequence of path-like
        Files of the material stage.
    sheet : tuple of (str, float, float)
        Model, L/W and t/W of the sheet that the claims are about.
    output : mapping
        Files to write: ``csv``, the claims (columns `write.CLAIM_COLUMNS`), ``page``, an HTML page
        that needs no other file, ``markdown``, the page of its sections in Markdown, and
        ``tables``, a sequence: the further tables of the catalogue as CSV, in its order.
    **analyses : path-like or sequence of path-like
        Files of the analyses of the study, by `results.analyses.input_name`.

    Raises
    ------
    ValueError
        If the study cannot be loaded, an input lacks a column or a key, or a cell is no number;
        one line that names study or file.
    """
    from importlib import import_module

    from wrinklestudy.results.analyses import analysis_files
    from wrinklestudy.study.claims import write
    from wrinklestudy.study.claims.discovery import load_claims
    from wrinklestudy.study.claims.page import html_page
    from wrinklestudy.study.claims.sections import markdown_page
    from wrinklestudy.study.claims.tables import load
    from wrinklestudy.study.loading import load_catalogue

    catalogue = load_catalogue(study)
    computed = load(states, stability, peaks, materials, sheet, analysis_files(analyses))
    judged = [(claim, claim.finding(computed)) for claim in load_claims(study)]
    extra = [import_module(entry.module).table(computed) for entry in catalogue.tables]
    text = html_page(catalogue, computed, judged, extra)
    sections = markdown_page(catalogue, judged, extra)
    write.claims(output["csv"], judged)
    for path, table in zip(output.get("tables", ()), extra, strict=True):
        write.extra_table(path, table)
    write.text(output["page"], text)
    write.text(output["markdown"], sections)
