"""Group 4: whether wrinkled states are stable in the whole sheet, sliding included."""

from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools import mirrors
from verification.tools.mirrors import SLIDING, name
from verification.tools.sheets import LATEX, PARITIES, THICKNESS, amplitude, energy_below
from verification.tools.sliding import (
    FINER,
    MESH,
    SPECTRA,
    STRAINS,
    Pair,
    ParityPairs,
    parity_pairs,
)
from wrinklestudy.equilibrium.mirror_stability import CLASSES, ClassStability
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath

DIFFERENCES = (0.026, 0.2)  # energies differ by more than their rounding between these strains
DEFAULT_ACROSS = MeshSettings().cells_across
EXCHANGE_BAR = 2e-3  # of a strain of exchange, between the two finest meshes
_NEGLIGIBLE = 1e-4  # of the energy saved: less than any experiment could place a pattern by
_SHEET_METRES = 0.14  # W of the sheet of Panaitescu et al.


def windows(roots: Sequence[float], stable_first: bool) -> list[str]:
    """Return the ranges of strain in which a state is stable, between the roots of mu."""
    marks = ["birth", *(f"{root:.3f}" for root in roots), "decay"]
    return [f"{a} to {b}" for a, b in pairwise(marks)][not stable_first :: 2]


def quick() -> list[Check]:
    """Return the cheap checks: the splitting into classes on a coarse mesh."""
    return mirrors.checks()


def _others(done: ParityPairs, which: int) -> list[ClassStability]:
    """Return the stability of one parity outside sliding, at all strains."""
    return [c for pair in done.pairs for c in pair.classes[which] if c[:2] != SLIDING]


def _single(done: ParityPairs) -> int:
    """Return at how many strains exactly one parity is stable to sliding."""
    return sum(sum(c.unstable for c in pair.sliding) == 1 for pair in done.pairs)


def _stability_checks(done: ParityPairs) -> list[Check]:
    others = [_others(done, k) for k in (0, 1)]
    stiffest = [c.softest for group in others for c in group if not np.isnan(c.softest)]
    cells = f"{MESH[0]} x {MESH[1]} cells"
    return [
        *(
            Check(
                f"{parity}, {cells}: unstable directions outside sliding, all strains",
                sum(c.unstable for c in group),
                0.0,
                kind="at most",
                reason="a state that was computed must be a minimum in the three other classes",
            )
            for parity, group in zip(PARITIES, others, strict=True)
        ),
        Check(
            f"smallest eigenvalue outside sliding at strains {', '.join(map(str, SPECTRA))}",
            min(stiffest),
            0.05,
            kind="at least",
            reason="far from zero: the verdict does not depend on rounding or on the mesh",
        ),
        Check(
            "strains at which exactly one parity is stable to sliding",
            _single(done),
            len(done.pairs),
            kind="absolute",
            reason="the energy E_a + (E_s - E_a) sin^2 p has one minimum for each half wave",
        ),
    ]


def _sliding_checks(done: ParityPairs) -> list[Check]:
    ratios = [abs(sum(p.softest)) / max(map(abs, p.softest)) for p in done.pairs]
    low, high = DIFFERENCES
    errors = [
        abs(predicted / pair.difference - 1.0)
        for pair in done.pairs
        if low <= pair.strain <= high
        for predicted in pair.predicted
    ]
    return [
        Check(
            "eigenvalues of the two parities: largest |mu_a + mu_s| / max |mu|",
            max(ratios),
            0.1,
            kind="at most",
            reason="opposite where the energy has one harmonic; a mesh that pins the pattern adds "
            "the same to both",
        ),
        Check(
            f"E_s - E_a from mu t^3 w.B w / 2, strains {low:g} to {high:g}: largest deviation",
            max(errors),
            0.06,
            kind="at most",
            reason="inertia and energies of states that were computed one by one tell the same",
        ),
        Check(
            "exchange of stability: antisymmetric against symmetric, largest difference",
            float(np.max([abs(a - s) for a, s, _ in done.roots])),
            1e-3,
            kind="at most",
            reason="both change their sign where E_s = E_a",
        ),
        Check(
            f"exchange of stability: {MESH[1]} against {FINER[1]} cells across, largest difference",
            _shift(done),
            EXCHANGE_BAR,
            kind="at most",
            reason="converged with the mesh",
        ),
    ]


def _table(done: ParityPairs) -> Table:
    rows = []
    for pair in done.pairs:
        gain = energy_below(pair.states[0])
        stable = [k for k in (0, 1) if sum(c.unstable for c in pair.classes[k]) == 0]
        rows.append(
            [
                f"{pair.strain:g}",
                *(f"{amplitude(state):.4f}" for state in pair.states),
                *(" ".join(str(c.unstable) for c in group) for group in pair.classes),
                *(f"{mu:.2e}" for mu in pair.softest),
                f"{pair.difference / gain:.1e}",
                f"{pair.predicted[0] / gain:.1e}",
                " and ".join(PARITIES[k] for k in stable) or "none",
            ]
        )
    return Table(
        f"Both parities at t/W = {THICKNESS:g}, {MESH[0]} x {MESH[1]} cells. Unstable directions "
        f"in the classes {'; '.join(map(name, CLASSES))}; mu of the second class; E_s - E_a in "
        "parts of the energy that wrinkles save, from the energies (rounding shows beyond strain "
        f"{DIFFERENCES[1]:g}) and from mu_a",
        [
            "strain", "A/t a", "A/t s", "unstable a", "unstable s", "mu a", "mu s",
            "E_s - E_a", "predicted", "stable in the whole sheet",
        ],
        rows,
    )  # fmt: skip


def _mesh_table(done: ParityPairs) -> Table:
    meshes: dict[tuple[int, int], Sequence[Pair]] = {**done.coarser, MESH: done.pairs}
    rows = []
    for k, strain in enumerate(STRAINS):
        row = [f"{strain:g}"]
        for pairs in meshes.values():
            row += [f"{mu:.1e}" for mu in pairs[k].softest]
        rows.append(row)
    columns = [f"{a} x {b}: mu {p}" for a, b in meshes for p in "as"]
    return Table("Sliding on coarser meshes", ["strain", *columns], rows)


def _roots_table(done: ParityPairs) -> Table:
    return Table(
        "Strains at which the two parities exchange stability",
        [*(f"{p}, {MESH[0]} x {MESH[1]}" for p in PARITIES), f"{FINER[0]} x {FINER[1]}"],
        [[f"{value:.4f}" for value in row] for row in done.roots],
    )


def _pinned(done: ParityPairs) -> dict[tuple[int, int], list[float]]:
    """Return for each coarser mesh the strains whose signs differ from those of the fine mesh."""
    return {
        mesh: [
            p.strain
            for p, q in zip(pairs, done.pairs, strict=True)
            if any(a * b < 0 for a, b in zip(p.softest, q.softest, strict=True))
        ]
        for mesh, pairs in done.coarser.items()
    }


def _plot(done: ParityPairs, path: Path) -> None:
    with style.applied():
        figure, axes = style.panel(style.WIDE, 8.0)
        meshes: dict[tuple[int, int], Sequence[Pair]] = {**done.coarser, MESH: done.pairs}
        for look, (mesh, pairs) in zip(style.ordered(3), meshes.items(), strict=True):
            for which, line in ((0, "-"), (1, "--")):
                axes.plot(
                    [pair.strain for pair in pairs],
                    [pair.softest[which] for pair in pairs],
                    line,
                    color=look.color,
                    marker=look.marker,
                    label=f"{PARITIES[which]}, {mesh[0]} x {mesh[1]} cells",
                )
        axes.axhline(0.0, color=style.GREY, linewidth=0.6)
        for root, *_ in done.roots:
            axes.axvline(root, color=style.GREY, linewidth=0.6, linestyle=":")
        axes.set_yscale("symlog", linthresh=1e-9)
        axes.set_xlabel("strain")
        axes.set_ylabel("softest eigenvalue against sliding")
        style.grow(figure, style.legend_above(axes, columns=3))
        style.save(figure, path)


def windows_text(stable: Sequence[str], single: int, count: int) -> str:
    """Say where each parity is stable, and whether always exactly one is.

    Parameters
    ----------
    stable : (str, str)
        Ranges of strain of both parities; empty where there is none.
    single, count : int
        Strains at which exactly one is stable, and all strains.
    """
    places = [
        conclusion(bool(where), f"stable in the whole sheet for strains {where}", "nowhere stable")
        for where in stable
    ]
    return (
        conclusion(
            single == count,
            f"Exactly one parity is stable there at all {count} strains.",
            f"Exactly one parity is stable there at only {single} of {count} strains.",
        )
        + f" **Antisymmetric: {places[0]}. Symmetric: {places[1]}.**"
    )


def barrier_text(relative: Sequence[float], strain: float, joules: float) -> str:
    """Say how flat the energy is to sliding, and what that means for an experiment."""
    return (
        f"from strain {strain:g} on the two parities differ by {min(relative):.0e} to "
        f"{max(relative):.0e} of the energy that the wrinkles save. For the sheet of the paper the "
        f"largest barrier is {joules:.0e} J. "
        + conclusion(
            max(relative) < _NEGLIGIBLE,
            "In an experiment imperfections, not this energy, will place the pattern (an "
            "inference: no imperfection was computed).",
            "Whether imperfections or this energy place the pattern in an experiment remains open.",
        )
    )


def mesh_text(
    pinned: dict[tuple[int, int], list[float]], default: Sequence[float], shift: float
) -> str:
    """Say what coarse meshes can tell of sliding, and whether the exchanges have converged.

    Parameters
    ----------
    pinned : dict
        Of each coarser mesh the strains whose signs differ from those of the finest.
    default : sequence of float
        The same of the mesh with as many cells across as the default mesh has.
    shift : float
        Largest change of a strain of exchange from `MESH` to `FINER`.
    """
    listed = "; ".join(
        f"{a} x {b}: {', '.join(f'{e:g}' for e in strains) or 'none'}"
        for (a, b), strains in pinned.items()
    )
    return (
        conclusion(
            any(pinned.values()),
            "Coarse meshes pin the pattern to their cells by more than the parities differ.",
            "The coarser meshes give the same signs.",
        )
        + f" Strains at which a sign differs from that of the {MESH[0]} x {MESH[1]} mesh: "
        f"{listed}. The default mesh has {DEFAULT_ACROSS} cells across: "
        + conclusion(
            bool(default),
            "it finds the states, but cannot tell at these strains which is stable to sliding.",
            "it tells which of the states is stable to sliding.",
        )
        + f" From {MESH[1]} to {FINER[1]} cells across the exchanges move by {shift:.0e} at most: "
        + conclusion(shift <= EXCHANGE_BAR, "they have converged.", "they have not converged.")
    )


def _text(done: ParityPairs) -> str:
    sliding = [abs(mu) for pair in done.pairs for mu in pair.softest]
    late = [p for p in done.pairs if p.strain >= SPECTRA[0]]
    relative = [abs(p.predicted[0]) / energy_below(p.states[0]) for p in late]
    stable = [
        "; ".join(windows([r[k] for r in done.roots], done.pairs[0].softest[k] > 0.0))
        for k in (0, 1)
    ]
    count = sum(c.unstable for k in (0, 1) for c in _others(done, k))
    joules = max(abs(p.predicted[0]) for p in late) * 4 * LATEX.shear_modulus * _SHEET_METRES**3
    pinned = _pinned(done)
    default = [e for (_, across), rows in pinned.items() if across == DEFAULT_ACROSS for e in rows]
    return (
        "A state has two mirrors. Perturbations fall into four classes, which keep or break each "
        f"of them. In three classes the states of {len(done.pairs)} strains have {count} unstable "
        "directions, both parities together. The fourth class, which keeps the mirror of x and "
        "breaks that of y, has the slide of the pattern across the sheet. Its eigenvalue, in units "
        f"of the bending stiffness of the flat state, lies between {min(sliding):.0e} and "
        f"{max(sliding):.0e} in size. {windows_text(stable, _single(done), len(done.pairs))} "
        "All of these states are minima within the quarter model, where sliding is excluded.\n\n"
        "The energy hardly changes as the pattern slides: "
        f"{barrier_text(relative, late[0].strain, joules)}\n\n"
        f"{mesh_text(pinned, default, _shift(done))}"
    )


def _shift(done: ParityPairs) -> float:
    """Return by how much the strains of exchange change on the finer mesh."""
    return float(np.max([abs(a - f) for a, _, f in done.roots]))


def run(output: AnyPath) -> None:
    """Compute the group and write it with its plot."""
    output = Path(output)
    done = parity_pairs()
    checks = [*quick(), *_stability_checks(done), *_sliding_checks(done)]
    plot = output.with_name("whole_sheet_sliding.png")
    _plot(done, plot)
    caption = "Softest eigenvalue against sliding; dotted: exchanges of stability"
    tables = (_table(done), _roots_table(done), _mesh_table(done))
    title = "Stability in the whole sheet"
    write(Group("whole_sheet", title, _text(done), checks, tables, ((plot.name, caption),)), output)
