"""States of a sheet with their shapes, over the strains that its wrinkles live through."""

import argparse
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from wrinklestudy.cli.numbers import numbers, values_within, whole_number
from wrinklestudy.cli.sheet_options import announce
from wrinklestudy.cli.solving import kept, solve_all
from wrinklestudy.cli.stability import report_critical
from wrinklestudy.vocabulary import JOBS, STRAIN

if TYPE_CHECKING:
    from wrinklestudy.equilibrium.newton import Observer
    from wrinklestudy.equilibrium.ranges import Stability
    from wrinklestudy.metrics.interpolant import DeformedSheet
    from wrinklestudy.results.sheets import SheetStates
    from wrinklestudy.sheet import Sheet

_FLAT_RANGE = (0.02, 0.4)  # strains of a sheet that never wrinkles
_BEFORE, _BEYOND = 0.6, 1.06  # first and last strain over those of birth and decay
_CROWDING = 1.4  # exponent: more strains near birth, where wrinkles grow fast
_DIGITS = 3


@dataclass(frozen=True)
class ShapedTask:
    """A strain at which a sheet is wanted with its shape."""

    sheet: "Sheet"
    strain: float


def add_strains(parser: argparse.ArgumentParser) -> None:
    """Add the options that choose strains and how many are solved at the same time."""
    parser.add_argument(
        "--strain",
        type=numbers,
        action="append",
        help=f"(L' - L)/L, a number or start:stop:step, repeatable, {STRAIN}; by default from "
        "before the birth of the wrinkles to after their decay",
    )
    parser.add_argument(
        "--jobs", type=whole_number, default=1, help="strains that are solved at the same time"
    )


def given_strains(arguments: argparse.Namespace) -> list[float] | None:
    """Return the strains that the options give, sorted; None if they give none.

    Raises
    ------
    ValueError
        If one is not allowed, or the number of jobs; one line.
    """
    if arguments.jobs not in JOBS:
        raise ValueError(f"--jobs = {arguments.jobs}: must be {JOBS}")
    if not arguments.strain:
        return None
    return sorted(values_within("--strain", arguments.strain, STRAIN))


def shaped_states(
    chosen: "Sheet", strains: Sequence[float] | None, count: int, jobs: int
) -> tuple["SheetStates", tuple["DeformedSheet | None", ...]]:
    """Return the states of a sheet over its strains, and the shape of each.

    Parameters
    ----------
    chosen : Sheet
    strains : sequence of float or None
        Sorted; by default from before birth to after decay.
    count : int
        How many strains that default has.
    jobs : int
        How many are solved at the same time.
    """
    from wrinklestudy.results.peaks import sheet_row
    from wrinklestudy.results.rows import SheetIdentity, StabilityRow, columns, make_row
    from wrinklestudy.results.sheets import SheetStates

    announce(chosen, jobs=min(jobs, count if strains is None else len(strains)))
    limits = chosen.stability(report_critical)
    strains = default_strains(limits, count) if strains is None else strains
    tasks = [ShapedTask(bare(chosen), strain) for strain in strains]
    solved = solve_all(solve_shaped, tasks, jobs)
    rows = tuple(values["row"] for values in solved)
    identity = {name: getattr(rows[0], name) for name in columns(SheetIdentity)}
    unstable = make_row(StabilityRow, vars(limits) | identity, "sheet", "row")
    states = SheetStates(sheet_row(unstable, rows), rows)
    return states, tuple(values["shape"] for values in solved)


def bare(chosen: "Sheet") -> "Sheet":
    """Return an equal sheet without its mesh, for tasks: a mesh cannot go to other processes.

    In this process the mesh of the sheet given serves them all.
    """
    kept(chosen)
    return replace(chosen)


def solve_shaped(task: ShapedTask, observer: "Observer | None" = None) -> dict[str, Any]:
    """Return the row of a state and its shape, None where it did not converge."""
    state = kept(task.sheet).solve(task.strain, observer=observer)
    return {"row": state.row(), "shape": None if state.measures is None else state.shape}


def default_strains(limits: "Stability", count: int) -> list[float]:
    """Return strains from before the birth of the wrinkles to after their decay."""
    import numpy as np

    from wrinklestudy.equilibrium.ranges import LARGEST_STRAIN

    if limits.birth_strain is None:
        strains = np.linspace(*_FLAT_RANGE, count)
    else:
        last = limits.largest_strain
        if limits.decay_strain is not None:
            last = min(_BEYOND * limits.decay_strain, LARGEST_STRAIN)
        first = _BEFORE * limits.birth_strain
        strains = first + (last - first) * np.linspace(0.0, 1.0, count) ** _CROWDING
    rounded = {float(f"{strain:.{_DIGITS}g}") for strain in strains}
    return sorted(strain for strain in rounded if strain in STRAIN)
