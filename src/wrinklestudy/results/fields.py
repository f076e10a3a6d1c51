"""HDF5 files of flat and wrinkled states, with fields in the layout of the grid."""

import math
from collections.abc import Mapping
from os import fspath
from pathlib import Path
from typing import Any

import numpy as np

from wrinklestudy.equilibrium import newton
from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.modes import Modes
from wrinklestudy.equilibrium.newton import Iteration
from wrinklestudy.equilibrium.planar import Planar, PlanarSettings
from wrinklestudy.equilibrium.wrinkled import Equilibrium
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.files.storage import read_h5, write_h5
from wrinklestudy.mechanics import laws
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.results.rows import StateRow, columns, make_row
from wrinklestudy.typing import AnyPath


def write_planar(planar: Planar, output: Path | str) -> None:
    """Write a planar state as an HDF5 file; fields are in the layout of the grid."""
    datasets: dict[str, Any] = {"grid/x": planar.grid.x, "grid/y": planar.grid.y}
    attrs = {
        "units": "lengths in W, stresses in the initial shear modulus mu, energies in mu W^2 per t",
        "material": planar.name,
        **laws.describe(planar.material),
        "strain": planar.strain,
        "aspect": planar.grid.aspect,
        **vars(planar.settings),
        "reason": planar.reason,
    }
    if planar.flat is not None and planar.modes is not None:
        flat, modes = planar.flat, planar.modes
        datasets |= {
            "position": flat.space.nodes_from_field(flat.position),
            "history": np.array(flat.history),
            "modes/squared_thickness": modes.squared,
            # single precision is enough for seeds
            "modes/shapes": flat.space.nodes_from_field(modes.shapes).astype(np.float32),
            "modes/corner": modes.corner,
            "modes/quartic": modes.quartic,
            "modes/relaxation": flat.space.nodes_from_field(modes.relaxation).astype(np.float32),
        }
        attrs |= {
            "energy": flat.energy,
            "nominal_stress": flat.force,
            "critical_thickness": modes.critical_thickness,
        }
    write_h5(output, datasets, attrs)


def read_planar(path: Path | str) -> Planar:
    """Read a planar state back."""
    data, attrs = read_h5(path)
    grid = Grid(data["grid/x"], data["grid/y"])
    material = laws.from_description(attrs)
    settings = PlanarSettings(attrs["bending"], attrs["parity"], attrs["modes"])
    strain, name = attrs["strain"], attrs["material"]
    if attrs["reason"]:
        return Planar(grid, material, name, strain, settings, None, None, attrs["reason"])
    space = Space(grid)
    flat = Flat(
        space,
        material.law,
        strain,
        space.field_from_nodes(data["position"]),
        attrs["energy"],
        attrs["nominal_stress"],
        tuple(Iteration(*row) for row in data["history"].tolist()),
        settings.symmetry,
    )
    modes = Modes(
        settings.symmetry,
        settings.bending,
        data["modes/squared_thickness"],
        space.field_from_nodes(data["modes/shapes"]),
        data["modes/corner"],
        data["modes/quartic"],
        space.field_from_nodes(data["modes/relaxation"]),
    )
    return Planar(grid, material, name, strain, settings, flat, modes)


def state_row(state: Equilibrium) -> StateRow:
    """Return the row of a state without what is measured on its shape.

    If it did not converge, the numbers are those of the last iterate.
    """
    planar = state.planar
    flat, modes = planar.flat, planar.modes
    along, across = planar.grid.cells
    width = None
    if flat is not None:
        width = 2.0 * flat.space.nodes_from_field(flat.position)[1, 0, 0, -1]
    measured = [column.name for column in columns(StateRow).values() if column.measured]
    values = dict.fromkeys(measured) | {
        "material": planar.name,
        "law": laws.describe(planar.material)["law"],
        "bending": planar.settings.bending,
        "parity": planar.settings.parity,
        "aspect": planar.grid.aspect,
        "thickness": state.thickness,
        "strain": planar.strain,
        "status": state.status,
        "reason": state.reason,
        "planar_width_over_width": width,
        "nominal_stress_pa": state.nominal_stress * planar.material.shear_modulus,
        "young_modulus_pa": planar.material.young_modulus,
        "energy": state.energy,
        "flat_energy": state.flat_energy,
        "critical_thickness": None if modes is None else modes.critical_thickness,
        "unstable_directions": state.unstable_directions,
        "newton_iterations": newton.count(state.history),
        "residual": state.residual,
        "cells_along": along,
        "cells_across": across,
    }
    return make_row(StateRow, values, "state", "row")


def write_wrinkle(state: Equilibrium, output: Path | str) -> None:
    """Write a state as an HDF5 file; the position is in the layout of the grid.

    The attributes are the columns of its row that are not measured on the shape, with NaN where
    there is no number, and whatever else describes the material and the solve.
    """
    planar = state.planar
    datasets: dict[str, Any] = {"grid/x": planar.grid.x, "grid/y": planar.grid.y}
    if state.position is not None and planar.flat is not None:
        datasets["position"] = planar.flat.space.nodes_from_field(state.position)
    datasets["history"] = np.array(state.history).reshape(-1, len(newton.Iteration._fields))
    row = vars(state_row(state))
    attrs = {
        "units": "lengths in W, stresses in the initial shear modulus mu, energies in mu W^3",
        **laws.describe(planar.material),
        "shear_modulus_pa": planar.material.shear_modulus,
        "poisson": planar.material.law.poisson,
        "nominal_stress": state.nominal_stress,
        "history_columns": list(newton.Iteration._fields),
        **{name: math.nan if row[name] is None else row[name] for name in _attributes()},
    }
    write_h5(output, datasets, attrs)


def read_wrinkle(path: AnyPath) -> tuple[StateRow, dict[str, Any]]:
    """Return the row of a wrinkle file, without what is measured on its shape, and its arrays.

    Raises
    ------
    ValueError
        If the file lacks an attribute or one is not what its column allows; one line that names
        the file.
    """
    datasets, attrs = read_h5(path)
    measured = dict.fromkeys(columns(StateRow).keys() - _attributes())
    return make_row(StateRow, attrs | measured, fspath(path), "wrinkle file"), datasets


def _attributes() -> list[str]:
    """Return the columns of a state that are attributes of its file."""
    return [column.name for column in columns(StateRow).values() if not column.measured]


def deformed_sheet(row: StateRow, datasets: Mapping[str, Any]) -> DeformedSheet:
    """Return the sheet of a wrinkle file, with grid and mirrors, from what `read_wrinkle` gives.

    Raises
    ------
    ValueError
        If a dataset is missing.
    """
    for name in ("grid/x", "grid/y", "position"):
        if name not in datasets:
            raise ValueError(f"dataset {name!r} is missing, not a wrinkle file")
    grid = Grid(datasets["grid/x"], datasets["grid/y"])
    return DeformedSheet(grid, datasets["position"], Symmetry.mirrored(row.parity))
