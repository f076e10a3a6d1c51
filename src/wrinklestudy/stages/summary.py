"""Summary stage: the tables of the whole study, put together from those of its sheets.

Three plain CSV files: all states (columns `metrics.table.COLUMNS`), birth and decay of all sheets
(`metrics.table.STABILITY_COLUMNS`) and the peak of each sheet over strain (`PEAK_COLUMNS`).
"""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any

from wrinklestudy.results.peaks import PEAK_COLUMNS, Row, peak_row
from wrinklestudy.results.table import (
    CASE,
    COLUMNS,
    STABILITY_COLUMNS,
    read_states,
    refuse_twins,
    stability_row,
    write_table,
)
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
        If a file lacks something, two files hold the same case, or a sheet has states and no
        stability file or the other way round; one line that names the file or the sheet.
    """
    found = [(row, path) for path in metrics for row in read_states(path)]
    states = [row for row, _ in found]
    refuse_twins(states, (*CASE, "strain"), [path for _, path in found])
    limits = [stability_row(path) for path in stability]
    refuse_twins(limits, CASE, stability)
    peaks = [peak_row(limit, rows) for limit, rows in _paired(limits, states)]
    write_table(states, COLUMNS, (*CASE, "strain"), output["states"])
    write_table(limits, STABILITY_COLUMNS, CASE, output["stability"])
    write_table(peaks, PEAK_COLUMNS, CASE, output["peaks"])


def _paired(limits: Sequence[Row], states: Sequence[Row]) -> list[tuple[Row, list[Row]]]:
    """Return each sheet of the stability stage with its states by strain."""
    found: dict[tuple[Any, ...], list[Row]] = defaultdict(list)
    for row in sorted(states, key=lambda row: row["strain"]):
        found[_case(row)].append(row)
    wanted = {_case(limit): limit for limit in limits}
    for case in sorted(found.keys() ^ wanted.keys()):
        lacks = "stability file" if case in found else "states"
        raise ValueError(f"sheet {', '.join(map(str, case))}: has no {lacks}")
    return [(limit, found[case]) for case, limit in wanted.items()]


def _case(row: Row) -> tuple[Any, ...]:
    return tuple(row[name] for name in CASE)
