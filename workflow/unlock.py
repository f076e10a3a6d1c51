"""Remove the lock that a run of this folder left behind when it was killed.

Snakemake locks the folder for a run. A run that ends by kill -9, for lack of memory or with its
terminal leaves the lock, and every later run stops at it. ``make`` calls this before each run; with
snakemake itself: ``.venv/bin/python workflow/unlock.py``. A lock is left alone as long as any
snakemake process of this machine works in the folder.
"""

import sys
from pathlib import Path

import psutil


def holders(folder: Path) -> list[int]:
    """Return the snakemake processes that work in a folder."""
    running = []
    for process in psutil.process_iter(["pid", "cmdline", "cwd"]):
        command, cwd = process.info["cmdline"], process.info["cwd"]
        if not command or not cwd or Path(cwd) != folder:
            continue
        if any(Path(argument).name == "snakemake" for argument in command):
            running.append(process.info["pid"])
    return sorted(running)


def unlock(folder: Path) -> str | None:
    """Remove the locks of a folder that no process holds; return who holds them, if any does."""
    locks = sorted((folder / ".snakemake" / "locks").glob("*.lock"))
    if not locks:
        return None
    if running := holders(folder):
        return f"{folder}: snakemake runs here already (process {running[0]}); wait or stop it"
    for lock in locks:
        lock.unlink(missing_ok=True)
    print(f"{folder}: the last run was killed; its lock is removed", file=sys.stderr)
    return None


if __name__ == "__main__":
    sys.exit(unlock(Path.cwd().resolve()))
