"""Imperfect sheets of a study: what is wrong with each, and the name under which its files lie."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING, Any

from wrinklestudy.results.cases import StudySheet, format_value
from wrinklestudy.vocabulary import Part

if TYPE_CHECKING:
    from wrinklestudy.equilibrium.imperfections import Imperfections

CLAMP_KEYS = ("shear", "rotate", "twist", "pitch", "lift")
RIPPLE_KEYS = ("amplitude", "wavelength", "angle", "phase")
WEIGHT_KEYS = ("density", "gravity", "width_mm")
PERFECT = "perfect"
COMBINED = "combined"
# What the names of imperfect sheets are made of; they have numbers with points.
IMPERFECTION_PATTERN = r"[a-z][a-z0-9.]*(?:[-_][a-z0-9.]+)*"

_STIFF = 1.0e30  # Pa: a sheet with a weight, but next to none

Amount = float | str | tuple[float, ...]


@dataclass(frozen=True)
class ImperfectSheet:
    """A sheet of a study that is not perfect, or one that is, for comparison.

    Parameters
    ----------
    sheet : StudySheet
    symmetry : {'quarter', 'half', 'half-width', 'whole'}
        The part that is solved.
    given : tuple of (key, value)
        What is not perfect, by the keys of the config: numbers for clamps and thickness, the four
        numbers of ``thickness_ripple``, the path of ``thickness_table``, and density, gravity and
        width for the weight.
    """

    sheet: StudySheet
    symmetry: Part = "whole"
    given: tuple[tuple[str, Amount], ...] = ()

    @property
    def name(self) -> str:
        """What tells it from other imperfect sheets of its size, as in the names of its files."""
        texts = [f"{_key(key)}-{_value(value)}" for key, value in self.given]
        part = [] if self.symmetry == "whole" else [self.symmetry]
        return "_".join([*(texts or [PERFECT]), *part])

    @property
    def kind(self) -> str:
        """What is imperfect, without how much; 'combined' if it is more than one thing."""
        main, rest = self._main
        if main is None:
            return PERFECT
        texts = [_key(main[0]), *rest]
        kinds = {key for key, _ in self.given} - set(WEIGHT_KEYS[1:])
        return COMBINED if len(kinds) > 1 else " ".join(texts)

    @property
    def size(self) -> float | None:
        """How much it is imperfect, in the unit of its key; None if it has no one size."""
        main, _ = self._main
        if main is None:
            return 0.0
        value = main[1][0] if isinstance(main[1], tuple) else main[1]
        return None if isinstance(value, str) or self.kind == COMBINED else value

    @property
    def _main(self) -> tuple[tuple[str, Amount] | None, list[str]]:
        """Return the first thing that is imperfect, and what besides its size tells its kind."""
        if not self.given:
            return None, []
        key, value = self.given[0]
        rest = [_number(part) for part in value[1:]] if isinstance(value, tuple) else []
        return (key, value), rest


def imperfections_of(given: Mapping[str, Any], shear_modulus: float) -> "Imperfections":
    """Return imperfections as the library takes them.

    Parameters
    ----------
    given : mapping
        By the keys of a config, see `ImperfectSheet`.
    shear_modulus : float
        mu in Pa, against which the weight counts.

    Raises
    ------
    ValueError
        If a number is not allowed, or the table of the thickness is none; one line.
    """
    from wrinklestudy.equilibrium.imperfections import Imperfections, self_weight
    from wrinklestudy.fem.clamps import Clamps
    from wrinklestudy.fem.thickness import Ripple, ThicknessField
    from wrinklestudy.results.thickness_table import read_thickness_table

    clamps = Clamps(**{key: given[key] for key in CLAMP_KEYS if key in given})
    table, ripple = given.get("thickness_table"), given.get("thickness_ripple")
    thickness = ThicknessField(
        given.get("thickness_along", 0.0),
        given.get("thickness_across", 0.0),
        () if ripple is None else (Ripple(*ripple),),
        None if table is None else read_thickness_table(table),
    )
    weight = 0.0
    if "density" in given:
        density, gravity, width = (given[key] for key in WEIGHT_KEYS)
        weight = self_weight(density, 1e-3 * width, shear_modulus, gravity)
    return Imperfections(clamps, thickness, weight)


def check_imperfect(sheet: ImperfectSheet) -> None:
    """Raise a ValueError of one line if the part of a sheet that is solved does not tell the whole.

    A table of the thickness is read if it is there; how heavy the sheet is does not matter.
    """
    given = dict(sheet.given)
    if not Path(str(given.get("thickness_table", "."))).is_file():
        given.pop("thickness_table", None)
    found, aspect = imperfections_of(given, _STIFF), sheet.sheet.aspect
    found.thickness.keeps(False, False, aspect)
    found.check_part(sheet.symmetry, aspect)


def repeated_names(sheets: Iterable[ImperfectSheet]) -> list[str]:
    """Return names that different imperfect sheets of one size share, as tables of one stem do."""
    known: dict[tuple[StudySheet, str], ImperfectSheet] = {}
    return [
        sheet.name
        for sheet in sheets
        if known.setdefault((sheet.sheet, sheet.name), sheet) != sheet
    ]


def _key(key: str) -> str:
    return key.replace("_", "-")


def _value(value: Amount) -> str:
    if isinstance(value, str):
        stem = PurePosixPath(value).stem.lower()
        return "".join(c if c.isascii() and c.isalnum() else "." for c in stem)
    values = value if isinstance(value, tuple) else (value,)
    return "x".join(_number(number) for number in values)


def _number(value: float) -> str:
    return f"{'minus' if value < 0 else ''}{format_value(abs(value))}"
