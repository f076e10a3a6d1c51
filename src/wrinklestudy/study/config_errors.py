"""Problems that pydantic finds in a config, as one line of text each."""

import difflib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, get_args

from pydantic import BaseModel
from pydantic_core import ErrorDetails

# pydantic puts the alternative that it tried into the path of an error
_TAGS = ("list", "range", "[key]")


def line(root: type[BaseModel], error: ErrorDetails) -> str:
    """Return one problem as text: dotted key, value, what is allowed.

    Parameters
    ----------
    root : type
        Model of the whole config.
    error : ErrorDetails
        One entry of `pydantic.ValidationError.errors`.
    """
    path = [part for part in error["loc"] if part not in _TAGS]
    key, kind, value = _dotted(path), error["type"], error["input"]
    if kind in ("missing", "extra_forbidden"):
        known, last = _block_at(root, path[:-1]).model_fields, str(path[-1])
        if kind == "missing":
            return f"{key}: is missing: {known[last].description}"
        return f"{key}: unknown key{closest(last, known)}"
    shown = "" if isinstance(value, Mapping) and value else f" = {_short(value)}"
    return f"{key}{shown}: {_requirement(error)}"


def _requirement(error: ErrorDetails) -> str:
    if error["type"] == "literal_error":
        return f"must be {error['ctx']['expected']}"
    return "must be a block of keys" if error["type"] == "model_type" else error["msg"]


def _dotted(path: list[int | str]) -> str:
    text = "".join(f"[{part}]" if isinstance(part, int) else f".{_key(part)}" for part in path)
    return text.removeprefix(".") or "the config"


def _key(name: str) -> str:
    return name if name.isprintable() else repr(name)  # it may hold a line break


def _short(value: Any) -> str:
    words = {None: "null", True: "true", False: "false"}
    text = words[value] if value is None or isinstance(value, bool) else repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def _block_at(root: type[BaseModel], path: list[int | str]) -> type[BaseModel]:
    """Return the model of the block that a path leads to."""
    block = root
    for part in path:
        field = block.model_fields.get(str(part))
        if field is not None:  # else an index or a name that the user chose
            block = next(_blocks_in(field.annotation), block)
    return block


def _blocks_in(annotation: Any) -> Iterator[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for inner in get_args(annotation):
        yield from _blocks_in(inner)


def closest(word: str, known: Iterable[str]) -> str:
    """Return the end of a message on an unknown word: the closest known one and all of them."""
    known = list(known)
    matches = difflib.get_close_matches(word, known, n=1)
    hint = f"did you mean {matches[0]}? " if matches else ""
    return f"; {hint}allowed: {', '.join(known)}"
