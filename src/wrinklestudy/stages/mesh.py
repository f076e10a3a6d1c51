"""The mesh stage: the mesh of the sheets of one L/W and design thickness."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.results.grids import write_grid


def run(aspect: float, resolved: float, settings: Mapping[str, Any], output: Path | str) -> None:
    """Write the mesh for a sheet as a file that meshio and ParaView read."""
    write_grid(make_grid(aspect, resolved, MeshSettings(**settings)), output)
