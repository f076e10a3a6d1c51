"""Group 12: the tension field against rays, radial equations and another discretisation."""

from pathlib import Path
from typing import NamedTuple

import numpy as np

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools import annulus, hidden_width, strip_field
from verification.tools.annulus import Annulus, PlanarState, RadialState
from verification.tools.sheared_strip import MansfieldStrip
from verification.tools.strip_field import StripField
from wrinklestudy.equilibrium import tension_field
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.mechanics.laws import MooneyRivlin, SaintVenantKirchhoff
from wrinklestudy.metrics.confinement import confinement, mesh_error
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath, Array

C10, C01 = 6.21e4, 1.58e5  # the latex sheet of the paper, Pa
LAW = MooneyRivlin(0.5 * C10 / (C10 + C01), 0.5 * C01 / (C10 + C01))
BOUND = 1e-3

# Mansfield's strip, 100 mm between clamps of 200 mm; the clamps' distance is the unit
STRIP = MansfieldStrip(1.0, 2.0, 0.002, 0.006)
POISSON = 0.31
SCALES = (1.0, 0.3, 0.1, 0.03, 0.01)  # of extension and shear, each from the one before
STRIP_CELLS = (16, 32)
STATIONS = np.array([0.0, 0.2, 0.4, 0.6, 0.8, 0.9])
KNOWN_ANGLE = 0.96505  # of the centre ray, from another evaluation of the quadrature

ANNULI = {
    "taut ring": Annulus(LAW, outer=2.0, hole=0.5, pull=1.0),
    "narrow wrinkled ring": Annulus(LAW, outer=2.0, hole=0.7, pull=0.9),
    "wrinkled to the edge": Annulus(LAW, outer=1.5, hole=0.5, pull=1.0),
}
RINGS = ((12, 12), (24, 24), (36, 36))

STRAINS = (0.02, 0.06, 0.12, 0.20, 0.30)
QUICK_STRAIN = 0.06
ASPECT = 2.0
MESHES = (MeshSettings(12, 18), MeshSettings(24, 36), MeshSettings(36, 54))


class StripErrors(NamedTuple):
    """Relative errors against Mansfield's rays at one load."""

    scale: float
    normal: float
    along: float
    angles: Array
    taut: float  # part of the sheet


def scaled(scale: float) -> MansfieldStrip:
    """Return the strip with a smaller displacement of its clamp."""
    return MansfieldStrip(
        STRIP.distance, STRIP.length, scale * STRIP.extension, scale * STRIP.shear
    )


def strip_errors(poisson: float, scales: tuple[float, ...] = SCALES) -> list[StripErrors]:
    """Return the errors of the sheared strip over falling loads."""
    space = strip_field.space_of(STRIP, STRIP_CELLS)
    law, exact = SaintVenantKirchhoff(poisson), STRIP.angles(STATIONS)
    errors: list[StripErrors] = []
    last: StripField | None = None
    for scale in scales:
        strip = scaled(scale)
        start = None if last is None else last.displacement * scale / errors[-1].scale
        last = strip_field.solve(space, strip, law, STATIONS, start)
        normal, along = last.normal / strip.forces[0], last.along / strip.forces[1]
        angles = last.angles / exact - 1.0
        errors.append(StripErrors(scale, normal - 1.0, along - 1.0, angles, last.taut))
    return errors


def _ray_checks() -> list[Check]:
    """Return the checks of the quadrature alone."""
    normal, along = STRIP.forces
    work = STRIP.extension * normal + STRIP.shear * along
    return [
        Check(
            "Mansfield's strip: angle of the centre ray",
            STRIP.angle(0.0),
            KNOWN_ANGLE,
            5e-6,
            "absolute",
            "another evaluation of the quadrature, five digits",
        ),
        Check(
            "Mansfield's strip: work of the clamps over twice the energy of the rays",
            work / (2.0 * STRIP.energy),
            1.0,
            1e-9,
            reason="Clapeyron; the two are different integrals",
        ),
    ]


def strip_checks(poisson: float, errors: list[StripErrors]) -> list[Check]:
    """Return the checks of the strip at its least load, and of how errors fall with the load."""
    case = f"sheared strip, nu = {poisson:g}"
    by_scale = {row.scale: row for row in errors}
    last = errors[-1]
    reason = "rays for small strains; what is left is the mesh"
    forces = reason if poisson == 0.0 else f"{reason} and a taut corner that the rays leave out"
    checks = [
        Check(f"{case}: angle at s = {s:g} H", 1.0 + error, 1.0, BOUND, reason=reason)
        for s, error in zip(STATIONS, last.angles, strict=True)
    ]
    checks += [
        Check(f"{case}: force away", 1.0 + last.normal, 1.0, BOUND, reason=forces),
        Check(f"{case}: force along", 1.0 + last.along, 1.0, BOUND, reason=forces),
    ]
    if {1.0, 0.1} <= by_scale.keys():
        fall = (by_scale[1.0].along - last.along) / (by_scale[0.1].along - last.along)
        linear = "errors of the theory of small strains are linear in the strain"
        ratio = (1.0 - last.scale) / (0.1 - last.scale)
        checks.append(Check(f"{case}: fall of the force's error", fall, ratio, 0.1, reason=linear))
    return checks


def _strip_table(poisson: float, errors: list[StripErrors]) -> Table:
    rows = [
        [
            f"{row.scale:g}",
            *(f"{100.0 * error:z.3f}" for error in (row.normal, row.along, *row.angles)),
            f"{100.0 * row.taut:.2f}",
        ]
        for row in errors
    ]
    angles = (f"angle at {s:g} H" for s in STATIONS)
    columns = ("load", "force away", "force along", *angles, "taut part of the sheet")
    title = f"Sheared strip, nu = {poisson:g}: deviation from Mansfield's rays in percent"
    return Table(title, columns, rows)


class Rings(NamedTuple):
    """An annulus by the radial equation and on several meshes."""

    exact: RadialState
    planar: list[PlanarState]


def rings(case: Annulus, meshes: tuple[tuple[int, int], ...] = RINGS) -> Rings:
    """Return an annulus by the radial equation, at the radii of the last mesh, and on meshes."""
    exact = annulus.radial(case, np.linspace(1.0, case.outer, 2 * meshes[-1][0] + 1))
    return Rings(exact, [annulus.planar(case, exact.edge, cells) for cells in meshes])


def ring_checks(name: str, case: Annulus, solved: Rings) -> list[Check]:
    """Return the checks of an annulus on its finest mesh."""
    exact, state = solved.exact, solved.planar[-1]
    moved = np.abs(exact.positions - exact.radii).max()
    away = float(np.abs(state.positions - exact.positions).max() / moved)
    reason = "radial equation, solved to 1e-10"
    return [
        Check(f"annulus, {name}: displacement", away, BOUND, kind="at most", reason=reason),
        Check(
            f"annulus, {name}: unevenness",
            state.uneven / float(moved),
            BOUND,
            kind="at most",
            reason="the same at all angles",
        ),
        Check(f"annulus, {name}: load", state.load, exact.load, BOUND, reason=reason),
        Check(
            f"annulus, {name}: radius of the interface",
            state.interface,
            exact.interface,
            BOUND,
            reason=f"{reason}; {conclusion(exact.interface < case.outer, 'within', 'at the edge')}",
        ),
    ]


def _ring_table(solved: dict[str, Rings]) -> Table:
    rows = []
    for name, case in solved.items():
        exact = case.exact
        rows.append(
            [name, "radial", f"{exact.load:.8f}", f"{exact.interface:.5f}", f"{exact.edge:.8f}", ""]
        )
        for cells, state in zip(RINGS, case.planar, strict=True):
            uneven = f"{state.uneven:.1e}"
            numbers = (f"{state.load:.8f}", f"{state.interface:.5f}", "held", uneven)
            rows.append([name, f"{cells[0]} x {cells[1]}", *numbers])
    columns = ("annulus", "solved", "load R P_r", "interface", "r(outer)", "uneven")
    return Table("Annulus between two edges, in units of the hole and mu", columns, rows)


class Widths(NamedTuple):
    """Phi^2 at one strain, on the meshes of the library and on other elements."""

    strain: float
    library: list[float]
    estimate: float  # the library's own, of the error on the second mesh
    other: float  # biquadratic elements with the lines of the second mesh


def widths(strain: float, meshes: tuple[MeshSettings, ...] = MESHES) -> Widths:
    """Return Phi^2 by the library on meshes, and on biquadratic elements."""
    values, estimates = [], []
    for settings in meshes:
        field = tension_field.solve(make_grid(ASPECT, settings=settings), LAW, strain)
        if not field.converged or field.coarser is None:
            raise ArithmeticError(field.reason)
        values.append(confinement(field).phi_squared)
        estimates.append(mesh_error(field, field.coarser))
    middle = len(meshes) // 2
    grid = make_grid(ASPECT, settings=meshes[middle])
    other = hidden_width.phi_squared(LAW, strain, grid.x, grid.y)
    return Widths(strain, values, estimates[middle], other)


def width_checks(row: Widths) -> list[Check]:
    """Return the checks of Phi^2 at one strain."""
    case = f"Phi^2 at eps = {row.strain:g}"
    middle = row.library[len(row.library) // 2]
    checks = [
        Check(
            f"{case}: bicubic and biquadratic",
            middle,
            row.other,
            BOUND,
            reason="other elements, other assembly, the same grid lines",
        )
    ]
    if len(row.library) > 1:
        change = abs(row.library[-1] - middle)
        covered = "the largest change near the middle from the coarser mesh bounds it"
        checks += [
            Check(
                f"{case}: change to the finest mesh",
                change / middle,
                BOUND,
                kind="at most",
                reason="converged to the bound of this group",
            ),
            Check(
                f"{case}: that change over the estimated error",
                change / row.estimate,
                1.0,
                kind="at most",
                reason=covered,
            ),
        ]
    return checks


def _width_table(rows: list[Widths]) -> Table:
    meshes = [f"{mesh.cells_along} x {mesh.cells_across}" for mesh in MESHES]
    columns = ("strain", *meshes, f"largest change from half of {meshes[1]}", "biquadratic")
    shown = [
        [
            f"{row.strain:g}",
            *(f"{value:.7f}" for value in row.library),
            f"{row.estimate:.1e}",
            f"{row.other:.7f}",
        ]
        for row in rows
    ]
    return Table("Phi^2 on X = 0, L/W = 2", columns, shown)


def _plot(errors: dict[float, list[StripErrors]], solved: Rings, path: Path) -> None:
    """Draw the ray angles along the strip with its errors over load, and one annulus."""
    with style.applied():
        figure = style.new(style.WIDE, 5.0)
        left, middle, right = figure.subplots(1, 3)
        stations = np.linspace(0.0, 0.5 * STRIP.length, 41)
        left.plot(stations, np.degrees(STRIP.angles(stations)), "-", label="rays")
        least = errors[POISSON][-1]
        angles = STRIP.angles(STATIONS) * (1.0 + least.angles)
        left.plot(STATIONS, np.degrees(angles), "o", color=style.VERMILLION, label="sheet")
        left.set(xlabel=r"$s/H$", ylabel="angle of the ray (degrees)")
        left.legend()
        looks = style.looks([str(poisson) for poisson in errors])
        for (poisson, rows), look in zip(errors.items(), looks, strict=True):
            scales = [row.scale for row in rows]
            away = [abs(row.normal) for row in rows]
            middle.loglog(scales, away, look.line, color=look.color, label=rf"$\nu = {poisson:g}$")
        middle.set(xlabel="load", ylabel="error of the force")
        middle.legend()
        exact, state = solved.exact, solved.planar[-1]
        right.plot(exact.radii, exact.positions - exact.radii, "-", label="radial")
        places, moved = state.radii[::6], (state.positions - state.radii)[::6]
        right.plot(places, moved, "o", color=style.VERMILLION, label="sheet")
        right.axvline(exact.interface, color=style.GREY, linestyle=":")
        right.set(xlabel="R", ylabel="r - R")
        right.legend()
        style.save(figure, path)


def quick() -> list[Check]:
    """Return the checks of the rays alone, the annuli, and Phi^2 at one strain."""
    checks = _ray_checks()
    for name, case in ANNULI.items():
        checks += ring_checks(name, case, rings(case, RINGS[-1:]))
    return [*checks, *width_checks(widths(QUICK_STRAIN, MESHES[1:2]))]


def taut_corner_text(plain: StripErrors, contracting: StripErrors) -> str:
    """Say what lateral contraction does to the force's error at the least load.

    Parameters
    ----------
    plain, contracting : StripErrors
        Without lateral contraction and with it.
    """
    numbers = (
        f"At the least load the force away deviates by {abs(plain.normal):.0e} with nu = 0, where "
        f"{plain.taut:.1%} of the sheet is taut, and by {abs(contracting.normal):.0e} with "
        f"nu = {POISSON:g}, where {contracting.taut:.1%} is."
    )
    corner = (
        " At a clamp the strain along it is zero, so that rays with cot^2 < nu leave the sheet "
        "taut there, which Mansfield's rays do not know."
    )
    explained = abs(plain.normal) < 0.2 * abs(contracting.normal) and plain.taut < contracting.taut
    return numbers + conclusion(explained, corner, "")


def _text(errors: dict[float, list[StripErrors]], rows: list[Widths]) -> str:
    centre = errors[POISSON][0].angles[0]
    away = max(abs(row.library[1] / row.other - 1.0) for row in rows)
    estimated = max(row.estimate / row.library[1] for row in rows)
    return (
        "The relaxed energy is minimised, with the derivatives and Newton's method of the library, "
        "where the answer is known otherwise.\n\n"
        "**Sheared strip.** Between clamps 100 mm apart and 200 mm long, one of them moved by 0.2 "
        "mm away and 0.6 mm along (load 1), tension rays run from clamp to clamp. For small "
        "strains the family of rays of largest energy has the first integral f(c) h(p) = f(c0) "
        "with the cotangent c of a ray, f = ((u + v c)/(1 + c^2))^2, p = H c'/2 and h = p^2/((1 - "
        "p^2) artanh^2 p); the free ends are rays, c = 0 (E. H. Mansfield, Proc. R. Soc. Lond. A "
        f"316, 269 (1970)). The centre ray stands at {STRIP.angle(0.0):.6f} rad, that of an "
        f"endless strip at {STRIP.endless_angle:.6f} rad; at load 1 the sheet's deviates by "
        f"{100.0 * centre:.2f}%. Strains are finite there, so that the load is lowered. "
        f"{taut_corner_text(errors[0.0][-1], errors[POISSON][-1])}\n\n"
        "**Annulus.** Pulled between its hole and its edge at large strain, in a Mooney-Rivlin "
        "sheet: R P(r') = C where radial wrinkles hide width, the radial equation of the law "
        "farther out, r/R = n(r') between the two. The sheet is a quarter of biquadratic elements "
        "in radius and angle with an assembly of its own.\n\n"
        "**Hidden width.** Phi^2 of the latex sheet by the library and on biquadratic elements "
        f"differ by at most {100.0 * away:.3f}%; the change from a mesh half as fine, the "
        f"library's own estimate of its error, is at most {100.0 * estimated:.2f}%."
    )


def run(output: AnyPath) -> None:
    """Write the group: sheared strip, annulus, hidden width."""
    output = Path(output)
    errors = {poisson: strip_errors(poisson) for poisson in (0.0, POISSON)}
    solved = {name: rings(case) for name, case in ANNULI.items()}
    rows = [widths(strain) for strain in STRAINS]
    checks = _ray_checks()
    for poisson, own in errors.items():
        checks += strip_checks(poisson, own)
    for name, case in solved.items():
        checks += ring_checks(name, ANNULI[name], case)
    for row in rows:
        checks += width_checks(row)
    _plot(errors, next(iter(solved.values())), output.with_name("tension_field.png"))
    caption = (
        "Left: angle between rays and clamps along the mid-line of the strip. Middle: error of "
        "the force that pulls its clamps apart. Right: displacement of the annulus, wrinkled left "
        "of the dotted line."
    )
    tables = [*(_strip_table(*item) for item in errors.items()), _ring_table(solved)]
    tables.append(_width_table(rows))
    plots = [("tension_field.png", caption)]
    text = _text(errors, rows)
    write(Group("tension_field", "Tension field", text, checks, tables, plots), output)
