"""The cases of a study, and the one place that turns numbers into file names and back.

A case is one sheet at one strain. Numbers in file names have one fixed format, so that equal
numbers give the same file: `format_value` and `parse_value`.
"""

import math
import re
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from decimal import Decimal

from wrinklestudy.vocabulary import STRAIN, Limits

DIGITS = 12
DESIGN_THICKNESS = 1.0e-3

# The texts that `format_value` returns: no sign, no leading or trailing zeros, no exponent.
VALUE_PATTERN = r"(?:0|[1-9][0-9]*)(?:\.[0-9]*[1-9])?"
NAME_PATTERN = r"[a-z0-9]+(?:[-_][a-z0-9]+)*"


def format_value(value: float) -> str:
    """Return a non-negative number as the shortest plain decimal with 12 significant digits.

    Examples
    --------
    >>> format_value(0.1 + 0.2), format_value(1e-3), format_value(2.0)
    ('0.3', '0.001', '2')

    Raises
    ------
    ValueError
        If the number is negative or not finite.
    """
    if not (math.isfinite(value) and value >= 0):
        raise ValueError(f"{value!r}: must be a finite number >= 0")
    text = format(Decimal(f"{value:.{DIGITS}g}"), "f")
    return text.rstrip("0").rstrip(".") if "." in text else text.lstrip("-")


def parse_value(text: str) -> float:
    """Return the number that `format_value` wrote.

    Raises
    ------
    ValueError
        If ``text`` is not in the format of `format_value`, such as ``0.10`` or ``1e-3``: another
        spelling would be another file for the same case.
    """
    if re.fullmatch(VALUE_PATTERN, text) and format_value(float(text)) == text:
        return float(text)
    raise ValueError(f"{text!r}: must be a plain decimal number such as 0.3, 0.001 or 2")


def canonical(value: float) -> float:
    """Return ``value`` as it is read back from a file name: 0.1 + 0.2 becomes 0.3."""
    return parse_value(format_value(value))


def strain_range(start: float, stop: float, step: float) -> tuple[float, ...]:
    """Return equally spaced strains, see `number_range`."""
    return number_range(start, stop, step, STRAIN)


def number_range(start: float, stop: float, step: float, allowed: Limits) -> tuple[float, ...]:
    """Return start, start + step, ... up to and including stop, in exact decimals.

    Parameters
    ----------
    start, stop, step : float
        Not negative.
    allowed : Limits
        What a message may offer for a stop that is not reached.

    Raises
    ------
    ValueError
        If the step is not positive, or stop lies before start or not a whole number of steps
        after it.
    """
    first, last, width = (Decimal(format_value(value)) for value in (start, stop, step))
    if width <= 0 or last < first:
        raise ValueError(f"start {start:g}, stop {stop:g}, step {step:g}: no values")
    steps, rest = divmod(last - first, width)
    if rest:
        ends = [float(first + k * width) for k in (steps, steps + 1)]
        nearest = " or ".join(format_value(end) for end in ends if end in allowed)
        raise ValueError(
            f"stop = {stop:g}: must be a whole number of steps above start; nearest: {nearest}"
        )
    return tuple(canonical(float(first + k * width)) for k in range(int(steps) + 1))


def resolved_thickness(thickness: float) -> float:
    """Return the design thickness t/W of the mesh that serves a sheet.

    This is the largest of 1e-3, 5e-4, 2.5e-4, ... that is not above ``thickness``; it is 1e-3 for
    all thicker sheets.

    Raises
    ------
    ValueError
        If the thickness is not positive.
    """
    if not thickness > 0:
        raise ValueError(f"thickness = {thickness:g}: must be > 0")
    halvings = math.ceil(math.log2(DESIGN_THICKNESS / thickness) - 1e-9)
    return canonical(DESIGN_THICKNESS / 2 ** max(halvings, 0))


@dataclass(frozen=True, order=True)
class StudySheet:
    """One sheet of a study.

    Parameters
    ----------
    material : str
        Name of the material in the config, or of a variant of one.
    aspect : float
        Length over width, L/W.
    thickness : float
        Thickness over width, t/W.
    """

    material: str
    aspect: float
    thickness: float

    @property
    def resolved(self) -> float:
        """Design thickness of its mesh."""
        return resolved_thickness(self.thickness)


@dataclass(frozen=True, order=True)
class Case:
    """One sheet at one strain (L' - L)/L."""

    sheet: StudySheet
    strain: float


def cases(
    series: Iterable[tuple[str, Sequence[float], Sequence[float], Sequence[float]]],
) -> tuple[Case, ...]:
    """Return the cases of all series, sorted and without repetitions.

    Parameters
    ----------
    series : iterable
        (material, aspects, thicknesses, strains); a series means all combinations of them.
    """
    return tuple(
        sorted(
            {
                Case(
                    StudySheet(material, canonical(aspect), canonical(thickness)), canonical(strain)
                )
                for material, aspects, thicknesses, strains in series
                for aspect in aspects
                for thickness in thicknesses
                for strain in strains
            }
        )
    )


def strains_by_length(
    series: Iterable[tuple[str, Sequence[float], Sequence[float]]],
) -> dict[tuple[str, float], tuple[float, ...]]:
    """Return the strains of each model and L/W, sorted and without repetitions.

    Parameters
    ----------
    series : iterable
        (material, aspects, strains); a series means all combinations of them.
    """
    strains_of: defaultdict[tuple[str, float], set[float]] = defaultdict(set)
    for material, aspects, strains in series:
        for aspect in aspects:
            strains_of[material, canonical(aspect)] |= set(map(canonical, strains))
    return {length: tuple(sorted(strains_of[length])) for length in sorted(strains_of)}
