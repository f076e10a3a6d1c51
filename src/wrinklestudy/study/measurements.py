"""Measured data of the user: stress, amplitude and wavelength tables, and scanned profiles.

What the files may hold is described in ``data/experiment/README.md``. All of them are UTF-8 CSV
files: lines that begin with ``#`` are notes, the first other line names the columns, in any order.
"""

import logging
import math
from dataclasses import dataclass
from os import PathLike
from pathlib import Path

import numpy as np

from wrinklestudy.files.number_table import (
    NumberColumn,
    NumberTable,
    read_number_table,
)
from wrinklestudy.material.data import STRESS_LIMITS, strain_column, stress_spellings
from wrinklestudy.metrics.measure import Measures
from wrinklestudy.metrics.profile import Profile
from wrinklestudy.metrics.scan import measure_scan
from wrinklestudy.results.cases import canonical
from wrinklestudy.study.scan_file import read_scan_file
from wrinklestudy.typing import AnyPath, Array, Mask
from wrinklestudy.vocabulary import ASPECT, STRAIN, THICKNESS, Limits

SheetSize = tuple[float, float]

KINDS = ("stress", "amplitude", "wavelength", "profiles")

# The sheet at rest may be measured, too.
_MEASURED_STRAIN = Limits(0.0, STRAIN.highest)

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


_ERROR_LIMITS = Limits(0.0)
_STRESS_TABLE = (
    strain_column(),
    NumberColumn("stress", stress_spellings("stress"), STRESS_LIMITS),
    NumberColumn("error", stress_spellings("error"), _ERROR_LIMITS, needed=False, gaps=True),
)
_SHEET_TABLE = (
    NumberColumn("aspect", {"aspect": 1.0}, ASPECT),
    NumberColumn("thickness", {"thickness": 1.0}, THICKNESS),
    strain_column(_MEASURED_STRAIN),
    NumberColumn("error", {"error": 1.0}, _ERROR_LIMITS, needed=False, gaps=True),
)
_VALUES = {
    "amplitude": NumberColumn("value", {"amplitude_over_thickness": 1.0}, Limits(0.0, unit="A/t")),
    "wavelength": NumberColumn(
        "value",
        {"wavelength_over_width": 1.0},
        Limits(0.0, 1.0, above_lowest=True, unit="lambda/W"),
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
