"""Files that commands write: which suffixes they may have, and what is there already."""

import argparse
from collections.abc import Collection
from pathlib import Path

PICTURES = (".png", ".pdf", ".svg")


def add_overwrite(parser: argparse.ArgumentParser) -> None:
    """Add the option that allows to replace files."""
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")


def check_output(option: str, text: str, suffixes: Collection[str], overwrite: bool) -> Path:
    """Return the path of a file to write, before any work is done for it.

    Raises
    ------
    ValueError
        If its suffix is not allowed, it exists and is not to be replaced, or its folder does not
        exist; one line that names the option.
    """
    path = Path(text).expanduser()
    if path.suffix.lower() not in suffixes:
        raise ValueError(f"{option} = {text}: must end in {', '.join(suffixes)}")
    if path.is_dir():
        raise ValueError(f"{option} = {text}: is a folder")
    if path.exists() and not overwrite:
        raise ValueError(f"{option} = {text}: exists; --overwrite replaces it")
    if not path.parent.is_dir():
        raise ValueError(f"{option} = {text}: there is no folder {path.parent}")
    return path
