"""Group 3: independent isogeometric shell codes: states point by point, and a buckling mode."""

from pathlib import Path
from typing import NamedTuple

import numpy as np
import pandas as pd
from scipy.optimize import brentq

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools import published_mode
from wrinklestudy.equilibrium.ranges import Stability
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.sheet import Sheet
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath, Array

DATA = Path("data/isogeometric_fixed_thickness.csv")  # from the folder of the project
MATERIAL = mooney_rivlin(6.21e4, 1.58e5)
WIDTH, THICKNESS = 0.14, 0.14e-3  # of the sheet in metres
# Birth and decay strain as the header of the data gives them, and what they may differ by
ONSET, END = 0.0250, 0.3247
ONSET_BAR, END_BAR = 7e-4, 2.5e-3
INSIDE = (0.06, 0.24)  # away from birth and decay
AMPLITUDE_BAR = 0.002
STRAIN_DIGITS = 1.0e-4  # the last digit of the strains of birth and decay
WIDTH_BAR, FORCE_BAR = 1.0e-5, 1.0e-5
_QUICK = (0.12, 0.23)
_BEYOND = 0.02  # how far beyond the data birth and decay are looked for
_SMOOTH_BAR = 3.0e-4
_FLAT = 1.0e-4  # A/t below which the sheet of the data is flat: its search does not end at zero
_EXTRAPOLATED = 4  # points of A^2 whose polynomial is extrapolated to zero


class ComparedState(NamedTuple):
    """One strain, computed here and by the other code; lengths in t or W, force in N."""

    strain: float
    status: str
    amplitude: float
    width: float
    force: float
    other_amplitude: float
    other_width: float
    other_force: float


def sheet_of_the_data() -> Sheet:
    """Return the sheet of the data on the default mesh."""
    return Sheet(2.0, THICKNESS / WIDTH, MATERIAL, bending="fixed-thickness")


def compare(sheet: Sheet, rows: pd.DataFrame) -> list[ComparedState]:
    """Return the states of a sheet at the strains of some rows of the data.

    The force is nominal stress x mu x W t with the initial shear modulus mu = 2 (C10 + C01).
    """
    points = []
    for row in rows.itertuples():
        state = sheet.solve(float(str(row.eps)))
        if state.measures is None:
            raise ArithmeticError(f"strain {row.eps}: {state.equilibrium.reason}")
        force = state.equilibrium.nominal_stress * MATERIAL.shear_modulus * WIDTH * THICKNESS
        points.append(
            ComparedState(
                state.strain,
                state.status,
                state.measures.amplitude / sheet.thickness,
                state.measures.projected_width,
                force,
                float(str(row.A_over_t)),
                float(str(row.projected_width_ratio)),
                float(str(row.clamp_force_N)),
            )
        )
    return points


def _slopes(points: list[ComparedState]) -> Array:
    """Return |dA/deps| in units of t: of the chord to the next neighbour, the steeper one."""
    strain = np.array([point.strain for point in points])
    amplitude = np.array([point.amplitude for point in points])
    chords = np.abs(np.diff(amplitude) / np.diff(strain))
    return np.maximum(np.append(chords, 0.0), np.insert(chords, 0, 0.0))


def _checks(points: list[ComparedState], slopes: Array) -> list[Check]:
    checks = []
    for point, slope in zip(points, slopes, strict=True):
        case = f"strain {point.strain:g}"
        bar = AMPLITUDE_BAR * point.other_amplitude
        reason = f"{100 * AMPLITUDE_BAR:g}%: discretisation errors of both codes"
        if not INSIDE[0] <= point.strain <= INSIDE[1]:
            bar += float(slope) * STRAIN_DIGITS
            reason += f", and dA/deps = {slope:.0f} t times the last digit of birth and decay"
        checks += [
            Check(f"{case}: A/t", point.amplitude, point.other_amplitude, bar, "absolute", reason),
            Check(
                f"{case}: projected width / W",
                point.width,
                point.other_width,
                WIDTH_BAR,
                "absolute",
                "all five digits of the data",
            ),
            Check(
                f"{case}: clamp force",
                point.force,
                point.other_force,
                FORCE_BAR,
                "relative",
                "an integral of the membrane stress; both meshes resolve it to that",
            ),
        ]
    return checks


def extrapolated(strain: Array, amplitude: Array, beyond: float) -> float:
    """Return the strain at which the polynomial through A^2 vanishes, looked for up to a strain."""
    squares = np.polynomial.Polynomial.fit(strain, amplitude**2, len(strain) - 1)
    nearest = strain[np.abs(strain - beyond).argmin()]
    return float(brentq(squares, *sorted((float(nearest), beyond))))


def _end_checks(points: list[ComparedState], ends: Stability) -> tuple[list[Check], Table]:
    """Return birth and decay strain against the header, and both extrapolations of A^2."""
    wrinkled = [point for point in points if point.status == "wrinkled"]
    strain = np.array([point.strain for point in wrinkled])
    amplitudes = np.array([[point.amplitude, point.other_amplitude] for point in wrinkled])
    checks, rows = [], []
    cases = (
        ("birth", ends.birth_strain, ONSET, ONSET_BAR, slice(None, _EXTRAPOLATED), -_BEYOND),
        ("decay", ends.decay_strain, END, END_BAR, slice(-_EXTRAPOLATED, None), _BEYOND),
    )
    for name, value, noted, bar, outermost, step in cases:
        root = float("nan") if value is None else value
        beyond = (strain[0] if step < 0 else strain[-1]) + step
        own, other = (extrapolated(strain[outermost], a, beyond) for a in amplitudes[outermost].T)
        rows.append([name, f"{root:.5f}", f"{noted:.4f}", f"{own:.5f}", f"{other:.5f}"])
        same = f"the same polynomial through {_EXTRAPOLATED} points of both, extrapolated to A = 0"
        smooth = f"A^2 is smooth: polynomial through {_EXTRAPOLATED} points of the data"
        checks += [
            Check(f"{name} strain", root, noted, bar, "absolute", "as noted with the data"),
            Check(f"{name} strain from A^2", own, other, STRAIN_DIGITS, "absolute", same),
            Check(f"{name} strain, data's A^2", root, other, _SMOOTH_BAR, "absolute", smooth),
        ]
    columns = ("", "eigenproblem", "noted with the data", "from A^2 here", "from A^2 of the data")
    return checks, Table("Strains of birth and decay", columns, rows)


def _table(points: list[ComparedState], slopes: Array) -> Table:
    rows = []
    for p, slope in zip(points, slopes, strict=True):
        ratio = (
            f"{100 * (p.amplitude / p.other_amplitude - 1):z.3f}%" if p.amplitude > 0 else p.status
        )
        rows.append(
            [
                f"{p.strain:g}",
                f"{p.amplitude:.5f}",
                f"{p.other_amplitude:.5f}",
                ratio,
                f"{slope:.0f}",
                f"{p.width:.6f}",
                f"{p.other_width:.5f}",
                f"{p.force:.6f}",
                f"{p.other_force:.6g}",
            ]
        )
    columns = (
        "strain",
        "A/t",
        "data",
        "difference",
        "dA/deps in t",
        "width/W",
        "data",
        "force (N)",
        "data",
    )
    return Table("Point by point", columns, rows)


def _plot(points: list[ComparedState], path: Path) -> None:
    values = np.array([[p.strain, *p[2:]] for p in points if p.status == "wrinkled"]).T
    strain, amplitude, width, force, other, other_width, other_force = values
    with style.applied():
        figure = style.new(style.WIDE, 5.0)
        left, right = figure.subplots(1, 2)
        left.plot(strain, amplitude, "-", color=style.BLUE, label="this library")
        left.plot(strain, other, "x", color=style.VERMILLION, label="isogeometric code")
        left.set(xlabel=r"strain $\varepsilon$", ylabel=r"$A/t$", ylim=(0.0, None))
        left.legend()
        pairs = (
            ("A/t", amplitude, other),
            ("width", width, other_width),
            ("force", force, other_force),
        )
        for (name, own, data), look in zip(pairs, style.looks(["a", "b", "c"]), strict=True):
            error = np.abs(own / data - 1.0)
            right.semilogy(strain, error, look.marker + look.line, color=look.color, label=name)
        right.set(xlabel=r"strain $\varepsilon$", ylabel="relative difference", ylim=(1e-8, 0.1))
        right.legend(loc="upper center", ncols=3)
        style.save(figure, path)


def quick() -> list[Check]:
    """Return the comparison at two strains, and that of the mode."""
    data = pd.read_csv(DATA, comment="#")
    points = compare(sheet_of_the_data(), data[data.eps.isin(_QUICK)])
    return [*_checks(points, np.zeros(len(points))), *published_mode.checks(MATERIAL)]


def end_text(strain: float, here: bool, there: bool) -> str:
    """Say whether both sheets are flat at the largest strain of the data.

    Parameters
    ----------
    strain : float
    here, there : bool
        Whether the sheet of this library and that of the data are flat.
    """
    width = ", and the projected width is that of the planar state"
    which = conclusion(here, "only the sheet computed here is", "only the sheet of the data is")
    neither = conclusion(here or there, which, "neither sheet is")
    both = f"both sheets are flat{width}"
    return f"At eps = {strain:g} {conclusion(here and there, both, f'{neither} flat')}."


def _text(points: list[ComparedState], ends: list[Check]) -> str:
    inside = [p for p in points if INSIDE[0] <= p.strain <= INSIDE[1]]
    differences = [abs(c.value - c.expected) for c in ends if c.name.endswith("data's A^2")]
    worst = max(abs(p.amplitude / p.other_amplitude - 1.0) for p in inside)
    last = points[-1]
    flat = (last.status == "flat", last.other_amplitude < _FLAT)
    return (
        f"`{DATA.as_posix()}` holds states of the latex sheet from an independent Kirchhoff-Love "
        f"code (cubic B-splines, 20 x 48 elements on the quarter) with the bending law "
        f"`fixed-thickness`. The same law here, default mesh, antisymmetric. For {INSIDE[0]:g} <= "
        f"eps <= {INSIDE[1]:g} the largest difference of A/t is {100 * worst:.2f}%.\n\n"
        f"Near birth and decay A is expected to go to zero like a square root, so that dA/deps "
        f"grows without limit: a difference of {STRAIN_DIGITS:g} in the strain of birth or decay "
        f"is a difference {STRAIN_DIGITS:g} dA/deps in A, which is added to the tolerance outside "
        f"of that range. {end_text(last.strain, *flat)}\n\n"
        f"The strains of birth and decay, roots of tau_1 = t, are compared with what is noted in "
        f"the header of the data, and with where the polynomial through the outermost "
        f"{_EXTRAPOLATED} values of the data's A^2 vanishes: this differs by {differences[0]:.0e} "
        f"at birth and {differences[1]:.0e} at decay.\n\n"
        f"{published_mode.TEXT}"
    )


def run(output: AnyPath) -> None:
    """Write the group: amplitude, width and force at every strain of the data, birth and decay."""
    output = Path(output)
    sheet = sheet_of_the_data()
    points = compare(sheet, pd.read_csv(DATA, comment="#"))
    slopes = _slopes(points)
    ends, ends_table = _end_checks(points, sheet.stability())
    _plot(points, output.with_name("independent.png"))
    plots = [("independent.png", "Amplitude, and relative differences of A/t, width and force.")]
    group = Group(
        "independent",
        "Independent data",
        _text(points, ends),
        [*_checks(points, slopes), *ends, *published_mode.checks(MATERIAL)],
        [_table(points, slopes), ends_table],
        plots,
    )
    write(group, output)
