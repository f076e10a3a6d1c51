"""`wrinklestudy provenance`: from what a file of a study was made."""

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from wrinklestudy.cli.output import Answer
from wrinklestudy.files.origin import embedded
from wrinklestudy.files.records import Record, damage, file_digest, read_record, record_of


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `run`."""
    parser.add_argument(
        "files",
        nargs="+",
        metavar="FILE",
        help="figure, table, state, mesh or material of a study (.pdf, .png, .csv, .h5, .vtu, ...)",
    )


def run(arguments: argparse.Namespace) -> Answer:
    """Return from what some files were made, and which of them are damaged.

    What a file has in itself goes with it wherever it is copied. Beside the results of a study is a
    record of each of its files, with the checksum and what it was made from.

    Raises
    ------
    ValueError
        If a file is missing or has no provenance; one line that names it.
    """
    answers = [_provenance(name) for name in arguments.files]
    failures = tuple(
        f"{answer['file']}: damaged, {answer['damage']}" for answer in answers if answer["damage"]
    )
    return Answer(answers, "\n".join(map(_text, answers)), failures)


def _provenance(name: str) -> dict[str, Any]:
    path = Path(name)
    if not path.is_file():
        raise ValueError(f"{name}: no such file")
    found = record_of(path)
    record = None if found is None else read_record(found)
    fault = None if record is None else damage(path, record)
    # nothing is read from a file that is known to be damaged
    made = record.made if record is not None else embedded(path)
    if made is None:
        raise ValueError(
            f"{name}: has no provenance: not made by a study of this program, or moved away from "
            "its record"
        )
    return {
        "file": name,
        "made": made,
        "mesh": None if fault else _mesh(path),
        "checked": record is not None,
        "damage": fault,
        "sources": {} if record is None else _sources(record),
    }


def _mesh(path: Path) -> str | None:
    """Return the cells of the mesh of a state."""
    if path.suffix != ".h5":
        return None
    from wrinklestudy.files.storage import read_h5

    datasets, _ = read_h5(path, ("grid/x", "grid/y"))
    along, across = (len(datasets[name]) - 1 for name in ("grid/x", "grid/y"))
    return f"{along} x {across} cells on the quarter sheet"


def _sources(record: Record) -> dict[str, dict[str, Any]]:
    """Return all files that a file comes from, with what their own records say, nearest first."""
    sources: dict[str, dict[str, Any]] = {}
    todo = dict(record.inputs)
    while todo:
        name, digest = next(iter(todo.items()))
        del todo[name]
        if name in sources:
            continue
        there = Path(name).is_file()
        unchanged = file_digest(name) == digest if there else None
        found = record_of(name) if unchanged else None
        upstream = None if found is None else read_record(found)
        made = None if upstream is None else upstream.made
        sources[name] = {"sha256": digest, "unchanged": unchanged, "made": made}
        todo |= {} if upstream is None else upstream.inputs
    return sources


def _text(answer: Mapping[str, Any]) -> str:
    lines = [f"{answer['file']}", *_made(answer["made"])]
    if answer["mesh"]:
        lines.append(f"mesh: {answer['mesh']}")
    if answer["checked"]:
        lines.append(f"checksum: {'as written' if answer['damage'] is None else 'damaged'}")
    for name, source in answer["sources"].items():
        state = {True: "unchanged", False: "changed since", None: "not here"}[source["unchanged"]]
        made = source["made"]
        how = "" if made is None else f": {_step(made)}, {_config(made)}code {made['code']}"
        lines.append(f"from {name} ({state}){how}")
    return "".join(f"{line}\n" for line in lines)


def _made(made: Mapping[str, Any]) -> list[str]:
    """Return the lines about one file."""
    versions = ", ".join(f"{name} {text}" for name, text in made["versions"].items())
    lines = [
        f"made by: {made['program']}, {_step(made)}, code {made['code']}",
        f"with: {versions}",
        f"on: {made['machine']}",
        f"config: {_config(made).removesuffix(', ')}",
    ]
    return lines + [f"{name}: {text}" for name, text in made.get("shown", {}).items() if text]


def _step(made: Mapping[str, Any]) -> str:
    """Return the stage of a study, or the command, that made a file."""
    return f"command {made['command']}" if "command" in made else f"stage {made['stage']}"


def _config(made: Mapping[str, Any]) -> str:
    return "".join(f"{name} = {value}, " for name, value in _flat("", made["config"]))


def _flat(prefix: str, values: Mapping[str, Any]) -> list[tuple[str, Any]]:
    """Return nested settings as pairs of a dotted name and a value, without those not given."""
    pairs = []
    for name, value in values.items():
        if isinstance(value, Mapping):
            pairs += _flat(f"{prefix}{name}.", value)
        elif value is not None:
            pairs.append((f"{prefix}{name}", value))
    return pairs
