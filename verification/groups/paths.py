"""Group 5: states depend neither on the seed nor on the path, and wrinkles come without a jump."""

from pathlib import Path

import numpy as np

from verification.tools import seeding, tracing
from verification.checks import Check, Group, write
from verification.tools.seeding import SIZES, Found, minima
from verification.tools.sheets import LATEX, PARITIES, THICKNESS, parts, planar_state, quarter, wrinkled
from verification.tools.tracing import MESH, STARTS, Landau, Traced, landau, slopes, traced
from wrinklestudy.equilibrium import continuation, flat, stability
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.planar import solve as solve_planar
from wrinklestudy.study.figures import style

THIN, THIN_MESH, THIN_STRAIN = 5.0e-4, (12, 24), 0.1
SEED_STRAINS = (0.06, 0.12, 0.3)


def from_seeds() -> list[Found]:
    """Return the minima from many seeds of the default and of a thinner sheet."""
    found = []
    for mesh, thickness, strains, sizes, count in (
        (MESH, THICKNESS, SEED_STRAINS, SIZES, 8),
        (THIN_MESH, THIN, (THIN_STRAIN,), (1.0,), 16),
    ):
        space = quarter(*mesh, thickness=thickness)
        for strain in strains:
            known = flat.solve(space, LATEX.law, strain)
            for parity in PARITIES:
                planar = planar_state(known, LATEX, PlanarSettings(parity=parity, modes=count))
                found.append(minima(planar, thickness, sizes))
    return found


def quick() -> list[Check]:
    """Return the cheap checks: a few seeds and a short branch on a coarse mesh."""
    space = quarter(8, 14)
    planar = solve_planar(space, LATEX, 0.12)
    found = minima(planar, THICKNESS, (1.0,))
    start = wrinkled(planar, THICKNESS)
    short = continuation.trace(
        start, (0.0, 0.2), options=continuation.ContinuationOptions(step=0.4, max_points=3)
    )
    last, position = short.points[-1], short.positions[-1]
    alone = wrinkled(solve_planar(space, LATEX, last.strain), THICKNESS)
    there = parts(alone).position
    return [
        *seeding.checks(found),
        Check(
            f"short branch to strain {last.strain:.4f}: energy",
            last.energy,
            alone.energy,
            seeding.AGREE,
            reason="the state at that strain found on its own",
        ),
        Check(
            f"short branch to strain {last.strain:.4f}: largest difference of the dofs in t",
            float(np.abs([*(position - there)[:2], np.abs(position[2]) - np.abs(there[2])]).max())
            / THICKNESS,
            1e-6,
            kind="at most",
            reason="the state at that strain found on its own",
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


def _text(runs: list[Traced], rows: dict[str, list[Landau]], found: list[Found]) -> str:
    thin = [f for f in found if f.thickness == THIN]
    stiff = [row.quartic for group in rows.values() for row in group]
    down, up = rows["downward"], rows["upward"]
    rise, fall = (slopes(group)[0] for group in (down, up))
    kinds = ["supercritical" if inside > 0 else "subcritical" for inside in (rise, -fall)]
    minima_found = sorted({f.distinct for f in found})
    return (
        f"Each state is found from its flat state alone. From {sum(len(f.states) for f in found)} "
        f"seeds (single modes of several sizes, random mixes) at {len(found)} sheets and strains, "
        f"the number of different minima within a parity is "
        f"{' or '.join(map(str, minima_found))}; at t/W = {THIN:g} the flat sheet has "
        f"{' and '.join(str(f.unstable) for f in thin)} unstable modes. The two parities are two "
        "states of nearly the same energy: the table lists both, and the group on the whole sheet "
        "says which is stable.\n\n"
        f"A continuation upward from strain {STARTS['upward']:g} and one downward from "
        f"{STARTS['downward']:g} pass through the same states as those found one by one. The "
        f"special points on them are {'; '.join(k for r in runs for k, _ in r.branch.special)}. "
        f"Birth is {kinds[0]}, decay {kinds[1]}: A^2 is linear in the strain with slope "
        f"{rise:.3g} and {fall:.3g} (in t^2), as the reduced energy says, whose quartic "
        f"coefficient G_11 lies between {min(stiff):.2e} and {max(stiff):.2e}: positive means that "
        "wrinkles grow from zero and nothing jumps. Meshes: "
        f"{MESH[0]} x {MESH[1]} and {THIN_MESH[0]} x {thin[0].planar.grid.cells[1]} cells (the "
        "question does not need finer ones)."
    )


def run(output: Path) -> None:
    """Compute the group and write it with its plot."""
    output = Path(output)
    runs, found = [traced(name) for name in STARTS], from_seeds()
    rows = {one.name: landau(one) for one in runs}
    curve = stability.critical_curve(quarter(*MESH), LATEX, PlanarSettings())
    ends = stability.find(curve, THICKNESS)
    roots = {"upward": ends.decay_strain, "downward": ends.birth_strain}
    checks: list[Check] = []
    for one in runs:
        root = roots[one.name]
        expected = float("nan") if root is None else root
        checks += tracing.checks(one, expected, rows[one.name])
    checks += [check for one in found for check in seeding.checks(one)]
    plot = output.with_name("paths_branches.png")
    _plot(runs, rows, plot)
    tables = (tracing.branch_table(runs), tracing.landau_table(rows), seeding.table(found))
    caption = "Branches upward and downward; squares of the amplitude at birth and decay"
    title = "No dependence on path or seed"
    write(
        Group("paths", title, _text(runs, rows, found), checks, tables, ((plot.name, caption),)),
        output,
    )
