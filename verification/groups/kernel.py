"""Group 1: energy, residual and tangent belong together, and rigid motions cost nothing."""

import numpy as np

from verification.checks import Check, Group, Table, write
from verification.tools.consistency import (
    CURVATURE,
    POINTS,
    ROLL,
    SHIFT,
    THICKNESS,
    TURN,
    at_rest,
    curved,
    membrane_errors,
    plate_errors,
    point_errors,
    rigid_errors,
    states,
)
from verification.tools.problem import LoadedSheet
from wrinklestudy.equilibrium import flat, modes
from wrinklestudy.equilibrium.flat import MembraneProblem
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.equilibrium.seeds import seed_position, seeds
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import laws
from wrinklestudy.mechanics.bending import BENDING_LAWS
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import AnyPath

# Laws and the principal stretches of the states; SVK has no thickness left beyond its own.
LAWS: dict[str, tuple[Law, tuple[float, float]]] = {
    "mooney-rivlin": (laws.mooney_rivlin(6.21e4, 1.58e5).law, (0.75, 2.0)),
    "neo-hookean": (laws.neo_hookean(1.0).law, (0.75, 2.0)),
    "svk": (laws.saint_venant_kirchhoff(1.0, 0.5).law, (0.8, 1.12)),
}
CELLS = MeshSettings(6, 6)
GRADIENT_BOUND, HESSIAN_BOUND, TANGENT_BOUND, RIGID_BOUND = 1e-13, 1e-11, 1e-8, 1e-11


def _quarter_errors() -> list[tuple[str, float, float, float]]:
    """Return the errors for the quarter as the solver has it, near a flat and a wrinkled state."""
    law, strain, thickness = LAWS["mooney-rivlin"][0], 0.12, 1e-3
    space = Space(make_grid(2.0, settings=MeshSettings(10, 12)))
    guess = flat.stretched(space, strain)
    membrane = MembraneProblem(space, law, guess)
    rows = [
        ("flat quarter, first guess", *membrane_errors(membrane, guess[membrane.assembler.free]))
    ]
    state = flat.solve(space, law, strain)
    critical = modes.critical_modes(state, count=3)
    seed = seed_position(state, critical, seeds(critical, thickness)[0])
    problem = PlateProblem.of_flat(state, critical, thickness)
    return [*rows, ("wrinkled quarter, seed", *plate_errors(problem, seed[problem.assembler.free]))]


def _checks(name: str, errors: tuple[float, float, float]) -> list[Check]:
    """Return the checks of an assembled problem."""
    what = (
        ("residual", GRADIENT_BOUND, "complex steps in the energy have no truncation error"),
        ("tangent", TANGENT_BOUND, "eighth-order differences of the residual; their rounding"),
        ("asymmetry", TANGENT_BOUND, "the residual is a gradient, so that its slope is symmetric"),
    )
    return [
        Check(f"{name}: {part}", error, bound, kind="at most", reason=reason)
        for error, (part, bound, reason) in zip(errors, what, strict=True)
    ]


def _case(
    name: str, section: Section, stretches: tuple[float, float]
) -> tuple[list[Check], list[str]]:
    """Return checks and the row of the table for a law with a bending law."""
    space = Space(make_grid(2.0, settings=CELLS))
    start = curved(space)
    problem = LoadedSheet(space, section, np.ones(start.shape, dtype=bool), start)
    points = point_errors(section, states(stretches))
    assembled = plate_errors(problem, start.ravel())
    rigid = (*rigid_errors(section, space), *at_rest(section, space))
    checks = [
        Check(
            f"{name}: gradient at points",
            points[0],
            GRADIENT_BOUND,
            kind="at most",
            reason="complex steps in the energy have no truncation error",
        ),
        Check(
            f"{name}: Hessian at points",
            points[1],
            HESSIAN_BOUND,
            kind="at most",
            reason="eighth-order differences of the gradient; their rounding",
        ),
        *_checks(f"{name}, assembled", assembled),
        Check(
            f"{name}: rigid motions",
            max(rigid),
            RIGID_BOUND,
            kind="at most",
            reason="energy and internal forces do not depend on where the sheet is; rounding only",
        ),
    ]
    return checks, [name, *(f"{value:.0e}" for value in (*points, *assembled, *rigid))]


def _all_cases() -> tuple[list[Check], list[list[str]]]:
    checks: list[Check] = []
    rows: list[list[str]] = []
    for law, (energy, stretches) in LAWS.items():
        for bending in BENDING_LAWS:
            section = Section(energy, THICKNESS, bending)
            more, row = _case(f"{law}, {bending}", section, stretches)
            checks += more
            rows.append(row)
    return checks, rows


def quick() -> list[Check]:
    """Return the checks of the group; they are cheap."""
    checks, _ = _all_cases()
    for name, *errors in _quarter_errors():
        checks += _checks(name, (errors[0], errors[1], errors[2]))
    return checks


def run(output: AnyPath) -> None:
    """Write the group: consistency of energy, residual and tangent; rigid motions."""
    checks, rows = _all_cases()
    quarter = _quarter_errors()
    for name, *errors in quarter:
        checks += _checks(name, (errors[0], errors[1], errors[2]))
    columns = (
        "law, bending law",
        "gradient",
        "Hessian",
        "residual",
        "tangent",
        "asymmetry",
        "energy",
        "turned residual",
        "rigid work",
        "energy at rest",
        "residual at rest",
    )
    tables = [
        Table("Largest relative errors: points, assembled, rigid motions", columns, rows),
        Table(
            "The quarter sheet as the solver has it (Mooney-Rivlin, thinning)",
            ("where", "residual", "tangent", "asymmetry"),
            [[name, *(f"{error:.0e}" for error in errors)] for name, *errors in quarter],
        ),
    ]
    write(Group("kernel", "Kernel", _text(), checks, tables), output)


def _text() -> str:
    ranges = ", ".join(f"{low:g} to {high:g} ({law})" for law, (_, (low, high)) in LAWS.items())
    turn = np.degrees(np.linalg.norm(TURN))
    return (
        f"**Points.** {POINTS} random states x,1 x,2 x,11 x,22 x,12 for each law and bending law: "
        f"any rotation in space, principal stretches {ranges}, t x,ab up to {CURVATURE:g} in each "
        f"component. The gradient of the energy density is compared with complex steps in the "
        f"energy, the Hessian with eighth-order differences of the gradient; derivatives with "
        f"respect to x,ab count in units of t, so that bending weighs as much as stretching.\n\n"
        f"**Assembled.** A quarter sheet that is stretched, rolled up over "
        f"{np.degrees(ROLL):.0f} degrees, rippled and turned in space, all dofs free: "
        f"residual against complex steps, tangent against differences of the residual along "
        f"random directions, and the asymmetry v.r'(w) - w.r'(v) of the slope of the residual.\n\n"
        f"**Rigid motions.** The same state turned by {turn:.0f} degrees about a skew axis and "
        f"shifted by {np.linalg.norm(SHIFT):.1f} W: change of the energy, change of the residual "
        f"turned back, work of the residual in rigid velocities; energy and residual per t of the "
        f"undeformed sheet, turned. `fvk` is tied to the direction z: it is turned about z only."
    )
