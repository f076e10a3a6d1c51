"""The stability stage: at which strains wrinkles of a sheet are born and decay.

A flat sheet is unstable exactly where its thickness is below the critical thickness tau_1(eps), so
birth and decay are the two roots of tau_1(eps) = t.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from wrinklestudy.equilibrium.flat import solve as solve_flat
from wrinklestudy.equilibrium.modes import critical_thickness
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import laws

# Strains of a first look at tau_1 where no study has computed any
SURVEY = (0.01, 0.03, 0.06, 0.1, 0.16, 0.24, 0.32, 0.4, 0.5)
LARGEST_STRAIN = 1.0

_TOLERANCE = 1.0e-5  # of birth and decay strain
_RELATIVE = 1.0e-3  # of a small strain of birth, which falls like t^2
_STEP_BEYOND = 0.1  # of the search beyond the last strain
_MAX_EVALUATIONS = 30
# A maximum of tau_1 between two strains is looked for if the table comes this near to the thickness
_NEAR = 0.8


@dataclass(frozen=True)
class Stability:
    """Strains at which wrinkles of a sheet appear and vanish.

    Parameters
    ----------
    thickness : float
        t/W.
    birth_strain, decay_strain : float or None
        Roots of tau_1(eps) = t; None where the sheet never wrinkles, decay also where wrinkles
        remain at the largest strain that was examined.
    max_critical_thickness, strain_at_max : float
        Largest tau_1/W that was computed and where.
    largest_strain : float
        Largest strain that was examined.
    critical_thickness : tuple of (strain, tau_1/W)
        All that was computed, sorted by strain.
    """

    thickness: float
    birth_strain: float | None
    decay_strain: float | None
    max_critical_thickness: float
    strain_at_max: float
    largest_strain: float
    critical_thickness: tuple[tuple[float, float], ...]


def find(
    curve: Callable[[float], float],
    thickness: float,
    known: Sequence[tuple[float, float]] = (),
    survey: Sequence[float] = SURVEY,
) -> Stability:
    """Return birth and decay strain from a function tau_1(eps).

    Parameters
    ----------
    curve : callable
        tau_1/W at a strain > 0, NaN where it cannot be computed; tau_1 = 0 at zero strain.
    thickness : float
        t/W.
    known : sequence of (strain, tau_1/W)
        Values that are there already.
    survey : sequence of float
        Strains to compute first where none are known.

    Raises
    ------
    ValueError
        If the thickness is not positive.
    ArithmeticError
        If birth or decay lies where the curve cannot be computed.
    """
    if not thickness > 0:
        raise ValueError(f"thickness = {thickness:g}: must be > 0 (in units of W)")
    table = {0.0: 0.0, **dict(known)}
    if len(table) < 4:
        table |= {strain: tau for strain in survey if (tau := curve(strain)) >= 0.0}
    peak = _peak(curve, table, thickness)
    birth = decay = None
    if table[peak] > thickness:
        below = max(e for e, tau in table.items() if e < peak and tau <= thickness)
        above = min(e for e in table if e > below)
        birth = _root(curve, table, thickness, below, above)
        end = _first_stable(curve, table, thickness, peak)
        if end is not None:
            decay = _root(curve, table, thickness, max(e for e in table if e < end), end)
    peak = max(table, key=table.__getitem__)
    rows = tuple(sorted((e, tau) for e, tau in table.items() if e > 0.0))
    return Stability(thickness, birth, decay, table[peak], peak, max(table), rows)


def _peak(curve: Callable[[float], float], table: dict[float, float], thickness: float) -> float:
    """Return the strain of the largest tau_1, refined if the sheet may just wrinkle there."""
    from scipy.optimize import minimize_scalar

    strains = sorted(table)
    peak = max(strains, key=table.__getitem__)
    if table[peak] > thickness or table[peak] < _NEAR * thickness:
        return peak
    place = strains.index(peak)
    low, high = strains[max(place - 1, 0)], strains[min(place + 1, len(strains) - 1)]

    def negative(strain: float) -> float:
        table[float(strain)] = curve(float(strain))
        return -table[float(strain)]

    minimize_scalar(negative, bounds=(low, high), method="bounded", options={"xatol": 1e-3})
    return max(table, key=table.__getitem__)


def _first_stable(
    curve: Callable[[float], float], table: dict[float, float], thickness: float, peak: float
) -> float | None:
    """Return the first strain beyond the peak where the sheet is flat, computing further ones."""
    while True:
        stable = [e for e, tau in table.items() if e > peak and tau <= thickness]
        if stable:
            return min(stable)
        last = max(table)
        if last >= LARGEST_STRAIN - 1e-9:
            return None
        further = min(last + _STEP_BEYOND, LARGEST_STRAIN)
        if math.isnan(tau := curve(further)):
            return None
        table[further] = tau


def _root(
    curve: Callable[[float], float],
    table: dict[float, float],
    thickness: float,
    low: float,
    high: float,
) -> float:
    """Return the root of tau_1 = t in a bracket; every value computed is put into the table.

    Raises
    ------
    ArithmeticError
        If tau_1 cannot be computed at a strain of the bracket.
    """
    from scipy.interpolate import PchipInterpolator
    from scipy.optimize import brentq

    guess = np.inf
    for _ in range(_MAX_EVALUATIONS):
        # tau_1^2 is smooth, at zero too: the root of its interpolant joins the table
        strains = np.array(sorted(table))
        values = np.array([table[e] for e in strains])
        last = guess
        guess = float(brentq(PchipInterpolator(strains, values**2 - thickness**2), low, high))
        if abs(guess - last) < min(_TOLERANCE, _RELATIVE * guess) or guess in table:
            return guess
        if math.isnan(tau := curve(guess)):
            raise ArithmeticError(f"tau_1 at strain {guess:g}, near birth or decay: not computed")
        table[guess] = tau
        if (table[guess] > thickness) == (table[high] > thickness):
            high = guess
        else:
            low = guess
    return guess


def critical_curve(
    grid: Grid | Space, material: laws.Material, settings: PlanarSettings
) -> Callable[[float], float]:
    """Return the function tau_1(eps)/W of a sheet on a grid.

    It is NaN where there is no flat state or the bending law has no value there.
    """
    space = grid if isinstance(grid, Space) else Space(grid)

    def curve(strain: float) -> float:
        try:
            flat = solve_flat(space, material.law, strain, symmetry=settings.symmetry)
            return critical_thickness(flat, settings.bending, settings.symmetry)
        except ArithmeticError:
            return math.nan

    return curve
