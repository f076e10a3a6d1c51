"""The compression stage: the centre of the flat sheet over strain, of one material and L/W."""

from collections.abc import Mapping
from typing import Any

from wrinklestudy.equilibrium.compression import central_states
from wrinklestudy.equilibrium.critical_map import map_grid
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.mechanics import laws
from wrinklestudy.stages.log import log_cpu
from wrinklestudy.typing import AnyPath


def run(
    material: AnyPath, aspect: float, mesh: Mapping[str, Any], output: AnyPath, name: str
) -> None:
    """Compute at which strains the centre is compressed and write them as a table.

    Parameters
    ----------
    material : path-like
        Material JSON with the constants.
    aspect : float
        L/W.
    mesh : mapping
        Keys of `MeshSettings`.
    output : path-like
        CSV file to write, with a row for each strain.
    name : str
        Name of the material in the study.
    """
    from pathlib import Path

    from wrinklestudy.results.compression import compression_row
    from wrinklestudy.results.materials import load_material
    from wrinklestudy.results.tables import write_compression

    loaded, grid = load_material(Path(material)), map_grid(aspect, MeshSettings(**mesh))
    with log_cpu("solve"):
        states = central_states(grid, loaded.law)
    law = str(laws.describe(loaded)["law"])
    write_compression([compression_row(state, name, law, grid) for state in states], output)
