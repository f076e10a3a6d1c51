"""Measured data of the user: stress, amplitude and wavelength tables, and scanned profiles.

What the files may hold is described in ``data/experiment/README.md``. All of them are UTF-8 CSV
files: lines that begin with ``#`` are notes, the first other line names the columns, in any order.
"""

import csv
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path

import numpy as np

from wrinklestudy.files.number_table import (
    Bounds,
    NumberColumn,
    NumberTable,
    read_number_table,
)
from wrinklestudy.material.data import strain_column, stress_spellings
from wrinklestudy.metrics.measure import Measures, measure
from wrinklestudy.metrics.profile import Profile, cleaned, noise_level
from wrinklestudy.results.cases import canonical
from wrinklestudy.typing import Array, Mask
from wrinklestudy.vocabulary import ASPECT, STRAIN, THICKNESS, Limits

SheetSize = tuple[float, float]

KINDS = ("stress", "amplitude", "wavelength", "profiles")

_Rule = tuple[str, Callable[[float], bool]]
_ANY: _Rule = ("a finite number", lambda _: True)
_ASPECT: _Rule = (str(ASPECT), ASPECT.__contains__)
_THICKNESS: _Rule = (str(THICKNESS), THICKNESS.__contains__)
# The sheet at rest may be measured, too.
_MEASURED_STRAIN = Limits(0.0, STRAIN.highest, unit="0.12 is 12%")
_STRAIN: _Rule = (str(_MEASURED_STRAIN), _MEASURED_STRAIN.__contains__)
_ERROR: _Rule = (">= 0", lambda v: v >= 0.0)

_SHEET_COLUMNS = {"aspect": _ASPECT, "thickness": _THICKNESS, "strain": _STRAIN}
_SCAN_HEADER: dict[str, _Rule] = {
    **_SHEET_COLUMNS,
    "width": ("> 0", lambda v: v > 0.0),
    "error": _ERROR,
}
_SCAN_REQUIRED = ("aspect", "thickness", "strain")
# A stretched sheet is narrower than W, but never by much more than half.
_NARROWEST, _WIDEST = 0.3, 1.1


@dataclass(frozen=True, eq=False)
class Points:
    """Measured values against strain.

    Parameters
    ----------
    strain, value, error : ndarray, shape (n,)
        In the order of the file; ``error`` is the standard error of the value, NaN where unknown.
    """

    strain: Array
    value: Array
    error: Array

    def joined(self, other: "Points") -> "Points":
        """Return the points of both."""
        both = zip(self._arrays(), other._arrays(), strict=True)
        return Points(*(np.concatenate(pair) for pair in both))

    def kept(self, rows: Mask) -> "Points":
        """Return some of the points."""
        return Points(*(values[rows] for values in self._arrays()))

    def highest(self) -> tuple[float, float]:
        """Return the largest value and its error."""
        top = int(np.argmax(self.value))
        return float(self.value[top]), float(self.error[top])

    def _arrays(self) -> tuple[Array, Array, Array]:
        return self.strain, self.value, self.error


@dataclass(frozen=True, eq=False)
class Scan:
    """A scanned profile half-way between the clamps.

    Parameters
    ----------
    sheet : tuple of float
        L/W and t/W.
    strain : float
        eps.
    profile : Profile
        Without noise, offset and tilt; in units of W, the middle of the sheet at y = 0.
    measures : Measures
        Of that profile.
    error : float
        Standard error of the amplitude in units of W; NaN where unknown.
    noise : float
        Standard deviation of the noise of single points, in units of W.
    """

    sheet: SheetSize
    strain: float
    profile: Profile
    measures: Measures
    error: float
    noise: float

    @property
    def wrinkled(self) -> bool:
        """Whether the amplitude exceeds its error and the noise, and there is a wavelength."""
        limit = max(self.noise, 0.0 if math.isnan(self.error) else self.error)
        return self.measures.amplitude > limit and math.isfinite(self.measures.wavelength)

    @property
    def relative_error(self) -> float:
        """Standard error of A, and of Phi at small slope, over the value itself."""
        amplitude = self.measures.amplitude
        return self.error / amplitude if amplitude > 0.0 else math.nan


def kind(path: str | PathLike[str]) -> str:
    """Return what a file holds, one of `KINDS`, from its name.

    Raises
    ------
    ValueError
        If the name is not that of a file of measured data.
    """
    path = Path(path)
    if path.suffix == ".csv" and path.parent.name == "profiles":
        return "profiles"
    if path.suffix == ".csv" and path.stem in KINDS[:3]:
        return path.stem
    names = ", ".join(f"{name}.csv" for name in KINDS[:3])
    raise ValueError(f"{path}: unknown measured data; allowed are {names} and profiles/*.csv")


def _bounds(limits: Limits) -> Bounds:
    return Bounds(limits.lowest, limits.highest, limits.above_lowest)


_ERROR_BOUNDS = Bounds(0.0)
_STRESS_TABLE = (
    strain_column(),
    NumberColumn("stress", stress_spellings("stress")),
    NumberColumn("error", stress_spellings("error"), _ERROR_BOUNDS, needed=False, gaps=True),
)
_SHEET_TABLE = (
    NumberColumn("aspect", {"aspect": 1.0}, _bounds(ASPECT), "L/W"),
    NumberColumn("thickness", {"thickness": 1.0}, _bounds(THICKNESS), "t/W"),
    strain_column(_bounds(_MEASURED_STRAIN)),
    NumberColumn("error", {"error": 1.0}, _ERROR_BOUNDS, needed=False, gaps=True),
)
_VALUES = {
    "amplitude": NumberColumn("value", {"amplitude_over_thickness": 1.0}, Bounds(0.0), "A/t"),
    "wavelength": NumberColumn(
        "value",
        {"wavelength_over_width": 1.0},
        Bounds(0.0, 1.0, open_low=True),
        "lambda/W",
    ),
}


def read_stress(path: str | PathLike[str]) -> Points:
    """Read nominal stress (Pa) against strain: columns strain, stress_pa, optional error_pa.

    Strain may be strain_percent, stress and error may be in kPa and MPa.

    Raises
    ------
    ValueError
        If the file is not such a table; one line that names the file, the line and the column.
    """
    table = read_number_table(path, _STRESS_TABLE)
    return _points(table, table.numbers["stress"])


def _points(table: NumberTable, value: Array) -> Points:
    unknown = np.full(value.shape, math.nan)
    return Points(table.numbers["strain"], value, table.numbers.get("error", unknown))


def read_sheets(path: str | PathLike[str]) -> dict[SheetSize, Points]:
    """Read amplitude.csv (A/t) or wavelength.csv (lambda/W) against strain, sheet by sheet.

    Columns aspect, thickness, strain or strain_percent, amplitude_over_thickness or
    wavelength_over_width, optional error.

    Returns
    -------
    dict
        Points by (L/W, t/W), sorted.

    Raises
    ------
    ValueError
        If the file is not such a table; one line that names the file, the line and the column.
    """
    table = read_number_table(path, (*_SHEET_TABLE, _VALUES[kind(path)]))
    points = _points(table, table.numbers["value"])
    sheets = [
        (canonical(aspect), canonical(thickness))
        for aspect, thickness in zip(
            table.numbers["aspect"], table.numbers["thickness"], strict=True
        )
    ]
    return {
        sheet: points.kept(np.array([other == sheet for other in sheets]))
        for sheet in sorted(set(sheets))
    }


def read_scan(path: str | PathLike[str]) -> Scan:
    """Read a scanned profile, bring it to units of W and measure it.

    Columns y and w in one unit of length; header lines ``# aspect: 2``, ``# thickness: 0.001``,
    ``# strain: 0.12`` and, optional, ``# width: 140`` (W in the unit of y and w, 1 if left out) and
    ``# error: 0.02`` (standard error of the amplitude in that unit). Noise, offset and tilt are
    removed (`metrics.profile.cleaned`) before anything is measured.

    Raises
    ------
    ValueError
        If the file is not such a scan; one line that names the file and, where there is one, the
        line.
    """
    path = Path(path)
    header = _header(path)
    table = _table(path, {"y": _ANY, "w": _ANY}, None)
    width = header.get("width", 1.0)
    y, z = table["y"] / width, table["w"] / width
    if y[0] > y[-1]:
        y, z = y[::-1], z[::-1]
    if not _NARROWEST <= y[-1] - y[0] <= _WIDEST:
        raise ValueError(
            f"{path}: y runs over {y[-1] - y[0]:.3g} W, must be {_NARROWEST:g} to {_WIDEST:g} "
            "(the full width); '# width:' gives W in the unit of y"
        )
    try:
        scanned = Profile(y - 0.5 * (y[0] + y[-1]), z.copy())
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
    profile = cleaned(scanned)
    return Scan(
        sheet=(canonical(header["aspect"]), canonical(header["thickness"])),
        strain=header["strain"],
        profile=profile,
        measures=measure(profile),
        error=header.get("error", math.nan) / width,
        noise=noise_level(scanned),
    )


def _table(path: Path, columns: dict[str, _Rule], error: str | None) -> dict[str, Array]:
    """Return the columns of a CSV file; those of a scan (without error) may have others beside."""
    rules = columns if error is None else columns | {error: _ERROR}
    rows = [(k, line) for k, line in _lines(path) if not line.startswith("#")]
    if not rows:
        raise ValueError(f"{path}: is empty; a line of column names and the data are needed")
    (first, names), *points = [(k, _cells(line, f"{path}, line {k}")) for k, line in rows]
    _check_names(f"{path}, line {first}", names, columns, rules if error is not None else None)
    if not points:
        raise ValueError(f"{path}: has column names but no data")
    table: dict[str, list[float]] = {name: [] for name in rules}
    for k, cells in points:
        if len(cells) != len(names):
            raise ValueError(f"{path}, line {k}: {len(cells)} cells for {len(names)} columns")
        row = dict(zip(names, cells, strict=True))
        for name, rule in rules.items():
            cell = row.get(name, "")
            unknown_error = name == error and not cell
            where = f"{path}, line {k}, column {name}"
            table[name].append(math.nan if unknown_error else _number(cell, rule, where))
    return {name: np.array(values, dtype=np.float64) for name, values in table.items()}


def _check_names(
    where: str, names: list[str], needed: dict[str, _Rule], allowed: dict[str, _Rule] | None
) -> None:
    for name in needed:
        if name not in names:
            raise ValueError(f"{where}: column {name!r} is missing (has {', '.join(names)})")
    for name in names:
        if names.count(name) > 1:
            raise ValueError(f"{where}: column {name!r} stands twice")
        if allowed is not None and name not in allowed:
            raise ValueError(f"{where}: column {name!r}: allowed are {', '.join(allowed)}")


def _header(path: Path) -> dict[str, float]:
    """Return the ``# key: number`` lines of a scan; other notes are left alone."""
    found: dict[str, float] = {}
    for k, line in _lines(path):
        name, colon, text = line.lstrip("# \t").partition(":")
        name = name.strip()
        if line.startswith("#") and colon and name in _SCAN_HEADER:
            if name in found:
                raise ValueError(f"{path}, line {k}: '# {name}:' is given twice")
            found[name] = _number(text.strip(), _SCAN_HEADER[name], f"{path}, line {k}, {name}")
    for name in _SCAN_REQUIRED:
        if name not in found:
            allowed = _SCAN_HEADER[name][0]
            raise ValueError(f"{path}: a line '# {name}: number' is missing; must be {allowed}")
    return found


def _lines(path: Path) -> Sequence[tuple[int, str]]:
    """Return the lines that are not blank, with their numbers."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise ValueError(f"{path}: cannot be read ({error.strerror})") from None
    except UnicodeDecodeError:
        raise ValueError(f"{path}: is not a UTF-8 text file") from None
    lines = enumerate((line.strip() for line in text.splitlines()), 1)
    return [(k, line) for k, line in lines if line.strip(" \t,")]


def _cells(line: str, where: str) -> list[str]:
    try:
        return [cell.strip() for cell in next(csv.reader([line]))]
    except csv.Error as error:
        raise ValueError(f"{where}: is not a line of comma-separated values ({error})") from None


def _number(text: str, rule: _Rule, where: str) -> float:
    allowed, holds = rule
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and holds(value)):
        raise ValueError(f"{where}: {text!r} must be {allowed}")
    return value
