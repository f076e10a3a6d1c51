"""The planar stage: the flat state of one model, L/W and strain, with its critical thicknesses."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from wrinklestudy.equilibrium.planar import PlanarSettings, solve
from wrinklestudy.results.fields import write_planar
from wrinklestudy.results.grids import read_grid
from wrinklestudy.stages.log import log_cpu


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
        Keys of `PlanarSettings`.
    output : path
        HDF5 file to write.
    name : str, optional
        Name of the model in the study; that of the material file by default.
    """
    from wrinklestudy.results.materials import load_material

    name = name or Path(material).stem
    grid, loaded = read_grid(mesh), load_material(material)
    with log_cpu("solve"):
        state = solve(grid, loaded, strain, PlanarSettings(**settings), name)
    write_planar(state, output)
