"""Values of a config: what each kind may be, as constraints that are part of the JSON schema.

A constraint is written down once. Pydantic makes the JSON schema from it, with which editors check
a config and `wording` says what is allowed; ``errorMessage`` and ``patternErrorMessage`` word what
a constraint alone would not explain.
"""

import os
import re
from collections.abc import Collection
from dataclasses import dataclass
from typing import Annotated, Any, TypeVar

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
)
from pydantic_core import PydanticCustomError, core_schema

from wrinklestudy.results.cases import NAME_PATTERN
from wrinklestudy.vocabulary import ASPECT, STRAIN, THICKNESS, Limits

# YAML 1.1 takes 1e-3 for text (YAML 1.2, like everybody, for a number), and Snakemake takes every
# number inside --config 'mesh={cells_across: 14}' for text.
_NUMBER = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?")
_COUNT = re.compile(r"[0-9]{1,18}")
# Systems allow 255 bytes in a name and some thousand in a path; names of files have more than names
# of materials: numbers, suffixes.
_LONGEST_NAME = 100
_LONGEST_PART, _LONGEST_PATH = 250, 1000
# The type of errors whose message says what is wrong.
SAID = "said"


def within(limits: Limits) -> Any:
    """Return the constraint that a number lies within limits; messages name their unit."""
    return Field(
        gt=limits.lowest if limits.above_lowest else None,
        ge=None if limits.above_lowest else limits.lowest,
        le=limits.highest,
        json_schema_extra={"unit": limits.unit} if limits.unit else None,
    )


@dataclass(frozen=True, eq=False)
class OneOf:
    """The constraint that a text is one of some names.

    Parameters
    ----------
    names : collection of str
        Read when a value is checked, since a registry may have grown.
    """

    names: Collection[str]

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        """Return how pydantic checks a value."""
        return core_schema.no_info_after_validator_function(self._check, handler(source))

    def __get_pydantic_json_schema__(
        self, core: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Return its entry in the JSON schema."""
        return {**handler(core), "enum": list(self.names)}

    def _check(self, value: str) -> str:
        if value not in self.names:
            raise PydanticCustomError("enum", "must be one of the names")
        return value


def _as_number(value: Any) -> Any:
    if isinstance(value, str) and _NUMBER.fullmatch(value):
        return float(value)
    return _no_boolean_no_text(value)


def _as_count(value: Any) -> Any:
    if isinstance(value, str) and _COUNT.fullmatch(value):
        return int(value)
    if isinstance(value, float):
        raise PydanticCustomError("whole", "must be a whole number")
    return _no_boolean_no_text(value)


def _no_boolean_no_text(value: Any) -> Any:
    """Refuse what pydantic would take for a number."""
    if isinstance(value, bool | str | bytes):
        raise PydanticCustomError("number", "must be a number")
    return value


def _normal(path: str) -> str:
    """Return the one spelling of a path: home folder for ``~``; no ``./``, ``//`` or last ``/``.

    Snakemake takes each spelling for a different file.
    """
    path = os.path.expanduser(path)
    if path.startswith("~"):
        text = "must be a path; there is no home folder of that name"
        raise PydanticCustomError(SAID, "{text}", {"text": text})
    if len(os.fsencode(path)) > _LONGEST_PATH or any(
        len(os.fsencode(part)) > _LONGEST_PART for part in path.split("/")
    ):
        text = (
            f"must be a path that no system finds too long: names of at most {_LONGEST_PART} bytes"
        )
        raise PydanticCustomError(SAID, "{text}", {"text": text})
    return re.sub("^/+", "/", os.path.normpath(path))


def _rising(window: tuple[float, float]) -> tuple[float, float]:
    if not window[0] < window[1]:
        raise PydanticCustomError("window", "must rise")
    return window


Entry = TypeVar("Entry")
Filled = Annotated[tuple[Entry, ...], Field(min_length=1)]
# Conversions of text come last here, so that they come first when a value is read.
Number = BeforeValidator(_as_number)
Count = BeforeValidator(_as_count)
Aspect = Annotated[float, within(ASPECT), Number]
Thickness = Annotated[float, within(THICKNESS), Number]
Strain = Annotated[float, within(STRAIN), Number]
Place = Annotated[
    str,
    Field(
        min_length=1,
        pattern=r"^[^{}\x00-\x1f]*[^{}\x00-\x1f\s][^{}\x00-\x1f]*$",
        json_schema_extra={
            "patternErrorMessage": "must be a path, not blank and without { and }",
        },
    ),
    AfterValidator(_normal),
]
Name = Annotated[
    str,
    Field(
        pattern=f"^{NAME_PATTERN}$",
        max_length=_LONGEST_NAME,
        json_schema_extra={
            "errorMessage": f"must be a name of at most {_LONGEST_NAME} lower-case letters, "
            "digits, '-' and '_'"
        },
    ),
]
_Stretch = Annotated[float, Field(gt=0, allow_inf_nan=False), Number]
Window = Annotated[
    tuple[_Stretch, _Stretch],
    AfterValidator(_rising),
    Field(
        json_schema_extra={"errorMessage": "must be two stretches [low, high], 0 < low < high"},
    ),
]
