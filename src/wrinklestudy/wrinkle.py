"""The wrinkle stage: the wrinkled equilibrium of one sheet at one strain.

No path is followed: the state starts from the flat state plus the modes with amplitudes that
minimise the reduced energy, and the full energy is minimised from there. It is accepted where the
residual is small, the tangent positive definite and the energy below that of the flat state.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from wrinklestudy import newton
from wrinklestudy.flat import ROUNDING, Flat
from wrinklestudy.joblog import log_cpu
from wrinklestudy.material import laws
from wrinklestudy.modes import Modes
from wrinklestudy.planar import Planar
from wrinklestudy.planar import read as read_planar
from wrinklestudy.problem import PlateProblem, Predicting
from wrinklestudy.reduced import seed_position, seeds
from wrinklestudy.store import write_h5

Array = NDArray[np.float64]
Status = Literal["wrinkled", "flat", "not-converged"]

# Steps with a predicted tangent lead along narrow valleys of the energy, a little up their walls.
_RISE = 10.0


@dataclass(frozen=True)
class Settings:
    """Options of the wrinkle stage.

    Parameters
    ----------
    tolerance : float
        Part of the energy below which the Newton decrement must fall.
    max_iterations : int
        Limit of Newton iterations for each seed.
    seeds : int
        How many different seeds to minimise from at the most; the lowest energy is kept.
    """

    tolerance: float = 1.0e-22
    max_iterations: int = 200
    seeds: int = 1


@dataclass(frozen=True)
class Equilibrium:
    """State of one sheet at one strain.

    Parameters
    ----------
    planar : Planar
        The flat state it belongs to.
    thickness : float
        t/W.
    status : {'wrinkled', 'flat', 'not-converged'}
    reason : str
        Why it did not converge, else empty.
    position : (3, size) array or None
        Position as dof vectors in units of W; the last iterate where it did not converge.
    energy, flat_energy : float
        Of the quarter sheet in units of mu W^3, NaN where unknown.
    nominal_stress : float
        Force at the clamp / (W t) in units of mu.
    unstable_directions : int
        Negative eigenvalues of the tangent within the parity of the state; -1 where unknown.
    residual : float
        Last Newton decrement in parts of the energy.
    history : tuple of newton.Iteration
    """

    planar: Planar
    thickness: float
    status: Status
    reason: str
    position: Array | None
    energy: float
    flat_energy: float
    nominal_stress: float
    unstable_directions: int
    residual: float
    history: tuple[newton.Iteration, ...]


def solve(planar: Planar, thickness: float, settings: Settings | None = None) -> Equilibrium:
    """Return the equilibrium of a sheet of thickness t/W from its planar state.

    Where t exceeds the critical thickness tau_1 the flat state is the answer.

    Parameters
    ----------
    planar : Planar
    thickness : float
        t/W.
    settings : Settings, optional

    Raises
    ------
    ValueError
        If the thickness is not positive.
    """
    if not thickness > 0:
        raise ValueError(f"thickness = {thickness:g}: must be > 0 (in units of W)")
    settings = settings or Settings()
    if planar.flat is None or planar.modes is None:
        nan = float("nan")
        return Equilibrium(
            planar, thickness, "not-converged", planar.reason, None, nan, nan, nan, -1, nan, ()
        )
    if thickness >= planar.modes.critical_thickness:
        return _flat(planar, planar.flat, planar.modes, thickness)
    problem = PlateProblem(planar.flat, planar.modes, thickness)
    best: Equilibrium | None = None
    for amplitudes in seeds(planar.modes, thickness)[: settings.seeds]:
        start = seed_position(planar.flat, planar.modes, amplitudes)
        found = _wrinkled(planar, problem, start, settings)
        if best is None or _rank(found) < _rank(best):
            best = found
    if best is None:
        raise RuntimeError("no seed although the flat state is unstable")
    return best


def _rank(state: Equilibrium) -> tuple[bool, float]:
    return state.status == "not-converged", state.energy


def _flat(planar: Planar, flat: Flat, modes: Modes, thickness: float) -> Equilibrium:
    position = np.zeros((3, flat.space.size))
    position[:2] = flat.position
    energy = thickness * flat.energy
    unstable = int(np.sum(modes.squared > thickness**2))
    residual = abs(flat.history[-1].decrement) / flat.energy
    return Equilibrium(
        planar, thickness, "flat", "", position, energy, energy, flat.force, unstable, residual, ()
    )


def _wrinkled(
    planar: Planar, problem: PlateProblem, start: Array, settings: Settings
) -> Equilibrium:
    """Minimise the energy from a seed and check what was found."""
    flat, modes = problem.flat, problem.modes
    thickness, solver = problem.section.thickness, problem.assembler.solver
    flat_energy = thickness * flat.energy
    options = newton.Options(
        tolerance=settings.tolerance,
        max_iterations=settings.max_iterations,
        first_shift=min(thickness**2, 0.25 * (modes.squared[0] - thickness**2)),
        rise=_RISE,
        ceiling=flat_energy,
        noise=ROUNDING * thickness,
    )
    found = newton.minimise(Predicting(problem), start[problem.assembler.free], solver, options)
    clamp = flat.space.edge_dofs("clamp", ["u"])
    force = 2.0 * float(problem.reactions(found.unknowns)[0, clamp].sum()) / thickness
    reason = found.reason
    if not reason and not found.energy < flat_energy:
        reason = "the energy is not below that of the flat state"
    unstable = 0
    if reason:
        unstable = -1 if found.tangent is None else solver.negative(found.tangent)
    last = found.history[-1].decrement if found.history else float("nan")
    return Equilibrium(
        planar,
        thickness,
        "not-converged" if reason else "wrinkled",
        reason,
        problem.position(found.unknowns),
        found.energy,
        flat_energy,
        force,
        unstable,
        last / flat_energy,
        found.history,
    )


def run(
    planar: Path | str, thickness: float, settings: Mapping[str, Any], output: Path | str
) -> None:
    """Solve one sheet at one strain from its planar file and write the state.

    Parameters
    ----------
    planar : path
        HDF5 file of the planar stage.
    thickness : float
        t/W.
    settings : mapping
        Keys of `Settings`.
    output : path
        HDF5 file to write.
    """
    flat = read_planar(planar)
    with log_cpu("solve"):
        state = solve(flat, thickness, Settings(**settings))
    write(state, output)


def write(state: Equilibrium, output: Path | str) -> None:
    """Write a state as an HDF5 file; the position is in the layout of the grid."""
    planar = state.planar
    datasets: dict[str, Any] = {"grid/x": planar.grid.x, "grid/y": planar.grid.y}
    flat, modes = planar.flat, planar.modes
    if state.position is not None and flat is not None:
        datasets["position"] = flat.space.nodes_from_field(state.position)
    datasets["history"] = np.array(state.history).reshape(-1, len(newton.Iteration._fields))
    along, across = planar.grid.cells
    nan = float("nan")
    width = nan if flat is None else 2.0 * flat.space.nodes_from_field(flat.position)[1, 0, 0, -1]
    attrs = {
        "units": "lengths in W, stresses in the initial shear modulus mu, energies in mu W^3",
        "material": planar.name,
        **laws.describe(planar.material),
        "shear_modulus_pa": planar.material.shear_modulus,
        "young_modulus_pa": planar.material.young_modulus,
        "poisson": planar.material.law.poisson,
        "bending": planar.settings.bending,
        "parity": planar.settings.parity,
        "aspect": planar.grid.aspect,
        "thickness": state.thickness,
        "strain": planar.strain,
        "status": state.status,
        "reason": state.reason,
        "energy": state.energy,
        "flat_energy": state.flat_energy,
        "nominal_stress": state.nominal_stress,
        "nominal_stress_pa": state.nominal_stress * planar.material.shear_modulus,
        "critical_thickness": nan if modes is None else modes.critical_thickness,
        "planar_width_over_width": width,
        "unstable_directions": state.unstable_directions,
        "newton_iterations": newton.count(state.history),
        "residual": state.residual,
        "history_columns": list(newton.Iteration._fields),
        "cells_along": along,
        "cells_across": across,
    }
    write_h5(output, datasets, attrs)
