"""Group 5: whether states depend on seed or path, and whether wrinkles come without a jump."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from verification.checks import Check, Group, conclusion, write
from verification.tools import seeding, tracing
from verification.tools.seeding import AGREE, SIZES, SeededMinima, minima
from verification.tools.sheets import (
    LATEX,
    PARITIES,
    THICKNESS,
    planar_state,
    quarter,
    solved,
    wrinkled,
)
from verification.tools.tracing import MESH, STARTS, Landau, Traced, landau, slopes, traced
from wrinklestudy.equilibrium import continuation, flat, stability
from wrinklestudy.equilibrium.critical_curve import critical_curve
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.planar import solve as solve_planar
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath

THIN, THIN_MESH, THIN_STRAIN = 5.0e-4, (12, 24), 0.1
SEED_STRAINS = (0.06, 0.12, 0.3)


def from_seeds() -> list[SeededMinima]:
    """Return the minima from many seeds of the default and of a thinner sheet."""
    cases = []
    for mesh, thickness, strains, sizes, count in (
        (MESH, THICKNESS, SEED_STRAINS, SIZES, 8),
        (THIN_MESH, THIN, (THIN_STRAIN,), (1.0,), 16),
    ):
        space = quarter(*mesh, thickness=thickness)
        for strain in strains:
            known = flat.solve(space, LATEX.law, strain)
            for parity in PARITIES:
                planar = planar_state(known, LATEX, PlanarSettings(parity=parity, modes=count))
                cases.append(minima(planar, thickness, sizes))
    return cases


def quick() -> list[Check]:
    """Return the cheap checks: a few seeds and a short branch on a coarse mesh."""
    space = quarter(8, 14)
    planar = solve_planar(space, LATEX, 0.12)
    seeded = minima(planar, THICKNESS, (1.0,))
    start = wrinkled(planar, THICKNESS)
    short = continuation.trace(
        start, (0.0, 0.2), options=continuation.ContinuationOptions(step=0.4, max_points=3)
    )
    last, position = short.points[-1], short.positions[-1]
    alone = wrinkled(solve_planar(space, LATEX, last.strain), THICKNESS)
    there = solved(alone).position
    return [
        *seeding.checks(seeded),
        Check(
            f"short branch to strain {last.strain:.4f}: energy",
            last.energy,
            alone.energy,
            seeding.AGREE,
            reason="the state at that strain, computed on its own",
        ),
        Check(
            f"short branch to strain {last.strain:.4f}: largest difference of the dofs in t",
            float(np.abs([*(position - there)[:2], np.abs(position[2]) - np.abs(there[2])]).max())
            / THICKNESS,
            1e-6,
            kind="at most",
            reason="the state at that strain, computed on its own",
        ),
    ]


def _plot(runs: list[Traced], rows: dict[str, list[Landau]], path: Path) -> None:
    with style.applied():
        figure = style.new(style.WIDE, 5.5)
        whole, *ends = figure.subplots(1, 3, width_ratios=(1.4, 1.0, 1.0))
        for run, look in zip(runs, style.looks(["a", "b"]), strict=True):
            strains = [p.strain for p in run.wrinkled]
            sizes = np.array([abs(p.amplitude) for p in run.wrinkled])
            options = {"color": look.color, "marker": look.marker, "linestyle": look.line}
            if run.name == "downward":  # hollow, so that both are seen
                options |= {"fillstyle": "none", "linestyle": "none"}
            whole.plot(strains, sizes, label=run.name, **options)
            for axes in ends:
                axes.plot(strains, sizes**2, **options)
        for axes, group in zip(ends, (rows["downward"], rows["upward"]), strict=True):
            strains = [row.strain for row in group]
            axes.plot(strains, [r.expected for r in group], color=style.BLACK, label="reduced")
            margin = 0.3 * max(np.ptp(strains), 1e-4)
            axes.set_xlim(min(strains) - margin, max(strains) + margin)
            axes.set_ylim(0.0, 1.2 * max(row.square for row in group))
            axes.set_xlabel("strain")
            axes.locator_params(axis="x", nbins=3)
            axes.legend()
        whole.set_xlabel("strain")
        whole.set_ylabel("largest |w| / t at the nodes")
        ends[0].set_ylabel("its square, near birth and decay")
        whole.legend()
        style.save(figure, path)


def minima_text(seeded: Sequence[SeededMinima]) -> str:
    """Say how many minima the seeds lead to, and how far the two parities are apart."""
    counts = sorted({case.distinct for case in seeded})
    gains = [case.gains[0] for case in seeded]
    # both parities of a sheet stand side by side
    apart = [abs(a / b - 1.0) for a, b in zip(gains[::2], gains[1::2], strict=True)]
    return (
        f"From {sum(len(case.states) for case in seeded)} seeds (single modes of several sizes, "
        f"random mixes) at {len(seeded)} sheets and strains, the number of different minima within "
        f"a parity is {' or '.join(map(str, counts))}: "
        + conclusion(
            counts == [1],
            "the state does not depend on the seed.",
            "the state depends on the seed.",
        )
        + f" The energies that the two parities save differ by {max(apart):.0e} at most: the table "
        "lists both, and the group on the whole sheet says which is stable."
    )


def same_text(runs: Sequence[Traced]) -> str:
    """Say whether the branches pass through the states that were computed one by one."""
    worst = max(max(run.energies, run.amplitudes) for run in runs)
    return (
        conclusion(
            worst <= AGREE,
            "pass through the same states as those computed one by one",
            "do not pass through the states computed one by one",
        )
        + f" (largest difference of energies, relative, and of A/t: {worst:.0e})"
    )


def onset_text(rise: float, fall: float, stiff: Sequence[float], folds: int) -> str:
    """Say how wrinkles come and go.

    Parameters
    ----------
    rise, fall : float
        Slopes of (A/t)^2 over strain at birth and at decay.
    stiff : sequence of float
        Quartic coefficients near both.
    folds : int
        On the branches.
    """
    kinds = [conclusion(s > 0.0, "supercritical", "subcritical") for s in (rise, -fall)]
    smooth = min(stiff) > 0.0 and folds == 0 and rise > 0.0 > fall
    return (
        f"Birth is {kinds[0]}, decay {kinds[1]}: the slope of A^2 over the strain is {rise:.3g} "
        f"and {fall:.3g} (in t^2). The quartic coefficient G_11 of the reduced energy lies between "
        f"{min(stiff):.2e} and {max(stiff):.2e}, and the branches have {folds} folds: "
        + conclusion(
            smooth,
            "wrinkles grow from zero and nothing jumps.",
            "wrinkles may come or go with a jump.",
        )
    )


def _text(runs: list[Traced], rows: dict[str, list[Landau]], seeded: Sequence[SeededMinima]) -> str:
    thin = [case for case in seeded if case.thickness == THIN]
    stiff = [row.quartic for group in rows.values() for row in group]
    rise, fall = (slopes(rows[name])[0] for name in ("downward", "upward"))
    special = [kind for run in runs for kind, _ in run.branch.special]
    return (
        f"Each state is computed from its flat state alone. {minima_text(seeded)} At t/W = "
        f"{THIN:g} the flat sheet has {' and '.join(str(case.unstable) for case in thin)} "
        "unstable modes.\n\n"
        f"A continuation upward from strain {STARTS['upward']:g} and one downward from "
        f"{STARTS['downward']:g} {same_text(runs)}. Their special points are: "
        f"{', '.join(special) or 'none'}. {onset_text(rise, fall, stiff, special.count('fold'))} "
        f"Meshes: {MESH[0]} x {MESH[1]} and {THIN_MESH[0]} x {thin[0].planar.grid.cells[1]} cells."
    )


def run(output: AnyPath) -> None:
    """Compute the group and write it with its plot."""
    output = Path(output)
    runs, seeded = [traced(name) for name in STARTS], from_seeds()
    rows = {branch.name: landau(branch) for branch in runs}
    curve = critical_curve(quarter(*MESH), LATEX, PlanarSettings())
    ends = stability.find(curve, THICKNESS)
    roots = {"upward": ends.decay_strain, "downward": ends.birth_strain}
    checks: list[Check] = []
    for branch in runs:
        root = roots[branch.name]
        expected = float("nan") if root is None else root
        checks += tracing.checks(branch, expected, rows[branch.name])
    checks += [check for case in seeded for check in seeding.checks(case)]
    plot = output.with_name("paths_branches.png")
    _plot(runs, rows, plot)
    tables = (tracing.branch_table(runs), tracing.landau_table(rows), seeding.table(seeded))
    caption = "Branches upward and downward; squares of the amplitude at birth and decay"
    text = _text(runs, rows, seeded)
    group = Group("paths", "Paths and seeds", text, checks, tables, ((plot.name, caption),))
    write(group, output)
