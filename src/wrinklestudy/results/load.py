"""Sheets with their states, read from the tables of a study or of single sheets."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from os import fspath
from typing import Any

from wrinklestudy.files.storage import read_json
from wrinklestudy.results.peaks import sheet_row
from wrinklestudy.results.rows import (
    SheetIdentity,
    StabilityRow,
    StateRow,
    columns,
    key_text,
    make_row,
)
from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.results.tables import read_sheets, read_states
from wrinklestudy.typing import AnyPath


def load_study(states: AnyPath, stability: AnyPath, peaks: AnyPath) -> list[SheetStates]:
    """Return the sheets of a study from the tables of the summary stage, sorted.

    Raises
    ------
    ValueError
        If a column is missing, a cell is not what its column allows, or a sheet is missing
        from one of the three tables; one line that names the file.
    """
    grouped = by_sheet(read_states(states))
    sheets = []
    for row in sorted(read_sheets(stability, peaks), key=lambda row: row.key):
        if row.key not in grouped:
            raise ValueError(f"{fspath(states)}: has no state of sheet {key_text(row.key)}")
        sheets.append(SheetStates(row, grouped.pop(row.key)))
    for key in grouped:
        raise ValueError(f"{fspath(peaks)}: has no sheet {key_text(key)}")
    return sheets


def load_sheets(metrics: Sequence[AnyPath], stability: Sequence[AnyPath]) -> list[SheetStates]:
    """Return the sheets of some tables of the metrics stage, in their order.

    What a sheet reaches over strain is determined as in the summary stage.

    Parameters
    ----------
    metrics : sequence of path-like
        Tables of the metrics stage.
    stability : sequence of path-like
        Files of the stability stage; a sheet without one has no birth and decay.

    Raises
    ------
    ValueError
        If a table has no rows, lacks a column or has a cell that is not what its column allows;
        one line that names the file.
    """
    tables = [(path, read_states(path)) for path in metrics]
    for path, rows in tables:
        if not rows:
            raise ValueError(f"{fspath(path)}: has no rows")
    limits = {row.key: row for row in map(read_limits, stability)}
    grouped = by_sheet(row for _, rows in tables for row in rows)
    return [
        SheetStates(sheet_row(limits.get(key) or _unknown_limits(states[0]), states), states)
        for key, states in grouped.items()
    ]


def read_limits(path: AnyPath) -> StabilityRow:
    """Return where a sheet is unstable from its file of the stability stage.

    Raises
    ------
    ValueError
        If a key is missing or a value is not what its column allows; one line that names the file.
    """
    content = read_json(path)
    values = content if isinstance(content, dict) else {}
    return make_row(StabilityRow, values, fspath(path), "stability file")


def by_sheet(states: Iterable[StateRow]) -> dict[tuple[Any, ...], tuple[StateRow, ...]]:
    """Return the states of each sheet by strain, with the sheets in the order given."""
    grouped: dict[tuple[Any, ...], list[StateRow]] = defaultdict(list)
    for row in states:
        grouped[row.sheet_key].append(row)
    return {key: tuple(sorted(rows, key=lambda row: row.strain)) for key, rows in grouped.items()}


def _unknown_limits(sheet: SheetIdentity) -> StabilityRow:
    identity = {name: getattr(sheet, name) for name in columns(SheetIdentity)}
    return make_row(StabilityRow, dict.fromkeys(columns(StabilityRow)) | identity, "sheet", "row")
