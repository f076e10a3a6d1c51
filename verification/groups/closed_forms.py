"""Group 2: homogeneous stretch, bending stiffness, buckling and a plate against closed forms."""

from pathlib import Path

import numpy as np

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools import bending, stiffness, stretching
from verification.tools.sheets import BENDING_LAWS
from wrinklestudy.material.homogeneous import nominal_stress
from wrinklestudy.mechanics.laws import Material, MooneyRivlin
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath

C10, C01 = 6.21e4, 1.58e5  # the latex sheet of the paper, Pa
LAW = MooneyRivlin(0.5 * C10 / (C10 + C01), 0.5 * C01 / (C10 + C01))
STRETCHES = (1.0, 1.2, 1.5, 2.0)
BENDS = (1e-3, 0.03, 0.1, 0.3)
PLATE_CELLS = (4, 8, 16)
STRIP_CELLS = (8, 16, 32)
EULER_CELLS = (4, 8, 16)
SHORTENINGS = (0.05, 0.2, 0.5)


def _stretch() -> tuple[list[Check], Table]:
    """Return the homogeneous states of the assembled sheet against their formulas."""
    checks: list[Check] = []
    rows: list[list[str]] = []
    for name, law, mode, stretch in stretching.cases():
        computed = stretching.solve(law, mode, stretch)
        along, across, width = stretching.exact(law, mode, stretch)
        case = f"{name}, {mode} {stretch:g}"
        error = (abs(computed.along - along) + abs(computed.across - across)) / along
        curve = float(nominal_stress(Material(law, 1.0), stretch, mode))
        reason = "the homogeneous state lies in the space; only rounding remains"
        fitted = "the curve that the material stage fits is that of the sheet"
        checks += [
            Check(f"{case}: nominal stresses", error, 1e-11, kind="at most", reason=reason),
            Check(f"{case}: deviation", computed.deviation, 1e-10, kind="at most", reason=reason),
            Check(f"{case}: fitted curve", curve, along, 1e-12, reason=fitted),
        ]
        numbers = (computed.along, along, computed.across, across, computed.width, width)
        rows.append([case, *(f"{value:z.8f}" for value in numbers)])
    columns = ("case", "T1", "formula", "T2", "formula", "y/Y at the edge", "formula")
    return checks, Table("Nominal stresses in units of mu", columns, rows)


def _stiffness() -> tuple[list[Check], Table]:
    """Return the bending stiffness of the assembled tangent against the formula."""
    checks, rows = [], []
    for name, (law, stretches) in stretching.CASES.items():
        for stretch in (1.0, *stretches):
            for option in BENDING_LAWS:
                computed = stiffness.stiffness(law, option, stretch)
                exact = stiffness.stiffness_formula(law, option, stretch)
                case = f"{name}, {option}, stretch {stretch:g}"
                for direction, value, formula in zip(
                    ("along", "across"), computed, exact, strict=True
                ):
                    reason = (
                        "w = X^2/2 lies in the space; rounding, amplified by the tension's part"
                    )
                    checks.append(
                        Check(f"{case}: D {direction}", value, formula, 1e-8, "relative", reason)
                    )
                shown = [computed[0], exact[0], computed[1], exact[1]]
                rows.append([case, *(f"{value:.8f}" for value in shown)])
    columns = ("case", "D/(mu t^3) along", "formula", "across", "formula")
    return checks, Table("Cylindrical bending stiffness of a stretched sheet", columns, rows)


Ratios = dict[str, list[float]]  # of the energies at all `STRETCHES`


def _flexure() -> tuple[list[Check], Table, Ratios]:
    """Return the plate's bending energy against the exact flexure of a stretched block.

    The ratios are those of the least bend.
    """
    checks, rows = [], []
    least: Ratios = {option: [] for option in BENDING_LAWS}
    for stretch in STRETCHES:
        for bend in BENDS:
            exact = stiffness.flexure(LAW, stretch, bend)
            ratios = {
                option: stiffness.flexure_plate(LAW, option, stretch, bend) / exact
                for option in BENDING_LAWS
            }
            shown = (f"{ratio:.6f}" for ratio in ratios.values())
            rows.append([f"{stretch:g}", f"{bend:g}", *shown])
            if bend == BENDS[0]:
                checks += _flexure_checks(stretch, ratios)
                for option, ratio in ratios.items():
                    least[option].append(ratio)
    title = "Bending energy across the pull over that of Rivlin's flexure"
    columns = ("stretch", "t lambda3 kappa", *BENDING_LAWS)
    return checks, Table(title, columns, rows), least


def _flexure_checks(stretch: float, ratios: dict[str, float]) -> list[Check]:
    bend = BENDS[0]
    case = f"flexure at stretch {stretch:g}, bend {bend:g}"
    exact = "exact to t^3: the next term is the square of the bend"
    stiff = "lambda3^-2 = lambda: the stretched block has not its initial thickness"
    fixed = "fixed-thickness over exact"
    return [
        Check(f"{case}: thinning over exact", ratios["thinning"], 1.0, bend**2, "absolute", exact),
        Check(
            f"{case}: {fixed}",
            ratios["fixed-thickness"],
            stretch,
            2 * stretch * bend**2,
            "absolute",
            stiff,
        ),
    ]


def flexure_text(least: Ratios) -> str:
    """Say of each bending law how its energy compares with the exact one over `STRETCHES`."""
    verdicts = []
    for option, ratios in least.items():
        worst = max(ratios, key=lambda ratio: abs(ratio - 1.0))
        exact = all(abs(ratio - 1.0) <= BENDS[0] ** 2 for ratio in ratios)
        off = conclusion(worst > 1.0, "stiffer", "softer")
        wrong = f"is up to {abs(worst - 1.0):.0%} {off} than the exact solution"
        right = f"agrees with the exact solution to {abs(worst - 1.0):.0e}"
        verdicts.append(f"`{option}` {conclusion(exact, right, wrong)}")
    return (
        f"At t lambda3 kappa = {BENDS[0]:g} and stretches up to {STRETCHES[-1]:g} "
        f"{', '.join(verdicts)}."
    )


def _buckling() -> tuple[list[Check], Table]:
    """Return the critical compression of a wide strip against Euler's load."""
    checks: list[Check] = []
    rows: list[list[str | int]] = []
    thickness = bending.STRIP_THICKNESS
    formula = bending.euler_formula(LAW, thickness)
    for option in BENDING_LAWS:
        for cells in EULER_CELLS:
            computed = bending.euler(LAW, option, thickness, cells)
            rows.append(
                [option, cells, f"{computed.strain:.6e}", f"{computed.force / formula - 1.0:.2e}"]
            )
        reason = (
            f"4 pi^2 D/L^2; the strip is compressed by {computed.strain:.1e}, which changes its "
            f"stiffness by some times that"
        )
        name = f"Euler load, {option}, {cells} cells"
        checks.append(Check(name, computed.force / formula, 1.0, 2e-5, "absolute", reason))
    columns = ("bending law", "cells", "critical strain", "P/P_Euler - 1")
    return checks, Table("Euler load of a wide clamped strip", columns, rows)


def _elastica() -> tuple[list[Check], Table, list[float]]:
    """Return the shortened strip against the elastica, and the errors that are plotted."""
    checks: list[Check] = []
    rows: list[list[str]] = []
    plotted: list[float] = []
    options: tuple[str, ...] = ("thinning", "fixed-thickness")
    cases = [(s, option, cells) for s in SHORTENINGS for option in options for cells in STRIP_CELLS]
    for shortening, option, cells in [*cases, (SHORTENINGS[1], "fvk", STRIP_CELLS[-1])]:
        formula, _ = bending.elastica_formula(LAW, shortening)
        computed = bending.elastica(LAW, option, shortening, cells)
        errors = (
            computed.force / formula.force - 1.0,
            computed.deflection / formula.deflection - 1.0,
        )
        rows.append([f"{shortening:g}", option, f"{cells}", *(f"{error:.1e}" for error in errors)])
        if shortening == SHORTENINGS[1] and option == "thinning":
            plotted.append(abs(errors[0]))
        if cells < STRIP_CELLS[-1] or option == "fvk":
            continue
        for name, error in zip(("force", "deflection"), errors, strict=True):
            reason = (
                "inextensible elastica 16 K^2 D/L^2 and k L/K; discretisation (see the coarser "
                "meshes), (t kappa)^2 and stretching remain"
            )
            case = f"elastica shortened by {shortening:g}, {option}, {cells} cells: {name}"
            checks.append(Check(case, 1.0 + error, 1.0, 5e-4, "absolute", reason))
    columns = ("shortening/L", "bending law", "cells", "P error", "deflection error")
    table = Table("Clamped strip after large shortening, against the elastica", columns, rows)
    return checks, table, plotted


def _plate() -> tuple[list[Check], Table, list[float]]:
    """Return the clamped plate against its series, and the errors that are plotted."""
    checks: list[Check] = []
    rows: list[list[str]] = []
    for option in BENDING_LAWS:
        computed = [bending.clamped_plate(LAW, option, cells) for cells in PLATE_CELLS]
        errors = [abs(value / bending.CLAMPED_PLATE - 1.0) for value in computed]
        for cells, value, error in zip(PLATE_CELLS, computed, errors, strict=True):
            rows.append([option, f"{cells} x {cells}", f"{value:.10f}", f"{error:.1e}"])
        name = f"clamped plate, {option}"
        reason = "coefficient of the series solution of a clamped square plate"
        order = float(np.log2(errors[-2] / errors[-1]))
        checks += [
            Check(f"{name}, finest mesh", computed[-1], bending.CLAMPED_PLATE, 1e-6, reason=reason),
            Check(
                f"{name}: observed order",
                order,
                4.0,
                0.3,
                "absolute",
                "cubics have order 2 in curvature, their energy the double",
            ),
        ]
    columns = ("bending law", "cells (quarter)", "w_max D/(q a^4)", "error")
    return checks, Table("Clamped square plate under uniform pressure", columns, rows), errors


def _plot(strip: list[float], plate: list[float], path: Path) -> None:
    """Draw the stiffness across the pull against stretch, and errors against cells."""
    stretch = np.linspace(1.0, 2.0, 41)
    with style.applied():
        figure = style.new(style.WIDE, 5.0)
        left, right = figure.subplots(1, 2)
        for option, look in zip(BENDING_LAWS, style.looks(list(BENDING_LAWS)), strict=True):
            formula = [stiffness.stiffness_formula(LAW, option, s)[1] for s in stretch]
            left.plot(stretch, formula, look.line, color=look.color, label=option)
        exact = [stiffness.flexure(LAW, s, BENDS[0]) for s in STRETCHES]
        left.plot(STRETCHES, exact, "x", color=style.BLACK, label="exact flexure")
        left.set(xlabel=r"stretch $\lambda$", ylabel=r"$D_{\mathrm{across}}/(\mu t^3)$")
        left.legend()
        right.loglog(STRIP_CELLS, strip, "s--", color=style.VERMILLION, label="elastica, force")
        right.loglog(PLATE_CELLS, plate, "o-", color=style.BLUE, label=r"plate, $w_{\max}$")
        cells = np.array([PLATE_CELLS[0], STRIP_CELLS[-1]], dtype=float)
        right.loglog(cells, 2e-3 * cells**-4.0, ":", color=style.GREY, label="order 4")
        right.set(xlabel="cells on half the length", ylabel="relative error")
        right.set_xticks([4, 8, 16, 32], ["4", "8", "16", "32"])
        right.minorticks_off()
        right.legend()
        style.save(figure, path)


def quick() -> list[Check]:
    """Return the cheap checks of the group: all except the buckled strips."""
    return [*_stretch()[0], *_stiffness()[0], *_flexure()[0], *_plate()[0]]


def run(output: AnyPath) -> None:
    """Write the group: closed forms of stretching and bending."""
    output = Path(output)
    strip_checks, strip_table, strip = _elastica()
    plate_checks, plate_table, plate = _plate()
    _plot(strip, plate, output.with_name("closed_forms.png"))
    flexure_checks, flexure_table, least = _flexure()
    results = [_stretch(), _stiffness(), (flexure_checks, flexure_table), _buckling()]
    results += [(strip_checks, strip_table), (plate_checks, plate_table)]
    checks = [check for own, _ in results for check in own]
    tables = [table for _, table in results]
    plots = [
        (
            "closed_forms.png",
            "Left: bending stiffness across the pull of a uniaxially stretched Mooney-Rivlin sheet "
            "and of the exact flexure. Right: errors of the strip shortened by "
            f"{SHORTENINGS[1]:g} (`thinning`) and of the clamped plate (`{BENDING_LAWS[-1]}`).",
        )
    ]
    write(Group("closed_forms", "Closed forms", _text(least), checks, tables, plots), output)


def _text(least: Ratios) -> str:
    slenderness = bending.STRIP_LENGTH / bending.STRIP_THICKNESS
    _, modulus = bending.elastica_formula(LAW, SHORTENINGS[-1])
    return (
        "All of this is the assembled sheet with boundary conditions of its own; the energy, "
        "residual, tangent and Newton's method are those of the library.\n\n"
        "**Homogeneous stretch.** The end is pulled and slides freely, the long edge is free "
        "(uniaxial) or moved (shear, biaxial); Newton starts from a shaken state. With principal "
        "stretches l1, l2 and l3 = 1/(l1 l2): T1 = 2 C10 (l1 - l1^-3 l2^-2) + 2 C01 (l1 l2^2 - "
        "l1^-3); Saint Venant-Kirchhoff: T1 = 2 mu l1 (E11 + nu E22)/(1 - nu).\n\n"
        "**Bending stiffness.** With g(zeta) = a - 2 zeta lambda3 b the energy is "
        "psi = int W(g) dzeta = t W(a) + (t^3/6) lambda3^2 b.W''(a).b + O(t^5), so that bending "
        "in one direction costs D b^2/2 for each reference area with "
        "D = (t^3/3) lambda3^2 d2W/dg_kk^2. Uniaxially stretched to lambda (g22 = 1/lambda): "
        "d2W/dg22^2 = 2 c10 lambda + 2 c01 lambda^3 across the pull, 2 c10 lambda^-5 + 2 c01 "
        "lambda^-6 along it, lambda3^2 = 1/lambda for `thinning` and 1 for `fixed-thickness`; "
        "`fvk` has the constant mu t^3/(6 (1 - nu)). Saint Venant-Kirchhoff: d2W/dg^2 = "
        "1/(2 (1 - nu)), lambda3^2 = 1 - nu (lambda^2 - 1). The table compares with the tangent "
        "on w = X^2/2 and Y^2/2, less the work of the tension.\n\n"
        "**Which law is right?** Bending a stretched incompressible block into a cylinder around "
        "the pull has an exact solution of three-dimensional elasticity (Rivlin's flexure): "
        "incompressibility makes r^2 linear in Z, the squared stretch around the cylinder is p = "
        "p0 + 2 c Z/lambda for the angle c Y, and the energy is U = (lambda/2c) int W(p) dp "
        "between the faces, with W equal on both (traction-free). Expanded, U = t W + (t^3/6) "
        "(c/lambda)^2 W''(p0); the curvature is b = lambda2 c, so that D = (t^3/3) lambda3^2 W'', "
        "which is the formula of `thinning` above; `fixed-thickness` is lambda times as stiff. "
        f"{flexure_text(least)} For bending along the pull the plate leaves out terms proportional "
        "to the stress in that direction (the third fundamental form); this solution says nothing "
        "of them.\n\n"
        f"**Euler load** of a strip of L/t = {slenderness:g} with clamped ends and held width: "
        "4 pi^2 D/L^2. **Elastica**: the same strip pushed on; shortening/L = 2 - 2 E(k)/K(k), "
        "P = 16 K(k)^2 D/L^2, deflection k L/K(k). It turns by up to "
        f"{np.degrees(2.0 * np.arcsin(modulus**0.5)):.0f} degrees and so tests "
        "rotations; `fvk`, which takes second derivatives of w for the curvature and is meant for "
        "small rotations, is shown for information. **Clamped plate**: a square of "
        f"t/a = {bending.PLATE_THICKNESS:g} under a pressure that deflects it by "
        f"{bending.PLATE_DEFLECTION:g} t."
    )
