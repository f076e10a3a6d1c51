"""States of one sheet, solved by this process or by several, and the files of each."""

import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from wrinklestudy.cli.outputs import write
from wrinklestudy.cli.processes import in_processes
from wrinklestudy.cli.progress import SolveProgress, StatusLine
from wrinklestudy.cli.sheet_options import GivenSize

if TYPE_CHECKING:
    from wrinklestudy.equilibrium.newton import Observer
    from wrinklestudy.results.solved import State
    from wrinklestudy.sheet import Sheet

# Samples of a VTU file over the length and width, if the cells do not give more by themselves.
_VTU_SAMPLES = (190, 290)


class StrainTask(Protocol):
    """Something to compute of a sheet at a strain."""

    @property
    def sheet(self) -> "Sheet":
        """The sheet."""

    @property
    def strain(self) -> float:
        """Strain of the clamps."""


@dataclass(frozen=True)
class Task:
    """A strain to solve, and the files to write of its state."""

    sheet: "Sheet"
    size: GivenSize
    strain: float
    vtu: Path | None
    picture: Path | None


def solve_all(
    work: Callable[..., dict[str, Any]], tasks: Sequence[StrainTask], jobs: int
) -> list[dict[str, Any]]:
    """Return the values of all states, in the order of the tasks.

    Parameters
    ----------
    work : callable
        Returns the values of a state from its task and an observer, which may be left out.
    tasks : sequence of StrainTask
    jobs : int
        How many are computed at the same time.

    Raises
    ------
    MemoryError
        If one of several processes was killed, which is what systems do where memory is short.
    """
    if jobs == 1 or len(tasks) == 1:
        return [_shown(work, task, k, len(tasks)) for k, task in enumerate(tasks, 1)]
    return list(_parallel(work, tasks, min(jobs, len(tasks))))


def _parallel(
    work: Callable[..., dict[str, Any]], tasks: Sequence[StrainTask], jobs: int
) -> Iterator[dict[str, Any]]:
    """Yield the values of the states that several processes solve."""
    for k, values in enumerate(in_processes(work, tasks, jobs), 1):
        _announce(tasks[k - 1].strain, k, len(tasks))
        yield values


def _announce(strain: float, k: int, count: int) -> None:
    if not sys.stderr.isatty() or count > 1:
        print(f"strain {strain:.12g} ({k} of {count})", file=sys.stderr)


def _shown(
    work: Callable[..., dict[str, Any]], task: StrainTask, k: int, count: int
) -> dict[str, Any]:
    """Solve in this process and show how it goes on."""
    _announce(task.strain, k, count)
    line = StatusLine()
    label = f"strain {task.strain:.12g}"
    try:
        return work(task, SolveProgress(label, task.sheet.size, task.sheet.thickness, line))
    finally:
        line.clear()


@cache
def kept(sheet: "Sheet") -> "Sheet":
    """Return the first of equal sheets: its mesh and orderings serve all strains of a process."""
    return sheet


def solve(task: Task, observer: "Observer | None" = None) -> dict[str, Any]:
    """Return the values of a state and write its files, none where it did not converge."""
    sheet = kept(task.sheet)
    state = sheet.solve(task.strain, observer=observer)
    if state.measures is not None:
        if task.vtu is not None:
            write(task.vtu, lambda path: _write_vtu(sheet, state, task.size, path))
        if task.picture is not None:
            write(task.picture, lambda path: _write_picture(sheet, state, task.size, path))
    return values_of(state, task.size)


def values_of(state: "State", size: GivenSize) -> dict[str, Any]:
    """Return the numbers of a state, besides in mm and N where the size is known."""
    values, measures = state.as_dict(), state.measures
    values["crests_and_troughs"] = None if measures is None else len(measures.extrema)
    if size.width_mm is None:
        return values
    values["clamps_mm"] = size.clamps_mm(state.strain)
    lengths = {
        "amplitude_mm": ("amplitude_over_thickness", size.thickness * size.width_mm),
        "amplitude_low_mm": ("amplitude_low", size.thickness * size.width_mm),
        "amplitude_high_mm": ("amplitude_high", size.thickness * size.width_mm),
        "wavelength_mm": ("wavelength_over_width", size.width_mm),
        "arc_width_mm": ("arc_width_over_width", size.width_mm),
        "projected_width_mm": ("projected_width_over_width", size.width_mm),
        "force_n": ("nominal_stress_pa", 1e-6 * size.thickness * size.width_mm**2),
    }
    for name, (ratio, scale) in lengths.items():
        if ratio not in values:  # only of sheets without mirrors
            continue
        values[name] = None if values[ratio] is None else scale * values[ratio]
    return values


def _write_vtu(sheet: "Sheet", state: "State", size: GivenSize, path: Path) -> None:
    from wrinklestudy.mechanics.section import Section
    from wrinklestudy.metrics.stress import sampled_stress
    from wrinklestudy.results.vtu import write_vtu

    section = Section(sheet.material.law, sheet.thickness, sheet.bending)
    cells = sheet.space.grid.cells
    along, across = (max(2, s // (2 * n)) for s, n in zip(_VTU_SAMPLES, cells, strict=True))
    sampled = sampled_stress(state.shape, section, (along, across))
    write_vtu(sampled, sheet.material.shear_modulus, path, size.unit)


def _write_picture(sheet: "Sheet", state: "State", size: GivenSize, path: Path) -> None:
    from wrinklestudy.study.figures import one_sheet, style

    with style.applied():
        pictured = pictured_sheet(sheet, size)
        style.save(one_sheet.draw_state(pictured, state.strain, state.shape), path)


def pictured_sheet(sheet: "Sheet", size: GivenSize) -> Any:
    """Return what pictures say of a sheet."""
    from wrinklestudy.mechanics.laws import describe
    from wrinklestudy.study.figures.one_sheet import PicturedSheet

    law = str(describe(sheet.material)["law"])
    return PicturedSheet(sheet.aspect, sheet.thickness, law, size.unit)
