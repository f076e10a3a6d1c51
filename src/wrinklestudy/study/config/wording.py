"""The problems that pydantic finds in a config, as one line of text each.

The words for what is allowed follow from the JSON schema of the config.
"""

import datetime
import difflib
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from typing import Any

from pydantic import BaseModel
from pydantic_core import ErrorDetails

from wrinklestudy.study.config.values import SAID

# pydantic puts the alternative that it tried into the path of an error
_TAGS = ("list", "range")
_BOUNDS = {"exclusiveMinimum": ">", "minimum": ">=", "exclusiveMaximum": "<", "maximum": "<="}
_KINDS = {"integer": "a whole number", "number": "a number", "string": "text"}

Schema = Mapping[str, Any]


def lines(root: type[BaseModel], errors: Sequence[ErrorDetails]) -> list[str]:
    """Return the problems as text: dotted key, value, what is allowed.

    Parameters
    ----------
    root : type
        Model of the whole config.
    errors : sequence of ErrorDetails
        From `pydantic.ValidationError.errors`.
    """
    # A list with a wrong entry is also reported as too short: the entry is what is wrong. And what
    # stands under a name that is not text can only be checked once it has a proper name.
    inner = {error["loc"][:k] for error in errors for k in range(len(error["loc"]))}
    unnamed = {
        error["loc"][:-1]
        for error in errors
        if _is_key(error) and not isinstance(error["input"], str)
    }
    return [
        _line(root, error, _path(error))
        for error in errors
        if (error["type"] != "too_short" or error["loc"] not in inner)
        and (_is_key(error) or not any(error["loc"][: len(place)] == place for place in unnamed))
    ]


def _path(error: ErrorDetails) -> tuple[int | str, ...]:
    """Return the keys and indices that lead to the place of an error."""
    path = tuple(part for part in error["loc"] if part not in _TAGS)
    if error["type"] == "invalid_key":  # a key that is not text, in a block with known keys
        return (*path[:-1], str(path[-1]))
    # pydantic alters a name that is not text: 0 for false
    return (*path[:-2], _short(error["input"]).strip("'")) if _is_key(error) else path


def _line(root: type[BaseModel], error: ErrorDetails, path: tuple[int | str, ...]) -> str:
    schema, key, kind, value = _schema(root), _dotted(path), error["type"], error["input"]
    if kind == "missing" and isinstance(path[-1], str):
        return f"{key}: is missing: {_at(schema, path)['description']}"
    if kind == "missing":  # an entry of a list of fixed length
        path = path[:-1]
        key = _dotted(path)
    if kind in ("extra_forbidden", "invalid_key"):
        kinds = _alternatives(schema, _at(schema, path[:-1]))
        known = next(kind["properties"] for kind in kinds if "properties" in kind)
        return f"{key}: unknown key{closest(str(path[-1]), known)}"
    node = _names(schema, path[:-1]) if _is_key(error) else _at(schema, path)
    node = _alternatives(schema, node)[0]
    allowed = error["msg"] if kind == SAID else _words(node, kind)
    shown = "" if isinstance(value, Mapping) and value else f" = {_short(value)}"
    return f"{key}{shown}: {allowed}{_reading(node, value)}"


def _is_key(error: ErrorDetails) -> bool:
    return error["loc"][-1:] == ("[key]",)


def _names(schema: Schema, path: Sequence[int | str]) -> Schema:
    """Return the part of a schema that describes the names in the block at a path."""
    kinds = _alternatives(schema, _at(schema, path))
    names: Schema = next(kind["propertyNames"] for kind in kinds if "propertyNames" in kind)
    return names


@cache
def _schema(root: type[BaseModel]) -> Schema:
    return root.model_json_schema()


def _at(schema: Schema, path: Sequence[int | str]) -> Schema:
    """Return the part of a schema that describes the value at a path."""
    node = schema
    for part in path:
        inner = (_entry(kind, part) for kind in _alternatives(schema, node))
        node = _resolved(schema, next(entry for entry in inner if entry is not None))
    return node


def _entry(node: Schema, part: int | str) -> Schema | None:
    """Return the schema of an entry of a list or block; None if it cannot have that entry."""
    if isinstance(part, int):
        fixed = node.get("prefixItems")
        return node.get("items") if fixed is None else fixed[part]
    chosen_by_user = next(iter(node.get("patternProperties", {}).values()), None)
    return node.get("properties", {}).get(part, chosen_by_user)


def _alternatives(schema: Schema, node: Schema) -> list[Schema]:
    kinds = node.get("anyOf") or node.get("oneOf") or [node]
    return [_resolved(schema, kind) for kind in kinds]


def _resolved(schema: Schema, node: Schema) -> Schema:
    """Return a part of a schema, with references replaced by what they refer to."""
    if "$ref" not in node:
        return node
    name = node["$ref"].rpartition("/")[2]
    return {**schema["$defs"][name], **node}


def _words(node: Schema, kind: str) -> str:
    """Return what the schema of a value allows, in words."""
    if "errorMessage" in node:
        return str(node["errorMessage"])
    if kind == "string_pattern_mismatch" and "patternErrorMessage" in node:
        return str(node["patternErrorMessage"])
    if "enum" in node:
        *others, last = map(repr, node["enum"])
        return f"must be {', '.join(others)} or {last}" if others else f"must be {last}"
    if node["type"] == "array":
        return f"must be a list{' with at least one entry' if node.get('minItems') else ''}"
    if node["type"] == "object":
        return f"must be a block{' of keys' if 'properties' in node else ''}"
    bounds = [f"{sign} {_plain(node[bound])}" for bound, sign in _BOUNDS.items() if bound in node]
    unit = f" ({node['unit']})" if "unit" in node else ""
    return f"must be {' '.join([_KINDS[node['type']], ' and '.join(bounds)]).strip()}{unit}"


def _plain(bound: float) -> str:
    return str(int(bound)) if bound == int(bound) else f"{bound:g}".replace("e-0", "e-")


def _reading(node: Schema, value: Any) -> str:
    """Return a hint where text is expected but YAML reads something else."""
    if node.get("type", "string") != "string":  # names have no type there: they are text
        return ""
    if isinstance(value, bool):
        word = "yes and on as true" if value else "no and off as false"
        return f"; YAML reads {word}: put the word in quotes"
    kind = "a number" if isinstance(value, int | float) else "a date"
    readable = isinstance(value, int | float | datetime.date)
    return f"; YAML reads it as {kind}: put it in quotes" if readable else ""


def _dotted(path: Sequence[int | str]) -> str:
    text = "".join(f"[{part}]" if isinstance(part, int) else f".{_key(part)}" for part in path)
    return text.removeprefix(".") or "the config"


def _key(name: str) -> str:
    return name if name.isprintable() else repr(name)  # it may hold a line break


def _short(value: Any) -> str:
    words = {None: "null", True: "true", False: "false"}
    text = words[value] if value is None or isinstance(value, bool) else repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def closest(word: str, known: Iterable[str]) -> str:
    """Return the end of a message about an unknown word: the closest known one, and all."""
    known = list(known)
    matches = difflib.get_close_matches(word, known, n=1)
    hint = f"did you mean {matches[0]}? " if matches else ""
    return f"; {hint}allowed: {', '.join(known)}"
