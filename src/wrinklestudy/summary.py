"""Summary stage: the tables of the whole study, put together from those of its sheets.

Three plain CSV files: all states (columns `metrics.table.COLUMNS`), birth and decay of all sheets
(`metrics.table.STABILITY_COLUMNS`) and the peak of each sheet over strain (`PEAK_COLUMNS`).
"""

import csv
import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wrinklestudy.metrics.peak import peak
from wrinklestudy.metrics.table import (
    CASE,
    COLUMNS,
    STABILITY_COLUMNS,
    refuse_twins,
    stability_row,
    write_table,
)

Path = str | PathLike[str]
Row = Mapping[str, Any]
Array = NDArray[np.float64]

PEAK_COLUMNS: dict[str, str] = {
    **{name: COLUMNS[name] for name in CASE},
    "birth_strain": STABILITY_COLUMNS["birth_strain"],
    "decay_strain": STABILITY_COLUMNS["decay_strain"],
    "max_amplitude_over_thickness": "largest A/t over strain; 0 if the sheet never wrinkles",
    "strain_at_max_amplitude": "where; empty if the sheet never wrinkles",
    "max_phi_squared": "largest Phi^2 (full width) over strain; 0 if the sheet never wrinkles",
    "strain_at_max_phi_squared": "where; empty if the sheet never wrinkles",
    "wavelength_over_width_at_max_amplitude": "lambda/W where A/t is largest",
    "min_wavelength_over_width": "smallest lambda/W of the wrinkled states",
    "max_wavelength_over_width": "largest lambda/W of the wrinkled states",
    "wrinkled": "number of wrinkled states",
    "flat": "number of flat states",
    "not_converged": "number of states that did not converge",
    "cells_along": COLUMNS["cells_along"],
    "cells_across": COLUMNS["cells_across"],
}

_TEXTS = ("material", "law", "bending", "parity", "status", "reason")
_NAN = math.nan


def run(metrics: Sequence[Path], stability: Sequence[Path], output: Mapping[str, Path]) -> None:
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


def read_states(path: Path) -> list[dict[str, Any]]:
    """Return the rows of a table of the metrics or of this stage.

    Numbers are as they were when the table was written, whole ones int; an empty cell is NaN.

    Raises
    ------
    ValueError
        If a column is missing or a cell is no number; one line that names the file.
    """
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        missing = [name for name in COLUMNS if name not in (reader.fieldnames or ())]
        if missing:
            raise ValueError(f"{fspath(path)}: column {missing[0]!r} is missing")
        return [{name: _value(path, name, row[name]) for name in COLUMNS} for row in reader]


def _value(path: Path, column: str, text: str) -> Any:
    if column in _TEXTS:
        return text
    try:
        return int(text) if text.lstrip("-").isdigit() else float(text or "nan")
    except (TypeError, ValueError):
        raise ValueError(f"{fspath(path)}: {column} = {text!r}: must be a number") from None


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


def peak_row(limit: Row, states: Sequence[Row]) -> dict[str, Any]:
    """Return what one sheet reaches over strain, keyed as `PEAK_COLUMNS`.

    (A/t)^2 and Phi^2 are smooth functions of the strain that vanish at birth and decay: the maxima
    are those of parabolas (`metrics.peak`), with birth and decay among the samples, and NaN where a
    state beside them did not converge. The wavelength at the peak is linear between the states.

    Parameters
    ----------
    limit : mapping
        Row of the stability stage, keyed as `STABILITY_COLUMNS`.
    states : sequence of mappings
        The states of the sheet by strain, keyed as `COLUMNS`.
    """
    curved = [row for row in states if row["status"] != "flat"]
    strain, amplitude, phi_squared, wavelength = (
        np.array([row[name] for row in curved], dtype=float)
        for name in ("strain", "amplitude_over_thickness", "phi_squared", "wavelength_over_width")
    )
    ends = [limit["birth_strain"], limit["decay_strain"]]
    at_amplitude, highest = _peak(strain, amplitude**2, ends)
    at_phi, largest = _peak(strain, phi_squared, ends)
    known = np.isfinite(wavelength)
    strain, wavelength = strain[known], wavelength[known]
    at_peak = float(np.interp(at_amplitude, strain, wavelength)) if known.any() else _NAN
    counts = {
        status: sum(row["status"] == status for row in states)
        for status in ("wrinkled", "flat", "not-converged")
    }
    return {
        **{name: limit[name] for name in (*CASE, "birth_strain", "decay_strain")},
        "max_amplitude_over_thickness": math.sqrt(highest),
        "strain_at_max_amplitude": at_amplitude,
        "max_phi_squared": largest,
        "strain_at_max_phi_squared": at_phi,
        "wavelength_over_width_at_max_amplitude": at_peak,
        "min_wavelength_over_width": float(wavelength.min()) if known.any() else _NAN,
        "max_wavelength_over_width": float(wavelength.max()) if known.any() else _NAN,
        **{status.replace("-", "_"): count for status, count in counts.items()},
        **{name: states[0][name] for name in ("cells_along", "cells_across")},
    }


def _peak(strain: Array, value: Array, ends: Sequence[float | None]) -> tuple[float, float]:
    """Return where the largest value is and how large, with birth and decay as further samples."""
    zeros = [end for end in ends if end is not None and end not in strain]
    if zeros and not np.isfinite(value).any():
        return _NAN, _NAN  # it wrinkles between two strains of the study: nothing was measured
    if not len(strain):
        return _NAN, 0.0
    return peak(np.append(strain, zeros), np.append(value, np.zeros(len(zeros))))
