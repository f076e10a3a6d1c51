"""Group: sheets without mirrors, with clamps that are off, against what is known of them."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from verification.checks import Check, Group, Table, write
from verification.tools.sheets import LATEX, PARITIES
from wrinklestudy import Clamps, MeshSettings, Sheet, ThicknessField
from wrinklestudy.results.whole import WholeState
from wrinklestudy.typing import AnyPath
from wrinklestudy.vocabulary import PARTS, Parity

STRAIN, THICKNESS, ASPECT = 0.12, 1.0e-3, 2.0
QUICK, MESH, FINER = MeshSettings(8, 18), MeshSettings(12, 24), MeshSettings(18, 36)
SAME = 1.0e-6
REFINED = 5.0e-3
TURNED = Clamps(shear=0.02, rotate=0.03, twist=0.1, pitch=0.05, lift=0.02)
REFINED_CASES: dict[str, dict[str, Any]] = {
    "perfect": {},
    "sheared by 0.01 W": {"clamps": Clamps(shear=0.01)},
    "twisted by 0.05": {"clamps": Clamps(twist=0.05)},
    "right end thicker by a tenth": {"thickness_field": ThicknessField(along=0.1)},
}


def _sheet(mesh: MeshSettings, parity: Parity = "antisymmetric", **options: object) -> Sheet:
    return Sheet(ASPECT, THICKNESS, LATEX, parity=parity, mesh=mesh, **options)  # type: ignore[arg-type]


def _amplitude(sheet: Sheet) -> float:
    """Return A/t, NaN where the state did not converge."""
    value = sheet.solve(STRAIN).as_dict()["amplitude_over_thickness"]
    return float("nan") if value is None else float(value)


def parts(mesh: MeshSettings, chosen: Sequence[str] = PARTS[1:]) -> list[Check]:
    """Return checks that larger parts of a perfect sheet have the states of the quarter."""
    rows = []
    for parity in PARITIES:
        quarter = _amplitude(_sheet(mesh, parity))
        rows += [
            Check(
                f"{parity}, symmetry {part}: A/t of a perfect sheet",
                _amplitude(_sheet(mesh, parity, symmetry=part)),
                quarter,
                SAME,
                reason="that of the quarter sheet: a state keeps the mirrors that are left out",
            )
            for part in chosen
        ]
    return rows


def clamped(mesh: MeshSettings) -> list[Check]:
    """Return checks of the ends of a sheet whose clamps are shifted and turned in all ways."""
    state = _sheet(mesh, symmetry="whole", clamps=TURNED).solve(STRAIN)
    if not isinstance(state, WholeState) or state.measures is None:
        return [Check("sheet with turned clamps: converged", 0.0, 1.0)]
    shape, checks = state.shape, []
    for name, end, turns in (
        ("left", -1, (0.0, -0.5 * TURNED.twist, 0.0)),
        ("right", 1, (TURNED.rotate, 0.5 * TURNED.twist, TURNED.pitch)),
    ):
        x, y = np.array([0.5 * end * ASPECT]), np.linspace(-0.45, 0.45, 7)
        along, across = (shape.evaluate(x, y, *order)[:, 0] for order in ((1, 0), (0, 1)))
        normal = np.cross(along, across, axis=0)
        normal /= np.linalg.norm(normal, axis=0)
        checks.append(
            Check(
                f"{name} clamp, turned in the plane, twisted and pitched: sine of the angle "
                "between the normal of the sheet and that of the clamp",
                float(np.abs(np.cross(normal.T, _normal(*turns))).max()),
                0.0,
                1e-10,
                kind="absolute",
                reason="the sheet leaves a clamp within its plane, whatever way it is turned",
            )
        )
    return checks


def _normal(rotate: float, twist: float, pitch: float) -> np.ndarray:
    """Return the normal of a clamp that was pitched, then twisted, then turned in the plane."""
    vector = np.array([-np.sin(pitch), 0.0, np.cos(pitch)])
    c, s = np.cos(twist), np.sin(twist)
    vector = np.array([vector[0], c * vector[1] - s * vector[2], s * vector[1] + c * vector[2]])
    c, s = np.cos(rotate), np.sin(rotate)
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1], vector[2]])


def iterations(mesh: MeshSettings) -> list[Check]:
    """Return the check that Newton's method meets a correct tangent at turned clamps."""
    found = _sheet(mesh, symmetry="whole", clamps=TURNED).solve(STRAIN).as_dict()
    converged = found["status"] == "wrinkled"
    return [
        Check(
            "sheet with turned clamps: Newton iterations",
            float(found["newton_iterations"]) if converged else float("nan"),
            12.0,
            kind="at most",
            reason="the tangent is exact, so that convergence is quadratic",
        )
    ]


def quick() -> list[Check]:
    """Return the cheap checks, on a coarse mesh."""
    return [*parts(QUICK, ("whole",)), *clamped(QUICK), *iterations(QUICK)]


def refined() -> tuple[list[Check], Table]:
    """Return checks of the amplitude of imperfect sheets against a finer mesh, with the numbers."""
    checks, rows = [], []
    for name, options in REFINED_CASES.items():
        coarse, fine = (
            _sheet(mesh, symmetry="whole", **options).solve(STRAIN).as_dict()
            for mesh in (MESH, FINER)
        )
        for end in ("low", "high"):
            key = f"amplitude_{end}"
            values = [float("nan") if one[key] is None else one[key] for one in (coarse, fine)]
            checks.append(
                Check(
                    f"{name}: A/t at its {end}est phase",
                    values[0],
                    values[1],
                    REFINED,
                    reason=f"{FINER.cells_along} x {FINER.cells_across} cells to a quarter",
                )
            )
            rows.append((name, end, *values, fine["pin_reaction"], fine["softest_eigenvalue"]))
    columns = ("sheet", "phase", "A/t", "A/t, finer mesh", "pin", "softest eigenvalue")
    return checks, Table("Imperfect sheets on two meshes", columns, rows)


def run(output: AnyPath) -> None:
    """Compute the group and write it."""
    checks, table = refined()
    checks = [*parts(MESH), *clamped(MESH), *iterations(MESH), *checks]
    pins = [abs(float(row[4])) for row in table.rows if row[4] is not None]
    text = (
        "A perfect sheet that is solved without its mirrors has the states of the quarter. Where "
        "clamps are off, the sheet leaves each within the plane of the clamp. The pin that keeps "
        f"the pattern from sliding moves it by at most {max(pins, default=float('nan')):.0e} of "
        "the thickness."
    )
    write(Group("imperfections", "Imperfect sheets", text, checks, (table,)), Path(output))
