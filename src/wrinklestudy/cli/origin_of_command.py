"""What a command says of itself in the files that it writes: `wrinklestudy provenance`."""

import argparse
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, is_dataclass
from pathlib import Path
from typing import Any

from wrinklestudy.cli.numbers import NumberRange

# Options that name the files to write, and those that change nothing in them.
_WRITES = ("vtu", "picture", "plot", "output")
_LEFT_OUT = {*_WRITES, "command", "given", "jobs", "json", "overwrite", "yaml"}


@contextmanager
def stating(command: str, arguments: argparse.Namespace, module: str) -> Iterator[None]:
    """State the origin of the files that a command writes within the block, if it writes any.

    Parameters
    ----------
    command : str
        Its name.
    arguments : argparse.Namespace
        Its options.
    module : str
        Name of its module.
    """
    if not any(getattr(arguments, name, None) for name in _WRITES):
        yield
        return
    from wrinklestudy.files.origin import stated
    from wrinklestudy.stages.recording import program
    from wrinklestudy.study.digest import SOURCE, code_digest, module_file

    file = module_file(module, (SOURCE,))
    assert file is not None
    given = {
        name: value
        for name, value in sorted(vars(arguments).items())
        if name not in _LEFT_OUT and value is not None and value is not False and value != []
    }
    made = {
        **program(),
        "command": command,
        "code": code_digest(file),
        "config": {name: _plain(value) for name, value in given.items()},
        "inputs": _inputs(given),
    }
    with stated(made):
        yield


def _inputs(given: Mapping[str, Any]) -> dict[str, str]:
    """Return the checksums of the files that the options name, by option; a list has numbers."""
    from wrinklestudy.files.records import file_digest

    checksums = {}
    for name, value in given.items():
        texts = value if isinstance(value, list) else [value]
        files = [text for text in texts if isinstance(text, str) and Path(text).is_file()]
        for number, file in enumerate(files, 1):
            checksums[name if len(texts) == 1 else f"{name} {number}"] = file_digest(file)
    return checksums


def _plain(value: Any) -> Any:
    """Return a value for JSON; of a file its name without its folder."""
    if isinstance(value, NumberRange):
        ends = value[:1] if value.is_single else value
        return ":".join(f"{number:.12g}" for number in ends)
    if isinstance(value, list | tuple):
        return [_plain(entry) for entry in value]
    if is_dataclass(value) and not isinstance(value, type):
        return asdict(value)
    return Path(value).name if isinstance(value, str) and "/" in value else value
