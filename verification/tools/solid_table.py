"""The cases of the solid, and the tables in which the results of `make verify-solid` are kept."""

from dataclasses import asdict, dataclass, fields
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from scipy.optimize import brentq

from verification.tools.sheets import LATEX, NEO_HOOKEAN, TEN_TO_ONE
from verification.tools.solid_space import Clamp
from verification.tools.solid_states import SolidMode, SolidSheet
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.results.solved import State
from wrinklestudy.sheet import Sheet
from wrinklestudy.typing import AnyPath

ENDS = Path("verification/solid_ends.csv")  # from the folder of the project
STATES = Path("verification/solid_states.csv")
MATERIALS = {"paper": LATEX, "neo-Hookean": NEO_HOOKEAN, "10:1": TEN_TO_ONE}
STRAINS = (0.04, 0.12, 0.18, 0.26, 0.36)
PLATE_MESH = MeshSettings(36, 54)  # decay to 3e-5, A/t to 0.05%
COARSE, MIDDLE, FINE, FINEST = (8, 16), (12, 24), (16, 32), (24, 48)
STIFF = 1.0e4
_BRACKETS = (2.0e-4, 1.0e-3)  # beside birth and decay of the plate, widened until they cross
_WIDENINGS = 3
_ROOT_DIGITS = 1.0e-6


@dataclass(frozen=True)
class SolidCase:
    """One solid sheet: what it is made of, and how it is solved."""

    material: str
    thickness: float
    cells_along: int
    cells_across: int
    bulk: float  # K/mu
    layers: int = 1
    clamp: Clamp = "line"

    def sheet(self) -> SolidSheet:
        """Return the sheet."""
        cells = (self.cells_along, self.cells_across)
        material = MATERIALS[self.material]
        return SolidSheet(material, self.thickness, cells, self.bulk, self.layers, self.clamp)

    def plate(self) -> Sheet:
        """Return the same sheet as a plate, under the bending law `thinning`."""
        return Sheet(2.0, self.thickness, MATERIALS[self.material], mesh=PLATE_MESH)


@dataclass(frozen=True)
class End:
    """Birth or decay: where a flat solid loses stability or has it again."""

    strain: float
    before: int  # unstable modes on both sides
    after: int
    corner: float  # part of the mode in the corner of clamp and free edge


def case(
    material: str, thickness: float, cells: tuple[int, int], bulk: float = STIFF, **options: Any
) -> SolidCase:
    """Return a case from its numbers of cells along and across."""
    return SolidCase(material, thickness, *cells, bulk, **options)


def end_cases() -> list[SolidCase]:
    """Return the cases of which birth and decay are kept."""
    sheets = [("paper", 1.0e-3), ("paper", 1.2e-3), ("neo-Hookean", 1.0e-3), ("10:1", 1.0e-3)]
    meshes = [case(*sheet, cells) for cells in (COARSE, MIDDLE, FINE) for sheet in sheets]
    return [
        *meshes,
        case("paper", 1.0e-3, FINEST),
        *(case("paper", 1.0e-3, FINE, bulk) for bulk in (200.0, 1000.0)),
        case("paper", 1.0e-3, FINE, layers=2),
        *(case("paper", 1.0e-3, cells, clamp="face") for cells in (FINE, FINEST)),
    ]


def state_cases() -> list[SolidCase]:
    """Return the cases of which wrinkled states are kept."""
    meshes = [case("paper", 1.0e-3, cells) for cells in (COARSE, MIDDLE, FINE)]
    return [*meshes, case("paper", 1.0e-3, FINE, 1000.0)]


@cache
def plate_ends(material: str, thickness: float, bending: str = "thinning") -> tuple[float, float]:
    """Return birth and decay of the plate.

    Raises
    ------
    ArithmeticError
        If it has not got both.
    """
    mesh = PLATE_MESH if bending == "thinning" else MeshSettings()
    ends = Sheet(2.0, thickness, MATERIALS[material], bending, mesh=mesh).stability()
    if ends.birth_strain is None or ends.decay_strain is None:
        raise ArithmeticError(f"{material}, t/W {thickness:g}: no birth or no decay")
    return ends.birth_strain, ends.decay_strain


def solve_ends(case: SolidCase) -> tuple[End, End]:
    """Return birth and decay of a solid, roots of its lowest eigenvalue near those of the plate.

    Raises
    ------
    ArithmeticError
        If no mode crosses zero there.
    """
    sheet = case.sheet()
    near = plate_ends(case.material, case.thickness)
    first, second = (_end(sheet, *pair) for pair in zip(near, _BRACKETS, strict=True))
    return first, second


def _end(sheet: SolidSheet, near: float, reach: float) -> End:
    modes: dict[float, SolidMode] = {}

    def eigenvalue(strain: float) -> float:
        modes[strain] = modes.get(strain) or sheet.mode(strain)
        return modes[strain].eigenvalue

    for widening in range(_WIDENINGS):
        low, high = near - reach * 3**widening, near + reach * 3**widening
        if eigenvalue(low) * eigenvalue(high) < 0.0:
            break
    else:
        raise ArithmeticError(f"no mode of the solid crosses zero from strain {low:g} to {high:g}")
    root = float(brentq(eigenvalue, low, high, xtol=_ROOT_DIGITS))
    closest = modes[min(modes, key=lambda strain: abs(strain - root))]
    return End(root, modes[low].unstable, modes[high].unstable, closest.corner)


def solve_state(sheet: SolidSheet, plate: State) -> dict[str, float]:
    """Return A/t of a wrinkled solid and what its middle line differs by from that of the plate."""
    state = sheet.wrinkled(plate)
    y = np.linspace(0.0, 0.5, 8001)
    line = sheet.deflection(state, y)
    other = plate.shape.evaluate(np.zeros(1), y)[2, 0]
    return {
        "amplitude_over_thickness": float(np.abs(line).max()) / sheet.thickness,
        "profile_difference": float(np.abs(line - other).max() / np.abs(other).max()),
        "unstable": state.unstable,
    }


def rows_of(table: pd.DataFrame, case: SolidCase) -> pd.DataFrame:
    """Return the rows of a kept table that belong to a case.

    Raises
    ------
    ValueError
        If there is none.
    """
    kept = np.ones(len(table), dtype=bool)
    for name in (field.name for field in fields(case)):
        kept &= (table[name] == getattr(case, name)).to_numpy()
    if not kept.any():
        raise ValueError(f"the kept table of the solid lacks {case}: run make verify-solid")
    return table[kept]


def append(path: AnyPath, case: SolidCase, values: dict[str, Any], stamp: dict[str, str]) -> None:
    """Add a row to a table, or begin one."""
    row = pd.DataFrame([asdict(case) | values | stamp])
    path = Path(path)
    table = pd.concat([pd.read_csv(path), row]) if path.exists() else row
    with atomic_path(path) as target:
        table.to_csv(target, index=False, float_format="%.9g", lineterminator="\n")
