"""The imperfection stage: an imperfect sheet at its strains, and where it wrinkles."""

from collections.abc import Mapping, Sequence
from os import fspath
from typing import Any

from wrinklestudy.equilibrium import stability
from wrinklestudy.equilibrium.whole import WholeSettings
from wrinklestudy.equilibrium.wrinkled import WrinkleSettings
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.results.cases import StudySheet, resolved_thickness
from wrinklestudy.results.imperfect_sheets import ImperfectSheet, imperfections_of
from wrinklestudy.results.imperfections import imperfection_row
from wrinklestudy.results.whole import solve_whole
from wrinklestudy.stages.log import log_cpu
from wrinklestudy.typing import AnyPath
from wrinklestudy.vocabulary import Part


def run(
    material: AnyPath,
    name: str,
    aspect: float,
    thickness: float,
    strains: Sequence[float],
    symmetry: Part,
    given: Sequence[Sequence[Any]],
    mesh: Mapping[str, Any],
    settings: Mapping[str, Any],
    output: AnyPath,
    thickness_table: AnyPath | None = None,
) -> None:
    """Solve an imperfect sheet at each strain, each from a seed of its own, and write a table.

    A state that does not converge is written with the reason and its Newton decrements.

    Parameters
    ----------
    material : path-like
        Material JSON with the constants.
    name : str
        Name of the model in the study.
    aspect, thickness : float
        L/W and t/W.
    strains : sequence of float
    symmetry : {'quarter', 'half', 'half-width', 'whole'}
        The part that is solved.
    given : sequence of (key, value)
        What is imperfect, see `ImperfectSheet`.
    mesh : mapping
        Keys of `MeshSettings`.
    settings : mapping
        ``bending``, ``parity``, ``modes``, ``tolerance``, ``max_iterations``, ``seeds``.
    output : path-like
        CSV file to write, with a row for each strain.
    thickness_table : path-like, optional
        The file that ``given`` names.
    """
    from pathlib import Path

    from wrinklestudy.results.materials import load_material
    from wrinklestudy.results.tables import write_imperfections

    loaded = load_material(Path(material))
    entries = tuple((key, tuple(v) if isinstance(v, list) else v) for key, v in given)
    if thickness_table is not None:  # as the rule has it
        table = ("thickness_table", fspath(thickness_table))
        entries = tuple(table if key == table[0] else (key, value) for key, value in entries)
    imperfect = ImperfectSheet(StudySheet(name, aspect, thickness), symmetry, entries)
    found = imperfections_of(dict(entries), loaded.shear_modulus)
    bending, parity = settings["bending"], settings["parity"]
    mirrors = Symmetry.of_part(symmetry, parity, found.clamps)
    quarter = make_grid(aspect, resolved_thickness(thickness), MeshSettings(**mesh))
    space = Space(mirrors.lines(quarter), unevenness=found.thickness)
    whole = WholeSettings(mirrors, bending, parity, found.weight, settings["modes"])
    options = WrinkleSettings(
        **{key: settings[key] for key in ("tolerance", "max_iterations", "seeds")}
    )
    limits, reason = None, ""
    with log_cpu("solve"):
        states = [
            solve_whole(space, loaded, strain, thickness, whole, symmetry, found, options)
            for strain in strains
        ]
        try:
            limits = stability.of_imperfect_sheet(space, loaded, whole, thickness)
            reason = limits.passed_over
        except ArithmeticError as error:
            reason = f"birth and decay: {error}"
    cells = space.grid.cells
    rows = [imperfection_row(one, imperfect, bending, cells, limits, reason) for one in states]
    write_imperfections(rows, output)
