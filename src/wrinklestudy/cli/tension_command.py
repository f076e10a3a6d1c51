"""`wrinklestudy tension-field`: a sheet in the limit of no thickness, at one or more strains."""

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import TYPE_CHECKING, Any

from wrinklestudy.cli.material_options import add_material, model
from wrinklestudy.cli.numbers import number, numbers, values_within, whole_number
from wrinklestudy.cli.output import Answer, cell, table, wrapped
from wrinklestudy.cli.sentences import between, failures
from wrinklestudy.cli.sheet_options import add_cells, mesh_settings
from wrinklestudy.cli.solving import solve_all
from wrinklestudy.vocabulary import ASPECT, JOBS, STRAIN

if TYPE_CHECKING:
    from wrinklestudy.equilibrium.newton import Observer
    from wrinklestudy.sheet import Sheet

_State = Mapping[str, Any]


@dataclass(frozen=True)
class TensionTask:
    """A strain at which the tension field of a sheet is wanted."""

    sheet: "Sheet"
    strain: float


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    group = parser.add_argument_group("sheet", "it has no thickness; --strain is repeatable")
    group.add_argument("--aspect", type=number, help=f"L/W, {ASPECT}")
    group.add_argument(
        "--strain",
        type=numbers,
        action="append",
        help=f"(L' - L)/L, a number or start:stop:step, {STRAIN}",
    )
    add_material(parser)
    add_cells(parser)
    parser.add_argument(
        "--jobs", type=whole_number, default=1, help="strains that are solved at the same time"
    )


def run(arguments: argparse.Namespace) -> Answer:
    """Return the tension field at each strain."""
    if arguments.jobs not in JOBS:
        raise ValueError(f"--jobs = {arguments.jobs}: must be {JOBS}")
    for option in ("aspect", "strain"):
        if getattr(arguments, option) is None:
            raise ValueError(f"--{option}: missing")
    if arguments.aspect not in ASPECT:
        raise ValueError(f"--aspect = {arguments.aspect:g}: must be {ASPECT}")
    strains = values_within("--strain", arguments.strain, STRAIN)
    chosen = _sheet(arguments, min(arguments.jobs, len(strains)))
    tasks = [TensionTask(chosen, strain) for strain in strains]
    states = solve_all(tension_values, tasks, arguments.jobs)
    return Answer(states, _text(states), tuple(failures(states)))


def _sheet(arguments: argparse.Namespace, jobs: int) -> "Sheet":
    """Return the sheet that the options describe, with a thickness that plays no role."""
    from wrinklestudy.equilibrium.tension_field import tension_grid
    from wrinklestudy.fem.grid import REFERENCE_THICKNESS
    from wrinklestudy.fem.size import ProblemSize
    from wrinklestudy.mechanics.relaxed import check_relaxed
    from wrinklestudy.sheet import Sheet

    aspect, mesh = arguments.aspect, mesh_settings(arguments)
    material = model(arguments).material
    check_relaxed(material.law)
    size = ProblemSize(*tension_grid(aspect, mesh).cells)
    size.check_memory(f"L/W = {aspect:g}", wrinkled=False, jobs=jobs)
    return Sheet(aspect, REFERENCE_THICKNESS, material, mesh=mesh)


def tension_values(task: TensionTask, observer: "Observer | None" = None) -> dict[str, Any]:
    """Return the values of the tension field at a strain."""
    return task.sheet.tension_field(task.strain, observer).as_dict()


def predicted_values(task: TensionTask, observer: "Observer | None" = None) -> dict[str, Any]:
    """Return what the tension field predicts of a thin sheet at a strain."""
    start = perf_counter()
    row = task.sheet.far_from_threshold(task.strain, observer)
    return row.shown() | {"seconds": perf_counter() - start}


def _text(states: Sequence[_State]) -> str:
    """Return in sentences where the sheet is wrinkled, and all states as a table."""
    converged = [state for state in states if state["status"] != "not-converged"]
    wrinkled = [state for state in converged if state["status"] == "wrinkled"]
    sentences = []
    limit = "In the limit of no thickness the sheet is"
    if wrinkled:
        sentences += [
            f"{limit} wrinkled at {len(wrinkled)} of {len(states)} strains{between(wrinkled)}.",
            _most(max(wrinkled, key=lambda state: state["phi_squared"])),
        ]
    elif converged:
        sentences.append(
            f"{limit} taut on both mid-lines at {len(converged)} of {len(states)} strains."
        )
    sentences += [
        f"At strain {state['strain']:.6g} {cell(state['remainder'])} of the energy is that of a "
        "sheet that does not wrinkle."
        for state in converged
        if state["remainder"] > 0.0
    ]
    sentences += [f"{failure}." for failure in failures(states)]
    columns = {
        "strain": "strain",
        "Phi^2": "phi_squared",
        "error": "phi_squared_error",
        "W_arc/W": "arc_width_over_width",
        "W_proj/W": "projected_width_over_width",
        "across": "wrinkled_width_over_width",
        "along": "wrinkled_length_over_length",
        "stress/Pa": "nominal_stress_pa",
    }
    rows = [
        [cell(state[name], 6 if name == "nominal_stress_pa" else 4) for name in columns.values()]
        for state in states
    ]
    return f"{wrapped(' '.join(sentences))}\n{table([*columns], rows)}"


def _most(state: _State) -> str:
    return (
        f"At strain {state['strain']:.6g} its wrinkles hide {cell(100.0 * state['phi_squared'])}% "
        f"of the width that is left in the middle, and reach over "
        f"{cell(100.0 * state['wrinkled_width_over_width'], 3)}% of the width and "
        f"{cell(100.0 * state['wrinkled_length_over_length'], 3)}% of the length."
    )
