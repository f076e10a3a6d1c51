"""Measured stress-strain data: one format for bundled and for a user's own files.

Lines that begin with ``#`` are notes (source, sample, remarks). The first other line names the
columns, in any order, with their units:

* ``stretch`` (lambda = L'/L), ``strain`` (lambda - 1), ``strain_percent``, or ``extension_mm`` with
  a line ``# gauge length: 80 mm``;
* ``stress_pa``, ``stress_kpa`` or ``stress_mpa``, nominal: force per undeformed area; or
  ``force_n`` or ``load_n`` (kN: ``_kn``) with lines ``# width: 10 mm`` and ``# thickness: 1 mm``;
* ``mode`` (optional): uniaxial (default), biaxial or shear;
* ``branch`` (optional): loading or unloading; otherwise told from the order of the points;
* ``standard_error_pa`` (kPa, MPa; optional): of the stress, > 0.

`wrinklestudy.files.text_table` says which separators and decimal signs are understood.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from wrinklestudy.files.number_table import (
    NumberColumn,
    NumberNote,
    NumberTable,
    WordColumn,
    read_number_table,
)
from wrinklestudy.material.branches import BRANCHES, tell_branches
from wrinklestudy.material.homogeneous import MODES
from wrinklestudy.typing import AnyPath, Array, Indices, Mask
from wrinklestudy.vocabulary import Limits

# Larger strains are per cent; no rubber is pressed to less than a hundredth.
STRAIN_LIMITS = Limits(-0.99, 10.0)
# Beyond these lie slips of the pen, and numbers whose powers are none.
STRESS_LIMITS = Limits(-1e15, 1e15)
_ERROR_LIMITS = Limits(1e-6, 1e15)
_LENGTH_LIMITS = Limits(1e-6, 1e9)  # in mm
_LENGTHS = {"mm": 1.0, "cm": 10.0, "m": 1e3, "um": 1e-3, "\N{MICRO SIGN}m": 1e-3}
_PASCALS = {"pa": 1.0, "kpa": 1e3, "mpa": 1e6}


def stress_spellings(name: str) -> dict[str, float]:
    """Return the names of a column of stress with a unit, and their factors to Pa."""
    return {f"{name}_{unit}": factor for unit, factor in _PASCALS.items()}


def strain_column(limits: Limits = STRAIN_LIMITS, needed: bool = True) -> NumberColumn:
    """Return the column of strain that all tables have."""
    spellings = {"strain": 1.0, "strain_percent": 0.01, "strain_%": 0.01}
    hint = "0.12 is 12 %; per cent belongs in a column strain_percent"
    return NumberColumn("strain", spellings, limits, hint, needed)


_STRETCH = NumberColumn(
    "stretch",
    {"stretch": 1.0},
    Limits(0.01, 1.0 + STRAIN_LIMITS.highest),
    "1 is undeformed",
    needed=False,
)
_EXTENSION = NumberColumn(
    "extension",
    {"extension_mm": 1.0, "extension_m": 1e3, "displacement_mm": 1.0, "displacement_m": 1e3},
    needed=False,
)
_STRESS = NumberColumn("stress", stress_spellings("stress"), STRESS_LIMITS, needed=False)
_FORCE = NumberColumn(
    "force", {"force_n": 1.0, "load_n": 1.0, "force_kn": 1e3, "load_kn": 1e3}, needed=False
)
_ERROR = NumberColumn(
    "standard_error", stress_spellings("standard_error"), _ERROR_LIMITS, needed=False
)
_COLUMNS = (_STRETCH, strain_column(needed=False), _EXTENSION, _STRESS, _FORCE, _ERROR)
_WORDS = (WordColumn("mode", MODES, MODES[0]), WordColumn("branch", BRANCHES, ""))
_EXAMPLES = {"gauge length": "80 mm", "width": "10 mm", "thickness": "1 mm"}
_NOTES = tuple(NumberNote(name, _LENGTH_LIMITS, _LENGTHS) for name in _EXAMPLES)
# A window that ends at 1.14 takes a point at strain 0.14, whose stretch is 1.1400000000000001.
_EDGE = 1e-9


@dataclass(frozen=True, eq=False)
class Measurement:
    """Measured points of a material test.

    Parameters
    ----------
    stretch : ndarray, shape ``(n,)``
        Stretch along the pull.
    stress : ndarray, shape ``(n,)``
        Nominal stress in Pa.
    mode : ndarray of str, shape ``(n,)``
        Deformation mode of each point: uniaxial, biaxial or shear.
    standard_error : ndarray of shape ``(n,)`` or None
        Standard error of the stress in Pa, where it is known.
    source : str
        Name of the file.
    note : str
        Comment lines of the file.
    branch, cycle, line : ndarray of shape ``(n,)`` or None
        Branch (loading or unloading) and cycle (from 1) of each point, and its line in the file.
        None: all points are of the first loading; not from a file.
    """

    stretch: Array
    stress: Array
    mode: NDArray[np.str_]
    standard_error: Array | None = None
    source: str = "data"
    note: str = ""
    branch: NDArray[np.str_] | None = None
    cycle: Indices | None = None
    line: Indices | None = None

    def kept(self, rows: Mask | Indices) -> "Measurement":
        """Return some of the points."""
        columns = ("stretch", "stress", "mode", "standard_error", "branch", "cycle", "line")
        values = {name: getattr(self, name) for name in columns}
        return replace(
            self, **{name: value[rows] for name, value in values.items() if value is not None}
        )

    def on(self, branch: str, cycle: int) -> Mask:
        """Return which points are on a branch of a cycle."""
        if self.branch is None or self.cycle is None:
            return np.full(self.stretch.shape, (branch, cycle) == (BRANCHES[0], 1))
        chosen: Mask = (self.branch == branch) & (self.cycle == cycle)
        return chosen

    def within(
        self,
        stretch: tuple[float, float] | None = None,
        modes: Sequence[str] | None = None,
    ) -> Mask:
        """Return which points are inside a window of stretch (ends included) and of some modes.

        Raises
        ------
        ValueError
            If the window is empty or a mode is unknown or not in the data.
        """
        keep = np.ones(self.stretch.shape, dtype=np.bool_)
        if stretch is not None:
            low, high = stretch
            if not 0.0 <= low < high:
                raise ValueError(
                    f"stretch = {low:g}, {high:g}: must be two numbers, 0 <= smallest < largest"
                )
            keep &= (self.stretch >= low * (1.0 - _EDGE)) & (self.stretch <= high * (1.0 + _EDGE))
        if modes is not None:
            self._check_modes(modes)
            keep &= np.isin(self.mode, np.array(modes, dtype=np.str_))
        return keep

    def select(
        self,
        stretch: tuple[float, float] | None = None,
        modes: Sequence[str] | None = None,
    ) -> "Measurement":
        """Return the points `within` a window of stretch and of some modes."""
        return self.kept(self.within(stretch, modes))

    @property
    def modes(self) -> tuple[str, ...]:
        """The deformation modes that the points have."""
        return tuple(mode for mode in MODES if mode in self.mode)

    def _check_modes(self, modes: Sequence[str]) -> None:
        if isinstance(modes, str) or not modes:
            raise ValueError(f"modes = {modes!r}: must be a list of {', '.join(MODES)}")
        for mode in modes:
            if mode not in MODES:
                raise ValueError(f"mode {mode!r} is unknown: allowed are {', '.join(MODES)}")
            if mode not in self.modes:
                raise ValueError(f"{self.source}: has no {mode} data, only {', '.join(self.modes)}")


def read(path: AnyPath) -> Measurement:
    """Read a stress-strain file in the format of this module.

    Parameters
    ----------
    path : path-like
        Table of numbers; see `wrinklestudy.files.text_table`.

    Returns
    -------
    Measurement

    Raises
    ------
    ValueError
        If the file cannot be read, a column or a line with a size of the specimen is missing, a
        column is unknown or doubled, or a cell is not what its column holds; one line naming the
        file, the line and the column.
    """
    table = read_number_table(
        path,
        _COLUMNS,
        _WORDS,
        _NOTES,
        either=(("stretch", "strain", "extension"), ("stress", "force")),
    )
    stretch = _stretch(table)
    mode = np.array(table.words["mode"], dtype=np.str_)
    named = table.words["branch"]
    branch, cycle = tell_branches(stretch, mode, named if all(named) else ())
    return Measurement(
        stretch,
        _stress(table),
        mode,
        table.numbers.get("standard_error"),
        table.path.name,
        table.note,
        branch,
        cycle,
        table.lines,
    )


def _stretch(table: NumberTable) -> Array:
    """Return the stretch; of an extension 1 + extension / gauge length."""
    if "stretch" in table.numbers:
        return table.numbers["stretch"]
    if "strain" in table.numbers:
        return 1.0 + table.numbers["strain"]
    gauge = _size(table, "gauge length", "extension")
    strain = table.numbers["extension"] / gauge
    for line, value in zip(table.lines, strain, strict=True):
        if float(value) not in STRAIN_LIMITS:
            raise ValueError(
                f"{table.path}, line {line}, column {table.spelled['extension']}: is a strain of "
                f"{value:g}, which must be {STRAIN_LIMITS}; is the gauge length {gauge:g} mm?"
            )
    return 1.0 + strain


def _stress(table: NumberTable) -> Array:
    """Return the nominal stress in Pa; of a force F/(W t)."""
    if "stress" in table.numbers:
        return table.numbers["stress"]
    width, thickness = (_size(table, name, "force") for name in ("width", "thickness"))
    stress: Array = table.numbers["force"] / (width * thickness * 1e-6)
    for line, value in zip(table.lines, stress, strict=True):
        if float(value) not in STRESS_LIMITS:
            raise ValueError(
                f"{table.path}, line {line}, column {table.spelled['force']}: is a stress of "
                f"{value:g} Pa, which must be {STRESS_LIMITS}; is the specimen {width:g} mm wide "
                f"and {thickness:g} mm thick?"
            )
    return stress


def _size(table: NumberTable, name: str, column: str) -> float:
    """Return a length of the specimen in mm."""
    if name not in table.notes:
        raise ValueError(
            f"{table.path}: a line '# {name}: {_EXAMPLES[name]}' is missing; column "
            f"{table.spelled[column]} needs the {name} of the specimen"
        )
    return table.notes[name]
