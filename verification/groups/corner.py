"""Group 2: the singular corner of clamp and free edge, and the grading that tames it."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools.singularity import (
    ASPECT,
    DEEPEST,
    MATERIAL,
    Densities,
    exponents,
    halved,
    twist_limit,
    williams,
)
from wrinklestudy.equilibrium import deflections, flat, modes, planar, wrinkled
from wrinklestudy.fem.boundary import QUARTER
from wrinklestudy.fem.factorisation import make_indefinite_solver
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.measure import measure_sheet
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath

THICKNESS = 1.0e-3
GRADINGS = (1.0, 1.25, 1.5, 2.0)
COARSE, DEFAULT = (16, 24), (MeshSettings().cells_along, MeshSettings().cells_across)
MODE_STRAINS = (0.06, 0.2, 0.3, 0.37, 0.5)
MODE_COUNT = 8
STRAINS = (0.06, 0.2, 0.37)
HALVINGS = 2  # of the cells at the corner; a third would make them as small as the thickness
# What resolving the corner may change: a third of the bars of the default mesh and less
BARS = {"tau_1": 3e-4, "A": 1e-3, "Phi^2": 2e-3}


class Leading(NamedTuple):
    """Largest critical thicknesses of wrinkles and of corner modes, in units of W."""

    wrinkle: float
    corner: float  # NaN if no corner mode is among the modes


def leading(space: Space, strain: float) -> Leading:
    """Return what the leading modes of the flat state are."""
    state = flat.solve(space, MATERIAL.law, strain)
    spectrum = modes.spectrum(state, count=MODE_COUNT)
    thickness = np.sqrt(np.maximum(spectrum.squared, 0.0))
    corner = spectrum.corner >= deflections.CORNER_PART
    wrinkles = thickness[~corner].max(initial=0.0)
    return Leading(float(wrinkles), float(thickness[corner].max()) if corner.any() else np.nan)


def _grading_study() -> tuple[
    list[Check], Table, dict[tuple[tuple[int, int], float], list[Leading]]
]:
    """Return which gradings and meshes have a corner mode, and how far tau_1 depends on them.

    The last are the leading modes by cells and grading, at `MODE_STRAINS`.
    """
    checks, rows = [], []
    by_mesh = {}
    for cells in (COARSE, DEFAULT):
        for grading in GRADINGS:
            space = Space(make_grid(ASPECT, settings=MeshSettings(*cells, grading)))
            leaders = [leading(space, strain) for strain in MODE_STRAINS]
            by_mesh[cells, grading] = leaders
            shown = (
                f"{1e3 * mode.wrinkle:.4f}"
                + ("" if np.isnan(mode.corner) else f" ({1e3 * mode.corner:.3f})")
                for mode in leaders
            )
            rows.append([f"{cells[0]} x {cells[1]}, {grading:g}", *shown])
            checks += _mode_checks(cells, grading, leaders)
    columns = ("mesh, grading", *(f"strain {strain:g}" for strain in MODE_STRAINS))
    title = f"10^3 tau_1/W, in brackets a corner mode among the {MODE_COUNT} leading modes"
    return checks, Table(title, columns, rows), by_mesh


def _mode_checks(cells: tuple[int, int], grading: float, leaders: list[Leading]) -> list[Check]:
    corners = [mode.corner for mode in leaders]
    if grading == MeshSettings().grading:
        reason = "the default grading has no corner mode before wrinkles of many nodes"
        name = f"{cells[0]} x {cells[1]}, grading {grading:g}: corner modes"
        count = float(np.sum(np.isfinite(corners)))
        return [Check(name, count, 0.0, 0.0, "absolute", reason)]
    if grading == 1.0 and cells == COARSE:
        late = MODE_STRAINS.index(0.3)
        reason = "the artefact that the part of energy at the corner is to find is there"
        name = f"{cells[0]} x {cells[1]}, uniform, strain 0.3: corner mode over tau_1"
        return [
            Check(name, corners[late] / leaders[late].wrinkle, 1.0, kind="at least", reason=reason)
        ]
    return []


def _refined(space: Space, strain: float) -> dict[str, float]:
    """Return tau_1, A and Phi^2 of the wrinkled sheet."""
    plane = planar.solve(space, MATERIAL, strain)
    state = wrinkled.solve(plane, THICKNESS)
    if state.status != "wrinkled" or plane.modes is None or state.position is None:
        raise ArithmeticError(f"strain {strain:g}: {state.status} {state.reason}")
    position = space.nodes_from_field(state.position)
    measures = measure_sheet(DeformedSheet(space.grid, position, plane.settings.symmetry))
    values = (plane.modes.critical_thickness, measures.amplitude, measures.phi_squared)
    return dict(zip(BARS, values, strict=True))


def _corner_study(spaces: Sequence[Space]) -> tuple[list[Check], Table]:
    """Return what halving the cells at the corner does to the default mesh's results."""
    checks, rows = [], []
    for strain in STRAINS:
        start = _refined(spaces[0], strain)
        for space in spaces[1 : HALVINGS + 1]:
            values = _refined(space, strain)
            changes = {name: value / start[name] - 1.0 for name, value in values.items()}
            rows.append(
                [f"{strain:g}", _cell(space), *(f"{change:.1e}" for change in changes.values())]
            )
        for name, change in changes.items():
            reason = f"{HALVINGS} halvings of the cells at the corner of the default mesh"
            case = f"strain {strain:g}: change of {name} by resolving the corner"
            checks.append(Check(case, change, 0.0, BARS[name], "absolute", reason))
    title = "Relative changes when the cells at the corner of the default mesh are halved"
    return checks, Table(title, ("strain", "cell at the corner", *BARS), rows)


def _cell(space: Space) -> str:
    """Return the size of the cell at the corner in words."""
    wide, high = (np.diff(line)[-1] / THICKNESS for line in (space.grid.x, space.grid.y))
    return f"{wide:.1f} t x {high:.1f} t"


def _definiteness(space: Space, strain: float) -> tuple[float, int]:
    """Return the part of the area where the bending form is indefinite, and B's negative values."""
    state = flat.solve(space, MATERIAL.law, strain)
    _, bent, _, points = deflections.deflection_forms(state, "thinning", QUARTER)
    entries = [(a, b) for a in range(5) for b in range(a, 5)]
    form = np.zeros((*points.shape[1:], 3, 3))
    for row, (a, b) in zip(points, entries, strict=True):
        if a >= 2:
            form[..., a - 2, b - 2] = form[..., b - 2, a - 2] = row
    indefinite = np.linalg.eigvalsh(form)[..., 0] < 0.0
    measure = space.measure
    solver = make_indefinite_solver()
    solver.factorise(bent)
    return float(measure[indefinite].sum() / measure.sum()), solver.negative_eigenvalues


class BendingForm(NamedTuple):
    """Where the bending form is indefinite on one mesh at one strain."""

    strain: float
    halvings: int
    cell: str  # at the corner, in words
    area: float  # part of the area
    negative: int  # eigenvalues of B


def _definiteness_study(
    spaces: Sequence[Space],
) -> tuple[list[Check], Table, list[BendingForm]]:
    """Return where the bending form is indefinite, and whether the matrix B is."""
    forms = [
        BendingForm(strain, halvings, _cell(space), *_definiteness(space, strain))
        for halvings, space in enumerate(spaces)
        for strain in MODE_STRAINS[-2:]
    ]
    reason = "tau_1 is that of an eigenproblem with B for the metric"
    checks = [
        Check(
            f"strain {form.strain:g}, default mesh: negative eigenvalues of B",
            form.negative,
            0.0,
            0.0,
            "absolute",
            reason,
        )
        for form in forms
        if form.halvings == 0
    ]
    columns = ("strain", "cell at the corner", "area with an indefinite form", "negative in B")
    rows: list[list[str | int]] = [
        [f"{f.strain:g}", f.cell, f"{f.area:.1e}", f.negative] for f in forms
    ]
    return checks, Table("Bending form at the corner (thinning)", columns, rows), forms


def _plot(densities: Densities, path: Path) -> None:
    """Draw tau_1 and corner modes against strain, and the density at the corner."""
    strain = np.array(MODE_STRAINS)
    with style.applied():
        figure = style.new(style.WIDE, 5.5)
        left, right = figure.subplots(1, 2)
        for grading, look in zip((1.0, 1.5), style.looks(["a", "b"]), strict=True):
            space = Space(make_grid(ASPECT, settings=MeshSettings(*COARSE, grading)))
            leaders = [leading(space, value) for value in strain]
            name = f"{COARSE[0]} x {COARSE[1]}, grading {grading:g}"
            taus = [1e3 * mode.wrinkle for mode in leaders]
            left.plot(strain, taus, look.marker + look.line, color=look.color, label=name)
            taus = [1e3 * mode.corner for mode in leaders]
            if np.isfinite(taus).any():
                left.plot(strain, taus, "x:", color=look.color, label=f"{name}: corner")
        left.set(xlabel=r"strain $\varepsilon$", ylabel=r"$10^3\,\tau/W$", ylim=(0.0, None))
        left.legend()
        for (value, rows), look in zip(densities.items(), style.ordered(4), strict=True):
            size, density = np.array(rows).T
            name = rf"$\varepsilon = {value:g}$"
            right.loglog(
                size, density / density[0], look.marker + "-", color=look.color, label=name
            )
        slope = 2.0 * williams(MATERIAL.law.poisson) - 2.0
        right.loglog(size, (size / size[0]) ** slope, "k:", label="Williams")
        right.set(xlabel="cell at the corner / W", ylabel=r"largest $W$ / that of the default mesh")
        right.legend()
        style.save(figure, path)


def quick() -> list[Check]:
    """Return the corner modes of coarse meshes."""
    checks = []
    for grading in (1.0, MeshSettings().grading):
        space = Space(make_grid(ASPECT, settings=MeshSettings(*COARSE, grading)))
        checks += _mode_checks(COARSE, grading, [leading(space, strain) for strain in MODE_STRAINS])
    return checks


def run(output: AnyPath) -> None:
    """Write the group: gradings, corner modes, the corner's influence and its singularity."""
    output = Path(output)
    spaces = [Space(halved(make_grid(ASPECT), times)) for times in range(HALVINGS + 2)]
    mode_checks, mode_table, leading_modes = _grading_study()
    singular, singular_table, densities = exponents(STRAINS)
    form_checks, form_table, forms = _definiteness_study(spaces)
    refined_checks, refined_table = _corner_study(spaces)
    _plot(densities, output.with_name("corner.png"))
    checks = [*mode_checks, *refined_checks, *singular, *form_checks]
    tables = [mode_table, refined_table, singular_table, form_table]
    plots = [
        (
            "corner.png",
            "Left: tau_1 and the corner mode (crosses) on a uniform and on the default grid. "
            "Right: largest energy density of the flat state against the cell at the corner.",
        )
    ]
    text = _text(leading_modes, refined_checks, forms)
    title = "Corner of clamp and free edge"
    write(Group("corner", title, text, checks, tables, plots), output)


def modes_text(uniform: Sequence[Leading], default: Sequence[Leading]) -> str:
    """Say where modes of the corner are among the leading ones, and where they lead.

    Parameters
    ----------
    uniform, default : sequence of Leading
        On a uniform mesh and with the default grading, at `MODE_STRAINS`.
    """
    leads = [
        strain
        for strain, mode in zip(MODE_STRAINS, uniform, strict=True)
        if mode.corner > mode.wrinkle
    ]
    there = [mode for mode in default if np.isfinite(mode.corner)]
    led = ", ".join(f"{strain:g}" for strain in leads)
    return (
        conclusion(
            bool(leads),
            f"On a uniform grid a spurious mode sits there; at strains {led} it has a larger "
            "critical thickness than the wrinkles.",
            "On a uniform grid no mode that sits there has a larger critical thickness than the "
            "wrinkles.",
        )
        + f" A mode is taken for one of the corner if at least {deflections.CORNER_PART:g} of its "
        "bending energy sits there, and never counts. With the default grading "
        + conclusion(
            not there,
            f"none is among the {MODE_COUNT} leading modes.",
            f"{len(there)} of the cases have one among the {MODE_COUNT} leading modes.",
        )
    )


def forms_text(forms: Sequence[BendingForm]) -> str:
    """Say where the bending form and the matrix B are indefinite."""
    default = [form for form in forms if form.halvings == 0]
    finer = [form for form in forms if form.halvings > 0 and form.negative]
    part = max(form.area for form in default)
    return (
        f"On the default mesh it is indefinite on {part:.1e} of the area at most, and the matrix B "
        + conclusion(
            not any(form.negative for form in default),
            "stays positive definite",
            "has negative eigenvalues there too",
        )
        + conclusion(
            bool(finer),
            "; on finer cells it does not at "
            + ", ".join(f"strain {form.strain:g} ({form.cell})" for form in finer)
            + ", and critical thicknesses have no meaning there.",
            "; on finer cells it has no negative eigenvalues either.",
        )
    )


def _text(
    leading_modes: dict[tuple[tuple[int, int], float], list[Leading]],
    refined: Sequence[Check],
    forms: Sequence[BendingForm],
) -> str:
    exponent = williams(MATERIAL.law.poisson)
    grading = MeshSettings().grading
    default = [m for (_, g), cases in leading_modes.items() if g == grading for m in cases]
    largest = max(abs(check.value) for check in refined)
    return (
        "Where the clamp meets the free edge the stress of the flat state is singular. "
        f"{modes_text(leading_modes[COARSE, 1.0], default)}\n\n"
        f"At small strain the exponent of the displacements must be Williams' root {exponent:.4f} "
        "for plane stress and nu = 1/2, W ~ r^(2e-2); the flat state alone is computed down to "
        f"{DEEPEST} halvings for that. The energy in the corner is integrable. Halving the cells "
        f"there changes the wrinkles far away by {largest:.0e} at most.\n\n"
        "Plate theory ends where the cells at the corner are as small as the thickness. For "
        "Mooney-Rivlin the bending energy b.W''.b leaves out terms proportional to the stress (see "
        "*Closed forms*). It becomes negative for some twists where the sheet is stretched much in "
        "both directions; in pure shear, as along the clamp, from a stretch of "
        f"{twist_limit():.3f} on. {forms_text(forms)}"
    )
