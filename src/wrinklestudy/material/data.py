"""Measured stress-strain data: one CSV format for bundled and for a user's own files.

Lines that begin with ``#`` are the header note (source, sample, remarks). The first other line
names the columns, separated by commas, in any order:

* ``stretch`` or ``strain``: lambda = L'/L, or lambda - 1;
* ``stress_pa`` or ``stress_mpa``: nominal stress, force per undeformed area;
* ``mode`` (optional): uniaxial (default), biaxial or shear;
* ``standard_error_pa`` or ``standard_error_mpa`` (optional): of the stress, > 0.
"""

import csv
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from wrinklestudy.material.homogeneous import MODES
from wrinklestudy.typing import Array

_STRETCH = ("stretch", "strain")
_STRESS = ("stress_pa", "stress_mpa")
_ERROR = ("standard_error_pa", "standard_error_mpa")
_COLUMNS = (*_STRETCH, *_STRESS, "mode", *_ERROR)

# A window that ends at 1.14 takes a point at strain 0.14, whose stretch is 1.1400000000000001.
_EDGE = 1e-9


@dataclass(frozen=True, eq=False)
class Measurement:
    """Measured points of a material test.

    Parameters
    ----------
    stretch : ndarray, shape ``(n,)``
        Stretch along the pull.
    stress : ndarray, shape ``(n,)``
        Nominal stress in Pa.
    mode : ndarray of str, shape ``(n,)``
        Deformation mode of each point: uniaxial, biaxial or shear.
    standard_error : ndarray of shape ``(n,)`` or None
        Standard error of the stress in Pa, where it is known.
    source : str
        Name of the file.
    note : str
        Comment lines of the file.
    """

    stretch: Array
    stress: Array
    mode: NDArray[np.str_]
    standard_error: Array | None = None
    source: str = "data"
    note: str = ""

    def select(
        self,
        stretch: tuple[float, float] | None = None,
        modes: Sequence[str] | None = None,
    ) -> "Measurement":
        """Return the points inside a window of stretch (ends included) and of some modes.

        Raises
        ------
        ValueError
            If the window is empty or a mode is unknown or not in the data.
        """
        keep = np.ones(self.stretch.shape, dtype=np.bool_)
        if stretch is not None:
            low, high = stretch
            if not 0.0 <= low < high:
                raise ValueError(
                    f"stretch = {low:g}, {high:g}: must be two numbers, 0 <= smallest < largest"
                )
            keep &= (self.stretch >= low * (1.0 - _EDGE)) & (self.stretch <= high * (1.0 + _EDGE))
        if modes is not None:
            self._check_modes(modes)
            keep &= np.isin(self.mode, np.array(modes, dtype=np.str_))
        error = None if self.standard_error is None else self.standard_error[keep]
        return Measurement(
            self.stretch[keep], self.stress[keep], self.mode[keep], error, self.source, self.note
        )

    def _check_modes(self, modes: Sequence[str]) -> None:
        if isinstance(modes, str) or not modes:
            raise ValueError(f"modes = {modes!r}: must be a list of {', '.join(MODES)}")
        present = [mode for mode in MODES if mode in self.mode]
        for mode in modes:
            if mode not in MODES:
                raise ValueError(f"mode {mode!r} is unknown: allowed are {', '.join(MODES)}")
            if mode not in present:
                raise ValueError(f"{self.source}: has no {mode} data, only {', '.join(present)}")


def read(path: str | Path) -> Measurement:
    """Read a stress-strain file in the format of this module.

    Parameters
    ----------
    path : str or Path
        CSV file, UTF-8.

    Returns
    -------
    Measurement

    Raises
    ------
    ValueError
        If the file cannot be read, a column is missing, unknown or doubled, or a cell is not what
        its column holds; one line naming the file, the line and the column.
    """
    path = Path(path)
    note: list[str] = []
    rows: list[tuple[int, list[str]]] = []
    for number, line in enumerate(_text(path).splitlines(), start=1):
        if line.lstrip().startswith("#"):
            note.append(line.lstrip().lstrip("#").strip())
        elif line.strip(" \t,"):
            rows.append((number, _cells(line, f"{path}, line {number}")))
    if not rows:
        raise ValueError(f"{path}: is empty; expected a line of column names and the data")
    (number, names), *points = rows
    _check_columns(f"{path}, line {number}", names)
    if not points:
        raise ValueError(f"{path}: has column names but no data")
    table: dict[str, list[float]] = {name: [] for name in names if name != "mode"}
    modes: list[str] = []
    for number, cells in points:
        where = f"{path}, line {number}"
        if len(cells) != len(names):
            raise ValueError(f"{where}: {len(cells)} cells where {len(names)} columns are named")
        row = dict(zip(names, cells, strict=True))
        modes.append(_mode(row.pop("mode", "uniaxial"), where))
        for name, cell in row.items():
            table[name].append(_number(cell, name, where))
    return _measurement(path.name, table, modes, "\n".join(note).strip())


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise ValueError(f"{path}: cannot be read ({error.strerror})") from error
    except UnicodeDecodeError as error:
        raise ValueError(f"{path}: is not a UTF-8 text file") from error


def _cells(line: str, where: str) -> list[str]:
    try:
        return [cell.strip() for cell in next(csv.reader([line]))]
    except csv.Error as error:
        raise ValueError(f"{where}: is not a line of comma-separated values ({error})") from error


def _check_columns(where: str, names: list[str]) -> None:
    for name in names:
        if name not in _COLUMNS:
            allowed = ", ".join(_COLUMNS)
            raise ValueError(f"{where}: column {name!r} is unknown; allowed are {allowed}")
    for pair in (_STRETCH, _STRESS, _ERROR, ("mode",)):
        found = [name for name in names if name in pair]
        if len(found) > 1:
            raise ValueError(f"{where}: columns {' and '.join(found)} exclude each other")
        if not found and pair in (_STRETCH, _STRESS):
            raise ValueError(f"{where}: a column {' or '.join(pair)} is missing")


def _mode(cell: str, where: str) -> str:
    if cell not in MODES:
        raise ValueError(f"{where}: column mode holds {cell!r}; allowed are {', '.join(MODES)}")
    return cell


def _number(cell: str, name: str, where: str) -> float:
    try:
        value = float(cell)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ValueError(f"{where}: column {name} holds {cell!r}; a finite number is needed")
    if name == "stretch" and value <= 0.0:
        raise ValueError(f"{where}: column stretch holds {cell}; must be > 0 (1 is undeformed)")
    if name == "strain" and value <= -1.0:
        raise ValueError(f"{where}: column strain holds {cell}; must be > -1 (0 is undeformed)")
    if name in _ERROR and value <= 0.0:
        raise ValueError(f"{where}: column {name} holds {cell}; must be > 0")
    return value


def _measurement(
    source: str, table: dict[str, list[float]], modes: list[str], note: str
) -> Measurement:
    """Bring the columns to stretch and Pa."""
    column = {name: np.array(values, dtype=np.float64) for name, values in table.items()}
    stretch = column["stretch"] if "stretch" in column else 1.0 + column["strain"]
    stress = column["stress_pa"] if "stress_pa" in column else 1e6 * column["stress_mpa"]
    error = column.get("standard_error_pa")
    if "standard_error_mpa" in column:
        error = 1e6 * column["standard_error_mpa"]
    return Measurement(stretch, stress, np.array(modes, dtype=np.str_), error, source, note)
