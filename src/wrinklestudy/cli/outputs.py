"""Files that a command writes: checked before anything is computed, then written whole."""

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path


class WriteError(Exception):
    """A result could not be written; one line."""


def add_overwrite(parser: argparse.ArgumentParser) -> None:
    """Add the option that lets files be replaced."""
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist already")


def planned(
    option: str, path: str | None, suffixes: Sequence[str], overwrite: bool, labels: Sequence[str]
) -> tuple[Path | None, ...]:
    """Return the file for each of some results, None for each where none is asked for.

    A single result has the path that was given; several have their labels before its suffix.

    Parameters
    ----------
    option : str
        The option that asks for the files, for messages.
    path : str or None
        What was given with it.
    suffixes : sequence of str
        The suffixes that are allowed.
    overwrite : bool
        Whether files that exist may be replaced.
    labels : sequence of str
        One for each result.

    Raises
    ------
    ValueError
        If the suffix is not allowed, a file exists, or its folder cannot be one.
    """
    if path is None:
        return (None,) * len(labels)
    whole = Path(path).expanduser()
    if whole.suffix not in suffixes:
        raise ValueError(f"{option} {path}: must end in {' or '.join(suffixes)}")
    files = [whole]
    if len(labels) > 1:
        files = [whole.with_name(f"{whole.stem}_{label}{whole.suffix}") for label in labels]
    for file in files:
        if file.is_dir():
            raise ValueError(f"{option} {file}: is a folder")
        if file.exists() and not overwrite:
            raise ValueError(f"{option} {file}: exists already; --overwrite replaces it")
    for folder in whole.parents:
        if folder.exists() and not folder.is_dir():
            raise ValueError(f"{option} {path}: {folder} is a file, not a folder")
    return tuple(files)


def write(file: Path, writer: Callable[[Path], None]) -> None:
    """Write a file with a function that takes its path.

    Raises
    ------
    WriteError
        If the system refuses; one line that names the file.
    """
    try:
        writer(file)
    except OSError as error:
        raise WriteError(f"{file}: cannot be written ({error.strerror or error})") from None
