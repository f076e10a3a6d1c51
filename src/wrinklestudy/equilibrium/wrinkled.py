"""The wrinkle stage: the wrinkled equilibrium of one sheet at one strain.

No path is followed: the state starts from the flat state plus the modes with amplitudes that
minimise the reduced energy, and the full energy is minimised from there. It is accepted where the
residual is small, the tangent positive definite and the energy below that of the flat state.
"""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.equilibrium import newton
from wrinklestudy.equilibrium.flat import ROUNDING, Flat
from wrinklestudy.equilibrium.modes import Modes
from wrinklestudy.equilibrium.planar import Planar
from wrinklestudy.equilibrium.problem import PlateProblem, Predicting
from wrinklestudy.equilibrium.seeds import seed_position, seeds
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import Status

# Steps with a predicted tangent lead along narrow valleys of the energy, a little up their walls.
_RISE = 10.0


@dataclass(frozen=True)
class WrinkleSettings:
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


def solve(planar: Planar, thickness: float, settings: WrinkleSettings | None = None) -> Equilibrium:
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
    settings = settings or WrinkleSettings()
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
    planar: Planar, problem: PlateProblem, start: Array, settings: WrinkleSettings
) -> Equilibrium:
    """Minimise the energy from a seed and check what was found."""
    flat, modes = problem.flat, problem.modes
    thickness, solver = problem.section.thickness, problem.assembler.solver
    flat_energy = thickness * flat.energy
    options = newton.NewtonOptions(
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
