"""The rows of the tables: what is kept of a state and of a sheet, each number with its unit.

Everything that lists columns follows from `StateRow` and `SheetRow`: the CSV tables, the attributes
of wrinkle files, ``solve --json``, the data dictionary, the arrays of figures and claims. None
means that a number does not exist, such as the wavelength of a flat sheet.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from functools import cache
from os import fspath
from typing import Any, TypeVar, get_args, get_type_hints

import numpy as np

from wrinklestudy.typing import AnyPath, Cell
from wrinklestudy.vocabulary import FEWEST_CELLS, FLAP, STATUSES, Status


@dataclass(frozen=True)
class Column:
    """What is known about one field of a row.

    Parameters
    ----------
    name : str
        Name of the field, of the column, of the attribute.
    kind : type
        str, int or float.
    optional : bool
        Whether there may be no such number.
    description : str
        What it is, with its symbol.
    unit : str
        Empty for texts, counts and ratios.
    identifies : bool
        Whether it identifies the case: no two rows agree in all such columns.
    measured : bool
        Whether it is measured on the shape. All other columns of a state are attributes of its
        wrinkle file.
    of_equilibrium : bool
        Whether it has no meaning for an iterate that is no equilibrium.
    shown : bool
        Whether ``solve --json`` shows it.
    allowed : tuple of str
        The texts that are allowed; empty if any is.
    """

    name: str
    kind: type
    optional: bool
    description: str
    unit: str = ""
    identifies: bool = False
    measured: bool = False
    of_equilibrium: bool = False
    shown: bool = False
    allowed: tuple[str, ...] = ()


def described(description: str, unit: str = "", **flags: bool | tuple[str, ...]) -> Any:
    """Return a dataclass field with what `Column` says about it besides name and kind."""
    return field(metadata={"description": description, "unit": unit, **flags})


def like(kind: type[Any], name: str) -> Any:
    """Return a dataclass field that is described as one of another row."""
    return field(metadata=kind.__dataclass_fields__[name].metadata)


class Row:
    """A row of a table: a dataclass whose fields are described by `Column`."""

    @property
    def key(self) -> tuple[Any, ...]:
        """What identifies the row in its table, which is sorted by it."""
        own = columns(type(self)).values()
        return tuple(getattr(self, column.name) for column in own if column.identifies)

    def shown(self) -> dict[str, Any]:
        """Return what the command line shows of the row with ``--json``."""
        own = columns(type(self)).values()
        return {column.name: getattr(self, column.name) for column in own if column.shown}


@dataclass(frozen=True)
class SheetIdentity(Row):
    """What tells a sheet of a study from the others."""

    material: str = described("name of the material, or of a variant of one", identifies=True)
    law: str = described("law of the strain energy", identifies=True)
    bending: str = described("bending law", identifies=True)
    parity: str = described("of z across the width: antisymmetric or symmetric", identifies=True)
    aspect: float = described("L/W", identifies=True)
    thickness: float = described("t/W", identifies=True)

    @property
    def sheet_key(self) -> tuple[Any, ...]:
        """What identifies the sheet."""
        return tuple(getattr(self, name) for name in columns(SheetIdentity))


@dataclass(frozen=True)
class StateRow(SheetIdentity):
    """A state: one sheet at one strain."""

    strain: float = described("eps = (L' - L)/L of the clamps", identifies=True, shown=True)
    status: Status = described(  # noqa: RUF009 (a field with metadata, like all the others)
        "wrinkled, flat or not-converged", allowed=STATUSES, shown=True
    )
    amplitude_over_thickness: float | None = described(
        "A/t, largest |z| on x = 0; 0 if flat", measured=True, shown=True
    )
    wavelength_over_width: float | None = described(
        "lambda/W, distance of the two central peaks of the same sign",
        measured=True,
        shown=True,
    )
    wavelength_zero_over_width: float | None = described(
        "lambda/W from the central zero crossings", measured=True
    )
    cells_per_wavelength: float | None = described(
        f"cells of the mesh in one wavelength across; below {FEWEST_CELLS:g} it is too coarse",
        measured=True,
        shown=True,
    )
    arc_width_over_width: float | None = described(
        "W_act/W, arc length of x = 0", measured=True, shown=True
    )
    projected_width_over_width: float | None = described(
        "W_proj/W, distance of the free edges on x = 0", measured=True, shown=True
    )
    planar_width_over_width: float | None = described(
        "width over W of the flat state of this strain on x = 0"
    )
    phi_squared: float | None = described(
        "Phi^2 = (W_act - W_proj)/W_proj over the full width", measured=True, shown=True
    )
    phi_squared_central: float | None = described(
        "Phi^2 over one wavelength around the centre", measured=True, shown=True
    )
    shape_constant: float | None = described(
        "C = A/(lambda Phi), Phi over the full width", measured=True, shown=True
    )
    shape_constant_central: float | None = described(
        "C = A/(lambda Phi), Phi over one wavelength", measured=True, shown=True
    )
    nominal_stress_pa: float | None = described(
        "clamp force over undeformed cross-section", "Pa", of_equilibrium=True, shown=True
    )
    young_modulus_pa: float = described("initial Young's modulus of the material", "Pa")
    energy: float | None = described("energy of the quarter sheet", "mu W^3", of_equilibrium=True)
    flat_energy: float | None = described(
        "energy of the flat quarter sheet at this strain", "mu W^3"
    )
    critical_thickness: float | None = described("tau_1/W: the flat sheet is unstable if t is less")
    sheet_amplitude_over_thickness: float | None = described(
        "largest |z|/t over the whole sheet", measured=True
    )
    sheet_amplitude_x_over_length: float | None = described(
        "X/L of the point of the largest |z|, 0 at the centre, 1/2 at the clamp", measured=True
    )
    sheet_amplitude_y_over_width: float | None = described(
        "Y/W of that point, 0 on the mid-line, 1/2 at the free edge", measured=True
    )
    envelope_amplitude_over_thickness: float | None = described(
        f"largest |z|/t but for {FLAP:g} W at the clamps, where thin sheets have a flap",
        measured=True,
    )
    envelope_amplitude_x_over_length: float | None = described(
        "X/L of the point of that |z|", measured=True
    )
    envelope_length_over_width: float | None = described(
        "l/W, length along X over which the largest |z| across the sheet is above half of that",
        measured=True,
    )
    deformed_envelope_length_over_width: float | None = described(
        "the same length on the deformed mid-line, over W", measured=True
    )
    unstable_directions: int | None = described(
        "negative eigenvalues of the tangent of the quarter", of_equilibrium=True, shown=True
    )
    newton_iterations: int = described("Newton iterations of the solve", shown=True)
    residual: float | None = described(
        "last Newton decrement of the solve, as a fraction of the energy", shown=True
    )
    cells_along: int = described("cells of the quarter along the pull")
    cells_across: int = described("cells of the quarter across")
    reason: str = described("why it did not converge; empty if it did", shown=True)


@dataclass(frozen=True)
class StabilityRow(SheetIdentity):
    """Where the flat sheet is unstable: what is known of a sheet without its states."""

    birth_strain: float | None = described(
        "strain at which the flat sheet becomes unstable; empty if it never does"
    )
    decay_strain: float | None = described(
        "strain at which it becomes stable again; empty if beyond the range"
    )
    max_critical_thickness: float | None = described("largest tau_1/W over strain")
    strain_at_max: float | None = described("strain of the largest tau_1")


@dataclass(frozen=True)
class SheetRow(StabilityRow):
    """A sheet: where it is unstable and what its states reach over strain."""

    max_amplitude_over_thickness: float | None = described(
        "largest A/t over strain; 0 if the sheet never wrinkles, empty if unknown"
    )
    strain_at_max_amplitude: float | None = described(
        "strain of the largest A/t; empty if there is none or it is unknown"
    )
    max_phi_squared: float | None = described(
        "largest Phi^2 (full width) over strain; 0 if the sheet never wrinkles, empty if unknown"
    )
    strain_at_max_phi_squared: float | None = described(
        "strain of the largest Phi^2; empty if there is none or it is unknown"
    )
    wavelength_over_width_at_max_amplitude: float | None = described(
        "lambda/W where A/t is largest"
    )
    min_wavelength_over_width: float | None = described("smallest lambda/W of the wrinkled states")
    max_wavelength_over_width: float | None = described("largest lambda/W of the wrinkled states")
    wrinkled: int = described("number of wrinkled states")
    flat: int = described("number of flat states")
    not_converged: int = described("number of states that did not converge")
    cells_along: int = described("cells of the quarter along the pull")
    cells_across: int = described("cells of the quarter across")


RowType = TypeVar("RowType", bound=SheetIdentity)


def columns(kind: type[Any]) -> Mapping[str, Column]:
    """Return the columns of a row type by name, in the order of the tables."""
    return _columns(kind)  # type: ignore[arg-type]  # mypy takes a dataclass for unhashable


@cache
def _columns(kind: type[Any]) -> Mapping[str, Column]:
    hints = get_type_hints(kind)
    by_name = {}
    for item in fields(kind):
        types = get_args(hints[item.name]) or (hints[item.name],)
        basic = next((basic for basic in (int, float) if basic in types), str)
        by_name[item.name] = Column(item.name, basic, type(None) in types, **item.metadata)
    return by_name


def make_row(kind: type[RowType], values: Mapping[str, Any], where: str, what: str) -> RowType:
    """Return a row from values read from a file, each checked; other values are ignored.

    Parameters
    ----------
    kind : type
        The type of the row.
    values : mapping
        By name of column; NaN counts as no number.
    where : str
        File, or file and line, for messages.
    what : str
        What the file should be, for messages.

    Raises
    ------
    ValueError
        If a value is missing or is not what its column allows; one line.
    """
    for name in columns(kind):
        if name not in values:
            raise ValueError(f"{where}: {name!r} is missing, not a {what}")
    cells: dict[str, Any] = {
        name: checked(column, values[name], where) for name, column in columns(kind).items()
    }
    return kind(**cells)


def checked(column: Column, value: Any, where: str) -> Cell:
    """Return a value in the type of its column: text, whole number, number or None.

    Raises
    ------
    ValueError
        If the column does not allow it; one line.
    """
    if isinstance(value, float | np.floating) and np.isnan(value):
        value = None
    if value is None and column.optional:
        return None
    if column.kind is str and isinstance(value, str) and value in (column.allowed or (value,)):
        return value
    if not isinstance(value, bool):
        if column.kind is float and isinstance(value, int | float | np.integer | np.floating):
            return float(value)
        if column.kind is int and isinstance(value, int | np.integer):
            return int(value)
    what = "is empty" if value is None else f"= {value!r}"
    raise ValueError(f"{where}: {column.name} {what}: must be {allowed_text(column)}")


def allowed_text(column: Column) -> str:
    """Return what a column may hold, in words."""
    if column.kind is str:
        return f"one of {', '.join(column.allowed)}" if column.allowed else "text"
    number = "a whole number" if column.kind is int else "a number"
    return f"{number} or empty" if column.optional else number


def numbers_of(rows: Iterable[SheetIdentity], name: str) -> list[float]:
    """Return a column of numbers of some rows, NaN where there is none."""
    values = (getattr(row, name) for row in rows)
    return [math.nan if value is None else float(value) for value in values]


def key_text(key: tuple[Any, ...]) -> str:
    """Return the key of a sheet or a state in words, for messages."""
    return ", ".join(map(str, key))


def refuse_twins(rows: Sequence[SheetIdentity], paths: Sequence[AnyPath]) -> None:
    """Raise a ValueError if two rows have the same key; it names the files they come from."""
    seen: dict[tuple[Any, ...], AnyPath] = {}
    for row, path in zip(rows, paths, strict=True):
        if row.key in seen:
            raise ValueError(f"{fspath(path)}: holds the same case as {fspath(seen[row.key])}")
        seen[row.key] = path
