"""Golden numbers: what the default mesh gives, with the error of that mesh as tolerance.

    python -m verification.golden verification/golden.csv

computes them on the default mesh and on one that is half as fine again, and writes a new file. The
tolerance of a number is its difference between the two meshes: a change of the code that moves a
number by more changes the physics, one that moves it by less is a matter of discretisation.
"""

import csv
import sys
from dataclasses import dataclass
from pathlib import Path

from verification.tools.sheets import LATEX, NEO_HOOKEAN, SVK, TEN_TO_ONE
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.material.fit import fit
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.results.solved import State
from wrinklestudy.sheet import Sheet
from wrinklestudy.vocabulary import Parity

DEFAULT = (MeshSettings().cells_along, MeshSettings().cells_across)
FINER = (36, 54)
COLUMNS = ("name", "value", "tolerance", "basis")
DISCRETISATION, ROUNDING = "difference to the finer mesh", "rounding"
SEARCH = "accuracy of the search"
TRELOAR = Path("data/treloar1944.csv")

# Smallest relative tolerances: of numbers from a mesh, of numbers without one
_LEAST = {DISCRETISATION: 1e-7, ROUNDING: 1e-9}
_STRAIN, _ENDS = 1e-5, ("birth", "decay")  # accuracy of these strains


@dataclass(frozen=True)
class Golden:
    """A number that must stay as it is.

    Parameters
    ----------
    value, tolerance : float
        Tolerance is absolute.
    basis : str
        Origin of the tolerance.
    """

    value: float
    tolerance: float
    basis: str


@dataclass(frozen=True)
class KeptCase:
    """States of one sheet whose numbers are kept."""

    label: str
    material: Material
    strains: tuple[float, ...]
    measures: tuple[str, ...] = ("A/t",)
    ends: tuple[str, ...] = ()
    bending: str = "thinning"
    parity: Parity = "antisymmetric"
    aspect: float = 2.0
    thickness: float = 1.0e-3


CASES = (
    KeptCase("latex", LATEX, (0.06, 0.12, 0.2, 0.3, 0.37), ("A/t", "Phi^2"), ("birth", "decay")),
    KeptCase(
        "latex",
        LATEX,
        (0.12,),
        ("lambda/W", "W_act/W", "W_proj/W", "stress/mu", "energy", "saved", "tau_1"),
    ),
    KeptCase("latex symmetric", LATEX, (0.12,), parity="symmetric"),
    KeptCase("latex fixed", LATEX, (0.12,), ends=("decay",), bending="fixed-thickness"),
    KeptCase("latex fvk", LATEX, (0.12,), ends=("decay",), bending="fvk"),
    KeptCase("10:1 fvk", TEN_TO_ONE, (), ends=("decay",), bending="fvk"),
    KeptCase("neo-Hookean", NEO_HOOKEAN, (0.1,), ends=("decay",)),
    KeptCase("SVK fixed", SVK, (0.06,), ends=("decay",), bending="fixed-thickness"),
    KeptCase("latex L/W 2.5", LATEX, (0.1,), aspect=2.5),
    KeptCase("latex t/W 5e-4", LATEX, (0.1,), thickness=5.0e-4),
)


def _measured(state: State) -> dict[str, float]:
    equilibrium, m = state.equilibrium, state.measures
    modes = equilibrium.planar.modes
    if m is None or modes is None:
        raise ArithmeticError(f"strain {state.strain:g}: {state.status} {equilibrium.reason}")
    return {
        "A/t": m.amplitude / equilibrium.thickness,
        "Phi^2": m.phi_squared,
        "lambda/W": m.wavelength,
        "W_act/W": m.arc_width,
        "W_proj/W": m.projected_width,
        "stress/mu": equilibrium.nominal_stress,
        "energy": equilibrium.energy,
        "saved": equilibrium.flat_energy - equilibrium.energy,
        "tau_1": modes.critical_thickness,
    }


def numbers(cells: tuple[int, int]) -> dict[str, float]:
    """Return all numbers that come from a mesh, by name."""
    result: dict[str, float] = {}
    for case in CASES:
        sheet = Sheet(
            case.aspect,
            case.thickness,
            case.material,
            case.bending,
            case.parity,
            MeshSettings(*cells),
        )
        for strain in case.strains:
            values = _measured(sheet.solve(strain))
            for measure in case.measures:
                result[f"{case.label}: {measure} at {strain:g}"] = values[measure]
        if case.ends:
            ends = sheet.stability()
            by_name = {"birth": ends.birth_strain, "decay": ends.decay_strain}
            for end in case.ends:
                value = by_name[end]
                result[f"{case.label}: {end}"] = float("nan") if value is None else value
    return result


def constants() -> dict[str, float]:
    """Return numbers without a mesh: constants fitted to Treloar's rubber, in Pa."""
    uniaxial = fit(TRELOAR, "mooney-rivlin", stretch=(1.0, 1.65), modes=["uniaxial"])
    every = fit(TRELOAR, "mooney-rivlin", stretch=(1.0, 1.65))
    return {
        f"Treloar, {label}: {name}": value
        for label, result in (("uniaxial", uniaxial), ("all modes", every))
        for name, value in result.constants.items()
    }


def golden() -> dict[str, Golden]:
    """Return the numbers of the default mesh with their tolerances."""
    default, finer = numbers(DEFAULT), numbers(FINER)
    result = {}
    for name, value in default.items():
        least = max(_LEAST[DISCRETISATION] * abs(value), _STRAIN * name.endswith(_ENDS))
        change = abs(finer[name] - value)
        basis = DISCRETISATION if change > least else SEARCH
        result[name] = Golden(value, max(change, least), basis)
    for name, value in constants().items():
        result[name] = Golden(value, _LEAST[ROUNDING] * abs(value), ROUNDING)
    return result


def write(kept: dict[str, Golden], output: Path) -> None:
    """Write golden numbers as a new CSV file.

    Raises
    ------
    FileExistsError
        If the file exists, so that old numbers are not replaced by accident.
    """
    if output.exists():
        raise FileExistsError(f"{output}: exists; remove it first to replace the golden numbers")
    with atomic_path(output) as path, path.open("w", encoding="utf-8", newline="") as file:
        file.write(
            f"# Numbers of the {DEFAULT[0]} x {DEFAULT[1]} mesh; tolerance: difference to "
            f"{FINER[0]} x {FINER[1]} cells.\n# Lengths in W, energies of the quarter in mu W^3, "
            "fitted constants in Pa.\n"
            f"# Made by: python -m verification.golden {output.as_posix()}\n"
        )
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(COLUMNS)
        for name, number in kept.items():
            cells = (f"{number.value:.12g}", f"{number.tolerance:.3g}", number.basis)
            rows.writerow([name, *cells])


def read(path: Path) -> dict[str, Golden]:
    """Return the golden numbers of a file.

    Raises
    ------
    ValueError
        If a line is not name, value, tolerance and basis.
    """
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    if not rows or tuple(rows[0]) != COLUMNS:
        raise ValueError(f"{path}: the first line must be {','.join(COLUMNS)}")
    kept = {}
    for row in rows[1:]:
        try:
            name, value, tolerance, basis = row
            kept[name] = Golden(float(value), float(tolerance), basis)
        except ValueError:
            raise ValueError(f"{path}: {','.join(row)!r} is not {','.join(COLUMNS)}") from None
    return kept


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python -m verification.golden FILE")
    target = Path(sys.argv[1])
    try:
        write(golden(), target)
    except FileExistsError as error:
        sys.exit(str(error))
