"""The row of a state with what is measured on its shape."""

from dataclasses import replace
from os import fspath
from typing import Any

from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.measure import Measures, measure_sheet
from wrinklestudy.metrics.profile import FoldedProfileError
from wrinklestudy.metrics.surface import envelope, sheet_peak
from wrinklestudy.results.fields import deformed_sheet, read_wrinkle
from wrinklestudy.results.rows import StateRow, columns
from wrinklestudy.typing import AnyPath


def measure_state(path: AnyPath) -> StateRow:
    """Return the row of one wrinkle file.

    A state that did not converge, or folds over itself, has no numbers that are measured or belong
    to an equilibrium; a flat state has amplitude 0, Phi^2 = 0 and no wavelength.

    Parameters
    ----------
    path : path-like
        File of the wrinkle stage.

    Raises
    ------
    ValueError
        If the file lacks something or a value is not allowed; one line that names the file.
    """
    row, datasets = read_wrinkle(path)
    if row.status == "not-converged":
        return unmeasured(row)
    try:
        return _measured(row, deformed_sheet(row, datasets))
    except FoldedProfileError as error:
        return unmeasured(replace(row, status="not-converged", reason=str(error)))
    except ValueError as error:
        raise ValueError(f"{fspath(path)}: {error}") from None


def _measured(row: StateRow, sheet: DeformedSheet) -> StateRow:
    if row.status == "flat":
        sheet = sheet.flattened()  # what remains of a seed that has decayed is no wrinkle
    return _with_surface(with_measures(row, measure_sheet(sheet)), sheet)


def with_measures(row: StateRow, measures: Measures) -> StateRow:
    """Return the row of a state with what was measured on its mid-line, in units of W."""
    return replace(
        row,
        amplitude_over_thickness=measures.amplitude / row.thickness,
        wavelength_over_width=_or_none(measures.wavelength),
        wavelength_zero_over_width=_or_none(measures.wavelength_zero),
        cells_per_wavelength=_or_none(measures.cells_per_wavelength(2 * row.cells_across)),
        arc_width_over_width=measures.arc_width,
        projected_width_over_width=measures.projected_width,
        phi_squared=measures.phi_squared,
        phi_squared_central=_or_none(measures.phi_squared_central),
        shape_constant=_or_none(measures.shape_constant),
        shape_constant_central=_or_none(measures.shape_constant_central),
    )


def unmeasured(row: StateRow) -> StateRow:
    """Return the row of a state that did not converge: without the numbers of an equilibrium."""
    state_columns = columns(StateRow).values()
    nothing: dict[str, Any] = {
        column.name: None for column in state_columns if column.measured or column.of_equilibrium
    }
    return replace(row, **nothing)


def _with_surface(row: StateRow, sheet: DeformedSheet) -> StateRow:
    peak = sheet_peak(sheet)
    row = replace(row, sheet_amplitude_over_thickness=peak.amplitude / row.thickness)
    if row.status == "flat":
        return row
    lengths = envelope(sheet)
    return replace(
        row,
        sheet_amplitude_x_over_length=peak.x / row.aspect,
        sheet_amplitude_y_over_width=peak.y,
        envelope_amplitude_over_thickness=lengths.amplitude / row.thickness,
        envelope_amplitude_x_over_length=lengths.x / row.aspect,
        envelope_length_over_width=lengths.length,
        deformed_envelope_length_over_width=lengths.deformed_length,
    )


def _or_none(value: float) -> float | None:
    return None if value != value else float(value)
