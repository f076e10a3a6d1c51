"""The tension stage: tension fields over strain of one material and L/W."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from wrinklestudy.equilibrium.tension_field import solve, tension_grid
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.stages.log import log_cpu
from wrinklestudy.typing import AnyPath


def run(
    material: AnyPath,
    aspect: float,
    strains: Sequence[float],
    mesh: Mapping[str, Any],
    output: Mapping[str, AnyPath],
    name: str | None = None,
) -> None:
    """Compute the tension fields of one sheet, and write them and what is measured on them.

    Parameters
    ----------
    material : path-like
        Material JSON with the constants.
    aspect : float
        L/W.
    strains : sequence of float
    mesh : mapping
        Keys of `MeshSettings`.
    output : mapping with ``table`` and ``fields``
        CSV file with a row for each strain, and HDF5 file of the fields.
    name : str, optional
        Name of the material in the study; that of its file by default.
    """
    from wrinklestudy.results.materials import load_material
    from wrinklestudy.results.tables import write_tension_rows
    from wrinklestudy.results.tension import tension_row, write_tension

    loaded, name = load_material(Path(material)), name or Path(material).stem
    grid = tension_grid(aspect, MeshSettings(**mesh))
    with log_cpu("solve"):
        fields = [solve(grid, loaded.law, strain) for strain in strains]
    write_tension(fields, loaded, name, output["fields"])
    write_tension_rows([tension_row(field, loaded, name) for field in fields], output["table"])
