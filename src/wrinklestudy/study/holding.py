"""One run at a time in a folder of results: who holds it, and what a dead run left.

A run holds a lock of the operating system on a file in the folder. It ends with the process,
however that ends, so that a lock is never stale. Snakemake's own locks are files that a killed run
leaves behind; they are removed by the run that holds the folder.
"""

import fcntl
import os
import platform
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import IO

from wrinklestudy.files.records import FOLDER

_RUNNING = ".running"
# Options with which Snakemake tells something and makes no file
_ASKS = re.compile(
    r"-[kpqrfF]*n\w*|-[DSVhlv]|--(dry-?run|lint|report|(detailed-)?summary|list|dag|d3dag|rulegraph"
    r"|filegraph|unlock|archive|delete|cleanup|conda|container|drop-metadata|generate|export|print-c"
    r"|help|version).*"
)


class FolderHeldError(ValueError):
    """Another run works in the folder, or no run can; one line that names the folder."""


def makes_files(words: Sequence[str]) -> bool:
    """Return whether a command line of Snakemake makes files, rather than asking for something."""
    return not any(_ASKS.fullmatch(word) for word in words)


def take_over(results: str, folders: Sequence[str]) -> IO[str]:
    """Hold a folder of results for this process, and say so if a dead one left its locks.

    Parameters
    ----------
    results : str
    folders : sequence of str
        Folders in which only a run that holds ``results`` writes.

    Returns
    -------
    file
        To be kept as long as the run; it stops with one line if another run holds the folder.
    """
    try:
        held = hold(results)
    except FolderHeldError as error:
        sys.exit(str(error))
    if remove_left_locks(Path(".snakemake"), folders):
        print(f"{results}: the last run was killed; this one goes on", file=sys.stderr)
    return held


def hold(results: str) -> IO[str]:
    """Hold a folder of results until the file that is returned is closed or the process ends.

    Raises
    ------
    FolderHeldError
        If another run holds it, or if it cannot be written.
    """
    file = Path(results, FOLDER, _RUNNING)
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        held = open(file, "a+", encoding="utf-8")  # noqa: SIM115 (open as long as the run)
    except OSError as error:
        raise FolderHeldError(f"{results}: cannot be written ({error.strerror})") from None
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        held.seek(0)
        holder = held.read().strip() or "another process"
        held.close()
        message = f"{results}: a run works here already ({holder}); wait for it or stop it"
        raise FolderHeldError(message) from None
    try:
        held.truncate(0)
        held.write(f"process {os.getpid()} on {platform.node()}\n")
        held.flush()
    except OSError as error:
        raise FolderHeldError(f"{results}: cannot be written ({error.strerror})") from None
    return held


def is_held(results: str) -> bool:
    """Return whether a run works in a folder of results; nothing is written."""
    try:
        with open(Path(results, FOLDER, _RUNNING), encoding="utf-8") as file:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except FileNotFoundError:
        return False
    except OSError:
        return True
    return False


def remove_left_locks(state: Path, folders: Sequence[str]) -> bool:
    """Remove Snakemake's locks on files below some folders, which the caller holds.

    Parameters
    ----------
    state : Path
        Snakemake's own folder.
    folders : sequence of str
        Folders of the study as they stand in paths.

    Returns
    -------
    bool
        Whether there were any.
    """
    starts = tuple(f"{folder}/" for folder in folders)
    left = [
        lock
        for lock in sorted((state / "locks").glob("*.lock"))
        if any(line.startswith(starts) for line in lock.read_text(encoding="utf-8").splitlines())
    ]
    for lock in left:
        lock.unlink(missing_ok=True)
    return bool(left)
