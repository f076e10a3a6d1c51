"""The map stage: the critical thickness over strain of one model and L/W."""

from collections.abc import Mapping, Sequence
from typing import Any

from wrinklestudy.equilibrium.critical_map import critical_states, map_grid
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.mechanics import laws
from wrinklestudy.stages.log import log_cpu
from wrinklestudy.typing import AnyPath


def run(
    material: AnyPath,
    aspect: float,
    strains: Sequence[float],
    mesh: Mapping[str, Any],
    settings: Mapping[str, Any],
    output: AnyPath | Mapping[str, AnyPath],
    name: str | None = None,
) -> None:
    """Compute tau_1 with its mode for both parities and write them as a table.

    The mesh is one of its own (`map_grid`): maps hold for all thicknesses.

    Parameters
    ----------
    material : path-like
        Material JSON with the constants.
    aspect : float
        L/W.
    strains : sequence of float
    mesh : mapping
        Keys of `MeshSettings`.
    settings : mapping
        ``bending``.
    output : path-like, or mapping with ``table``
        CSV file to write, with a row for each strain and parity.
    name : str, optional
        Name of the model in the study; that of the material file by default.
    """
    from pathlib import Path

    from wrinklestudy.results.maps import map_row
    from wrinklestudy.results.materials import load_material
    from wrinklestudy.results.tables import write_map

    loaded, grid = load_material(Path(material)), map_grid(aspect, MeshSettings(**mesh))
    with log_cpu("solve"):
        states = critical_states(grid, loaded.law, strains, [settings["bending"]])
    law = str(laws.describe(loaded)["law"])
    rows = [map_row(state, name or Path(material).stem, law, grid) for state in states]
    write_map(rows, output["table"] if isinstance(output, Mapping) else output)
