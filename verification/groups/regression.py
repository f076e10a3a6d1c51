"""Group 7: whether numbers stay, and what repeats, threads and factorisation do to them."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np

from verification.checks import Check, Group, Table, write
from verification.golden import DEFAULT, DISCRETISATION, FINER, Golden, constants, numbers, read
from verification.tools.sheets import LATEX, THICKNESS, solved
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.sheet import Sheet
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath

GOLDEN = Path("verification/golden.csv")
MESH, STRAIN = (12, 18), 0.12
QUICK_MESH = (8, 14)
_THREADS = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS")
_NAMES = ("energy", "A/t", "Phi^2", "W_proj/W", "stress/mu", "tau_1/W")
_ROUNDING, _SOLVER = 1e-10, 1e-9
# Without pypardiso the library factorises with SuperLU; only the library sees that it is missing
_CHILD = (
    "import json, sys\n"
    "if {superlu}: sys.modules['pypardiso'] = None\n"
    "from verification.groups.regression import fingerprint\n"
    "print(json.dumps(fingerprint({mesh})))"
)


class Repeat(NamedTuple):
    """A way to compute the same state again."""

    name: str
    bound: float
    reason: str
    difference: float  # largest relative difference of the numbers


def fingerprint(mesh: tuple[int, int]) -> list[float]:
    """Return numbers of a wrinkled state with all digits: `_NAMES`, then |w| at every node."""
    state = Sheet(2.0, THICKNESS, LATEX, mesh=MeshSettings(*mesh)).solve(STRAIN)
    equilibrium, measures = state.equilibrium, state.measures
    modes = equilibrium.planar.modes
    if measures is None or modes is None:
        raise ArithmeticError(f"{state.status} {equilibrium.reason}")
    _, space, position = solved(equilibrium)
    deflection = np.abs(space.nodes_from_field(position)[2, 0]).ravel()
    return [
        equilibrium.energy,
        measures.amplitude / THICKNESS,
        measures.phi_squared,
        measures.projected_width,
        equilibrium.nominal_stress,
        modes.critical_thickness,
        *(deflection / THICKNESS).tolist(),
    ]


def _elsewhere(mesh: tuple[int, int], threads: int, superlu: bool = False) -> list[float]:
    """Return the fingerprint from a new process."""
    environment = os.environ | {name: str(threads) for name in _THREADS}
    code = _CHILD.format(superlu=superlu, mesh=mesh)
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False
    )
    if done.returncode:
        raise RuntimeError(f"new process, {threads} threads: {done.stderr.strip()}")
    values: list[float] = json.loads(done.stdout)
    return values


def difference(first: list[float], second: list[float]) -> float:
    """Return the largest difference: relative for `_NAMES`, in units of t for deflections."""
    a, b = np.array(first), np.array(second)
    scale = np.ones_like(a)
    scale[: len(_NAMES)] = np.abs(a[: len(_NAMES)])
    return float(np.max(np.abs(a - b) / scale))


def repeats(mesh: tuple[int, int]) -> list[Repeat]:
    """Return how much the numbers of one state differ between ways to compute it."""
    first = _elsewhere(mesh, 1)
    here = fingerprint(mesh)
    same = "bit for bit: nothing is random, nothing is left over from before"
    return [
        Repeat("twice in one process", 0.0, same, difference(here, fingerprint(mesh))),
        Repeat("two processes, one thread", 0.0, same, difference(first, _elsewhere(mesh, 1))),
        Repeat(
            "two BLAS threads against one",
            _ROUNDING,
            "sums in another order: rounding",
            difference(first, _elsewhere(mesh, 2)),
        ),
        Repeat(
            "SuperLU against PARDISO",
            _SOLVER,
            "another factorisation: rounding, and where the iterations stop",
            difference(first, _elsewhere(mesh, 1, superlu=True)),
        ),
    ]


def _repeat_checks(repeated: list[Repeat]) -> list[Check]:
    return [
        Check(
            f"{repeat.name}: largest difference",
            repeat.difference,
            repeat.bound,
            kind="at most",
            reason=repeat.reason,
        )
        for repeat in repeated
    ]


def quick() -> list[Check]:
    """Return the cheap checks: two processes and two threads, and the numbers without a mesh."""
    return [*_repeat_checks(repeats(QUICK_MESH)), *_golden_checks(constants(), read(GOLDEN))]


def _golden_checks(now: dict[str, float], known: dict[str, Golden]) -> list[Check]:
    return [
        Check(name, value, known[name].value, known[name].tolerance, "absolute", known[name].basis)
        if name in known
        else Check(name, float("nan"), float("nan"), reason=f"not in {GOLDEN}")
        for name, value in now.items()
    ]


def _golden_table(now: dict[str, float], known: dict[str, Golden]) -> Table:
    rows = []
    for name, value in now.items():
        kept = known.get(name, Golden(float("nan"), float("nan"), ""))
        moved = (value - kept.value) / kept.tolerance
        rows.append(
            [
                name,
                f"{value:.8g}",
                f"{kept.value:.8g}",
                f"{kept.tolerance:.1e}",
                f"{kept.tolerance / abs(kept.value):.1e}",
                f"{moved:.1e}",
                kept.basis,
            ]
        )
    return Table(
        "Golden numbers",
        ["number", "now", "golden", "tolerance", "relative", "moved by (tolerances)", "basis"],
        rows,
    )


def _plot(known: dict[str, Golden], path: Path) -> None:
    meshed = {name: kept for name, kept in known.items() if kept.basis == DISCRETISATION}
    relative = sorted((kept.tolerance / abs(kept.value), name) for name, kept in meshed.items())
    with style.applied():
        figure, axes = style.panel(style.WIDE, 11.0)
        axes.barh([name for _, name in relative], [part for part, _ in relative], color=style.BLUE)
        axes.set_xscale("log")
        axes.set_xlabel("error of the default mesh, in parts of the number")
        axes.tick_params(axis="y", labelsize="x-small", which="both", right=False)
        axes.minorticks_off()
        style.save(figure, path)


def _text(now: dict[str, float], known: dict[str, Golden], repeated: list[Repeat]) -> str:
    moved = max(abs(now[n] - kept.value) / kept.tolerance for n, kept in known.items() if n in now)
    meshed = [kept for kept in known.values() if kept.basis == DISCRETISATION]
    relative = [kept.tolerance / abs(kept.value) for kept in meshed]
    differences = "; ".join(f"{repeat.name}: {repeat.difference:.1e}" for repeat in repeated)
    return (
        f"{len(known)} numbers of the {DEFAULT[0]} x {DEFAULT[1]} mesh are kept in "
        f"`{GOLDEN.as_posix()}` (`python -m verification.golden FILE` makes it anew). "
        f"The tolerance of each is its difference to {FINER[0]} x {FINER[1]} cells, between "
        f"{min(relative):.1e} and {max(relative):.1e} of the number: a change of the code that "
        "moves one by more than refining the mesh does has changed the physics. Today the largest "
        f"move is {moved:.1e} tolerances.\n\n"
        f"The same state computed again on a {MESH[0]} x {MESH[1]} mesh, largest difference of "
        f"{', '.join(_NAMES)} (relative) and of the deflection of every node (in t): {differences}."
    )


def run(output: AnyPath) -> None:
    """Compute the group and write it with its plot; reads `GOLDEN` from the project's folder."""
    output = Path(output)
    known, repeated = read(GOLDEN), repeats(MESH)
    now = numbers(DEFAULT) | constants()
    gone = sorted(set(known) - set(now))
    checks = [
        *_golden_checks(now, known),
        Check(
            "golden numbers that are no longer computed",
            len(gone),
            0,
            kind="at most",
            reason=", ".join(gone) or "each must be compared",
        ),
        *_repeat_checks(repeated),
    ]
    plot = output.with_name("regression_tolerances.png")
    _plot(known, plot)
    group = Group(
        "regression",
        "Regression and determinism",
        _text(now, known, repeated),
        checks,
        (_golden_table(now, known),),
        ((plot.name, "Tolerances: the measured discretisation error of each number"),),
    )
    write(group, output)
