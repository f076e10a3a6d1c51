"""Group: thin sheets, from another start and against what tension field theory predicts."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools.sheets import ASPECT, LATEX
from wrinklestudy.equilibrium import newton, planar, wrinkled
from wrinklestudy.equilibrium.seeds import seed_position, seeds
from wrinklestudy.equilibrium.thin_seeds import thin_seed
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.measure import measure_sheet
from wrinklestudy.sheet import Sheet
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath

STRAINS = (0.1, 0.2)
THICKNESSES = (1.0e-3, 5.0e-4, 2.0e-4, 1.0e-4, 5.0e-5)
# Both starts are tried at the first strain for these thicknesses
STARTED = (2.0e-4, 1.0e-4)
QUICK_MESH, QUICK_THICKNESS, QUICK_STRAIN = MeshSettings(12, 24), 2.0e-4, 0.12
SAME = 1e-9  # relative, of energies: both are minima to rounding
HOLDS = 0.1  # relative: what the prediction is asked to hold to
_COLUMNS = ("A/t", "lambda/W")


class Compared(NamedTuple):
    """A resolved sheet and its prediction: A/t and lambda/W of both."""

    thickness: float
    strain: float
    solved: tuple[float, float]
    predicted: tuple[float, float]

    @property
    def errors(self) -> tuple[float, float]:
        """Predicted over solved, less one."""
        first, second = (p / s - 1.0 for p, s in zip(self.predicted, self.solved, strict=True))
        return first, second


class Starts(NamedTuple):
    """The state that one start leads to and that of another."""

    thickness: float
    strain: float
    iterations: tuple[int, int]  # from the tension field, from the modes
    difference: float  # of the energies, relative
    converged: bool


def starts(sheet: Sheet, strain: float) -> Starts:
    """Return what a thin sheet comes to from the tension field and from its modes."""
    plane = planar.solve(sheet.space, sheet.material, strain, sheet.settings)
    if plane.flat is None or plane.modes is None:
        raise ArithmeticError(plane.reason)
    start = thin_seed(plane, sheet.thickness)
    if start is None:
        raise ArithmeticError(f"strain {strain:g}: no tension field to start from")
    amplitudes = seeds(plane.modes, sheet.thickness)[0]
    states = [
        wrinkled.minimise_from(plane, sheet.thickness, position)
        for position in (start, seed_position(plane.flat, plane.modes, amplitudes))
    ]
    counts = (newton.count(states[0].history), newton.count(states[1].history))
    difference = abs(states[0].energy / states[1].energy - 1.0)
    together = all(state.status == "wrinkled" for state in states)
    return Starts(sheet.thickness, strain, counts, difference, together)


def start_checks(pairs: Sequence[Starts]) -> list[Check]:
    """Return the checks that two starts lead to one state."""
    checks = []
    for pair in pairs:
        name = f"t/W = {pair.thickness:g}, strain {pair.strain:g}"
        reason = "one minimum from the tension field and from the modes of the flat state"
        checks += [
            Check(f"{name}: both converge", float(pair.converged), 1.0, reason=reason),
            Check(f"{name}: energies", pair.difference, SAME, kind="at most", reason=reason),
        ]
    return checks


def compared(sheet: Sheet, strain: float) -> Compared:
    """Return a resolved state and what tension field theory predicts of it."""
    state = sheet.solve(strain)
    if state.measures is None or state.equilibrium.position is None:
        raise ArithmeticError(f"strain {strain:g}: {state.status}")
    nodes = sheet.space.nodes_from_field(state.equilibrium.position)
    measures = measure_sheet(DeformedSheet(sheet.space.grid, nodes, sheet.settings.symmetry))
    row = sheet.far_from_threshold(strain)
    predicted = (row.amplitude_over_thickness, row.wavelength_over_width)
    if measures.wavelength is None or predicted[0] is None or predicted[1] is None:
        raise ArithmeticError(f"strain {strain:g}: no wavelength")
    solved = (measures.amplitude / sheet.thickness, measures.wavelength)
    return Compared(sheet.thickness, strain, solved, (predicted[0], predicted[1]))


def thinnest_that_fails(cases: Sequence[Compared]) -> float:
    """Return the thinnest t/W at which the prediction is farther off than `HOLDS`; 0 if none."""
    return max((c.thickness for c in cases if max(map(abs, c.errors)) > HOLDS), default=0.0)


def _thin_checks(cases: Sequence[Compared]) -> list[Check]:
    """Return the checks that the prediction gets better as sheets get thinner, and holds."""
    checks = []
    for strain in STRAINS:
        own = [case for case in cases if case.strain == strain]
        for k, column in enumerate(_COLUMNS):
            first, last = own[0].errors[k], own[-1].errors[k]
            name = f"strain {strain:g}, t/W = {own[-1].thickness:g}: {column} predicted"
            reason = "the limit of no thickness"
            checks += [
                Check(name, last, 0.0, HOLDS, "absolute", reason),
                Check(f"{name}, over that at t/W = {own[0].thickness:g}", abs(last / first), 1.0,
                      kind="at most", reason="the thinner, the better"),
            ]  # fmt: skip
    return checks


def quick() -> list[Check]:
    """Return the checks of two starts, and of the predicted wavelength, on a coarse mesh."""
    sheet = Sheet(ASPECT, QUICK_THICKNESS, LATEX, mesh=QUICK_MESH)
    error = compared(sheet, QUICK_STRAIN).errors[1]
    reason = "the limit of no thickness"
    predicted = Check("wavelength predicted", error, 0.0, HOLDS, "absolute", reason)
    return [*start_checks([starts(sheet, QUICK_STRAIN)]), predicted]


def run(output: AnyPath) -> None:
    """Write the group: two starts, and the prediction against resolved sheets."""
    output = Path(output)
    sheets = {thickness: Sheet(ASPECT, thickness, LATEX) for thickness in THICKNESSES}
    pairs = [starts(sheets[thickness], STRAINS[0]) for thickness in STARTED]
    cases = [compared(sheets[t], strain) for strain in STRAINS for t in THICKNESSES]
    _plot(cases, output.with_name("thin_sheets.png"))
    tables = [_starts_table(pairs), _compared_table(cases)]
    plots = [
        (
            "thin_sheets.png",
            "Amplitude and wavelength predicted from the tension field, over those of the resolved "
            f"sheet; the band is {HOLDS:.0%}.",
        )
    ]
    checks = [*start_checks(pairs), *_thin_checks(cases)]
    title = "Thin sheets: another start, and the far-from-threshold prediction"
    write(Group("thin_sheets", title, text(pairs, cases), checks, tables, plots), output)


def text(pairs: Sequence[Starts], cases: Sequence[Compared]) -> str:
    """Say what the starts lead to and how thin a sheet must be for the prediction."""
    fails = thinnest_that_fails(cases)
    holding = [case.thickness for case in cases if case.thickness < fails or fails == 0.0]
    same = all(pair.converged and pair.difference <= SAME for pair in pairs)
    counts = "; ".join(
        f"{pair.iterations[0]} instead of {pair.iterations[1]} at t/W = {pair.thickness:g}"
        for pair in pairs
    )
    return (
        "Thin sheets start from the tension field under wrinkles of one wavelength. "
        + conclusion(
            same,
            f"The state is the one that the modes of the flat state lead to, with {counts} Newton "
            "iterations.",
            "The state is not the one that the modes of the flat state lead to.",
        )
        + " The same envelope predicts A and lambda without any solution of the plate: "
        + conclusion(
            bool(holding),
            f"within {HOLDS:.0%} of the resolved sheet for t/W = {max(holding, default=0.0):g} and "
            f"thinner ones, not at t/W = {fails:g}.",
            f"at none of these thicknesses within {HOLDS:.0%}.",
        )
    )


def _starts_table(pairs: Sequence[Starts]) -> Table:
    rows: list[list[str | int]] = [
        [f"{p.thickness:g}", f"{p.strain:g}", *p.iterations, f"{p.difference:.1e}"] for p in pairs
    ]
    columns = ("t/W", "strain", "from the tension field", "from the modes", "energies differ by")
    return Table("Newton iterations from two starts", columns, rows)


def _compared_table(cases: Sequence[Compared]) -> Table:
    rows: list[list[str | int]] = [
        [
            f"{case.strain:g}",
            f"{case.thickness:g}",
            *(f"{value:.4g}" for k in (0, 1) for value in (case.solved[k], case.predicted[k])),
            *(f"{100.0 * error:+.1f}%" for error in case.errors),
        ]
        for case in cases
    ]
    columns = ("strain", "t/W", "A/t", "predicted", "lambda/W", "predicted", "A off", "lambda off")
    return Table("Resolved sheets and the far-from-threshold prediction", columns, rows)


def _plot(cases: Sequence[Compared], path: Path) -> None:
    """Draw predicted over resolved amplitude and wavelength against thickness."""
    with style.applied():
        figure = style.new(style.WIDE, 5.5)
        for axes, k, label in zip(figure.subplots(1, 2), (0, 1), ("A", r"\lambda"), strict=True):
            for strain, look in zip(STRAINS, style.looks([f"{s:g}" for s in STRAINS]), strict=True):
                own = [case for case in cases if case.strain == strain]
                thickness = np.array([case.thickness for case in own])
                ratio = np.array([1.0 + case.errors[k] for case in own])
                name = rf"$\varepsilon = {strain:g}$"
                axes.semilogx(
                    thickness, ratio, look.marker + look.line, color=look.color, label=name
                )
            axes.axhspan(1.0 - HOLDS, 1.0 + HOLDS, color="0.9", zorder=0)
            axes.set(xlabel=r"$t/W$", ylabel=rf"${label}$ predicted / resolved")
            axes.legend()
        style.save(figure, path)
