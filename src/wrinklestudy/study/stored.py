"""The files that a study has already, compared with their records before anything runs.

A file that is not what its record says, that has no record, or that another version of the program
made without Snakemake knowing, must not be used: the workflow removes it and makes it again, as if
it had been lost.
"""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

from wrinklestudy.files.records import FOLDER, DamagedFileError, Record, damage, read_record
from wrinklestudy.results.paths import STAGES, Paths
from wrinklestudy.study.config import StudyConfig
from wrinklestudy.study.plan import files_of


class Unsound(NamedTuple):
    """A file that must not be used.

    Parameters
    ----------
    file, record : str
    fault : str
        What is wrong.
    """

    file: str
    record: str
    fault: str


def unsound_files(
    study: StudyConfig,
    paths: Paths,
    code_of: Callable[[str, str], str],
    remembered: Callable[[str], bool],
) -> list[Unsound]:
    """Return the files of a study that must not be used.

    Parameters
    ----------
    study : StudyConfig
    paths : Paths
    code_of : function
        Digest of the code that makes a file today, from stage and file.
    remembered : function
        Whether Snakemake knows how a file was made; it then runs by itself what has changed.
    """
    found: dict[str, Unsound] = {}
    records: dict[str, Record] = {}
    for file, path in _recorded(paths):
        fault = None
        try:
            records[file] = read_record(path)
            fault = damage(file, records[file])
        except DamagedFileError:
            fault = "its record is damaged"
        if fault is not None:
            found[file] = Unsound(file, path, f"damaged, {fault}")
    for stage in STAGES:
        for file in files_of(study, paths, stage):
            if file in found or not Path(file).is_file():
                continue
            if file not in records:
                found[file] = Unsound(file, paths.record(file), "no record says how it was made")
            elif not remembered(file) and (
                fault := _outdated(records[file], code_of(stage, file), found)
            ):
                found[file] = Unsound(file, paths.record(file), fault)
    return list(found.values())


def _outdated(record: Record, code: str, found: dict[str, Unsound]) -> str | None:
    """Return why a file is not what the program would make today; None if it is."""
    if record.made.get("code") != code:
        return f"made by {record.made.get('program')} with other code"
    outdated = [file for file in record.inputs if file in found and "made by" in found[file].fault]
    return found[outdated[0]].fault if outdated else None


def _recorded(paths: Paths) -> Iterator[tuple[str, str]]:
    """Yield each file that is there and has a record, with the path of the record."""
    for root in (paths.results, paths.figures):
        folder = Path(root, FOLDER)
        for record in sorted(folder.rglob("*.json")):
            below = record.relative_to(folder)
            file = Path(root, below.with_name(below.name.removesuffix(".json")))
            if file.is_file():
                yield file.as_posix(), record.as_posix()


def report(unsound: list[Unsound], what_happens: str) -> list[str]:
    """Return a line for each fault, with one of the files that have it and how many others do."""
    by_fault: dict[tuple[str, bool], list[str]] = {}
    for one in unsound:
        alone = one.fault.startswith("damaged")
        by_fault.setdefault((one.file if alone else one.fault, alone), []).append(one.file)
    faults = {one.file: one.fault for one in unsound}
    lines = []
    for files in by_fault.values():
        others = f" and {len(files) - 1} more" if files[1:] else ""
        lines.append(f"{files[0]}{others}: {faults[files[0]]}; {what_happens}")
    return lines
