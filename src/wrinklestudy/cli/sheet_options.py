"""Options of the commands that are about one sheet: its size, its material, its mesh."""

import argparse
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

from wrinklestudy.cli.imperfection_options import imperfections
from wrinklestudy.cli.material_options import add_law, add_material, model
from wrinklestudy.cli.numbers import number, whole_number
from wrinklestudy.vocabulary import ASPECT, CELLS, PARITIES, THICKNESS

if TYPE_CHECKING:
    from wrinklestudy.fem.grid import MeshSettings
    from wrinklestudy.results.vtu import LengthUnit
    from wrinklestudy.sheet import Sheet

__all__ = ["GivenSize", "add_law", "add_sheet", "given_size", "sheet"]

_RATIOS = ("aspect", "thickness")
_LENGTHS = ("length_mm", "width_mm", "thickness_mm")
# Sheets with more unknowns than this say so before they start.
_MANY_UNKNOWNS = 50_000


@dataclass(frozen=True)
class GivenSize:
    """The size of the sheet as it was given.

    Parameters
    ----------
    aspect, thickness : float
        L/W and t/W.
    width_mm : float or None
        W if lengths were given, None if ratios were.
    """

    aspect: float
    thickness: float
    width_mm: float | None = None

    @property
    def length_mm(self) -> float | None:
        """L if lengths were given."""
        return None if self.width_mm is None else self.aspect * self.width_mm

    @property
    def unit(self) -> "LengthUnit":
        """The unit in which files and pictures show lengths."""
        from wrinklestudy.results.vtu import IN_WIDTHS, LengthUnit

        return IN_WIDTHS if self.width_mm is None else LengthUnit("mm", self.width_mm)

    def clamps_mm(self, strain: float | None) -> float | None:
        """Return the distance of the clamps at a strain, None where there is none."""
        if strain is None or self.length_mm is None:
            return None
        return self.length_mm * (1.0 + strain)


def add_sheet(parser: argparse.ArgumentParser) -> None:
    """Add the options of a sheet."""
    group = parser.add_argument_group("size", "ratios, or all three lengths")
    group.add_argument("--aspect", type=number, help="L/W")
    group.add_argument("--thickness", type=number, help="t/W")
    group.add_argument("--length-mm", type=number, help="L between the clamps at rest")
    group.add_argument("--width-mm", type=number, help="W along a clamp")
    group.add_argument("--thickness-mm", type=number, help="t at rest")
    add_material(parser)
    add_bending(parser)
    parser.add_argument(
        "--parity", choices=PARITIES, default=PARITIES[0], help="of the wrinkles across the sheet"
    )
    add_cells(parser)


def add_bending(parser: argparse.ArgumentParser) -> None:
    """Add the option that names a bending law."""
    from wrinklestudy.mechanics.bending import BENDING_LAWS

    meanings = "; ".join(f"{name}: {law.meaning}" for name, law in BENDING_LAWS.items())
    names = tuple(BENDING_LAWS)
    parser.add_argument("--bending", choices=names, default=names[0], help=meanings)


def add_cells(parser: argparse.ArgumentParser) -> None:
    """Add the options of the mesh."""
    add = parser.add_argument
    add(
        "--cells-along",
        type=whole_number,
        help="cells on half the length of the reference sheet L/W = 2",
    )
    add("--cells-across", type=whole_number, help="cells on half the width at t/W = 1e-3")


def mesh_settings(arguments: argparse.Namespace) -> "MeshSettings":
    """Return the mesh that the options describe."""
    from wrinklestudy.fem.grid import MeshSettings

    cells = {
        key: getattr(arguments, key)
        for key in ("cells_along", "cells_across")
        if getattr(arguments, key) is not None
    }
    for key, value in cells.items():
        if value not in CELLS:
            raise ValueError(f"{_option(key)} = {value}: must be {CELLS}")
    return MeshSettings(**cells)


def given_size(arguments: argparse.Namespace) -> GivenSize:
    """Return the size that the options give, from ratios or from lengths but not from both.

    Ratios of lengths are rounded to 12 digits, so that they are those that one would write.
    """
    from wrinklestudy.results.cases import canonical

    lengths = [getattr(arguments, name) for name in _LENGTHS]
    ratios = [getattr(arguments, name) for name in _RATIOS]
    if all(value is None for value in lengths):
        _refuse_missing(_RATIOS, arguments)
        size = GivenSize(*ratios)
    elif any(value is not None for value in ratios):
        mixed = ", ".join(
            _option(name) for name in (*_RATIOS, *_LENGTHS) if name in arguments.given
        )
        raise ValueError(f"{mixed}: give ratios or lengths, not both")
    else:
        _refuse_missing(_LENGTHS, arguments)
        for name, value in zip(_LENGTHS, lengths, strict=True):
            if not value > 0.0:
                raise ValueError(f"{_option(name)} = {value:g}: must be > 0 mm")
        length, width, thickness = lengths
        size = GivenSize(canonical(length / width), canonical(thickness / width), width)
        for name, ratio, limits in (
            ("length_mm", size.aspect, ASPECT),
            ("thickness_mm", size.thickness, THICKNESS),
        ):
            if ratio not in limits:
                given = f"{_option(name)} over --width-mm"
                raise ValueError(f"{given} = {ratio:g}: must be {limits}")
    return size


def _refuse_missing(names: tuple[str, ...], arguments: argparse.Namespace) -> None:
    missing = [_option(name) for name in names if name not in arguments.given]
    if missing:
        other = "" if names == _LENGTHS else ", or --length-mm, --width-mm and --thickness-mm"
        raise ValueError(f"{' and '.join(missing)}: missing; give {_options(names)}{other}")


def _options(names: tuple[str, ...]) -> str:
    *first, last = map(_option, names)
    return f"{', '.join(first)} and {last}"


def _option(name: str) -> str:
    return f"--{name.replace('_', '-')}"


def sheet(arguments: argparse.Namespace, size: GivenSize) -> "Sheet":
    """Return the sheet that the options describe; say so where it is a large problem."""
    from wrinklestudy.sheet import Sheet

    chosen = model(arguments)
    imperfect = {}
    if hasattr(arguments, "symmetry"):
        imperfect = imperfections(arguments, size.aspect, size.width_mm, chosen.material)
    return Sheet(
        size.aspect,
        size.thickness,
        chosen.material,
        chosen.bending or arguments.bending,
        chosen.parity or arguments.parity,
        mesh_settings(arguments),
        **imperfect,
    )


def announce(chosen: "Sheet", wrinkled: bool = True, jobs: int = 1) -> None:
    """Refuse what the memory would not hold; say what a large problem needs before it starts."""
    chosen.check_memory(wrinkled, jobs)
    if chosen.size.unknowns > _MANY_UNKNOWNS:
        print(f"t/W = {chosen.thickness:g}: {chosen.size.text(wrinkled)}", file=sys.stderr)
