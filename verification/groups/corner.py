"""Group 2: the singular corner of clamp and free edge, and the grading that tames it."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from verification.checks import Check, Group, Table, write
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
from wrinklestudy.equilibrium import flat, modes, planar, wrinkled
from wrinklestudy.fem.factorisation import make_indefinite_solver
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.metrics.measure import measure_position
from wrinklestudy.study.figures import style

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
    found = modes.spectrum(state, count=MODE_COUNT)
    thickness = np.sqrt(np.maximum(found.squared, 0.0))
    corner = found.corner >= modes.CORNER_PART
    wrinkles = thickness[~corner].max(initial=0.0)
    return Leading(float(wrinkles), float(thickness[corner].max()) if corner.any() else np.nan)


def _grading_study() -> tuple[list[Check], Table]:
    """Return which gradings and meshes have a corner mode, and how far tau_1 depends on them."""
    checks, rows = [], []
    for cells in (COARSE, DEFAULT):
        for grading in GRADINGS:
            space = Space(make_grid(ASPECT, settings=MeshSettings(*cells, grading)))
            found = [leading(space, strain) for strain in MODE_STRAINS]
            rows.append(
                [
                    f"{cells[0]} x {cells[1]}, {grading:g}",
                    *(
                        f"{1e3 * one.wrinkle:.4f}"
                        + ("" if np.isnan(one.corner) else f" ({1e3 * one.corner:.3f})")
                        for one in found
                    ),
                ]
            )
            checks += _mode_checks(cells, grading, found)
    columns = ("mesh, grading", *(f"strain {strain:g}" for strain in MODE_STRAINS))
    title = f"10^3 tau_1/W, in brackets a corner mode among the {MODE_COUNT} leading modes"
    return checks, Table(title, columns, rows)


def _mode_checks(cells: tuple[int, int], grading: float, found: list[Leading]) -> list[Check]:
    corners = [one.corner for one in found]
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
            Check(name, corners[late] / found[late].wrinkle, 1.0, kind="at least", reason=reason)
        ]
    return []


def _refined(space: Space, strain: float) -> dict[str, float]:
    """Return tau_1, A and Phi^2 of the wrinkled sheet."""
    found = planar.solve(space, MATERIAL, strain)
    state = wrinkled.solve(found, THICKNESS)
    if state.status != "wrinkled" or found.modes is None or state.position is None:
        raise ArithmeticError(f"strain {strain:g}: {state.status} {state.reason}")
    position = space.nodes_from_field(state.position)
    measures = measure_position(space.grid.x, space.grid.y, position, found.settings.parity)
    values = (found.modes.critical_thickness, measures.amplitude, measures.phi_squared)
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
    _, bent, _, points = modes.deflection_matrices(state, "thinning", "antisymmetric")
    entries = [(a, b) for a in range(5) for b in range(a, 5)]
    form = np.zeros((*points.shape[1:], 3, 3))
    for row, (a, b) in zip(points, entries, strict=True):
        if a >= 2:
            form[..., a - 2, b - 2] = form[..., b - 2, a - 2] = row
    indefinite = np.linalg.eigvalsh(form)[..., 0] < 0.0
    measure = space.measure
    solver = make_indefinite_solver()
    solver.factorise(bent)
    return float(measure[indefinite].sum() / measure.sum()), solver.negative


def _definiteness_study(spaces: Sequence[Space]) -> tuple[list[Check], Table]:
    """Return where the bending form is indefinite, and whether the matrix B is."""
    checks: list[Check] = []
    rows: list[list[str | int]] = []
    for space in spaces:
        for strain in MODE_STRAINS[-2:]:
            part, negative = _definiteness(space, strain)
            rows.append([f"{strain:g}", _cell(space), f"{part:.1e}", negative])
            if space is spaces[0]:
                name = f"strain {strain:g}, default mesh: negative eigenvalues of B"
                reason = "tau_1 is that of an eigenproblem with B for the metric"
                checks.append(Check(name, negative, 0.0, 0.0, "absolute", reason))
    columns = ("strain", "cell at the corner", "area with an indefinite form", "negative in B")
    return checks, Table("Bending form at the corner (thinning)", columns, rows)


def _plot(densities: Densities, path: Path) -> None:
    """Draw tau_1 and corner modes against strain, and the density at the corner."""
    strain = np.array(MODE_STRAINS)
    with style.applied():
        figure = style.new(style.WIDE, 5.5)
        left, right = figure.subplots(1, 2)
        for grading, look in zip((1.0, 1.5), style.looks(["a", "b"]), strict=True):
            space = Space(make_grid(ASPECT, settings=MeshSettings(*COARSE, grading)))
            found = [leading(space, one) for one in strain]
            name = f"{COARSE[0]} x {COARSE[1]}, grading {grading:g}"
            taus = [1e3 * one.wrinkle for one in found]
            left.plot(strain, taus, look.marker + look.line, color=look.color, label=name)
            taus = [1e3 * one.corner for one in found]
            if np.isfinite(taus).any():
                left.plot(strain, taus, "x:", color=look.color, label=f"{name}: corner")
        left.set(xlabel=r"strain $\varepsilon$", ylabel=r"$10^3\,\tau/W$", ylim=(0.0, None))
        left.legend()
        for (one, rows), look in zip(densities.items(), style.ordered(4), strict=True):
            size, density = np.array(rows).T
            name = rf"$\varepsilon = {one:g}$"
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
        checks += _mode_checks(COARSE, grading, [leading(space, one) for one in MODE_STRAINS])
    return checks


def run(output: Path | str) -> None:
    """Write the group: gradings, corner modes, the corner's influence and its singularity."""
    output = Path(output)
    singular, singular_table, densities = exponents(STRAINS)
    spaces = [Space(halved(make_grid(ASPECT), times)) for times in range(HALVINGS + 2)]
    parts = [
        _grading_study(),
        _corner_study(spaces),
        (singular, singular_table),
        _definiteness_study(spaces),
    ]
    _plot(densities, output.with_name("corner.png"))
    checks = [check for found, _ in parts for check in found]
    tables = [table for _, table in parts]
    plots = [
        (
            "corner.png",
            "Left: tau_1 and the corner mode (crosses) on a uniform and on the default grid. "
            "Right: largest energy density of the flat state against the cell at the corner.",
        )
    ]
    write(Group("corner", "Corner of clamp and free edge", _text(), checks, tables, plots), output)


def _text() -> str:
    exponent = williams(MATERIAL.law.poisson)
    return (
        "Where the clamp meets the free edge the stress of the flat state is singular. On a "
        "uniform grid a spurious mode sits there and soon has a larger critical thickness than the "
        f"wrinkles; a mode is taken for one of the corner if at least {modes.CORNER_PART:g} of its "
        "bending energy sits there, and never counts. With the default grading none is among the "
        f"{MODE_COUNT} leading modes.\n\n"
        f"At small strain the exponent of the displacements must be Williams' root {exponent:.4f} "
        "for plane stress and nu = 1/2, W ~ r^(2e-2); the flat state alone is computed down to "
        f"{DEEPEST} halvings for that. The energy in the corner is integrable and its influence on "
        "the wrinkles far away is bounded by halving the cells there.\n\n"
        "Cells at the corner that are as small as the thickness ask for more than plate theory "
        "knows: for Mooney-Rivlin the form b.W''.b, which leaves out terms proportional to the "
        "stress (see *Closed forms*), is indefinite in twist where the sheet is stretched much in "
        "both directions, in pure shear (as along the clamp) from a stretch of "
        f"{twist_limit():.3f} on. On the default mesh these are single points at the corner and "
        "the matrix B stays positive definite; where it does not (last column), critical "
        "thicknesses have no meaning."
    )
