"""Records: what a file of a study was made from, and its checksum.

The folders of results and of figures have a folder `FOLDER` with a record for each file. The record
of ``results/planar/latex/strain0.1.h5`` is ``results/.record/planar/latex/strain0.1.h5.json``: the
tables themselves stay plain CSV. Every reader of the files between the stages calls `check`
first, so that a damaged file is found before a number is taken from it.
"""

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from wrinklestudy.typing import AnyPath

FOLDER = ".record"
_AGAIN = "run the study again, it is then made anew"


class DamagedFileError(ValueError):
    """A file does not hold what was written; one line that names the file and what is wrong."""


@dataclass(frozen=True)
class Record:
    """What is known of a file.

    Parameters
    ----------
    made : mapping
        Program, stage, config, versions and machine; see `stages.recording`.
    inputs : mapping
        SHA-256 of each file that it was made from, by path.
    size : int
        Bytes of the file.
    sha256 : str
        SHA-256 of the file.
    """

    made: Mapping[str, Any]
    inputs: Mapping[str, str]
    size: int
    sha256: str

    def text(self) -> str:
        """Return the record's file, JSON with a checksum of its own."""
        content = {**vars(self), "made": dict(self.made), "inputs": dict(self.inputs)}
        checksum = hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
        return json.dumps(content | {"checksum": checksum}, sort_keys=True, indent=1) + "\n"


def file_digest(path: AnyPath) -> str:
    """Return the SHA-256 of a file."""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def record_of(path: AnyPath) -> Path | None:
    """Return the record of a file; None if no folder above the file has one."""
    file = Path(path)
    for root in file.parents:
        record = root / FOLDER / file.relative_to(root).with_name(f"{file.name}.json")
        if record.is_file():
            return record
    return None


def read_record(path: AnyPath) -> Record:
    """Read the file of a record.

    Raises
    ------
    DamagedFileError
        If it is not one that was written whole.
    """
    try:
        text = Path(path).read_text(encoding="utf-8")
        content = json.loads(text)
        del content["checksum"]
        record = Record(**content)
        whole = record.text() == text
    except (AttributeError, KeyError, TypeError, ValueError, RecursionError):
        whole = False
    if not whole:
        raise DamagedFileError(f"{os.fspath(path)}: damaged record; {_AGAIN}")
    return record


def damage(path: AnyPath, record: Record) -> str | None:
    """Return what is wrong with a file that is there; None if it is as it was written."""
    size = Path(path).stat().st_size
    if size != record.size:
        return f"has {size} bytes of {record.size}"
    if file_digest(path) != record.sha256:
        return "its bytes are not those that were written"
    return None


def check(path: AnyPath) -> None:
    """Compare a file with its record, if it has one.

    Raises
    ------
    DamagedFileError
        If they differ or the record is damaged.
    """
    record = record_of(path)
    if record is None or not Path(path).is_file():
        return
    fault = damage(path, read_record(record))
    if fault is not None:
        raise DamagedFileError(f"{os.fspath(path)}: damaged, {fault}; {_AGAIN}")
