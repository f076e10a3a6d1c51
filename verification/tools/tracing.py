"""Branches over strain, against states computed one by one and against the reduced energy."""

from typing import NamedTuple

import numpy as np

from verification.checks import Check, Table
from verification.tools.seeding import AGREE
from verification.tools.sheets import LATEX, PARITIES, THICKNESS, amplitude_of, quarter, wrinkled
from wrinklestudy.equilibrium import continuation
from wrinklestudy.equilibrium.continuation import Branch, BranchPoint
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.planar import solve as solve_planar

MESH = (12, 18)
STARTS = {"upward": 0.03, "downward": 0.385}
EVERY = 5  # every how many points of a branch one is solved again on its own
_WIDE = (0.0, 1.0)
# A/t below which a state is so soft that the tolerance of the solver shows
_SOFT = 0.1
_NEAR = 0.5  # A/t below which amplitudes are compared to the reduced energy


class Traced(NamedTuple):
    """A branch, and how states computed on their own at some of its strains compare."""

    name: str
    branch: Branch
    energies: float  # largest relative difference
    amplitudes: float  # largest difference of A/t
    compared: int

    @property
    def wrinkled(self) -> list[BranchPoint]:
        """Points with wrinkles: the last one has none, or those of the opposite sign."""
        return list(self.branch.points[:-1])

    @property
    def end(self) -> float:
        """Strain at which the amplitude vanishes; NaN if it does not."""
        return next((e for kind, e in self.branch.special if kind == "vanishing"), float("nan"))


class Landau(NamedTuple):
    """Amplitude near birth or decay, from the reduced energy of the first mode."""

    strain: float
    square: float  # (A/t)^2 of the branch, at the nodes
    expected: float
    quartic: float  # G_11 of the reduced energy


def traced(name: str) -> Traced:
    """Follow a branch and solve some of its strains again from the flat state alone."""
    space = quarter(*MESH)
    start = wrinkled(solve_planar(space, LATEX, STARTS[name]), THICKNESS)
    branch = continuation.trace(start, _WIDE, upward=name == "upward")
    energies, amplitudes = [], []
    for k in range(1, len(branch.points) - 1, EVERY):
        point = branch.points[k]
        if point.amplitude < _SOFT:
            continue
        alone = wrinkled(solve_planar(space, LATEX, point.strain), THICKNESS)
        if alone.position is None:
            raise ArithmeticError(f"strain {point.strain:g}: no position")
        positions = (branch.positions[k], alone.position)
        values = [amplitude_of(space, position, PARITIES[0]) for position in positions]
        energies.append(abs(point.energy / alone.energy - 1.0))
        amplitudes.append(abs(values[0] - values[1]) / THICKNESS)
    return Traced(name, branch, max(energies), max(amplitudes), len(energies))


def landau(run: Traced) -> list[Landau]:
    """Compare the points of small amplitude to A^2 = max phi^2 (tau_1^2 - t^2) / (2 G_11)."""
    space = quarter(*MESH)
    rows = []
    for point in run.wrinkled:
        if abs(point.amplitude) > _NEAR:
            continue
        modes = solve_planar(space, LATEX, point.strain, PlanarSettings(modes=2)).modes
        if modes is None:
            raise ArithmeticError(f"strain {point.strain:g}: no modes")
        highest = np.abs(space.nodes_from_field(modes.shapes[0])[0]).max()
        stiff = float(modes.quartic[0, 0])
        square = (modes.squared[0] - THICKNESS**2) / (2.0 * stiff) * (highest / THICKNESS) ** 2
        rows.append(Landau(point.strain, point.amplitude**2, float(square), stiff))
    return rows


def slopes(group: list[Landau]) -> tuple[float, float]:
    """Return d(A/t)^2/deps of the branch and of the reduced energy, at the least amplitudes."""
    first, second = sorted(group, key=lambda row: row.square)[:2]
    run = second.strain - first.strain
    return (second.square - first.square) / run, (second.expected - first.expected) / run


def checks(run: Traced, root: float, rows: list[Landau]) -> list[Check]:
    """Return the checks of a branch that must end at a root of tau_1 = t."""
    kinds = [kind for kind, _ in run.branch.special]
    unstable = max(point.unstable for point in run.wrinkled)
    least = min(rows, key=lambda row: row.square)
    slope, expected = slopes(rows)
    return [
        Check(
            f"{run.name}: energy against states computed alone, {run.compared} strains",
            run.energies,
            AGREE,
            kind="at most",
            reason="the same equilibrium; relative",
        ),
        Check(
            f"{run.name}: A/t against states computed alone",
            run.amplitudes,
            AGREE,
            kind="at most",
            reason="the same equilibrium; absolute, in units of t",
        ),
        Check(
            f"{run.name}: strain where the amplitude vanishes",
            run.end,
            root,
            2e-5,
            "absolute",
            "root of tau_1(eps) = t from the flat states, known to 1e-5",
        ),
        Check(
            f"{run.name}: folds",
            kinds.count("fold"),
            0,
            kind="at most",
            reason="wrinkles come and go without a jump",
        ),
        Check(
            f"{run.name}: largest number of unstable directions within the parity",
            unstable,
            0,
            kind="at most",
            reason="no loss of stability between birth and decay",
        ),
        Check(
            f"{run.name}: A^2 over that of the reduced energy where it is least",
            least.square / least.expected,
            1.0,
            0.02,
            reason="A^2 = max phi^2 (tau_1^2 - t^2) / (2 G_11); bending in the quartic term, of "
            "order (t k)^2, is left out",
        ),
        Check(
            f"{run.name}: slope of (A/t)^2 over strain where the amplitude vanishes",
            slope,
            expected,
            0.02,
            reason="reduced energy; its sign makes the pitchfork supercritical",
        ),
        Check(
            f"{run.name}: smallest quartic coefficient G_11",
            min(row.quartic for row in rows),
            0.0,
            kind="more than",
            reason="positive: supercritical",
        ),
    ]


def landau_table(rows: dict[str, list[Landau]]) -> Table:
    """Return the squares of the amplitudes near birth and decay."""
    return Table(
        "Birth and decay: (A/t)^2 of the branches and of the reduced energy",
        ["end", "strain", "(A/t)^2", "reduced", "ratio", "G_11"],
        [
            [
                name,
                f"{row.strain:.6f}",
                f"{row.square:.4e}",
                f"{row.expected:.4e}",
                f"{row.square / row.expected:.4f}",
                f"{row.quartic:.3e}",
            ]
            for name, group in rows.items()
            for row in group
        ],
    )


def branch_table(runs: list[Traced]) -> Table:
    """Return the branches with their special points."""
    rows: list[list[str | int]] = [
        [
            run.name,
            f"{STARTS[run.name]:g}",
            len(run.branch.points),
            max(p.iterations for p in run.branch.points),
            "; ".join(f"{kind} at {strain:.6f}" for kind, strain in run.branch.special),
            run.branch.reason,
        ]
        for run in runs
    ]
    columns = ["branch", "starts at", "points", "most iterations", "special points", "ends because"]
    return Table("Branches by pseudo-arclength continuation", columns, rows)
