"""`wrinklestudy map`: the critical thickness of sheets over strain and L/W."""

import argparse
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from wrinklestudy.cli.material_options import add_material, model
from wrinklestudy.cli.numbers import numbers, values_within, whole_number
from wrinklestudy.cli.output import Answer, cell, table, wrapped
from wrinklestudy.cli.outputs import add_overwrite, planned, write
from wrinklestudy.cli.processes import in_processes
from wrinklestudy.cli.progress import StatusLine
from wrinklestudy.cli.sheet_options import add_bending, add_cells, mesh_settings
from wrinklestudy.vocabulary import ASPECT, JOBS, PARITIES, STRAIN

if TYPE_CHECKING:
    from wrinklestudy.fem.grid import MeshSettings
    from wrinklestudy.mechanics.laws import Material

LARGER, _BOTH = "larger", "both"


@dataclass(frozen=True)
class MapTask:
    """All strains of one L/W."""

    aspect: float
    strains: tuple[float, ...]
    material: "Material"
    bending: str
    mesh: "MeshSettings"
    parity: str


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    group = parser.add_argument_group("map", "repeatable; a number, or start:stop:step")
    group.add_argument("--aspect", type=numbers, action="append", help=f"L/W, {ASPECT}")
    group.add_argument("--strain", type=numbers, action="append", help=f"(L' - L)/L, {STRAIN}")
    add_material(parser)
    add_bending(parser)
    add = parser.add_argument
    add(
        "--parity",
        choices=(LARGER, _BOTH, *PARITIES),
        default=LARGER,
        help=f"of the wrinkles across the sheet; {LARGER}, the default: that of the thicker sheet",
    )
    add_cells(parser)
    add("--jobs", type=whole_number, default=1, help="L/W that are computed at the same time")
    add("--plot", metavar="FILE", help="draw contours of tau_1/W: .png, .pdf or .svg")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> Answer:
    """Return the critical thickness at each L/W and strain, and draw it if that is asked for."""
    from wrinklestudy.stages.figures import SUFFIXES

    if arguments.jobs not in JOBS:
        raise ValueError(f"--jobs = {arguments.jobs}: must be {JOBS}")
    for option in ("aspect", "strain"):
        if not getattr(arguments, option):
            raise ValueError(f"--{option}: missing")
    aspects = values_within("--aspect", arguments.aspect, ASPECT)
    strains = values_within("--strain", arguments.strain, STRAIN)
    (plot,) = planned("--plot", arguments.plot, SUFFIXES, arguments.overwrite, [""])
    if plot is not None and min(len(aspects), len(strains)) < 2:
        raise ValueError("--plot: contours need at least two L/W and two strains")
    chosen, mesh = model(arguments), mesh_settings(arguments)
    check_memory(max(aspects), mesh, min(arguments.jobs, len(aspects)))
    bending, parity = chosen.bending or arguments.bending, chosen.parity or arguments.parity
    tasks = [
        MapTask(aspect, tuple(strains), chosen.material, bending, mesh, parity)
        for aspect in aspects
    ]
    points = [point for points in computed(tasks, arguments.jobs) for point in points]
    if plot is not None:
        write(plot, lambda path: _draw(points, chosen.material, path))
    return Answer(points, _text(points), tuple(_failures(points)))


def check_memory(aspect: float, mesh: "MeshSettings", jobs: int) -> None:
    """Refuse L/W whose flat states the memory would not hold."""
    from wrinklestudy.equilibrium.critical_map import map_grid
    from wrinklestudy.fem.size import ProblemSize

    size = ProblemSize(*map_grid(aspect, mesh).cells)
    size.check_memory(f"L/W = {aspect:g}", wrinkled=False, jobs=jobs)


def computed(tasks: Sequence[MapTask], jobs: int) -> Iterator[list[dict[str, Any]]]:
    """Yield the points of each L/W and say on stderr which are done."""
    if jobs == 1 or len(tasks) == 1:
        for k, task in enumerate(tasks, 1):
            _announce(task.aspect, k, len(tasks))
            yield _shown(task, k, len(tasks))
        return
    for k, points in enumerate(in_processes(points_of, tasks, min(jobs, len(tasks))), 1):
        _announce(tasks[k - 1].aspect, k, len(tasks))
        yield points


def _announce(aspect: float, k: int, count: int) -> None:
    print(f"L/W {aspect:.12g} ({k} of {count})", file=sys.stderr)


def _shown(task: MapTask, k: int, count: int) -> list[dict[str, Any]]:
    line, place = StatusLine(), f"L/W {task.aspect:.12g} ({k} of {count})"
    try:
        return points_of(task, line, place)
    finally:
        line.clear()


def points_of(
    task: MapTask, line: StatusLine | None = None, place: str = ""
) -> list[dict[str, Any]]:
    """Return the points of one L/W in the order of the strains."""
    from wrinklestudy.equilibrium.critical_map import critical_states, map_grid
    from wrinklestudy.mechanics.laws import describe
    from wrinklestudy.results.maps import map_row

    def report(strain: float) -> None:
        if line is not None:
            line.show(f"{place}: strain {strain:.6g} is done")

    grid = map_grid(task.aspect, task.mesh)
    parities = [parity for parity in PARITIES if task.parity in (parity, LARGER, _BOTH)]
    states = critical_states(
        grid, task.material.law, task.strains, [task.bending], parities, report
    )
    if task.parity == LARGER:
        pairs = zip(states[::2], states[1::2], strict=True)
        states = [max(pair, key=lambda state: state.critical_thickness or -1.0) for pair in pairs]
    law = str(describe(task.material)["law"])
    points = [map_row(state, law, law, grid).shown() for state in states]
    return sorted(points, key=lambda point: task.strains.index(point["strain"]))


def _failures(points: Sequence[dict[str, Any]]) -> list[str]:
    return [
        f"L/W {point['aspect']:.6g}, {point['parity']}: {point['reason']}"
        for point in points
        if point["status"] == "not-converged"
    ]


def _text(points: Sequence[dict[str, Any]]) -> str:
    """Return in a sentence which is the thickest sheet that wrinkles, and all points as a table."""
    known = [point for point in points if point["status"] == "unstable"]
    sentences = ["No sheet wrinkles there."] if not known else []
    if known:
        most = max(known, key=lambda point: point["critical_thickness"])
        sentences.append(
            f"Sheets up to t/W = {cell(most['critical_thickness'])} wrinkle, the thickest at L/W = "
            f"{cell(most['aspect'])} and strain {cell(most['strain'])}."
        )
    sentences += [f"{failure}." for failure in _failures(points)]
    columns = {
        "L/W": "aspect",
        "strain": "strain",
        "tau_1/W": "critical_thickness",
        "parity": "parity",
        "half-waves": "half_waves",
        "x/L": "largest_at",
        "status": "status",
    }
    rows = [[point[name] for name in columns.values()] for point in points]
    return f"{wrapped(' '.join(sentences))}\n{table([*columns], rows)}"


def _draw(points: Sequence[dict[str, Any]], chosen: "Material", path: object) -> None:
    import pandas as pd

    from wrinklestudy.mechanics.laws import describe
    from wrinklestudy.study.figures import strain_map, style

    with style.applied():
        figure = strain_map.draw_one(
            strain_map.of_table(pd.DataFrame(points)),
            style.law_label(str(describe(chosen)["law"])),
        )
        style.save(figure, str(path))
