"""Tables of measured numbers: columns with units and bounds, and numbers in the notes above.

One reader for stress-strain curves, tables of amplitudes and wavelengths, and scanned profiles.
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from wrinklestudy.files.text_table import TableRow, TextTable, read_text_table
from wrinklestudy.typing import AnyPath, Array, Indices
from wrinklestudy.vocabulary import Limits

# Plain decimal numbers: no underscores, no words such as inf
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
_NUMBER_WITH_UNIT = re.compile(rf"({_NUMBER.pattern})\s*([^\d\s_.,+-].*)")
_DECIMAL_COMMA = re.compile(r"[-+]?\d+,(\d{1,2}|\d{4,})(?!\d)")
_MISSING = ("", "nan", "na", "n/a", "null", "none", "-", "--")
# What testing machines and scanners write beside what is measured
IGNORED = re.compile(r"(time|point|index|cycle_time|temperature|brightness|intensity)(_.*)?")


@dataclass(frozen=True)
class NumberColumn:
    """A column that a table may have.

    Parameters
    ----------
    name : str
        What it is called in the program.
    spellings : mapping
        Names that the file may use, each with the factor to the unit of the program.
    limits : Limits
        Of the number in the unit of the program.
    hint : str
        What a number outside the limits probably is, for the message.
    needed : bool
        Whether a table without it is refused.
    gaps : bool
        Whether a cell may be empty: NaN.
    """

    name: str
    spellings: Mapping[str, float]
    limits: Limits = field(default_factory=Limits)
    hint: str = ""
    needed: bool = True
    gaps: bool = False


@dataclass(frozen=True)
class WordColumn:
    """A column of words, such as the deformation of a test.

    Parameters
    ----------
    name : str
        Name in the file.
    words : tuple of str
        What may stand in it.
    default : str
        What a table without the column has throughout; empty where that means nothing.
    """

    name: str
    words: tuple[str, ...]
    default: str


@dataclass(frozen=True)
class NumberNote:
    """A number that may stand in a line ``# name: number`` above the table.

    Parameters
    ----------
    name : str
    limits : Limits
    units : mapping
        Units that may follow the number, with their factors; without a unit the number is taken
        as it is.
    needed : bool
    unit_of : str
        Column of numbers whose unit in the file (mm of ``y_mm``) may follow the number.
    """

    name: str
    limits: Limits = field(default_factory=Limits)
    units: Mapping[str, float] = field(default_factory=dict)
    needed: bool = False
    unit_of: str = ""

    def with_unit_of(self, spelled: Mapping[str, str]) -> "NumberNote":
        """Return the note with the unit that its column has in the file."""
        unit = spelled.get(self.unit_of, "").partition("_")[2]
        return replace(self, units={unit: 1.0}) if unit else self


@dataclass(frozen=True, eq=False)
class NumberTable:
    """What was read.

    Parameters
    ----------
    path : Path
    numbers : dict
        Columns by the name that they have in the program, shape ``(n,)``.
    words : dict
        Columns of words.
    spelled : dict
        Name in the file of each column of numbers.
    notes : dict
        Numbers of the notes.
    lines : (n,) array of int
        Line of each row in the file.
    note : str
        All lines that begin with ``#``, joined.
    """

    path: Path
    numbers: dict[str, Array]
    words: dict[str, tuple[str, ...]]
    spelled: dict[str, str]
    notes: dict[str, float]
    lines: Indices
    note: str


def read_number_table(
    path: AnyPath,
    columns: Sequence[NumberColumn],
    words: Sequence[WordColumn] = (),
    notes: Sequence[NumberNote] = (),
    others: bool = False,
    either: Sequence[Sequence[str]] = (),
) -> NumberTable:
    """Read a table of numbers.

    Parameters
    ----------
    path : path-like
    columns : sequence of NumberColumn
    words : sequence of WordColumn
    notes : sequence of NumberNote
    others : bool
        Whether columns of other names are left alone; else only those of `IGNORED` are.
    either : sequence of sequences of str
        Names of columns of which a table must have exactly one.

    Raises
    ------
    ValueError
        If the file is not such a table; one line that names the file, the line, the column, what
        is wrong and what is allowed.
    """
    table = read_text_table(path)
    spelled = _spelled(table, columns, words, others)
    for group in either:
        _check_one_of(table, [column for column in columns if column.name in group], spelled)
    numbers = {
        column.name: _numbers(table, column, spelled[column.name])
        for column in columns
        if column.name in spelled
    }
    return NumberTable(
        path=table.path,
        numbers=numbers,
        words={column.name: _words(table, column) for column in words},
        spelled=spelled,
        notes=_notes(table, [note.with_unit_of(spelled) for note in notes]),
        lines=np.array([row.line for row in table.rows], dtype=np.int64),
        note="\n".join(text for _, text in table.notes).strip(),
    )


def _spelled(
    table: TextTable, columns: Sequence[NumberColumn], words: Sequence[WordColumn], others: bool
) -> dict[str, str]:
    """Return the name in the file of each column, after checking all names."""
    names = table.names.cells
    where = table.where(table.names)
    spelled: dict[str, str] = {}
    for column in columns:
        own = [name for name in names if name in column.spellings]
        if len(own) > 1:
            raise ValueError(f"{where}: columns {' and '.join(own)} exclude each other")
        if own:
            spelled[column.name] = own[0]
    known = [name for column in columns for name in column.spellings]
    known += [column.name for column in words]
    for name in names:
        if name not in known and not others and not IGNORED.fullmatch(name):
            with_unit = [other for other in known if other.startswith(f"{name}_")]
            allowed = (
                f"write it with its unit: {' or '.join(with_unit)}"
                if with_unit
                else f"allowed are {', '.join(known)}"
            )
            raise ValueError(f"{where}: column {name!r} is unknown; {allowed}")
    for column in columns:
        if column.needed and column.name not in spelled:
            wanted = " or ".join(column.spellings)
            raise ValueError(f"{where}: a column {wanted} is missing (has {', '.join(names)})")
    return spelled


def _check_one_of(
    table: TextTable, columns: Sequence[NumberColumn], spelled: Mapping[str, str]
) -> None:
    """Refuse a table that has none of some columns, or more than one."""
    where = table.where(table.names)
    own = [spelled[column.name] for column in columns if column.name in spelled]
    if len(own) > 1:
        raise ValueError(f"{where}: columns {' and '.join(own)} exclude each other")
    if not own:
        wanted = " or ".join(name for column in columns for name in column.spellings)
        names = ", ".join(table.names.cells)
        raise ValueError(f"{where}: a column {wanted} is missing (has {names})")


def _numbers(table: TextTable, column: NumberColumn, name: str) -> Array:
    place, factor = table.names.cells.index(name), column.spellings[name]
    return np.array(
        [_number(table, row, column, name, row.cells[place]) * factor for row in table.rows],
        dtype=np.float64,
    )


def _number(table: TextTable, row: TableRow, column: NumberColumn, name: str, cell: str) -> float:
    where = table.where(row, name)
    if cell.lower() in _MISSING and column.gaps:
        return math.nan
    if not _NUMBER.fullmatch(cell):
        allowed = "a number is needed, such as 0.12 or 1.5e5"
        raise ValueError(f"{where}: {cell!r} is not a number; {_unit_trouble(cell) or allowed}")
    value = float(cell)
    factor = column.spellings[name]
    if value * factor not in column.limits:
        low, high = column.limits.lowest / factor, column.limits.highest / factor
        scaled = replace(column.limits, lowest=low, highest=high)
        hint = f" ({column.hint})" if column.hint else ""
        raise ValueError(f"{where}: {cell} must be {scaled}{hint}")
    return value


def _unit_trouble(text: str) -> str:
    """Return what to say of a number with a unit behind it; empty if there is none."""
    with_unit = _NUMBER_WITH_UNIT.fullmatch(text)
    if with_unit is None:
        return ""
    return f"write the number without the unit {with_unit[with_unit.lastindex or 0]!r}"


def _words(table: TextTable, column: WordColumn) -> tuple[str, ...]:
    if column.name not in table.names.cells:
        return (column.default,) * len(table.rows)
    place = table.names.cells.index(column.name)
    for row in table.rows:
        if row.cells[place].lower() not in column.words:
            raise ValueError(
                f"{table.where(row, column.name)}: {row.cells[place]!r}; allowed are "
                f"{', '.join(column.words)}"
            )
    return tuple(row.cells[place].lower() for row in table.rows)


class _Written(NamedTuple):
    """A note as it stands in the file."""

    line: int
    text: str


def _notes(table: TextTable, notes: Sequence[NumberNote]) -> dict[str, float]:
    """Return the numbers of the lines ``# name: number``; other notes are left alone.

    An equals sign for the colon and underscores in the name mean the same.
    """
    known = {note.name: note for note in notes}
    written: dict[str, _Written] = {}
    for line, text in table.notes:
        name, *rest = re.split("[:=]", text, maxsplit=1)
        name = " ".join(name.replace("_", " ").split()).lower()
        value = "".join(rest)
        if rest and name in known:
            if name in written:
                raise ValueError(f"{table.path}, line {line}: '# {name}:' is given twice")
            written[name] = _Written(line, value.strip())
    for note in notes:
        if note.needed and note.name not in written:
            raise ValueError(
                f"{table.path}: a line '# {note.name}: number' is missing; must be {note.limits}"
            )
    return {
        name: _note_number(known[name], one.text, f"{table.path}, line {one.line}, {name}")
        for name, one in written.items()
    }


def _note_number(note: NumberNote, text: str, where: str) -> float:
    plain = text.replace(",", ".", 1) if _DECIMAL_COMMA.match(text) else text
    number, factor = plain, 1.0
    with_unit = _NUMBER_WITH_UNIT.fullmatch(plain)
    if with_unit and (unit := with_unit[with_unit.lastindex or 0].strip()) in note.units:
        number, factor = with_unit[1], note.units[unit]
    if not _NUMBER.fullmatch(number):
        units = f"; units may be {', '.join(note.units)}" if note.units else ""
        trouble = _unit_trouble(plain) or "a number is needed, such as 0.12"
        column = f", in the unit of column {note.unit_of}" if note.unit_of else ""
        raise ValueError(f"{where}: {text!r} is not a number; {trouble}{column}{units}")
    value = float(number) * factor
    if value not in note.limits:
        raise ValueError(f"{where}: {text} must be {note.limits}")
    return value
