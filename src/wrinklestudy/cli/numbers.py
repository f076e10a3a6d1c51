"""Numbers on the command line."""

import argparse
import math
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from wrinklestudy.vocabulary import Limits

# What float() takes besides is no number to most people: 1_000, nan, digits of other scripts.
_NUMBER = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?")


class NumberRange(NamedTuple):
    """Equally spaced numbers, both ends included; a single number is its own range."""

    start: float
    stop: float
    step: float

    @property
    def is_single(self) -> bool:
        """Whether it is a single number."""
        return math.isnan(self.step)


def number(text: str) -> float:
    """Return a finite number."""
    text = text.strip()
    value = float(text) if _NUMBER.fullmatch(text) else math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text!r} is not a finite number")
    return value


def whole_number(text: str) -> int:
    """Return a whole number."""
    value = number(text)
    if value != round(value):
        raise argparse.ArgumentTypeError(f"{text.strip()!r} is not a whole number")
    return int(value)


def numbers(text: str) -> NumberRange:
    """Return a number, or the range ``start:stop:step``."""
    parts = text.split(":")
    if len(parts) == 1:
        return NumberRange(number(text), number(text), math.nan)
    if len(parts) != 3:
        raise argparse.ArgumentTypeError(
            f"{text.strip()!r} is neither a number nor a range start:stop:step"
        )
    return NumberRange(*map(number, parts))


def is_negative(text: str) -> bool:
    """Return whether a text is a negative number, or a range that begins with one."""
    return _NUMBER.match(text) is not None and text.startswith("-")


def values_within(option: str, entries: Sequence[NumberRange], allowed: "Limits") -> list[float]:
    """Return the numbers of all entries in the order given, each once.

    Raises
    ------
    ValueError
        If one is not allowed, or the end of a range is not a whole number of steps away.
    """
    for entry in entries:
        for end in entry[:2]:
            if end not in allowed:
                raise ValueError(f"{option} = {end:g}: must be {allowed}")
    return list(dict.fromkeys(x for entry in entries for x in range_values(option, entry, allowed)))


def range_values(option: str, entry: NumberRange, allowed: "Limits") -> tuple[float, ...]:
    """Return the numbers of an entry; see `number_range` for what is allowed."""
    from wrinklestudy.results.cases import number_range

    if entry.is_single:
        return (entry.start,)
    try:
        return number_range(*entry, allowed)
    except ValueError as error:
        raise ValueError(f"{option} {':'.join(f'{x:g}' for x in entry)}: {error}") from None
