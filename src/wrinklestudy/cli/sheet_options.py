"""Options of the commands that are about one sheet: its material, its size, its mesh."""

import argparse
from typing import TYPE_CHECKING

from wrinklestudy.cli.numbers import number, whole_number
from wrinklestudy.vocabulary import CELLS, PARITIES

if TYPE_CHECKING:
    from wrinklestudy.mechanics.laws import Material
    from wrinklestudy.sheet import Sheet

DEFAULT_LAW = "mooney-rivlin"


def add_sheet(parser: argparse.ArgumentParser) -> None:
    """Add the options of a sheet."""
    from wrinklestudy.mechanics.bending import BENDING_LAWS

    add = parser.add_argument
    add("--aspect", type=number, required=True, help="L/W")
    add("--thickness", type=number, required=True, help="t/W")
    add_law(parser)
    _add_constants(parser)
    meanings = "; ".join(f"{name}: {law.meaning}" for name, law in BENDING_LAWS.items())
    add("--bending", choices=tuple(BENDING_LAWS), default=next(iter(BENDING_LAWS)), help=meanings)
    add("--parity", choices=PARITIES, default=PARITIES[0], help="of the wrinkles across the sheet")
    add(
        "--cells-along",
        type=whole_number,
        help="cells on half the length of the reference sheet L/W = 2",
    )
    add("--cells-across", type=whole_number, help="cells on half the width at t/W = 1e-3")


def add_law(parser: argparse.ArgumentParser) -> None:
    """Add the option that names a law."""
    from wrinklestudy.mechanics.laws import LAWS

    parser.add_argument(
        "--law",
        choices=tuple(LAWS),
        default=DEFAULT_LAW,
        help=f"strain energy, {DEFAULT_LAW} by default",
    )


def _add_constants(parser: argparse.ArgumentParser) -> None:
    """Add an option for each constant of any law."""
    from wrinklestudy.mechanics.laws import LAWS

    texts: dict[str, dict[str, list[str]]] = {}
    for law in LAWS.values():
        for constant in law.constants:
            default = "" if constant.default is None else f", default {constant.default:g}"
            unit = f" ({constant.unit})" if constant.unit else ""
            meaning = f"{constant.meaning}{unit}, {constant.allowed}{default}"
            texts.setdefault(constant.name, {}).setdefault(meaning, []).append(law.name)
    for name, meanings in texts.items():
        lines = [f"{', '.join(names)}: {meaning}" for meaning, names in meanings.items()]
        parser.add_argument(f"--{name}", type=number, help="; ".join(lines))


def material(arguments: argparse.Namespace) -> "Material":
    """Return the material that the options describe."""
    from wrinklestudy.mechanics.laws import LAWS, law_of

    law = law_of(arguments.law)
    allowed = {constant.name: constant for constant in law.constants}
    names = dict.fromkeys(c.name for other in LAWS.values() for c in other.constants)
    given = {name: getattr(arguments, name) for name in names}
    given = {name: value for name, value in given.items() if value is not None}
    for name in given:
        if name not in allowed:
            options = ", ".join(f"--{known}" for known in allowed)
            raise ValueError(f"--{name}: not a constant of {law.name}, which takes {options}")
    for name, constant in allowed.items():
        if name not in given and constant.default is None:
            raise ValueError(f"--{name}: {law.name} needs it ({constant.unit or 'a number'})")
    return law.material(**given)


def sheet(arguments: argparse.Namespace) -> "Sheet":
    """Return the sheet that the options describe."""
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
        material(arguments),
        arguments.bending,
        arguments.parity,
        MeshSettings(**cells),
    )
