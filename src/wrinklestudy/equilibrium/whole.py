"""Wrinkled states of a sheet without the mirror at Y = 0, with clamps that need not be perfect.

Each state starts from a seed of its own, as in `wrinkled`: the unwrinkled state with the modes in
amplitudes that minimise the reduced energy. Two states are solved, an odd and an even one, between
which the pattern can slide: what an experiment sees lies between them.
"""

from dataclasses import dataclass
from functools import partial
from typing import Literal

import numpy as np

from wrinklestudy.equilibrium import newton
from wrinklestudy.equilibrium.families import Family, families
from wrinklestudy.equilibrium.flat import ROUNDING, Flat
from wrinklestudy.equilibrium.flat import solve as solve_flat
from wrinklestudy.equilibrium.modes import deflection_forms
from wrinklestudy.equilibrium.pin import Pinned, Slide, pinned_dof, slide
from wrinklestudy.equilibrium.problem import PlateProblem, Predicting
from wrinklestudy.equilibrium.seeds import seed_position, seeds
from wrinklestudy.equilibrium.unwrinkled import lifted, planar_symmetry, plate_problem
from wrinklestudy.equilibrium.wrinkled import WrinkleSettings
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.factorisation import NotPositiveDefiniteError
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import Parity

# Steps with a predicted tangent lead along narrow valleys of the energy, a little up their walls.
_RISE = 10.0
_ABOVE = 1.2  # thickness, over tau_1, at which an unwrinkled state is lifted
WholeStatus = Literal["wrinkled", "unwrinkled", "flat", "not-converged"]


@dataclass(frozen=True)
class PhaseState:
    """A state of one parity of the pattern at the centre of the sheet.

    Parameters
    ----------
    parity : {'antisymmetric', 'symmetric'}
        Whether the deflection, or its slope across, is held at the centre.
    status : {'wrinkled', 'unwrinkled', 'flat', 'not-converged'}
        'unwrinkled' is a state that is not flat although the sheet is too thick to wrinkle.
    reason : str
        Why it did not converge, else empty.
    position : (3, size) array
        Position as dof vectors in units of W; the last iterate where it did not converge.
    energy : float
        Of the part that is solved, in units of mu W^3.
    nominal_stress : float
        Force at the clamp / (W t) in units of mu.
    slide : Slide or None
        What the pin carries and the eigenvalue without it; None without a pin.
    residual : float
        Last Newton decrement in parts of the energy.
    history : tuple of newton.Iteration
    """

    parity: Parity
    status: WholeStatus
    reason: str
    position: Array
    energy: float
    nominal_stress: float
    slide: Slide | None
    residual: float
    history: tuple[newton.Iteration, ...]


@dataclass(frozen=True)
class WholeEquilibrium:
    """The states of one sheet at one strain.

    Parameters
    ----------
    flat : Flat
        With the clamps in their plane.
    symmetry : Symmetry
        With the clamps as they are.
    thickness : float
        t/W, of an uneven sheet its mean.
    critical_thickness : float
        tau_1/W of the flat state.
    unwrinkled : (3, size) array
        The sheet without wrinkles.
    states : tuple of PhaseState
        That of the parity that was asked for, then the other.
    """

    flat: Flat
    symmetry: Symmetry
    thickness: float
    critical_thickness: float
    unwrinkled: Array
    states: tuple[PhaseState, ...]

    @property
    def state(self) -> PhaseState:
        """The state of the parity that was asked for."""
        return self.states[0]


@dataclass(frozen=True)
class WholeSettings:
    """What a sheet is like besides its size and material.

    Parameters
    ----------
    symmetry : Symmetry
        Mirrors and clamps.
    bending : str
        The bending law, a name in `mechanics.bending.BENDING_LAWS`.
    parity : {'antisymmetric', 'symmetric'}
        Of the pattern at the centre in the state that comes first.
    weight : float
        rho g W/mu; it pulls toward -z.
    modes : int
        Number of modes of each parity.
    """

    symmetry: Symmetry
    bending: str = "thinning"
    parity: Parity = "antisymmetric"
    weight: float = 0.0
    modes: int = 8

    @property
    def stays_flat(self) -> bool:
        """Whether nothing lifts the sheet out of its plane, so that z -> -z is a symmetry."""
        return self.symmetry.clamps.planar and self.weight == 0.0


def solve(
    space: Space,
    law: Law,
    strain: float,
    thickness: float,
    settings: WholeSettings,
    options: WrinkleSettings | None = None,
    observer: newton.Observer | None = None,
) -> WholeEquilibrium:
    """Return the odd and the even state of a sheet at a strain.

    Parameters
    ----------
    space : Space
        On the part of the sheet that is solved.
    law : Law
    strain : float
        eps = (L' - L)/L of the middles of the clamps.
    thickness : float
        t/W, of an uneven sheet its mean.
    settings : WholeSettings
    options : WrinkleSettings, optional
    observer : newton.Observer, optional
        Is told of each iteration.

    Raises
    ------
    ArithmeticError
        If there is no flat state, or the bending law has no value there; one line.
    """
    symmetry = planar_symmetry(settings.symmetry)
    flat = solve_flat(space, law, strain, symmetry=symmetry, observer=observer)
    if observer is not None:
        observer("modes", None)
    both = families(flat, settings.bending, settings.parity, settings.modes)
    critical = max(family.modes.critical_thickness for family in both)
    problem = plate_problem(flat, settings.symmetry, settings.bending, thickness, settings.weight)
    unwrinkled = flat.sheet_position
    if not settings.stays_flat:
        stiff = max(_ABOVE * critical, thickness)
        unwrinkled = lifted(flat, problem, settings.bending, stiff)
    states = tuple(
        _state(flat, family, problem, unwrinkled, settings, options or WrinkleSettings(), observer)
        for family in both
    )
    return WholeEquilibrium(flat, settings.symmetry, thickness, critical, unwrinkled, states)


def _state(
    flat: Flat,
    family: Family,
    problem: PlateProblem,
    unwrinkled: Array,
    settings: WholeSettings,
    options: WrinkleSettings,
    observer: newton.Observer | None,
) -> PhaseState:
    thickness = problem.thickness
    wrinkles = family.modes.critical_thickness > thickness
    if not wrinkles and settings.stays_flat:
        energy = thickness * flat.energy
        residual = abs(flat.history[-1].decrement) / flat.energy
        return PhaseState(
            family.parity, "flat", "", unwrinkled, energy, flat.force, None, residual, ()
        )
    if family.modes.symmetry.odd_across is not None:
        free = family.modes.symmetry.free(flat.space)
        problem = PlateProblem(flat.space, problem.uniform, free, unwrinkled)
    starts = [unwrinkled]
    if wrinkles:
        starts = [
            unwrinkled + seed_position(flat, family.modes, q) - flat.sheet_position
            for q in seeds(family.modes, thickness)[: options.seeds]
        ]
    states = [
        _minimised(flat, family, problem, start, wrinkles, settings, options, observer)
        for start in starts
    ]
    return min(states, key=lambda state: (state.status == "not-converged", state.energy))


def _minimised(
    flat: Flat,
    family: Family,
    problem: PlateProblem,
    start: Array,
    wrinkles: bool,
    settings: WholeSettings,
    options: WrinkleSettings,
    observer: newton.Observer | None,
) -> PhaseState:
    thickness, free = problem.thickness, problem.assembler.free
    squared = float(family.modes.squared.max(initial=0.0))
    has_pin = family.modes.symmetry.odd_across is None
    pinned = Pinned(problem, _unknown(problem, family.parity)) if has_pin else None
    solver = problem.assembler.solver
    limits = newton.NewtonOptions(
        tolerance=options.tolerance,
        max_iterations=options.max_iterations,
        first_shift=min(thickness**2, 0.25 * abs(squared - thickness**2)),
        rise=_RISE,
        ceiling=thickness * flat.energy if settings.stays_flat else np.inf,
        noise=ROUNDING * thickness,
        observe=None if observer is None else partial(observer, f"{family.parity} state"),
    )
    minimum = newton.minimise(pinned or Predicting(problem), start[free], solver, limits)
    reason, known = minimum.reason, None
    if not reason and settings.stays_flat and not minimum.energy < thickness * flat.energy:
        reason = "the energy is not below that of the flat state"
    if not reason and pinned is not None:
        forms = deflection_forms(flat, settings.bending, flat.symmetry)
        bent = thickness**3 * forms.bending
        try:
            known = slide(pinned, minimum.unknowns, bent, forms.assembler.size, solver)
        except NotPositiveDefiniteError:
            reason = "the state is unstable with its pin"
    reactions = problem.reactions(minimum.unknowns)
    last = minimum.history[-1].decrement if minimum.history else float("nan")
    return PhaseState(
        family.parity,
        "not-converged" if reason else "wrinkled" if wrinkles else "unwrinkled",
        reason,
        problem.position(minimum.unknowns),
        minimum.energy,
        settings.symmetry.clamp.force(flat.space, reactions) / thickness,
        known,
        last / (thickness * flat.energy),
        minimum.history,
    )


def _unknown(problem: PlateProblem, parity: Parity) -> int:
    """Return the number of the unknown that the pin of a parity holds."""
    free = problem.assembler.free
    place = 2 * free.shape[1] + pinned_dof(problem.assembler.space, parity)
    return int(free.ravel()[:place].sum())
