"""The stability stage: at which strains wrinkles of a sheet are born and decay.

A flat sheet is unstable exactly where its thickness is below the critical thickness tau_1(eps), so
birth and decay are roots of tau_1(eps) = t.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

from wrinklestudy.equilibrium.critical_curve import CriticalCurve, guide_space, guided_curve
from wrinklestudy.equilibrium.lifted_curve import LiftedCurve
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.ranges import Stability, search, tolerance
from wrinklestudy.equilibrium.scaled_curve import ScaledCurve
from wrinklestudy.equilibrium.unwrinkled import planar_symmetry
from wrinklestudy.equilibrium.whole import WholeSettings
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import laws

# Strains of a first look at tau_1 where no study has computed any
SURVEY = (
    *(0.001, 0.003, 0.01, 0.03, 0.06, 0.1, 0.16, 0.24, 0.32, 0.4),
    *(0.5, 0.6, 0.7, 0.8, 0.9, 1.0),
)

# With a guide: a root is known where tau_1 itself was computed this near to it, in tolerances (one
# step of a secant reduces the error at least tenfold), the maximum where no more is to be gained.
_NEIGHBOURHOOD = 10.0
_GAIN = 2.0e-5
# A guide that is less true than this at the maximum does not know well where it is: values on both
# sides, at these multiples of its strain, tell.
_TRUE = 5.0e-3
_BESIDE = (0.9, 1.1)
_MAX_PASSES = 20


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


def of_imperfect_sheet(
    space: Space,
    material: laws.Material,
    settings: WholeSettings,
    thickness: float,
    report: Callable[[float, float], None] | None = None,
) -> Stability:
    """Return the ranges of strain in which a sheet wrinkles whose clamps may be off.

    Where the sheet is lifted out of its plane, the critical thickness is that of
    `lifted_curve`. See `of_sheet` for the other parameters and the errors.

    Parameters
    ----------
    space : Space
        On the part of the sheet that is solved.
    settings : WholeSettings
    """
    flat = replace(settings, symmetry=planar_symmetry(settings.symmetry))
    coarse = guide_space(space)
    guide: CriticalCurve | None = None
    if settings.stays_flat:
        if coarse is not None:
            guide = CriticalCurve(coarse, material.law, flat, report=report)
        curve = CriticalCurve(space, material.law, flat, guide, report)
    else:
        lift = (thickness, settings.symmetry, settings.weight)
        if coarse is not None:
            guide = LiftedCurve(coarse, material.law, flat, None, report, *lift)
        curve = LiftedCurve(space, material.law, flat, guide, report, *lift)
    return find(
        curve,
        thickness,
        guide=guide,
        origin=settings.symmetry.clamps.perfect and settings.weight == 0.0,
    )


def find(
    curve: Callable[[float], float],
    thickness: float,
    known: Sequence[tuple[float, float]] = (),
    survey: Sequence[float] = SURVEY,
    guide: Callable[[float], float] | None = None,
    origin: bool = True,
) -> Stability:
    """Return birth and decay strain from a function tau_1(eps).

    Parameters
    ----------
    curve : callable
        tau_1/W at a strain > 0; raises ArithmeticError where it cannot be computed.
    thickness : float
        t/W.
    known : sequence of (strain, tau_1/W)
        Values that are there already.
    survey : sequence of float
        Strains to compute first where fewer than four are known.
    guide : callable, optional
        A curve like it that costs little: then few values of the curve itself are computed.
    origin : bool
        Whether tau_1 = 0 at zero strain, as it is where no clamp is shifted or turned.

    Raises
    ------
    ValueError
        If the thickness is not positive.
    ArithmeticError
        If tau_1 can be computed at no strain, or not near birth or decay.
    """
    if not thickness > 0:
        raise ValueError(f"thickness = {thickness:g}: must be > 0 (in units of W)")
    failures: dict[float, str] = {}
    noted = _noting(curve, failures)
    if guide is None:
        limits = search(noted, thickness, known, survey, origin=origin)
    else:
        scaled = ScaledCurve(noted, _noting(guide, failures))
        limits = _find_guided(scaled, thickness, survey, origin)
    least = limits.critical_thickness[0][0]
    reasons = [reason for strain, reason in sorted(failures.items()) if strain < least]
    text = f"below strain {least:g} nothing is known: {reasons[-1]}" if reasons else ""
    return replace(limits, passed_over=text)


def _noting(
    curve: Callable[[float], float], failures: dict[float, str]
) -> Callable[[float], float]:
    """Return a curve that notes at which strains it could not be computed, and why."""

    def noted(strain: float) -> float:
        try:
            return curve(strain)
        except ArithmeticError as error:
            failures[strain] = str(error)
            raise

    return noted


def _find_guided(
    scaled: ScaledCurve, thickness: float, survey: Sequence[float], origin: bool
) -> Stability:
    """Return birth, decay and maximum of a curve from its guide, corrected where they lie."""
    for _ in range(_MAX_PASSES):
        limits = search(scaled, thickness, scaled.known(), survey, 1.0, origin and not scaled.late)
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
    least = limits.critical_thickness[0][0]  # where a range may begin without a root
    roots = [root for ends in limits.ranges for root in ends if root is not None and root > least]
    return [r for r in roots if scaled.distance(r) > _NEIGHBOURHOOD * tolerance(r)]
