"""Command line: one sheet, its stability, or one fit. Results go to stdout, progress to stderr."""

import argparse
import math
import os
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

from wrinklestudy.vocabulary import BENDING_LAWS, CELLS, PARITIES, STRAIN

if TYPE_CHECKING:
    from wrinklestudy.mechanics.laws import Material
    from wrinklestudy.sheet import Sheet


# Laws and the options that give their constants
_CONSTANTS = {
    "mooney-rivlin": ("c10", "c01"),
    "neo-hookean": ("c10",),
    "svk": ("young", "poisson"),
}


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text!r} is not a finite number")
    return value


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="wrinklestudy", description="Wrinkles in stretched hyperelastic sheets."
    )
    commands = parser.add_subparsers(dest="command", required=True)
    solve = commands.add_parser("solve", help="state of one sheet at one or more strains")
    _add_sheet(solve)
    solve.add_argument(
        "--strain", type=_number, action="append", required=True, help="0 < eps <= 1; repeatable"
    )
    _add_sheet(commands.add_parser("stability", help="birth and decay strain of one sheet"))
    fit = commands.add_parser("fit", help="constants of a law from measured stress and strain")
    fit.add_argument("data", help="CSV with stretch or strain, stress_pa or stress_mpa, mode")
    fit.add_argument("--law", choices=tuple(_CONSTANTS), default="mooney-rivlin")
    fit.add_argument(
        "--stretch", type=_number, nargs=2, metavar=("LOW", "HIGH"), help="stretches to fit"
    )
    fit.add_argument(
        "--mode",
        action="append",
        choices=("uniaxial", "biaxial", "shear"),
        help="modes of deformation to fit; repeatable, default all",
    )
    fit.add_argument("--json", action="store_true", help="print JSON")
    return parser


def _add_sheet(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--aspect", type=_number, required=True, help="L/W")
    add("--thickness", type=_number, required=True, help="t/W")
    add("--law", choices=tuple(_CONSTANTS), default="mooney-rivlin")
    add("--c10", type=_number, help="C10 in Pa")
    add("--c01", type=_number, help="C01 in Pa (mooney-rivlin)")
    add("--young", type=_number, help="Young's modulus in Pa (svk, default 1e6)")
    add("--poisson", type=_number, help="Poisson's ratio (svk, default 0.5)")
    add("--bending", choices=BENDING_LAWS, default="thinning")
    add("--parity", choices=PARITIES, default="antisymmetric")
    add("--cells-along", type=int, help="cells on half the length of the reference sheet L/W = 2")
    add("--cells-across", type=int, help="cells on half the width at t/W = 1e-3")
    add("--json", action="store_true", help="print JSON")


def _material(arguments: argparse.Namespace) -> "Material":
    from wrinklestudy.mechanics import laws

    allowed = _CONSTANTS[arguments.law]
    given = {k: getattr(arguments, k) for k in ("c10", "c01", "young", "poisson")}
    for key, value in given.items():
        if value is not None and key not in allowed:
            names = ", ".join(f"--{name}" for name in allowed)
            raise ValueError(f"--{key}: not a constant of {arguments.law}, which takes {names}")
    constants = {key: given[key] for key in allowed if given[key] is not None}
    if arguments.law == "svk":
        return laws.saint_venant_kirchhoff(**constants)
    for key in allowed:
        if key not in constants:
            raise ValueError(f"--{key}: {arguments.law} needs it (Pa)")
    return laws.mooney_rivlin(constants["c10"], constants.get("c01", 0.0))


def _sheet(arguments: argparse.Namespace) -> "Sheet":
    from wrinklestudy.fem.grid import MeshSettings
    from wrinklestudy.sheet import Sheet

    cells = {
        key: getattr(arguments, key)
        for key in ("cells_along", "cells_across")
        if getattr(arguments, key) is not None
    }
    for key, value in cells.items():
        if value not in CELLS:
            raise ValueError(f"--{key.replace('_', '-')} = {value}: must be {CELLS}")
    return Sheet(
        arguments.aspect,
        arguments.thickness,
        _material(arguments),
        arguments.bending,
        arguments.parity,
        MeshSettings(**cells),
    )


def _solve(arguments: argparse.Namespace) -> list[dict[str, Any]]:
    sheet = _sheet(arguments)
    for strain in arguments.strain:
        if strain not in STRAIN:
            raise ValueError(f"--strain = {strain:g}: must be {STRAIN}")
    return [sheet.solve(strain).as_dict() for strain in _progress(arguments.strain)]


def _progress(strains: Sequence[float]) -> Iterable[float]:
    """Show a bar on a terminal, a line for each strain elsewhere; both on stderr."""
    if sys.stderr.isatty():
        from tqdm import tqdm

        yield from tqdm(strains, unit="strain", file=sys.stderr)
        return
    for number, strain in enumerate(strains, 1):
        print(f"strain {strain:g} ({number} of {len(strains)})", file=sys.stderr)
        yield strain


def _stability(arguments: argparse.Namespace) -> dict[str, Any]:
    from wrinklestudy.equilibrium import stability

    sheet = _sheet(arguments)
    curve = stability.critical_curve(sheet.space, sheet.material, sheet.settings)

    def reported(strain: float) -> float:
        value = curve(strain)
        print(f"strain {strain:.5f}: critical thickness {value:.6g} W", file=sys.stderr)
        return value

    return vars(stability.find(reported, sheet.thickness))


def _fit(arguments: argparse.Namespace) -> dict[str, Any]:
    from wrinklestudy.material.fit import fit

    window = None if arguments.stretch is None else tuple(arguments.stretch)
    return fit(arguments.data, arguments.law, stretch=window, modes=arguments.mode).as_dict()


def _print_text(result: Any) -> None:
    if isinstance(result, list):
        columns = ["strain", "status", "amplitude_over_thickness", "wavelength_over_width"]
        columns += ["phi_squared", "nominal_stress_pa", "newton_iterations"]
        print("  ".join(f"{name:>24}" for name in columns))
        for row in result:
            print("  ".join(f"{_text(row[name]):>24}" for name in columns))
        return
    for key, value in result.items():
        if key == "critical_thickness":
            for strain, tau in value:
                print(f"critical_thickness at strain {strain:.5f}: {tau:.6g}")
        else:
            print(f"{key}: {_text(value)}")


def _text(value: Any) -> str:
    if value is None or value != value:
        return "-"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


_COMMANDS: dict[str, Callable[[argparse.Namespace], Any]] = {
    "solve": _solve,
    "stability": _stability,
    "fit": _fit,
}


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status: 0, or 2 for input that is not allowed."""
    # The factorisations are small: more threads than one only get in each other's way.
    for name in ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    arguments = _parser().parse_args(argv)
    try:
        result = _COMMANDS[arguments.command](arguments)
    except (ValueError, ArithmeticError, OSError) as error:
        print(f"wrinklestudy {arguments.command}: {error}", file=sys.stderr)
        return 2
    if arguments.json:
        from wrinklestudy.results.files import format_json

        print(format_json(result), end="")
    else:
        _print_text(result)
    return 0


if __name__ == "__main__":
    sys.exit(main())
