"""The planar stage: flat state of one material, L/W and strain, with its critical thicknesses."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from wrinklestudy.fem.space import Parity, Space
from wrinklestudy.flat import Flat
from wrinklestudy.flat import solve as solve_flat
from wrinklestudy.joblog import log_cpu
from wrinklestudy.material import laws
from wrinklestudy.mesh import Grid, read_grid
from wrinklestudy.modes import Modes, critical_modes
from wrinklestudy.newton import Iteration
from wrinklestudy.section import Bending
from wrinklestudy.store import read_h5, write_h5


@dataclass(frozen=True)
class Settings:
    """Options of the planar stage.

    Parameters
    ----------
    bending : {'thinning', 'fixed-thickness', 'fvk'}
        The bending law.
    parity : {'antisymmetric', 'symmetric'}
        Of the deflection across y = 0.
    modes : int
        Number of critical thicknesses and modes.
    """

    bending: Bending = "thinning"
    parity: Parity = "antisymmetric"
    modes: int = 8


@dataclass(frozen=True)
class Planar:
    """A flat state with its modes and its material; ``flat`` and ``modes`` are None if it failed.

    Parameters
    ----------
    grid : Grid
    material : Material
    name : str
        Name of the material in the study.
    strain : float
        eps of the clamps.
    settings : Settings
    flat : Flat or None
    modes : Modes or None
    reason : str
        Why there is no flat state; empty if there is one.
    """

    grid: Grid
    material: laws.Material
    name: str
    strain: float
    settings: Settings
    flat: Flat | None
    modes: Modes | None
    reason: str = ""


def solve(
    grid: Grid | Space,
    material: laws.Material,
    strain: float,
    settings: Settings | None = None,
    name: str = "material",
) -> Planar:
    """Return the flat state at a strain with its critical thicknesses and modes.

    A state that does not converge is returned as such, with the reason.

    Parameters
    ----------
    grid : Grid or Space
        Grid of the quarter sheet.
    material : Material
    strain : float
        eps = (L' - L)/L of the clamps.
    settings : Settings, optional
    name : str
        Name of the material.
    """
    settings = settings or Settings()
    space = grid if isinstance(grid, Space) else Space(grid)
    try:
        flat = solve_flat(space, material.law, strain)
        modes = critical_modes(flat, settings.bending, settings.parity, settings.modes)
    except ArithmeticError as error:
        return Planar(space.grid, material, name, strain, settings, None, None, str(error))
    return Planar(space.grid, material, name, strain, settings, flat, modes)


def run(
    mesh: Path | str,
    material: Path | str,
    strain: float,
    settings: Mapping[str, Any],
    output: Path | str,
    name: str | None = None,
) -> None:
    """Solve the flat state of one case and write it.

    Parameters
    ----------
    mesh : path
        Mesh file.
    material : path
        Material JSON with the fitted constants.
    strain : float
        eps of the clamps.
    settings : mapping
        Keys of `Settings`.
    output : path
        HDF5 file to write.
    name : str, optional
        Name of the model in the study; that of the material file by default.
    """
    from wrinklestudy.material.result import load

    name = name or Path(material).stem
    grid, loaded = read_grid(mesh), load(material)
    with log_cpu("solve"):
        state = solve(grid, loaded, strain, Settings(**settings), name)
    write(state, output)


def write(planar: Planar, output: Path | str) -> None:
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
            # seeds need no more than single precision
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


def read(path: Path | str) -> Planar:
    """Read a planar state back."""
    data, attrs = read_h5(path)
    grid = Grid(data["grid/x"], data["grid/y"])
    material = laws.from_description(attrs)
    settings = Settings(attrs["bending"], attrs["parity"], attrs["modes"])
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
    )
    modes = Modes(
        settings.parity,
        settings.bending,
        data["modes/squared_thickness"],
        space.field_from_nodes(data["modes/shapes"]),
        data["modes/corner"],
        data["modes/quartic"],
        space.field_from_nodes(data["modes/relaxation"]),
    )
    return Planar(grid, material, name, strain, settings, flat, modes)
