"""The stability stage: the strains at which the wrinkles of a sheet are born and decay."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from wrinklestudy.equilibrium.critical_curve import critical_curve
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.stability import find
from wrinklestudy.mechanics import laws
from wrinklestudy.results.grids import read_grid
from wrinklestudy.stages.log import log_cpu


def run(
    planar: Sequence[Path | str],
    mesh: Path | str,
    material: Path | str,
    thickness: float,
    settings: Mapping[str, Any],
    output: Path | str,
    name: str | None = None,
) -> None:
    """Find birth and decay strain of one sheet, starting from the planar states of a study.

    Parameters
    ----------
    planar : sequence of paths
        HDF5 files of the planar stage of this material and L/W.
    mesh, material : path
        The files that the planar states were made from.
    thickness : float
        t/W.
    settings : mapping
        Keys of `PlanarSettings`.
    output : path
        JSON file to write.
    name : str, optional
        Name of the model in the study; that of the material file by default.
    """
    from wrinklestudy.files.storage import read_h5, write_json
    from wrinklestudy.results.materials import load_material

    attributes = [read_h5(path, ())[1] for path in planar]
    known = [(a["strain"], a["critical_thickness"]) for a in attributes if not a["reason"]]
    grid, loaded, options = read_grid(mesh), load_material(material), PlanarSettings(**settings)
    with log_cpu("solve"):
        limits = find(critical_curve(grid, loaded, options), thickness, known)
    description = {
        "material": name or Path(material).stem,
        **laws.describe(loaded),
        "bending": options.bending,
        "parity": options.parity,
        "aspect": grid.aspect,
    }
    write_json(output, description | vars(limits))
