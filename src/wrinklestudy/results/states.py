"""The row of a state with what is measured on its shape."""

from collections.abc import Mapping
from dataclasses import replace
from os import fspath
from typing import Any

from wrinklestudy.metrics.measure import Measures, measure_position
from wrinklestudy.metrics.surface import SheetPeak, sheet_peak
from wrinklestudy.results.fields import read_wrinkle
from wrinklestudy.results.rows import StateRow, columns
from wrinklestudy.typing import AnyPath

_GEOMETRY = ("grid/x", "grid/y", "position")


def measure_state(path: AnyPath) -> StateRow:
    """Return the row of one wrinkle file.

    A state that did not converge has no number for what is measured or belongs to an equilibrium;
    a flat one has amplitude 0 and Phi^2 = 0, and no wavelength.

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
    for name in _GEOMETRY:
        if name not in datasets:
            raise ValueError(f"{fspath(path)}: dataset {name!r} is missing, not a wrinkle file")
    try:
        return _measured(row, datasets)
    except ValueError as error:
        raise ValueError(f"{fspath(path)}: {error}") from None


def _measured(row: StateRow, datasets: Mapping[str, Any]) -> StateRow:
    grid_x, grid_y, position = (datasets[name] for name in _GEOMETRY)
    if row.status == "flat":
        position = position.copy()
        position[2] = 0.0  # what is left of a seed that decayed is no wrinkle
    row = with_measures(row, measure_position(grid_x, grid_y, position, row.parity))
    return _with_peak(row, sheet_peak(grid_x, grid_y, position))


def with_measures(row: StateRow, measures: Measures) -> StateRow:
    """Return the row of a state with what was measured on its mid-line, in units of W."""
    return replace(
        row,
        amplitude_over_thickness=measures.amplitude / row.thickness,
        wavelength_over_width=_or_none(measures.wavelength),
        wavelength_zero_over_width=_or_none(measures.wavelength_zero),
        arc_width_over_width=measures.arc_width,
        projected_width_over_width=measures.projected_width,
        phi_squared=measures.phi_squared,
        phi_squared_central=_or_none(measures.phi_squared_central),
        shape_constant=_or_none(measures.shape_constant),
        shape_constant_central=_or_none(measures.shape_constant_central),
    )


def unmeasured(row: StateRow) -> StateRow:
    """Return the row of a state that did not converge: without the numbers of an equilibrium."""
    its = columns(StateRow).values()
    nothing: dict[str, Any] = {
        column.name: None for column in its if column.measured or column.of_equilibrium
    }
    return replace(row, **nothing)


def _with_peak(row: StateRow, peak: SheetPeak) -> StateRow:
    flat = row.status == "flat"
    return replace(
        row,
        sheet_amplitude_over_thickness=peak.amplitude / row.thickness,
        sheet_amplitude_x_over_length=None if flat else peak.x / row.aspect,
        sheet_amplitude_y_over_width=None if flat else peak.y,
    )


def _or_none(value: float) -> float | None:
    return None if value != value else float(value)
