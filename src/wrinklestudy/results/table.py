"""The table of a sheet: one row per wrinkle file; and the row of a stability file.

Tables are plain CSV with one header line. The columns and their units are `COLUMNS` and
`STABILITY_COLUMNS`; an empty cell means that there is no such number (a state that did not
converge, a flat sheet that has no wavelength).
"""

import csv
from collections.abc import Mapping, Sequence
from os import fspath
from typing import Any

from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.measure import measure_sheet
from wrinklestudy.metrics.surface import sheet_peak
from wrinklestudy.results.files import atomic_path, read_h5, read_json
from wrinklestudy.typing import AnyPath

CASE = ("material", "law", "bending", "parity", "aspect", "thickness")

COLUMNS: dict[str, str] = {
    "material": "name of the material or variant",
    "law": "strain energy: mooney-rivlin, neo-hookean or svk",
    "bending": "bending law: thinning, fixed-thickness or fvk",
    "parity": "of z across the width: antisymmetric or symmetric",
    "aspect": "L/W",
    "thickness": "t/W",
    "strain": "(L' - L)/L",
    "status": "wrinkled, flat or not-converged",
    "amplitude_over_thickness": "A/t, largest |z| on x = 0",
    "wavelength_over_width": "lambda/W, distance of the neighbouring like-signed central peaks",
    "wavelength_zero_over_width": "lambda/W from the central zero crossings",
    "arc_width_over_width": "W_act/W, arc length of x = 0",
    "projected_width_over_width": "W_proj/W, distance of the free edges on x = 0",
    "planar_width_over_width": "width of the flat state of this strain on x = 0",
    "phi_squared": "(W_act - W_proj)/W_proj over the full width",
    "phi_squared_central": "the same over one wavelength around the centre",
    "shape_constant": "A/(lambda Phi), Phi over the full width",
    "shape_constant_central": "A/(lambda Phi), Phi over one wavelength",
    "nominal_stress_pa": "clamp force over undeformed cross-section (Pa)",
    "young_modulus_pa": "initial Young's modulus of the material (Pa)",
    "energy": "energy of the quarter sheet (mu W^3)",
    "flat_energy": "energy of the flat quarter sheet at this strain (mu W^3)",
    "critical_thickness": "tau_1/W: the flat sheet is unstable if t is less",
    "sheet_amplitude_over_thickness": "largest |z|/t over the whole sheet",
    "sheet_amplitude_x_over_length": "where: X/L from the centre, clamp at 1/2",
    "sheet_amplitude_y_over_width": "where: Y/W from the mid-line, free edge at 1/2",
    "unstable_directions": "negative eigenvalues of the tangent of the quarter",
    "newton_iterations": "iterations of the solve",
    "residual": "of the solve",
    "cells_along": "cells of the quarter along the pull",
    "cells_across": "cells of the quarter across",
    "reason": "why the state has this status",
}

STABILITY_COLUMNS: dict[str, str] = {
    **{name: COLUMNS[name] for name in CASE},
    "birth_strain": "smallest strain at which the flat sheet is unstable; empty if none",
    "decay_strain": "strain at which it becomes stable again; empty if not in the range",
    "max_critical_thickness": "largest tau_1/W over the strains",
    "strain_at_max": "strain at which it is reached",
}

_MEASURED = (
    "amplitude_over_thickness",
    "wavelength_over_width",
    "wavelength_zero_over_width",
    "arc_width_over_width",
    "projected_width_over_width",
    "phi_squared",
    "phi_squared_central",
    "shape_constant",
    "shape_constant_central",
    "sheet_amplitude_over_thickness",
    "sheet_amplitude_x_over_length",
    "sheet_amplitude_y_over_width",
)
# Numbers of an equilibrium: there are none if the solve did not converge.
_OF_EQUILIBRIUM = ("nominal_stress_pa", "energy", "unstable_directions")
_GEOMETRY = ("grid/x", "grid/y", "position")


def measure_state(path: AnyPath) -> dict[str, Any]:
    """Return the row of one wrinkle file, keyed as `COLUMNS`.

    A state that did not converge has None for everything that is measured; a flat one has
    amplitude 0 and Phi^2 = 0, and no wavelength.

    Parameters
    ----------
    path : path-like
        File of the wrinkle stage.

    Returns
    -------
    dict

    Raises
    ------
    ValueError
        If the file lacks something or its status is unknown; one line that names the file.
    """
    datasets, attrs = read_h5(path)
    return row_of_state(datasets, attrs, fspath(path))


def row_of_state(
    datasets: Mapping[str, Any], attrs: Mapping[str, Any], name: str
) -> dict[str, Any]:
    """Return the row of `measure_state` from what is in the file; ``name`` is for messages."""
    row: dict[str, Any] = dict.fromkeys(COLUMNS)
    status = attrs.get("status")
    if status not in ("wrinkled", "flat", "not-converged"):
        raise ValueError(f"{name}: status = {status!r}: must be wrinkled, flat or not-converged")
    for column in COLUMNS:
        if column in attrs and column not in _MEASURED:
            row[column] = attrs[column]
        elif column not in _MEASURED:
            raise ValueError(f"{name}: attribute {column!r} is missing, not a wrinkle file")
    if status == "not-converged":
        row.update(dict.fromkeys(_OF_EQUILIBRIUM))
        return row
    missing = [key for key in _GEOMETRY if key not in datasets]
    if missing:
        raise ValueError(f"{name}: dataset {missing[0]!r} is missing, not a wrinkle file")
    return row | _measured(datasets, attrs, name)


def _measured(datasets: Mapping[str, Any], attrs: Mapping[str, Any], name: str) -> dict[str, Any]:
    grid_x, grid_y, position = (datasets[key] for key in _GEOMETRY)
    flat = attrs["status"] == "flat"
    try:
        symmetry = Symmetry.mirrored(attrs["parity"])
        sheet = DeformedSheet(Grid(grid_x, grid_y), position, symmetry)
        if flat:
            sheet = sheet.flattened()  # what is left of a seed that decayed is no wrinkle
        found = measure_sheet(sheet)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    peak = sheet_peak(sheet)
    thickness, length = attrs["thickness"], attrs["aspect"]
    values = (
        found.amplitude / thickness,
        found.wavelength,
        found.wavelength_zero,
        found.arc_width,
        found.projected_width,
        found.phi_squared,
        found.phi_squared_central,
        found.shape_constant,
        found.shape_constant_central,
        peak.amplitude / thickness,
        None if flat else peak.x / length,
        None if flat else peak.y,
    )
    return dict(zip(_MEASURED, values, strict=True))


def stability_row(path: AnyPath) -> dict[str, Any]:
    """Return the row of one stability file, keyed as `STABILITY_COLUMNS`.

    Raises
    ------
    ValueError
        If a key is missing; one line that names the file.
    """
    content = read_json(path)
    for column in STABILITY_COLUMNS:
        if not isinstance(content, dict) or column not in content:
            raise ValueError(f"{fspath(path)}: {column!r} is missing, not a stability file")
    return {column: content[column] for column in STABILITY_COLUMNS}


def refuse_twins(
    rows: Sequence[Mapping[str, Any]], key: Sequence[str], paths: Sequence[AnyPath]
) -> None:
    """Raise a ValueError if two rows have the same key; it names the files they come from."""
    seen: dict[tuple[Any, ...], AnyPath] = {}
    for row, path in zip(rows, paths, strict=True):
        case = tuple(row[name] for name in key)
        if case in seen:
            raise ValueError(f"{fspath(path)}: holds the same case as {fspath(seen[case])}")
        seen[case] = path


def write_table(
    rows: Sequence[Mapping[str, Any]],
    columns: Mapping[str, str],
    key: Sequence[str],
    output: AnyPath,
) -> None:
    """Write rows as CSV, sorted by a key; numbers have all their digits, None and NaN are empty."""
    ordered = sorted(rows, key=lambda row: tuple(row[name] for name in key))
    with atomic_path(output) as path, open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([_cell(row[name]) for name in columns] for row in ordered)


def _cell(value: Any) -> str:
    if value is None or value != value:
        return ""
    return repr(float(value)) if isinstance(value, float) else str(value)


_TEXTS = ("material", "law", "bending", "parity", "status", "reason")


def read_states(path: AnyPath) -> list[dict[str, Any]]:
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


def _value(path: AnyPath, column: str, text: str) -> Any:
    if column in _TEXTS:
        return text
    try:
        return int(text) if text.lstrip("-").isdigit() else float(text or "nan")
    except (TypeError, ValueError):
        raise ValueError(f"{fspath(path)}: {column} = {text!r}: must be a number") from None
