"""The four classes of perturbations against the whole sheet, and against the flat state."""

from dataclasses import replace

import numpy as np

from verification.checks import Check
from verification.tools.sheets import (
    LATEX,
    PARITIES,
    THICKNESS,
    both_parities,
    planar_state,
    quarter,
    solved,
)
from wrinklestudy.equilibrium import flat, mirror_stability
from wrinklestudy.equilibrium.mirror_stability import MirrorClass
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.wrinkled import Equilibrium, solve
from wrinklestudy.fem.assembly import Assembler
from wrinklestudy.fem.element import ORDERS
from wrinklestudy.fem.factorisation import make_indefinite_solver
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import plate
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

SLIDING = MirrorClass(keeps_x=True, keeps_y=False)
THINNER = (4.0e-4, 2.0e-4)


def name(kind: MirrorClass) -> str:
    """Return a class of perturbations in words."""
    return ", ".join(f"{'keeps' if k else 'breaks'} {a}" for k, a in zip(kind, "xy", strict=True))


def whole_sheet_inertia(state: Equilibrium) -> int:
    """Return the negative eigenvalues of the tangent of the whole sheet, without any mirror.

    The state of the quarter is reflected into the other three; only the clamps hold.
    """
    _, space, quarter_position = solved(state)
    grid = space.grid
    whole = Space(Grid(_mirrored(grid.x), _mirrored(grid.y)))
    nodes = space.nodes_from_field(quarter_position)
    odd_y = state.planar.settings.parity == "antisymmetric"
    for axis, odd in ((0, (True, False, False)), (1, (False, True, odd_y))):
        signs = np.array([[(-1.0) ** (o[axis] + is_odd) for o in ORDERS] for is_odd in odd])
        image = np.flip(nodes, axis=2 + axis) * signs[:, :, None, None]
        keep = [slice(None)] * 4
        keep[2 + axis] = slice(0, -1)
        nodes = np.concatenate([image[tuple(keep)], nodes], axis=2 + axis)
    free = np.ones((3, whole.size), dtype=bool)
    for edge in ("left", "right"):  # the clamped ends
        free[:2, whole.edge_dofs(edge, ["u", "u_y"])] = False
        free[2, whole.edge_dofs(edge, ["u", "u_x", "u_y", "u_xy"])] = False
    bending = state.planar.settings.bending
    section = Section(state.planar.material.law, state.thickness, bending)
    surface, slopes = plate.respond(section, whole.derivatives(whole.field_from_nodes(nodes)))
    solver = make_indefinite_solver()
    solver.factorise(Assembler(whole, free).tangent(plate.hessian(surface, slopes)))
    return solver.negative_eigenvalues


def _mirrored(lines: Array) -> Array:
    return np.concatenate([-lines[:0:-1], lines])


def checks() -> list[Check]:
    """Return the checks of the four classes, on a coarse mesh."""
    mesh, strain, thick = (8, 18), 0.12, 2.0e-3
    space = quarter(*mesh)
    rows: list[Check] = []
    for parity, state in zip(PARITIES, both_parities(space, strain), strict=True):
        # With the stiffness of a thinner sheet the same shape has unstable directions to count
        for thickness in (THICKNESS, *THINNER):
            probe = replace(state, thickness=thickness)
            counts = [c.unstable for c in mirror_stability.classes(probe, eigenvalues=())]
            rows.append(
                Check(
                    f"{parity}, {mesh[0]} x {mesh[1]} cells, stiffness for t/W = {thickness:g}: "
                    "unstable directions",
                    sum(counts),
                    whole_sheet_inertia(probe),
                    kind="absolute",
                    reason="inertia of the tangent of the whole sheet, assembled without mirrors",
                )
            )
    known = flat.solve(space, LATEX.law, strain)
    planar = [planar_state(known, LATEX, PlanarSettings(parity=parity)) for parity in PARITIES]
    sheet = solve(planar[0], thick)
    for kind, other in zip((MirrorClass(True, True), SLIDING), planar, strict=True):
        squared = float("nan") if other.modes is None else float(other.modes.squared[0])
        stability = next(c for c in mirror_stability.classes(sheet) if c[:2] == kind)
        rows.append(
            Check(
                f"flat sheet of t/W = {thick:g}, class ({name(kind)}): softest eigenvalue",
                stability.softest,
                1.0 - squared / thick**2,
                1e-6,
                reason="1 - (tau_1/t)^2, tau_1 of that parity from the flat state",
            )
        )
    return rows
