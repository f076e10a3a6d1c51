"""Values of a config: what each kind may be, in the words of the message that refuses it."""

import math
import re
from collections.abc import Callable
from importlib import import_module
from typing import Annotated, Any, TypeVar

from pydantic import BeforeValidator
from pydantic_core import PydanticCustomError

from wrinklestudy.results.cases import NAME_PATTERN

# YAML 1.1 takes 1e-3 for text (YAML 1.2, as everybody, for a number).
_EXPONENT = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)[eE][-+]?\d+")


def requirement(text: str, holds: Callable[[Any], bool]) -> BeforeValidator:
    """Return a validator that says what is allowed in words."""

    def check(value: Any) -> Any:
        if not holds(value):
            raise PydanticCustomError("requirement", "{text}", {"text": text})
        return value

    return BeforeValidator(check)


def number(allowed: str, holds: Callable[[float], bool]) -> BeforeValidator:
    """Return a validator for a finite number in an interval, in words and as a condition."""

    def check(value: Any) -> Any:
        if isinstance(value, str) and _EXPONENT.fullmatch(value):
            value = float(value)
        if not (_is_number(value) and holds(value)):
            text = f"must be a number {allowed}"
            raise PydanticCustomError("requirement", "{text}", {"text": text})
        return value

    return BeforeValidator(check)


def count(low: int, high: int) -> BeforeValidator:
    """Return a validator for a whole number in an interval."""
    return requirement(
        f"must be a whole number >= {low} and <= {high}",
        lambda v: isinstance(v, int) and not isinstance(v, bool) and low <= v <= high,
    )


def registered(module: str, registry: str) -> BeforeValidator:
    """Return a validator for a name in a registry of `wrinklestudy.mechanics`."""

    def check(value: Any) -> Any:
        # Here because it imports numpy, which reading this module does not need.
        names = getattr(import_module(f"wrinklestudy.mechanics.{module}"), registry)
        if not isinstance(value, str) or value not in names:
            text = f"must be one of {', '.join(names)}"
            raise PydanticCustomError("requirement", "{text}", {"text": text})
        return value

    return BeforeValidator(check)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _is_window(value: Any) -> bool:
    pair = isinstance(value, list | tuple) and len(value) == 2 and all(map(_is_number, value))
    return pair and 0 < value[0] < value[1]


Entry = TypeVar("Entry")
Filled = Annotated[
    tuple[Entry, ...],
    requirement(
        "must be a list with at least one entry", lambda v: isinstance(v, list | tuple) and v
    ),
]
Strain = Annotated[float, number("> 0 and <= 1", lambda v: 0 < v <= 1)]
Aspect = Annotated[float, number(">= 0.5 and <= 20 (L/W)", lambda v: 0.5 <= v <= 20)]
Thickness = Annotated[float, number("> 0 and <= 0.05 (t/W)", lambda v: 0 < v <= 0.05)]
Text = Annotated[str, requirement("must be text", lambda v: isinstance(v, str) and v.strip() != "")]
Name = Annotated[
    str,
    requirement(
        "must be a name of lower-case letters, digits, '-' and '_'",
        lambda v: isinstance(v, str) and re.fullmatch(NAME_PATTERN, v) is not None,
    ),
]
Window = Annotated[
    tuple[float, float],
    requirement("must be two stretches [low, high], 0 < low < high", _is_window),
]
