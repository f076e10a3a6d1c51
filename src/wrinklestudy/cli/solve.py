"""`wrinklestudy solve`: the state of one sheet at one or more strains."""

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING

from wrinklestudy.cli.imperfection_options import add_imperfections
from wrinklestudy.cli.numbers import (
    NumberRange,
    numbers,
    range_values,
    values_within,
    whole_number,
)
from wrinklestudy.cli.output import Answer
from wrinklestudy.cli.outputs import add_overwrite, planned
from wrinklestudy.cli.sentences import failures, predictions_text, states_text
from wrinklestudy.cli.sheet_options import GivenSize, add_sheet, announce, given_size, sheet
from wrinklestudy.cli.solving import Task, solve, solve_all
from wrinklestudy.cli.tension_command import TensionTask, predicted_values
from wrinklestudy.vocabulary import JOBS, STRAIN, Limits

if TYPE_CHECKING:
    from wrinklestudy.sheet import Sheet


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    add_sheet(parser)
    add_imperfections(parser)
    group = parser.add_argument_group("strains", "repeatable; a number, or start:stop:step")
    group.add_argument("--strain", type=numbers, action="append", help=f"(L' - L)/L, {STRAIN}")
    group.add_argument(
        "--clamp-mm", type=numbers, action="append", help="distance L' of the clamps instead"
    )
    add = parser.add_argument
    add("--jobs", type=whole_number, default=1, help="strains that are solved at the same time")
    add(
        "--far-from-threshold",
        action="store_true",
        help="predict thin sheets from tension field theory instead of solving them",
    )
    add("--vtu", metavar="FILE.vtu", help="write the surface with its stresses, for ParaView")
    add("--picture", metavar="FILE", help="draw the sheet and its profile: .png, .pdf or .svg")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> Answer:
    """Return the states, and write the files that are asked for."""
    from wrinklestudy.results.cases import format_value
    from wrinklestudy.results.vtu import SUFFIXES as VTU
    from wrinklestudy.stages.figures import SUFFIXES as PICTURES

    if arguments.jobs not in JOBS:
        raise ValueError(f"--jobs = {arguments.jobs}: must be {JOBS}")
    size = given_size(arguments)
    strains = _strains(arguments, size)
    labels = [f"strain{format_value(strain)}" for strain in strains]
    if arguments.far_from_threshold:
        return _predicted(arguments, sheet(arguments, size), strains)
    overwrite = arguments.overwrite
    vtu = planned("--vtu", arguments.vtu, VTU, overwrite, labels)
    pictures = planned("--picture", arguments.picture, PICTURES, overwrite, labels)
    chosen = sheet(arguments, size)
    if vtu[0] is not None and not chosen.thickness_field.uniform:
        raise ValueError("--vtu: only of a sheet of uniform thickness")
    announce(chosen, jobs=min(arguments.jobs, len(strains)))
    tasks = [
        Task(chosen, size, *of_strain) for of_strain in zip(strains, vtu, pictures, strict=True)
    ]
    states = solve_all(solve, tasks, arguments.jobs)
    return Answer(states, states_text(states, size), tuple(failures(states)))


def _predicted(arguments: argparse.Namespace, chosen: "Sheet", strains: Sequence[float]) -> Answer:
    """Return what tension field theory predicts at each strain."""
    for option in ("vtu", "picture"):
        if getattr(arguments, option):
            raise ValueError(f"--{option}: not with --far-from-threshold, which solves no surface")
    tasks = [TensionTask(chosen, strain) for strain in strains]
    rows = solve_all(predicted_values, tasks, arguments.jobs)
    return Answer(rows, predictions_text(rows), tuple(failures(rows)))


def _strains(arguments: argparse.Namespace, size: GivenSize) -> list[float]:
    """Return the strains in the order given, each once."""
    if arguments.strain and arguments.clamp_mm:
        raise ValueError("--strain, --clamp-mm: give strains or distances, not both")
    if arguments.strain:
        return values_within("--strain", arguments.strain, STRAIN)
    if arguments.clamp_mm:
        if size.length_mm is None:
            raise ValueError("--clamp-mm: needs --length-mm, --width-mm and --thickness-mm")
        strains = [eps for entry in arguments.clamp_mm for eps in _of_clamps(entry, size.length_mm)]
        return list(dict.fromkeys(strains))
    raise ValueError("--strain: missing; give --strain or --clamp-mm")


def _of_clamps(entry: NumberRange, length: float) -> tuple[float, ...]:
    """Return the strains of clamps at distances, rounded to 12 digits."""
    from wrinklestudy.results.cases import canonical

    for clamps in entry[:2]:
        if (strain := clamps / length - 1.0) not in STRAIN:
            raise ValueError(
                f"--clamp-mm = {clamps:g}: strain {strain:.3g} of a length of {length:g} mm "
                f"must be {STRAIN}"
            )
    distances = range_values("--clamp-mm", entry, Limits(length, 2.0 * length))
    return tuple(canonical((clamps - length) / length) for clamps in distances)
