"""The summary stage: the tables of the whole study, put together from those of its sheets.

These are three CSV files: all states, birth and decay of all sheets, and the peak of each sheet
over strain. Their columns are those of `results.rows`.
"""

from collections.abc import Mapping, Sequence

from wrinklestudy.results.load import by_sheet, read_limits
from wrinklestudy.results.peaks import sheet_row
from wrinklestudy.results.rows import key_text, refuse_twins
from wrinklestudy.results.tables import read_states, write_peaks, write_stability, write_states
from wrinklestudy.typing import AnyPath


def run(
    metrics: Sequence[AnyPath], stability: Sequence[AnyPath], output: Mapping[str, AnyPath]
) -> None:
    """Write the three tables of a study.

    The same files give the same bytes, whatever their order.

    Parameters
    ----------
    metrics : sequence of path-like
        Tables of the metrics stage, one per sheet.
    stability : sequence of path-like
        Files of the stability stage for the same sheets.
    output : mapping
        CSV files to write: ``states``, ``stability`` and ``peaks``.

    Raises
    ------
    ValueError
        If a file lacks something, two files hold the same case, or a sheet has states but no
        stability file, or the other way round; one line that names the file or the sheet.
    """
    tables = [(path, read_states(path)) for path in metrics]
    states = [row for _, rows in tables for row in rows]
    refuse_twins(states, [path for path, rows in tables for _ in rows])
    limits = [read_limits(path) for path in stability]
    refuse_twins(limits, stability)
    grouped = by_sheet(states)
    known = {row.sheet_key for row in limits}
    for sheet in sorted(grouped.keys() ^ known):
        lacks = "stability file" if sheet in grouped else "states"
        raise ValueError(f"sheet {key_text(sheet)}: has no {lacks}")
    sheets = [sheet_row(row, grouped[row.sheet_key]) for row in limits]
    write_states(states, output["states"])
    write_stability(sheets, output["stability"])
    write_peaks(sheets, output["peaks"])
