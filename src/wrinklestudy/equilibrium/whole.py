"""Wrinkled states of a sheet without the mirror at Y = 0, with clamps that need not be perfect.

Each state starts from a seed of its own, as in `wrinkled`: the unwrinkled state with the modes in
amplitudes that minimise the reduced energy. It is odd or even at the centre; between the two the
pattern can slide, and what an experiment sees lies between them.
"""

from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium import newton
from wrinklestudy.equilibrium.families import Families, opposite
from wrinklestudy.equilibrium.flat import ROUNDING, Flat
from wrinklestudy.equilibrium.flat import solve as solve_flat
from wrinklestudy.equilibrium.modes import Modes
from wrinklestudy.equilibrium.pin import Pinned, further, pinned_dof, slide
from wrinklestudy.equilibrium.problem import PlateProblem, Predicting
from wrinklestudy.equilibrium.seeds import seed_position, seeds
from wrinklestudy.equilibrium.unwrinkled import lifted, planar_symmetry, plate_problem
from wrinklestudy.equilibrium.wrinkled import WrinkleSettings
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import Parity, WholeStatus

# Steps with a predicted tangent lead along narrow valleys of the energy, a little up their walls.
_RISE = 10.0
_PARTNER_TOLERANCE = 1.0e-12
_CLOSE, _ROUGH = 1.0e-8, 1.0e-6  # where few digits are wanted old tangents give them sooner
_ABOVE = 1.2  # thickness, over tau_1, at which an unwrinkled state is lifted


@dataclass(frozen=True)
class WholeEquilibrium:
    """State of one sheet at one strain.

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
    status : {'wrinkled', 'unwrinkled', 'flat', 'not-converged'}
        'unwrinkled' is a state that is not flat although the sheet is too thick to wrinkle.
    reason : str
        Why it did not converge, else empty.
    position : (3, size) array
        Position as dof vectors in units of W; the last iterate where it did not converge.
    unwrinkled : (3, size) array
        The sheet without wrinkles.
    energy : float
        Of the part that is solved, in units of mu W^3.
    nominal_stress : float
        Force at the clamp / (W t) in units of mu.
    residual : float
        Last Newton decrement in parts of the energy.
    history : tuple of newton.Iteration
    pin_reaction, softest : float
        See `pin.Slide`; NaN where there is no pin.
    slide : (n,) array or None
        The direction of `pin.Slide`.
    partner : WholeEquilibrium or None
        The state of the other parity, a quarter of a wave further across; None where the sheet
        does not wrinkle.
    """

    flat: Flat
    symmetry: Symmetry
    thickness: float
    critical_thickness: float
    status: WholeStatus
    reason: str
    position: Array
    unwrinkled: Array
    energy: float
    nominal_stress: float
    residual: float
    history: tuple[newton.Iteration, ...]
    pin_reaction: float = float("nan")
    softest: float = float("nan")
    slide: Array | None = None
    partner: "WholeEquilibrium | None" = None

    @property
    def wrinkles(self) -> Array:
        """The deflection beyond that of the sheet without wrinkles, (size,)."""
        wrinkles: Array = self.position[2] - self.unwrinkled[2]
        return wrinkles


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
        Of the pattern at the centre: the deflection, or its slope across, is held there.
    weight : float
        rho g W/mu; it pulls toward -z.
    modes : int
        Number of modes.
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
    """Return the state of a sheet at a strain.

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
    families = Families(flat, settings.bending, thickness, settings.modes)
    options = options or WrinkleSettings()
    known = _known(families, settings, thickness)
    state = _of_family(known, options, observer)
    if state.status != "wrinkled":
        return state
    # The amplitude of the other is wanted, not its last digits.
    rough = replace(options, tolerance=max(options.tolerance, _PARTNER_TOLERANCE))
    other = replace(settings, parity=opposite(settings.parity))
    if state.slide is not None:
        start = further(flat, known.bent, state.position, state.unwrinkled, state.slide)
        partner = _minimised(known._replace(settings=other), start, rough, observer)
        if partner.status == "wrinkled":
            return replace(state, partner=partner)
    known = _known(families, other, thickness)
    return replace(state, partner=_of_family(known, rough, observer))


def _known(families: Families, settings: WholeSettings, thickness: float) -> "_Known":
    """Return what there is to know of the states of a parity."""
    flat, modes, bending = families.flat, families.modes(settings.parity), settings.bending
    # A mirror at Y = 0 goes with perfect clamps; the parity of z is then that of the modes.
    symmetry = replace(modes.symmetry, clamps=settings.symmetry.clamps)
    problem = plate_problem(flat, symmetry, bending, thickness, settings.weight)
    unwrinkled = flat.sheet_position
    if not settings.stays_flat:
        highest = float(np.sqrt(modes.squared.max(initial=0.0)))  # of wrinkles or of corners
        unwrinkled = lifted(flat, problem, bending, max(_ABOVE * highest, thickness))
    return _Known(
        flat, modes, problem, unwrinkled, symmetry, settings, families.bent(modes.symmetry)
    )


def _of_family(
    known: "_Known", options: WrinkleSettings, observer: newton.Observer | None
) -> WholeEquilibrium:
    """Return the state of one parity from its own seed."""
    flat, modes, thickness = known.flat, known.modes, known.problem.thickness
    critical = modes.critical_thickness
    if thickness >= critical and known.settings.stays_flat:
        return _flat(known)
    starts = [known.unwrinkled]
    if thickness < critical:
        starts = [
            known.centred(known.unwrinkled + seed_position(flat, modes, q) - flat.sheet_position)
            for q in seeds(modes, thickness)[: options.seeds]
        ]
    states = [_minimised(known, start, options, observer) for start in starts]
    return min(states, key=lambda state: (state.status == "not-converged", state.energy))


class _Known(NamedTuple):
    """What is known of a sheet before its state is sought."""

    flat: Flat
    modes: Modes
    problem: PlateProblem
    unwrinkled: Array
    symmetry: Symmetry
    settings: WholeSettings
    bent: sparse.csr_array  # B on the free deflections

    @property
    def ceiling(self) -> float:
        """The energy below which a wrinkled state lies."""
        return self.problem.thickness * self.flat.energy if self.settings.stays_flat else np.inf

    def centred(self, position: Array) -> Array:
        """Return a first guess whose wrinkles vanish where a pin holds them."""
        pin = pinned_dof(self.flat.space, self.settings.parity)
        position[2, pin] = self.unwrinkled[2, pin]
        return position


def _flat(known: _Known) -> WholeEquilibrium:
    flat, thickness = known.flat, known.problem.thickness
    return WholeEquilibrium(
        flat,
        known.symmetry,
        thickness,
        known.modes.critical_thickness,
        "flat",
        "",
        known.unwrinkled,
        known.unwrinkled,
        thickness * flat.energy,
        flat.force,
        abs(flat.history[-1].decrement) / flat.energy,
        (),
    )


def _minimised(
    known: _Known,
    start: Array,
    options: WrinkleSettings,
    observer: newton.Observer | None,
) -> WholeEquilibrium:
    """Return the state to which the energy falls from a start."""
    flat, problem = known.flat, known.problem
    thickness, critical = problem.thickness, known.modes.critical_thickness
    unknowns, solver, pinned = start[problem.assembler.free], problem.assembler.solver, None
    if known.symmetry.odd_across is None and critical > thickness:
        pin = _pinned_unknown(problem, known.settings.parity)
        pinned = Pinned(problem, pin)
    limits = newton.NewtonOptions(
        tolerance=options.tolerance,
        max_iterations=options.max_iterations,
        first_shift=min(thickness**2, 0.25 * abs(critical**2 - thickness**2)),
        rise=_RISE,
        ceiling=known.ceiling,
        noise=ROUNDING * thickness,
        eager=True,
        quasi=_ROUGH if options.tolerance >= _PARTNER_TOLERANCE else _CLOSE,
        observe=None if observer is None else partial(observer, "wrinkled state"),
    )
    minimum = newton.minimise(pinned or Predicting(problem), unknowns, solver, limits)
    reason = minimum.reason
    if not reason and not minimum.energy < known.ceiling:
        reason = "the energy is not below that of the flat state"
    reactions = problem.reactions(minimum.unknowns)
    last = minimum.history[-1].decrement if minimum.history else float("nan")
    state = WholeEquilibrium(
        flat,
        known.symmetry,
        thickness,
        critical,
        "not-converged" if reason else "wrinkled" if critical > thickness else "unwrinkled",
        reason,
        problem.position(minimum.unknowns),
        known.unwrinkled,
        minimum.energy,
        known.symmetry.clamp.force(flat.space, reactions) / thickness,
        last / (thickness * flat.energy),
        minimum.history,
    )
    if reason or pinned is None or options.tolerance >= _PARTNER_TOLERANCE:
        return state
    return _with_slide(state, pinned, minimum.unknowns, known)


def _with_slide(
    state: WholeEquilibrium, pinned: Pinned, unknowns: Array, known: _Known
) -> WholeEquilibrium:
    """Return a state with what its pin carries and the pattern to which it can slide."""
    found = slide(pinned, unknowns, state.thickness**3 * known.bent, known.problem.assembler.solver)
    return replace(state, pin_reaction=found.reaction, softest=found.softest, slide=found.direction)


def _pinned_unknown(problem: PlateProblem, parity: Parity) -> int:
    """Return the number of the unknown that the pin of a parity holds."""
    free = problem.assembler.free
    place = 2 * free.shape[1] + pinned_dof(problem.assembler.space, parity)
    return int(free.ravel()[:place].sum())
