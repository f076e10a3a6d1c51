"""Options of sheets that are not perfect: clamps, thickness, weight, the part that is solved."""

import argparse
from dataclasses import fields
from typing import TYPE_CHECKING, Any

from wrinklestudy.cli.numbers import number
from wrinklestudy.vocabulary import DENSITY, GRAVITY, PARTS, SIZED_IMPERFECTIONS, STANDARD_GRAVITY

if TYPE_CHECKING:
    from wrinklestudy.fem.thickness import Ripple, ThicknessTable
    from wrinklestudy.mechanics.laws import Material


def add_imperfections(parser: argparse.ArgumentParser) -> None:
    """Add the options of clamps, thickness and weight."""
    group = parser.add_argument_group(
        "imperfections", "of a sheet that is solved without mirrors: --symmetry whole"
    )
    add = group.add_argument
    add(
        "--symmetry",
        choices=PARTS,
        default=PARTS[0],
        help="part that is solved: with mirrors at x = 0 and y = 0, at x = 0, at y = 0, with none",
    )
    for name, meaning in SIZED_IMPERFECTIONS.items():
        add(f"--{name.replace('_', '-')}", type=number, default=0.0, help=meaning)
    add(
        "--thickness-ripple",
        type=_ripple,
        action="append",
        metavar="AMPLITUDE:WAVELENGTH[:ANGLE[:PHASE]]",
        help="wave of the thickness, over its mean and over W; angles in rad, by default across "
        "the sheet with a crest on the mid-line; repeatable",
    )
    add(
        "--thickness-table",
        metavar="FILE.csv",
        help="measured thickness: columns x, y (from the centre, over W) and thickness",
    )
    add("--density", type=number, help="kg/m^3: the sheet is level and bears its own weight")
    add("--gravity", type=number, default=STANDARD_GRAVITY, help="m/s^2")


def _ripple(text: str) -> "Ripple":
    """Return a wave of the thickness."""
    from wrinklestudy.fem.thickness import Ripple

    numbers = [number(part) for part in text.split(":")]
    if not 2 <= len(numbers) <= 4:
        raise argparse.ArgumentTypeError(f"{text!r} is not AMPLITUDE:WAVELENGTH[:ANGLE[:PHASE]]")
    try:
        return Ripple(*numbers)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def imperfections(
    arguments: argparse.Namespace, aspect: float, width_mm: float | None, material: "Material"
) -> dict[str, Any]:
    """Return what the options say of clamps, thickness and weight, by the names of `Sheet`."""
    from wrinklestudy.fem.clamps import CLAMP_LIMITS, Clamps
    from wrinklestudy.fem.thickness import ThicknessField

    for name, limits in CLAMP_LIMITS.items():
        if (value := getattr(arguments, name)) not in limits:
            raise ValueError(f"--{name} = {value:g}: must be {limits}")
    clamps = Clamps(**{item.name: getattr(arguments, item.name) for item in fields(Clamps)})
    table = _table(arguments.thickness_table, aspect) if arguments.thickness_table else None
    thickness = ThicknessField(
        arguments.thickness_along,
        arguments.thickness_across,
        tuple(arguments.thickness_ripple or ()),
        table,
    )
    return {
        "symmetry": arguments.symmetry,
        "clamps": clamps,
        "thickness_field": thickness,
        "weight": _weight(arguments, width_mm, material),
    }


def _table(path: str, aspect: float) -> "ThicknessTable":
    from wrinklestudy.results.thickness_table import read_thickness_table

    table = read_thickness_table(path)
    try:
        table.check_reach(aspect)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
    return table


def _weight(arguments: argparse.Namespace, width_mm: float | None, material: "Material") -> float:
    """Return rho g W/mu, zero without a density."""
    from wrinklestudy.equilibrium.imperfections import self_weight

    if arguments.density is None:
        if "gravity" in arguments.given:
            raise ValueError("--gravity: needs --density")
        return 0.0
    for name, limits in (("density", DENSITY), ("gravity", GRAVITY)):
        if (value := getattr(arguments, name)) not in limits:
            raise ValueError(f"--{name} = {value:g}: must be {limits}")
    if width_mm is None:
        raise ValueError("--density: needs --length-mm, --width-mm and --thickness-mm")
    width = 1e-3 * width_mm
    return self_weight(arguments.density, width, material.shear_modulus, arguments.gravity)
