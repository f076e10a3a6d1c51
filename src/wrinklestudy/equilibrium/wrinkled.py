"""The wrinkle stage: the wrinkled equilibrium of one sheet at one strain.

No path is followed: the state starts from the flat state plus the modes with amplitudes that
minimise the reduced energy, and the full energy is minimised from there. It is accepted where the
residual is small, the tangent positive definite and the energy below that of the flat state.
"""

from dataclasses import dataclass
from functools import partial

import numpy as np

from wrinklestudy.equilibrium import newton
from wrinklestudy.equilibrium.flat import ROUNDING, Flat
from wrinklestudy.equilibrium.modes import Modes
from wrinklestudy.equilibrium.planar import Planar
from wrinklestudy.equilibrium.problem import PlateProblem, Predicting
from wrinklestudy.equilibrium.seeds import seed_position, seeds
from wrinklestudy.equilibrium.thin_seeds import THIN, thin_seed
from wrinklestudy.fem.factorisation import count_negative_eigenvalues
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
        Of the part that is solved, in units of mu W^3, NaN where unknown.
    nominal_stress : float
        Force at the clamp / (W t) in units of mu.
    unstable_directions : int
        Negative eigenvalues of the tangent within the symmetry of the state; -1 where unknown.
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


def solve(
    planar: Planar,
    thickness: float,
    settings: WrinkleSettings | None = None,
    observer: newton.Observer | None = None,
) -> Equilibrium:
    """Return the equilibrium of a sheet of thickness t/W from its planar state.

    Where t exceeds the critical thickness tau_1 the flat state is the answer.

    Parameters
    ----------
    planar : Planar
    thickness : float
        t/W.
    settings : WrinkleSettings, optional
    observer : newton.Observer, optional
        Is told of each iteration.

    Raises
    ------
    ValueError
        If the thickness is not positive.
    """
    if not thickness > 0:
        raise ValueError(f"thickness = {thickness:g}: must be > 0 (in units of W)")
    settings = settings or WrinkleSettings()
    if planar.flat is None or planar.modes is None:
        return _unknown(planar, thickness)
    if thickness >= planar.modes.critical_thickness:
        return _flat(planar, planar.flat, planar.modes, thickness)
    states = []
    if thickness < THIN * planar.modes.critical_thickness:
        start = thin_seed(planar, thickness, observer)
        if start is not None:
            states.append(minimise_from(planar, thickness, start, settings, observer))
            if states[0].status == "wrinkled":
                return states[0]
    states += [
        minimise_from(
            planar, thickness, seed_position(planar.flat, planar.modes, q), settings, observer
        )
        for q in seeds(planar.modes, thickness)[: settings.seeds]
    ]
    if not states:
        raise RuntimeError("no seed although the flat state is unstable")
    return min(states, key=lambda state: (state.status == "not-converged", state.energy))


def minimise_from(
    planar: Planar,
    thickness: float,
    start: Array,
    settings: WrinkleSettings | None = None,
    observer: newton.Observer | None = None,
) -> Equilibrium:
    """Return the equilibrium to which the energy falls from a start, and whether it is wrinkled.

    Parameters
    ----------
    planar : Planar
    thickness : float
        t/W, below the critical one.
    start : (3, size) array
        Position as dof vectors; only its free values count.
    settings : WrinkleSettings, optional
    observer : newton.Observer, optional
        Is told of each iteration.

    Raises
    ------
    ValueError
        If there is no flat state.
    """
    if planar.flat is None or planar.modes is None:
        raise ValueError(f"no flat state to start from: {planar.reason}")
    settings, flat_energy = settings or WrinkleSettings(), thickness * planar.flat.energy
    problem = PlateProblem.of_flat(planar.flat, planar.modes, thickness)
    options = newton.NewtonOptions(
        tolerance=settings.tolerance,
        max_iterations=settings.max_iterations,
        first_shift=min(thickness**2, 0.25 * (planar.modes.squared[0] - thickness**2)),
        rise=_RISE,
        ceiling=flat_energy,
        noise=ROUNDING * thickness,
        observe=None if observer is None else partial(observer, "wrinkled state"),
    )
    minimum = newton.minimise(
        Predicting(problem), start[problem.assembler.free], problem.assembler.solver, options
    )
    return _checked(planar, problem, minimum)


def _checked(planar: Planar, problem: PlateProblem, minimum: newton.Minimum) -> Equilibrium:
    """Return the state where a minimisation ended, converged only if it lies below the flat one."""
    if planar.flat is None or planar.modes is None:
        raise ValueError(f"no flat state to compare with: {planar.reason}")
    thickness = problem.thickness
    flat_energy = thickness * planar.flat.energy
    reason, unstable = minimum.reason, 0
    if not reason and not minimum.energy < flat_energy:
        reason = "the energy is not below that of the flat state"
    if reason:
        tangent = minimum.tangent
        unstable = -1 if tangent is None else count_negative_eigenvalues(tangent)
    clamp, reactions = planar.modes.symmetry.clamp, problem.reactions(minimum.unknowns)
    last = minimum.history[-1].decrement if minimum.history else float("nan")
    return Equilibrium(
        planar,
        thickness,
        status="not-converged" if reason else "wrinkled",
        reason=reason,
        position=problem.position(minimum.unknowns),
        energy=minimum.energy,
        flat_energy=flat_energy,
        nominal_stress=clamp.force(planar.flat.space, reactions) / thickness,
        unstable_directions=unstable,
        residual=last / flat_energy,
        history=minimum.history,
    )


def _flat(planar: Planar, flat: Flat, modes: Modes, thickness: float) -> Equilibrium:
    energy = thickness * flat.energy
    return Equilibrium(
        planar,
        thickness,
        status="flat",
        reason="",
        position=flat.sheet_position,
        energy=energy,
        flat_energy=energy,
        nominal_stress=flat.force,
        unstable_directions=int(np.sum(modes.squared > thickness**2)),
        residual=abs(flat.history[-1].decrement) / flat.energy,
        history=(),
    )


def _unknown(planar: Planar, thickness: float) -> Equilibrium:
    nan = float("nan")
    return Equilibrium(
        planar,
        thickness,
        status="not-converged",
        reason=planar.reason,
        position=None,
        energy=nan,
        flat_energy=nan,
        nominal_stress=nan,
        unstable_directions=-1,
        residual=nan,
        history=(),
    )
