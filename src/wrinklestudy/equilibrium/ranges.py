"""The ranges of strain in which a curve tau_1(eps) exceeds a thickness, and its maximum.

tau_1 is the largest of many smooth tau_i(eps): the curve may have several humps, and where one mode
takes over from another a kink, at which it bends up. Its maxima are smooth.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from wrinklestudy.equilibrium.extrema import inner_extrema, refine

LARGEST_STRAIN = 1.0

_TOLERANCE = 1.0e-5  # of birth and decay strain
_RELATIVE = 1.0e-3  # of a small strain of birth, which falls like t^2
_STEP_BEYOND = 0.1  # of the search beyond the last strain
_MAX_EVALUATIONS = 30
_HALVES = 5  # of the last step, where a curve ends within it
# A maximum of tau_1 between two strains is looked for if the table comes this near to the thickness
# or to its own largest value, a minimum if it comes as near from above.
_NEAR = 0.8


@dataclass(frozen=True)
class Stability:
    """Strains at which wrinkles of a sheet appear and vanish.

    Parameters
    ----------
    thickness : float
        t/W.
    birth_strain, decay_strain : float or None
        The first and the last root of tau_1(eps) = t. None where the sheet never wrinkles, decay
        also where wrinkles remain at the largest strain that was examined.
    ranges : tuple of (birth, decay)
        All ranges of strain in which the sheet wrinkles, nearly always one; the last decay may be
        None. A range that reaches down to the least strain that was examined, as a sheared sheet
        may have, begins there.
    max_critical_thickness, strain_at_max : float
        Largest tau_1/W up to the largest strain, on the mesh of the sheet, to 1e-4 of itself, and
        where it is.
    largest_strain : float
        Largest strain that was examined.
    reason : str
        Why no larger strain was; empty if all of those that were asked for were examined.
    critical_thickness : tuple of (strain, tau_1/W)
        All that was computed, sorted by strain. Those that only a coarser mesh gave are scaled to
        agree with the mesh of the sheet where both were used.
    passed_over : str
        Why tau_1 is not known at smaller strains, as those at which a heavy sheet sags; empty where
        it is known from the least strain on.
    """

    thickness: float
    birth_strain: float | None
    decay_strain: float | None
    ranges: tuple[tuple[float, float | None], ...]
    max_critical_thickness: float
    strain_at_max: float
    largest_strain: float
    reason: str
    critical_thickness: tuple[tuple[float, float], ...]
    passed_over: str = ""


def search(
    curve: Callable[[float], float],
    thickness: float,
    known: Sequence[tuple[float, float]],
    survey: Sequence[float],
    near: float = 0.0,
    origin: bool = True,
) -> Stability:
    """Return birth, decay and maximum from values of one curve.

    See `stability.find` for the other parameters and the errors.

    Parameters
    ----------
    near : float
        How near to a known strain, in tolerances, a root need not be computed.
    """
    table = {0.0: 0.0} if origin else {}
    table.update(known)
    reason = _survey(curve, table, survey) if len(table) < 4 else ""
    reason = reason or _survey(curve, table, _beyond(table, thickness), thickness)
    for sign, low, high in ((1.0, _NEAR, 1.0), (-1.0, 1.0, 1.0 / _NEAR)):
        for strain in inner_extrema(table, sign):
            if low * thickness <= table[strain] <= high * thickness:
                refine(curve, table, strain, sign)
    ranges = _ranges(curve, table, thickness, near)
    births = [birth for birth, _ in ranges if birth > min(table)]
    for strain in inner_extrema(table, 1.0):
        if table[strain] >= _NEAR * max(table.values()) > 0.0:
            refine(curve, table, strain, 1.0)
    peak = max(table, key=table.__getitem__)
    return Stability(
        thickness,
        births[0] if births else None,
        ranges[-1][1] if ranges else None,
        ranges,
        table[peak],
        peak,
        max(table),
        reason,
        tuple(sorted((e, tau) for e, tau in table.items() if e > 0.0)),
    )


def _survey(
    curve: Callable[[float], float],
    table: dict[float, float],
    strains: Sequence[float],
    until: float | None = None,
) -> str:
    """Put values at strains into a table, until one is below a thickness; return what failed.

    Strains below the first value are passed over: a heavy sheet that is hardly stretched sags.
    """
    first: ArithmeticError | None = None
    for strain in strains:
        if strain in table:
            continue
        try:
            table[strain] = curve(strain)
        except ArithmeticError as error:
            if max(table, default=0.0) > 0.0:
                return _edge(curve, table, strain, str(error))
            first = first or error
        else:
            if until is not None and table[strain] <= until:
                break
    if first is not None:
        table.pop(0.0, None)  # nothing is known of what lies between
        if not table:
            raise first
    return ""


def _edge(
    curve: Callable[[float], float], table: dict[float, float], failed: float, reason: str
) -> str:
    """Put values nearer to the strain beyond which none can be computed into a table.

    Returns the last reason for one that failed.
    """
    low = max(table)
    for _ in range(_HALVES):
        middle = 0.5 * (low + failed)
        try:
            table[middle] = curve(middle)
            low = middle
        except ArithmeticError as error:
            failed, reason = middle, str(error)
    return reason


def _beyond(table: dict[float, float], thickness: float) -> list[float]:
    """Return the strains beyond a table that ends where the sheet wrinkles."""
    last = max(table)
    if table[last] <= thickness or last >= LARGEST_STRAIN - 1e-9:
        return []
    steps = math.ceil((LARGEST_STRAIN - last) / _STEP_BEYOND - 1e-9)
    return [min(last + k * _STEP_BEYOND, LARGEST_STRAIN) for k in range(1, steps + 1)]


def _ranges(
    curve: Callable[[float], float], table: dict[float, float], thickness: float, near: float
) -> tuple[tuple[float, float | None], ...]:
    """Return the ranges of strain in which a table exceeds a thickness, their ends as roots."""
    strains = sorted(table)
    roots: list[float | None] = [strains[0]] if table[strains[0]] > thickness else []
    roots += [
        _root(curve, table, thickness, low, high, near)
        for low, high in pairwise(strains)
        if (table[low] > thickness) != (table[high] > thickness)
    ]
    if len(roots) % 2:
        roots.append(None)
    births = [root for root in roots[::2] if root is not None]
    return tuple(zip(births, roots[1::2], strict=True))


def _root(
    curve: Callable[[float], float],
    table: dict[float, float],
    thickness: float,
    low: float,
    high: float,
    near: float,
) -> float:
    """Return the root of tau_1 = t in a bracket; every value computed is put into the table.

    See `search` for `near`.

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
        nearest = np.abs(strains - guess).min()
        if abs(guess - last) < tolerance(guess) or nearest <= near * tolerance(guess):
            return guess
        try:
            table[guess] = curve(guess)
        except ArithmeticError as error:
            raise ArithmeticError(
                f"tau_1 at strain {guess:g}, near birth or decay: {error}"
            ) from None
        if (table[guess] > thickness) == (table[high] > thickness):
            high = guess
        else:
            low = guess
    return guess


def tolerance(root: float) -> float:
    """Return the error that is allowed of a root tau_1(eps) = t."""
    return min(_TOLERANCE, _RELATIVE * root)
