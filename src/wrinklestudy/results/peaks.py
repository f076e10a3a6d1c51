"""What a sheet reaches over strain: the rows of the table of peaks."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from wrinklestudy.metrics.peak import peak
from wrinklestudy.results.table import CASE, COLUMNS, STABILITY_COLUMNS
from wrinklestudy.typing import Array

Row = Mapping[str, Any]


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


_NAN = math.nan


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
