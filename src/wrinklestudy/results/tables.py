"""The tables as CSV files: the one place where rows are written and read back.

A table has a header line and a line per row. Numbers have all their digits, whole numbers no point;
an empty cell means that there is no such number, and a text stays a text even if it looks like a
number. Only carriage returns are not kept, because they end a line as line feeds do. The same rows
give the same bytes, whatever their order.
"""

from collections.abc import Callable, Mapping, Sequence
from os import fspath
from typing import TYPE_CHECKING, Any

from wrinklestudy.files.records import check
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.results.compression import CompressionRow
from wrinklestudy.results.imperfection_rows import ImperfectionRow
from wrinklestudy.results.maps import MapRow
from wrinklestudy.results.rows import (
    Column,
    Row,
    SheetIdentity,
    SheetRow,
    StabilityRow,
    StateRow,
    allowed_text,
    checked,
    columns,
    key_text,
)
from wrinklestudy.results.tension import TensionRow
from wrinklestudy.typing import AnyPath, Cell

if TYPE_CHECKING:
    import pandas as pd

STATE_COLUMNS = columns(StateRow)
STABILITY_COLUMNS = columns(StabilityRow)
MAP_COLUMNS = columns(MapRow)
TENSION_COLUMNS = columns(TensionRow)
COMPRESSION_COLUMNS = columns(CompressionRow)
IMPERFECTION_COLUMNS = columns(ImperfectionRow)
PEAK_COLUMNS: Mapping[str, Column] = {
    name: column
    for name, column in columns(SheetRow).items()
    if name not in ("max_critical_thickness", "strain_at_max")
}

_DTYPES = {str: "object", int: "Int64", float: "float64"}
_PARSERS: dict[type, Callable[[str], Cell]] = {str: str, int: int, float: float}


def write_states(rows: Sequence[StateRow], output: AnyPath) -> None:
    """Write states as a table, sorted by case and strain."""
    _write(rows, STATE_COLUMNS, output)


def write_stability(rows: Sequence[StabilityRow], output: AnyPath) -> None:
    """Write where sheets are unstable as a table, sorted by sheet."""
    _write(rows, STABILITY_COLUMNS, output)


def write_peaks(rows: Sequence[SheetRow], output: AnyPath) -> None:
    """Write what sheets reach over strain as a table, sorted by sheet."""
    _write(rows, PEAK_COLUMNS, output)


def write_tension_rows(rows: Sequence[TensionRow], output: AnyPath) -> None:
    """Write tension fields as a table, sorted by material, L/W and strain."""
    _write(rows, TENSION_COLUMNS, output)


def write_compression(rows: Sequence[CompressionRow], output: AnyPath) -> None:
    """Write the centre of flat sheets as a table, sorted by material, L/W and strain."""
    _write(rows, COMPRESSION_COLUMNS, output)


def write_imperfections(rows: Sequence[ImperfectionRow], output: AnyPath) -> None:
    """Write states of imperfect sheets as a table, sorted by sheet and strain."""
    _write(rows, IMPERFECTION_COLUMNS, output)


def write_map(rows: Sequence[MapRow], output: AnyPath) -> None:
    """Write a map as a table, sorted by model, parity, L/W and strain."""
    _write(rows, MAP_COLUMNS, output)


def read_map(path: AnyPath) -> list[MapRow]:
    """Return the rows of a table of the map stage, in its order.

    Raises
    ------
    ValueError
        As `read_states`.
    """
    return [MapRow(**cells) for cells in _read(path, MAP_COLUMNS)]


def read_tension(path: AnyPath) -> list[TensionRow]:
    """Return the rows of a table of the tension stage, in its order.

    Raises
    ------
    ValueError
        As `read_states`.
    """
    return [TensionRow(**cells) for cells in _read(path, TENSION_COLUMNS)]


def read_states(path: AnyPath) -> list[StateRow]:
    """Return the states of a table of the metrics or the summary stage, in its order.

    Raises
    ------
    ValueError
        If a column is missing or a cell is not what its column allows; one line that names the
        file and the line.
    """
    return [StateRow(**cells) for cells in _read(path, STATE_COLUMNS)]


def read_sheets(stability: AnyPath, peaks: AnyPath) -> list[SheetRow]:
    """Return the sheets of the tables of stability and of peaks, in the order of the latter.

    Raises
    ------
    ValueError
        As `read_states`, or if a sheet is in only one of the tables.
    """
    unstable = [StabilityRow(**cells) for cells in _read(stability, STABILITY_COLUMNS)]
    limits = {row.key: row for row in unstable}
    rows = []
    for cells in _read(peaks, PEAK_COLUMNS):
        key = tuple(cells[name] for name in columns(SheetIdentity))
        if key not in limits:
            raise ValueError(f"{fspath(stability)}: has no sheet {key_text(key)}")
        rows.append(SheetRow(**cells | vars(limits.pop(key))))
    for key in limits:
        raise ValueError(f"{fspath(peaks)}: has no sheet {key_text(key)}")
    return rows


def _write(
    rows: Sequence[Row],
    wanted: Mapping[str, Column],
    output: AnyPath,
) -> None:
    import pandas as pd

    ordered = sorted(rows, key=lambda row: row.key)
    table = pd.DataFrame(
        {
            name: pd.Series([getattr(row, name) for row in ordered], dtype=_DTYPES[column.kind])
            for name, column in wanted.items()
        }
    )
    with atomic_path(output) as path:
        table.to_csv(path, index=False, lineterminator="\n", encoding="utf-8")


def _read(path: AnyPath, wanted: Mapping[str, Column]) -> list[dict[str, Any]]:
    """Return the cells of a table by column name; other columns are left alone."""
    table = _texts(path)
    header = list(table.iloc[0])
    for name in wanted:
        if header.count(name) != 1:
            wrong = "stands twice" if name in header else "is missing"
            raise ValueError(f"{fspath(path)}: column {name!r} {wrong}")
    table.columns = header
    lines = table.iloc[1:][list(wanted)].itertuples(index=False, name=None)
    return [
        {
            column.name: _cell(column, text, f"{fspath(path)}, line {number}")
            for column, text in zip(wanted.values(), texts, strict=True)
        }
        for number, texts in enumerate(lines, 2)
    ]


def _texts(path: AnyPath) -> "pd.DataFrame":
    """Return a CSV file as texts, the header as the first row."""
    import pandas as pd

    check(path)
    try:
        return pd.read_csv(
            path,
            header=None,
            dtype=str,
            na_filter=False,
            skip_blank_lines=False,
            encoding="utf-8",
        )
    except (pd.errors.ParserError, pd.errors.EmptyDataError, UnicodeDecodeError) as error:
        message = str(error).strip().splitlines()[-1]
        raise ValueError(f"{fspath(path)}: is not a table ({message})") from None


def _cell(column: Column, text: str, where: str) -> Cell:
    value: Cell = text
    if column.kind is not str:
        try:
            value = None if text == "" else _PARSERS[column.kind](text)
        except ValueError:
            allowed = allowed_text(column)
            raise ValueError(f"{where}: {column.name} = {text!r}: must be {allowed}") from None
    return checked(column, value, where)
