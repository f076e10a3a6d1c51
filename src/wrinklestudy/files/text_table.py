"""Tables of text cells from files that people and machines write: separators, quotes, notes.

What can be read without a guess is read: commas, semicolons, tabs or blanks between the cells,
quotes, a byte order mark, a comma as decimal sign where it cannot be a separator, a row of units
below the names, the unnamed counter that pandas writes in front. Where two readings are possible
the file is refused with the line and what makes it ambiguous.
"""

import codecs
import csv
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from wrinklestudy.typing import AnyPath

_UTF16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
_DECIMAL_COMMA = re.compile(r"[-+]?\d*,\d+([eE][-+]?\d+)?|[-+]?\d+,([eE][-+]?\d+)?")
_THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2}(,\d{3})+")
_UNIT_CELL = re.compile(r"[(\[]\s*([^()\[\]]*?)\s*[)\]]|")
_NAMED_UNIT = re.compile(r"(.*\S)\s*[(\[]\s*([^()\[\]]+?)\s*[)\]]")


@dataclass(frozen=True)
class TableRow:
    """The cells of a line and its number in the file, from 1."""

    line: int
    cells: tuple[str, ...]


@dataclass(frozen=True)
class TextTable:
    """A table as text.

    Parameters
    ----------
    path : Path
        The file, for messages.
    notes : tuple of (int, str)
        Lines that begin with ``#``, without it, with their numbers.
    names : TableRow
        Names of the columns in lower case with their units: ``force_n`` for ``Force (N)``.
    rows : tuple of TableRow
        The data; each row has one cell for every name, numbers with a point as decimal sign.
    """

    path: Path
    notes: tuple[tuple[int, str], ...]
    names: TableRow
    rows: tuple[TableRow, ...]

    def where(self, row: TableRow, name: str = "") -> str:
        """Return file, line and column for a message."""
        column = f", column {name}" if name else ""
        return f"{self.path}, line {row.line}{column}"


def read_text_table(path: AnyPath) -> TextTable:
    """Read the cells of a file.

    Parameters
    ----------
    path : path-like
        Text in UTF-8, or in UTF-16 with its byte order mark.

    Raises
    ------
    ValueError
        If the file cannot be read, has no names or no rows, or can be read in more than one way;
        one line that names the file and, where there is one, the line.
    """
    path = Path(path)
    lines = [(k, line) for k, line in enumerate(_text(path).splitlines(), 1) if line.strip(" \t,;")]
    notes = tuple((k, line.strip()[1:].strip()) for k, line in lines if _is_note(line))
    table = [(k, line) for k, line in lines if not _is_note(line)]
    if not table:
        raise ValueError(f"{path}: is empty; a line of column names and the data are needed")
    separator = _separator(table[0][1])
    names, *rows = [
        TableRow(k, tuple(_cells(line, separator, f"{path}, line {k}"))) for k, line in table
    ]
    names, rows = _with_units(names, rows)
    names = TableRow(names.line, tuple(_plain_name(name) for name in names.cells))
    if not rows:
        raise ValueError(f"{path}: has column names but no data")
    _refuse_repeated_names(path, names, rows)
    rows = [_fitted(path, row, names, separator) for row in rows]
    names, rows = _without_unnamed(path, names, rows)
    return TextTable(path, notes, names, tuple(_with_points(path, rows)))


def _text(path: Path) -> str:
    try:
        content = path.read_bytes()
    except OSError as error:
        raise ValueError(f"{path}: cannot be read ({error.strerror})") from None
    encoding = "utf-16" if content.startswith(_UTF16) else "utf-8-sig"
    try:
        text = content.decode(encoding)
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise ValueError(
            f"{path}, line {line}: is not UTF-8 text; save the file as UTF-8"
        ) from None
    if "\0" in text:
        raise ValueError(f"{path}: is not a text file")
    return text


def _is_note(line: str) -> bool:
    return line.lstrip().startswith("#")


def _separator(names: str) -> str:
    """Return what separates the cells: the first of ; tab , among the names, or blanks."""
    return next((sign for sign in ";\t," if sign in names), " ")


def _cells(line: str, separator: str, where: str) -> Iterator[str]:
    if separator == " " and '"' not in line:
        yield from line.split()
        return
    # Blanks behind a closing quote, which csv would take for text.
    line = re.sub(f'" +(?={re.escape(separator)}|$)', '"', line.strip("\r\n"))
    try:
        reader = csv.reader([line], delimiter=separator, skipinitialspace=True, strict=True)
        yield from (cell.strip() for cell in next(reader))
    except csv.Error as error:
        raise ValueError(f"{where}: is not a row of cells ({error})") from None


def _plain_name(name: str) -> str:
    """Return a name in lower case, with its unit behind an underscore: force_n for Force (N)."""
    named = _NAMED_UNIT.fullmatch(name)
    text = f"{named[1]} {named[2].replace('%', 'percent')}" if named else name
    return re.sub(r"[\s_]+", "_", text.strip().lower())


def _with_units(names: TableRow, rows: list[TableRow]) -> tuple[TableRow, list[TableRow]]:
    """Take a row of units in brackets, as testing machines write it, into the names."""
    if not rows or len(rows[0].cells) != len(names.cells):
        return names, rows
    units = [_UNIT_CELL.fullmatch(cell) for cell in rows[0].cells]
    if not all(units) or not any(rows[0].cells):
        return names, rows
    joined = [
        f"{name} {cell}".strip() for name, cell in zip(names.cells, rows[0].cells, strict=True)
    ]
    return TableRow(names.line, tuple(joined)), rows[1:]


def _refuse_repeated_names(path: Path, names: TableRow, rows: Sequence[TableRow]) -> None:
    for row in rows:
        if tuple(_plain_name(cell) for cell in row.cells) == names.cells:
            raise ValueError(
                f"{path}, line {row.line}: the column names stand again; a file holds one table"
            )
    for place, name in enumerate(names.cells):
        if name and name in names.cells[:place]:
            raise ValueError(f"{path}, line {names.line}: column {name!r} stands twice")


def _fitted(path: Path, row: TableRow, names: TableRow, separator: str) -> TableRow:
    """Return a row with one cell for each name; empty cells at its end do not count."""
    count, cells = len(names.cells), row.cells
    while len(cells) > count and not cells[-1]:
        cells = cells[:-1]
    if len(cells) == count:
        return TableRow(row.line, cells)
    hint = ""
    if separator == "," and len(cells) > count and all(re.fullmatch(r"[-+]?\d+", c) for c in cells):
        hint = (
            "; a comma is both the separator and the decimal sign: write decimal points, or "
            "separate the columns by semicolons"
        )
    raise ValueError(
        f"{path}, line {row.line}: {len(cells)} cells where {count} columns are named "
        f"({', '.join(names.cells)}){hint}"
    )


def _without_unnamed(
    path: Path, names: TableRow, rows: Sequence[TableRow]
) -> tuple[TableRow, list[TableRow]]:
    """Leave out columns without a name that hold nothing, and a counter of the rows in front."""
    dropped = set()
    for place, name in enumerate(names.cells):
        cells = [row.cells[place] for row in rows]
        counter = place == 0 and cells in (
            [str(k) for k in range(len(rows))],
            [str(k) for k in range(1, len(rows) + 1)],
        )
        if not name and (counter or not any(cells)):
            dropped.add(place)
        elif not name:
            raise ValueError(
                f"{path}, line {names.line}: column {place + 1} has no name; name it or remove it"
            )
    return _kept(names, dropped), [_kept(row, dropped) for row in rows]


def _kept(row: TableRow, dropped: set[int]) -> TableRow:
    return TableRow(row.line, tuple(c for k, c in enumerate(row.cells) if k not in dropped))


def _with_points(path: Path, rows: Sequence[TableRow]) -> Iterator[TableRow]:
    """Yield the rows with points for decimal commas, if commas are the decimal sign."""
    cells = [(row, cell) for row in rows for cell in row.cells]
    commas = [(row, cell) for row, cell in cells if _DECIMAL_COMMA.fullmatch(cell)]
    pointed = [cell for _, cell in cells if re.fullmatch(r"[-+]?\d*\.\d*([eE][-+]?\d+)?", cell)]
    if commas and (pointed or all(_THOUSANDS.fullmatch(cell) for _, cell in commas)):
        row, cell = commas[0]
        raise ValueError(
            f"{path}, line {row.line}: {cell!r}: the comma may be a decimal sign or separate "
            "thousands; write numbers with a decimal point and no other signs between digits"
        )
    for row in rows:
        yield TableRow(
            row.line,
            tuple(c.replace(",", ".") if _DECIMAL_COMMA.fullmatch(c) else c for c in row.cells),
        )
