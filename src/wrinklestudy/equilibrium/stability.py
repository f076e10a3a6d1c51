"""The stability stage: at which strains wrinkles of a sheet are born and decay.

A flat sheet is unstable exactly where its thickness is below the critical thickness tau_1(eps), so
birth and decay are roots of tau_1(eps) = t.

tau_1 is the largest of many smooth tau_i(eps): the curve may have several humps, and where one mode
takes over from another a kink, at which it bends up. Its maxima are smooth.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from wrinklestudy.equilibrium.critical_curve import guided_curve
from wrinklestudy.equilibrium.extrema import inner_extrema, refine
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.scaled_curve import ScaledCurve
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import laws

# Strains of a first look at tau_1 where no study has computed any
SURVEY = (
    *(0.001, 0.003, 0.01, 0.03, 0.06, 0.1, 0.16, 0.24, 0.32, 0.4),
    *(0.5, 0.6, 0.7, 0.8, 0.9, 1.0),
)
LARGEST_STRAIN = 1.0

_TOLERANCE = 1.0e-5  # of birth and decay strain
_RELATIVE = 1.0e-3  # of a small strain of birth, which falls like t^2
_STEP_BEYOND = 0.1  # of the search beyond the last strain
_MAX_EVALUATIONS = 30
_HALVES = 5  # of the last step, where a curve ends within it
# A maximum of tau_1 between two strains is looked for if the table comes this near to the thickness
# or to its own largest value, a minimum if it comes as near from above.
_NEAR = 0.8
# With a guide: a root is known where tau_1 itself was computed this near to it, in tolerances (one
# step of a secant reduces the error at least tenfold), the maximum where no more is to be gained.
_NEIGHBOURHOOD = 10.0
_GAIN = 2.0e-5
# A guide that is less true than this at the maximum does not know well where it is: values on both
# sides, at these multiples of its strain, tell.
_TRUE = 5.0e-3
_BESIDE = (0.9, 1.1)
_MAX_PASSES = 20


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
        None.
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


def of_sheet(
    grid: Grid | Space,
    material: laws.Material,
    settings: PlanarSettings,
    thickness: float,
    report: Callable[[float, float], None] | None = None,
) -> Stability:
    """Return birth, decay and largest critical thickness of a sheet of which nothing is known.

    What shape tau_1(eps) has is found on a coarser mesh; its roots and its maximum are those of
    the mesh of the sheet.

    Parameters
    ----------
    grid : Grid or Space
        The mesh of the sheet.
    material, settings, thickness
        As in `find` and `planar.solve`.
    report : callable, optional
        Called with each strain that is computed and its tau_1/W.

    Raises
    ------
    ValueError
        If the thickness is not positive.
    ArithmeticError
        If tau_1 can be computed at no strain.
    """
    curve = guided_curve(grid, material, settings, report)
    return find(curve, thickness, guide=curve.guide)


def find(
    curve: Callable[[float], float],
    thickness: float,
    known: Sequence[tuple[float, float]] = (),
    survey: Sequence[float] = SURVEY,
    guide: Callable[[float], float] | None = None,
) -> Stability:
    """Return birth and decay strain from a function tau_1(eps).

    Parameters
    ----------
    curve : callable
        tau_1/W at a strain > 0; raises ArithmeticError where it cannot be computed. tau_1 = 0 at
        zero strain.
    thickness : float
        t/W.
    known : sequence of (strain, tau_1/W)
        Values that are there already.
    survey : sequence of float
        Strains to compute first where fewer than four are known.
    guide : callable, optional
        A curve like it that costs little: then few values of the curve itself are computed.

    Raises
    ------
    ValueError
        If the thickness is not positive.
    ArithmeticError
        If tau_1 can be computed at no strain, or not near birth or decay.
    """
    if not thickness > 0:
        raise ValueError(f"thickness = {thickness:g}: must be > 0 (in units of W)")
    if guide is None:
        return _find(curve, thickness, known, survey)
    return _find_guided(ScaledCurve(curve, guide), thickness, survey)


def _find(
    curve: Callable[[float], float],
    thickness: float,
    known: Sequence[tuple[float, float]],
    survey: Sequence[float],
) -> Stability:
    """Return birth, decay and maximum from values of one curve."""
    table = {0.0: 0.0, **dict(known)}
    reason = _survey(curve, table, survey) if len(table) < 4 else ""
    reason = reason or _survey(curve, table, _beyond(table, thickness), thickness)
    for sign, low, high in ((1.0, _NEAR, 1.0), (-1.0, 1.0, 1.0 / _NEAR)):
        for strain in inner_extrema(table, sign):
            if low * thickness <= table[strain] <= high * thickness:
                refine(curve, table, strain, sign)
    ranges = _ranges(curve, table, thickness)
    for strain in inner_extrema(table, 1.0):
        if table[strain] >= _NEAR * max(table.values()) > 0.0:
            refine(curve, table, strain, 1.0)
    peak = max(table, key=table.__getitem__)
    return Stability(
        thickness,
        ranges[0][0] if ranges else None,
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
    """Put values at strains into a table, until one is below a thickness; return what failed."""
    for strain in strains:
        if strain in table:
            continue
        try:
            table[strain] = curve(strain)
        except ArithmeticError as error:
            if max(table) == 0.0:
                raise
            return _edge(curve, table, strain, str(error))
        if until is not None and table[strain] <= until:
            break
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
    curve: Callable[[float], float], table: dict[float, float], thickness: float
) -> tuple[tuple[float, float | None], ...]:
    """Return the ranges of strain in which a table exceeds a thickness, their ends as roots."""
    strains = sorted(table)
    roots: list[float | None] = [
        _root(curve, table, thickness, low, high)
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
        if abs(guess - last) < _tolerance(guess) or guess in table:
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


def _tolerance(root: float) -> float:
    return min(_TOLERANCE, _RELATIVE * root)


def _find_guided(scaled: ScaledCurve, thickness: float, survey: Sequence[float]) -> Stability:
    """Return birth, decay and maximum of a curve from its guide, corrected where they lie."""
    for _ in range(_MAX_PASSES):
        limits = _find(scaled, thickness, scaled.known(), survey)
        wanted = _wanted(limits, scaled)
        if not wanted:
            break
        for strain in wanted:
            if strain < scaled.end:
                scaled.correct(strain)
    strain = max(scaled.exact, key=scaled.exact.__getitem__, default=limits.strain_at_max)
    return Stability(
        **vars(limits)
        | {
            "max_critical_thickness": scaled.exact.get(strain, 0.0),
            "strain_at_max": strain,
            "reason": scaled.reason or limits.reason,
        }
    )


def _wanted(limits: Stability, scaled: ScaledCurve) -> list[float]:
    """Return the strains at which a curve itself must still be computed: the maximum first."""
    best = max(scaled.exact.values(), default=0.0)
    if scaled.broken and scaled.distance(limits.largest_strain) > 0.0:
        return [limits.largest_strain]
    if limits.max_critical_thickness == 0.0:
        return []
    if limits.max_critical_thickness > (1.0 + _GAIN) * best:
        return [limits.strain_at_max]
    if len(scaled.exact) == 1 and abs(scaled.ratio(limits.strain_at_max) - 1.0) > _TRUE:
        beside = [limits.strain_at_max * factor for factor in _BESIDE]
        return [strain for strain in beside if strain <= limits.largest_strain]
    roots = [root for ends in limits.ranges for root in ends if root is not None]
    return [r for r in roots if scaled.distance(r) > _NEIGHBOURHOOD * _tolerance(r)]
