"""Measured data of the user: stress, amplitude and wavelength tables, and scanned profiles.

What the files may hold is described in ``data/experiment/README.md``. All of them are UTF-8 CSV
files: lines that begin with ``#`` are notes, the first other line names the columns, in any order.
"""

import csv
import logging
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path

import numpy as np

from wrinklestudy.metrics.measure import Measures
from wrinklestudy.metrics.profile import Profile
from wrinklestudy.metrics.scan import measure_scan
from wrinklestudy.results.cases import canonical
from wrinklestudy.study.scan_file import read_scan_file
from wrinklestudy.typing import AnyPath, Array
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
_STRESS_COLUMNS = {"strain": ("> -1 and <= 10", lambda v: -1.0 < v <= 10.0), "stress_pa": _ANY}
_VALUE_COLUMNS: dict[str, dict[str, _Rule]] = {
    "amplitude": {"amplitude_over_thickness": (">= 0 (A/t)", lambda v: v >= 0.0)},
    "wavelength": {"wavelength_over_width": ("> 0 and <= 1 (lambda/W)", lambda v: 0.0 < v <= 1.0)},
}

_LOGGER = logging.getLogger(__name__)


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

    def highest(self) -> tuple[float, float]:
        """Return the largest value and its error."""
        top = int(np.argmax(self.value))
        return float(self.value[top]), float(self.error[top])

    def _arrays(self) -> tuple[Array, Array, Array]:
        return self.strain, self.value, self.error


@dataclass(frozen=True, eq=False)
class Scan:
    """A scanned profile half-way between the clamps, lengths in units of W.

    Parameters
    ----------
    sheet : tuple of float
        L/W and t/W.
    strain : float
        eps.
    profile : Profile
        Without noise, offset and tilt; the middle of the sheet at y = 0.
    measures : Measures
        Of that profile.
    wrinkled : bool
        Whether wrinkles stand out of the noise.
    error, wavelength_error, phi_squared_error : float
        Standard errors of A, lambda and Phi^2; NaN where there is no number.
    noise : float
        Standard deviation of the noise of single points.
    left_out : int
        Points that were lost or spikes.
    """

    sheet: SheetSize
    strain: float
    profile: Profile
    measures: Measures
    wrinkled: bool
    error: float
    wavelength_error: float
    phi_squared_error: float
    noise: float
    left_out: int


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


def read_stress(path: str | PathLike[str]) -> Points:
    """Read nominal stress (Pa) against strain: columns strain, stress_pa, optional error_pa.

    Raises
    ------
    ValueError
        If the file is not such a table; one line that names the file, the line and the column.
    """
    table = _table(Path(path), _STRESS_COLUMNS, "error_pa")
    return Points(table["strain"], table["stress_pa"], table["error_pa"])


def read_sheets(path: str | PathLike[str]) -> dict[SheetSize, Points]:
    """Read amplitude.csv (A/t) or wavelength.csv (lambda/W) against strain, sheet by sheet.

    Columns aspect, thickness, strain, amplitude_over_thickness or wavelength_over_width,
    optional error.

    Returns
    -------
    dict
        Points by (L/W, t/W), sorted.

    Raises
    ------
    ValueError
        If the file is not such a table; one line that names the file, the line and the column.
    """
    columns = _VALUE_COLUMNS[kind(path)]
    table = _table(Path(path), _SHEET_COLUMNS | columns, "error")
    (value,) = columns
    sheets = [
        (canonical(a), canonical(t))
        for a, t in zip(table["aspect"], table["thickness"], strict=True)
    ]
    found = {}
    for sheet in sorted(set(sheets)):
        own = np.array([one == sheet for one in sheets])
        found[sheet] = Points(table["strain"][own], table[value][own], table["error"][own])
    return found


def read_scan(path: AnyPath) -> Scan | None:
    """Read a scanned profile, bring it to units of W and measure it: `metrics.scan`.

    The file is that of `study.scan_file`, with header lines ``# aspect: 2``,
    ``# thickness: 0.001``, ``# strain: 0.12`` and, optional, ``# width: 140`` (W in the unit of y,
    1 if left out) and ``# error: 0.02`` (standard error of the amplitude in that unit, such as that
    of the calibration). The errors are the larger of those that the scan itself tells and those
    that follow from that line.

    Returns
    -------
    Scan or None
        None where the scan cannot tell; the log says why, and how many points were left out.

    Raises
    ------
    ValueError
        If the file is not such a scan; one line that names the file and, where there is one, the
        line.
    """
    file = read_scan_file(path, of_sheet=True)
    width = file.notes.get("width", 1.0)
    scan = measure_scan(file.y / width, file.z / width)
    if scan.left_out:
        _LOGGER.warning("%s: %d points left out (lost or spikes)", path, scan.left_out)
    if scan.measures is None or scan.profile is None:
        _LOGGER.warning("%s: not shown: %s", path, scan.reason)
        return None
    if scan.note:
        _LOGGER.warning("%s: %s", path, scan.note)
    stated, measures = file.notes.get("error", 0.0) / width, scan.measures
    relative = stated / measures.amplitude if measures.amplitude > 0.0 else 0.0
    return Scan(
        sheet=(canonical(file.notes["aspect"]), canonical(file.notes["thickness"])),
        strain=file.notes["strain"],
        profile=scan.profile,
        measures=measures,
        wrinkled=scan.wrinkled,
        error=max(scan.amplitude_error, stated),
        wavelength_error=scan.wavelength_error,
        # Phi^2 grows as the square of the deflection
        phi_squared_error=max(scan.phi_squared_error, 2.0 * relative * measures.phi_squared),
        noise=scan.noise,
        left_out=scan.left_out,
    )


def _table(path: Path, columns: dict[str, _Rule], error: str) -> dict[str, Array]:
    """Return the columns of a CSV file."""
    rules = columns | {error: _ERROR}
    rows = [(k, line) for k, line in _lines(path) if not line.startswith("#")]
    if not rows:
        raise ValueError(f"{path}: is empty; a line of column names and the data are needed")
    (first, names), *points = [(k, _cells(line, f"{path}, line {k}")) for k, line in rows]
    _check_names(f"{path}, line {first}", names, columns, rules)
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
    where: str, names: list[str], needed: dict[str, _Rule], allowed: dict[str, _Rule]
) -> None:
    for name in needed:
        if name not in names:
            raise ValueError(f"{where}: column {name!r} is missing (has {', '.join(names)})")
    for name in names:
        if names.count(name) > 1:
            raise ValueError(f"{where}: column {name!r} stands twice")
        if name not in allowed:
            raise ValueError(f"{where}: column {name!r}: allowed are {', '.join(allowed)}")


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
