"""What a sheet reaches over strain: its row, from its limits and its states."""

import math
from collections import Counter
from collections.abc import Sequence
from typing import Any

import numpy as np

from wrinklestudy.metrics.peak import peak
from wrinklestudy.results.rows import SheetRow, StabilityRow, StateRow, make_row, numbers_of
from wrinklestudy.typing import Array

_NAN = math.nan


def sheet_row(limits: StabilityRow, states: Sequence[StateRow]) -> SheetRow:
    """Return the row of a sheet.

    (A/t)^2 and Phi^2 are smooth functions of the strain that vanish at birth and decay. Their
    maxima are those of parabolas (`metrics.peak`), with birth and decay among the samples; they are
    unknown if a state beside them did not converge. The wavelength at the
    peak is interpolated linearly.

    Parameters
    ----------
    limits : StabilityRow
        Where the sheet is unstable.
    states : sequence of StateRow
        The states of the sheet by strain, at least one.
    """
    curved = [row for row in states if row.status != "flat"]
    strain, amplitude, phi_squared, wavelength = (
        np.array(numbers_of(curved, name), dtype=np.float64)
        for name in ("strain", "amplitude_over_thickness", "phi_squared", "wavelength_over_width")
    )
    ends = [end for end in (limits.birth_strain, limits.decay_strain) if end is not None]
    at_amplitude, highest = _peak(strain, amplitude**2, ends)
    at_phi, largest = _peak(strain, phi_squared, ends)
    known = np.isfinite(wavelength)
    strain, wavelength = strain[known], wavelength[known]
    at_peak = float(np.interp(at_amplitude, strain, wavelength)) if known.any() else _NAN
    counts = Counter(row.status for row in states)
    values: dict[str, Any] = {
        "max_amplitude_over_thickness": math.sqrt(highest),
        "strain_at_max_amplitude": at_amplitude,
        "max_phi_squared": largest,
        "strain_at_max_phi_squared": at_phi,
        "wavelength_over_width_at_max_amplitude": at_peak,
        "min_wavelength_over_width": float(wavelength.min()) if known.any() else _NAN,
        "max_wavelength_over_width": float(wavelength.max()) if known.any() else _NAN,
        "wrinkled": counts["wrinkled"],
        "flat": counts["flat"],
        "not_converged": counts["not-converged"],
        "cells_along": states[0].cells_along,
        "cells_across": states[0].cells_across,
    }
    return make_row(SheetRow, vars(limits) | values, "sheet", "row")


def _peak(strain: Array, value: Array, ends: Sequence[float]) -> tuple[float, float]:
    """Return where the largest value is and how large, with birth and decay as further samples."""
    zeros = [end for end in ends if end not in strain]
    if zeros and not np.isfinite(value).any():
        return _NAN, _NAN  # it wrinkles between two strains of the study only
    if not len(strain):
        return _NAN, 0.0
    return peak(np.append(strain, zeros), np.append(value, np.zeros(len(zeros))))
