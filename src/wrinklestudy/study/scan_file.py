"""Files of scanned profiles: coordinate across the sheet and deflection."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from wrinklestudy.files.number_table import (
    NumberColumn,
    NumberNote,
    NumberTable,
    read_number_table,
)
from wrinklestudy.typing import AnyPath, Array, Indices
from wrinklestudy.vocabulary import ASPECT, STRAIN, THICKNESS, Limits

UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}
_DEFLECTIONS = ("w", "z")
_Y = NumberColumn("y", {"y": 1.0} | {f"y_{unit}": 1.0 for unit in UNITS})
_W = NumberColumn(
    "w",
    {name: 1.0 for w in _DEFLECTIONS for name in (w, *(f"{w}_{unit}" for unit in UNITS))},
    gaps=True,
)
# A stretched sheet is narrower than W: rubber by 1/sqrt(1 + eps), and the scan may miss the edges
_NARROWEST, _WIDEST = 0.75, 1.1


@dataclass(frozen=True, eq=False)
class ScanFile:
    """A scanned profile as it stands in a file.

    Parameters
    ----------
    path : Path
    y : (n,) array
        Coordinate across the sheet, increasing, in the unit of the file.
    z : (n,) array
        Deflection in the unit of ``y``; NaN where the cell is empty.
    unit : str
        Of both; empty where the columns name none.
    notes : dict
        Numbers of the lines ``# name: number``: aspect, thickness, strain, width, error.
    """

    path: Path
    y: Array
    z: Array
    unit: str
    notes: dict[str, float]


def read_scan_file(path: AnyPath, of_sheet: bool = False) -> ScanFile:
    """Read a scanned profile.

    Columns ``y`` and ``w`` (or ``z``), both in one unit, or with their units as in ``y_mm``,
    ``w_mm``; other columns are left alone. Header lines ``# width: 140`` and ``# error: 0.02`` are
    in the unit of ``y``.

    Parameters
    ----------
    path : path-like
    of_sheet : bool
        Whether the header must say of which sheet and strain the profile is.

    Raises
    ------
    ValueError
        If the file is not such a scan; one line that names the file and, where there is one, the
        line.
    """
    length = Limits(0.0, above_lowest=True)
    notes = (
        NumberNote("aspect", ASPECT, needed=of_sheet),
        NumberNote("thickness", THICKNESS, needed=of_sheet),
        NumberNote("strain", Limits(0.0, STRAIN.highest), needed=of_sheet),
        NumberNote("width", length, unit_of="y"),
        NumberNote("error", Limits(0.0), unit_of="y"),
    )
    table = read_number_table(path, (_Y, _W), notes=notes, others=True)
    unit, factor = _unit(table)
    y, z = table.numbers["y"], factor * table.numbers["w"]
    rising = float(np.sign(np.diff(y)).sum()) >= 0.0
    _refuse_disorder(table.path, y, table.lines, rising)
    if not rising:
        y, z = y[::-1], z[::-1]
    scan = ScanFile(table.path, y.copy(), z.copy(), unit, table.notes)
    if of_sheet or "width" in table.notes:
        _check_width(scan)
    return scan


def _unit(table: NumberTable) -> tuple[str, float]:
    """Return the unit of y, and the factor to it from that of the deflection."""
    across, deflection = (table.spelled[name] for name in ("y", "w"))
    units = [name.partition("_")[2] for name in (across, deflection)]
    if bool(units[0]) != bool(units[1]):
        raise ValueError(
            f"{table.path}: columns {across} and {deflection}: one has a unit and the other none; "
            "name the unit of both, or of none where it is the same"
        )
    return units[0], UNITS[units[1]] / UNITS[units[0]] if units[0] != units[1] else 1.0


def _refuse_disorder(path: Path, y: Array, lines: Indices, rising: bool) -> None:
    steps = np.diff(y) if rising else -np.diff(y)
    wrong = np.flatnonzero(steps <= 0.0)
    if not len(wrong):
        return
    k = int(wrong[0])
    here, before = f"{y[k + 1]:g}", f"line {lines[k]}"
    trouble = (
        f"{here} stands in {before} too"
        if y[k + 1] == y[k]
        else f"{here} comes after {y[k]:g} of {before}"
    )
    raise ValueError(
        f"{path}, line {lines[k + 1]}, column y: {trouble}; y must rise, or fall, from row to row"
    )


def _check_width(scan: ScanFile) -> None:
    """Refuse a scan that does not go from edge to edge of a sheet, by default of W = 1."""
    width = scan.notes.get("width", 1.0)
    expected = width / np.sqrt(1.0 + scan.notes.get("strain", STRAIN.highest))
    over = float(np.ptp(scan.y))
    if not _NARROWEST * expected <= over <= _WIDEST * width:
        raise ValueError(
            f"{scan.path}: y runs over {over / width:.3g} W, must be "
            f"{_NARROWEST * expected / width:.2g} to {_WIDEST:g} (from edge to edge); '# width:' "
            "gives W in the unit of y"
        )
