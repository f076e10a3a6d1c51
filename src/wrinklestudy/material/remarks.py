"""What a person must know of a fit before believing its constants, each in one line."""

from collections.abc import Iterator, Sequence

import numpy as np

from wrinklestudy.material.choice import Chosen
from wrinklestudy.material.data import Measurement
from wrinklestudy.material.homogeneous import dimensionless_stress, nominal_stress
from wrinklestudy.material.preload import KEEP
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import NeoHookean

# Columns scaled to unit length with a larger condition number harm what is estimated from them:
# Belsley, Kuh and Welsch, Regression Diagnostics (1980), section 3.2.
ILL_CONDITIONED = 30.0
# Young's moduli in Pa of what is sold as rubber, gel or elastomer, with a margin.
_YOUNG = (1e4, 1e8)
# A curve straighter than this part of the bend of a neo-Hookean one, if that bends by so much.
_STRAIGHT, _BEND = 0.6, 0.2
# A point apart from its neighbours by more than robust standard deviations, parts of the largest
# stress.
_DEVIATIONS, _OFF = 8.0, 0.05
_SHOWN = 3
# Part of the points that share their stretch with others, and how far their stresses may differ.
_REPEATED, _GAP = 0.5, 0.05


def remarks(fit: Fit, chosen: Chosen) -> tuple[str, ...]:
    """Return the warnings of a fit, the gravest first.

    Parameters
    ----------
    fit : Fit
    chosen : Chosen
        The points of the fit and the file that they are of.
    """
    return (
        *_preloads(fit),
        *_straight(chosen.points),
        *_strange_modulus(fit),
        *_outliers(fit, chosen.points),
        *_mixed(chosen.points),
        *_left_out(fit),
        *_constants(fit),
    )


def _preloads(fit: Fit) -> Iterator[str]:
    for mode, offset in fit.offsets.items():
        if offset.told and fit.preload == KEEP:
            yield (
                f"preload: the {mode} stress at stretch 1 is {offset.stress_pa:.4g} "
                f"+- {offset.standard_error_pa:.2g} Pa, no law has one and the constants are wrong "
                "by it; --remove-preload (preload: remove) shifts all stresses by it"
            )


def _straight(used: Measurement) -> Iterator[str]:
    """Yield that strains may be per cent: their curves are straight, those of rubber are not."""
    for mode in used.modes:
        points = used.kept((used.mode == mode) & (used.stretch > 1.0))
        strain = points.stretch - 1.0
        points = points.kept(strain > 0.05 * strain.max(initial=0.0))
        strain = points.stretch - 1.0
        if strain.size < 3 or not strain.max() > 1.0 or not (points.stress > 0.0).all():
            continue
        rubber = dimensionless_stress(NeoHookean(0.5), points.stretch, mode)
        bend, expected = (
            float(1.0 - slope.min() / slope.max())
            for slope in (points.stress / strain, rubber / strain)
        )
        if expected > _BEND and bend < _STRAIGHT * expected:
            yield (
                f"strain: the {mode} stress is proportional to it up to {strain.max():.3g} within "
                f"{bend:.0%}, which no rubber does (neo-Hookean: {expected:.0%}); if it is in per "
                "cent, call the column strain_percent"
            )


def _strange_modulus(fit: Fit) -> Iterator[str]:
    young = fit.material().young_modulus
    low, high = _YOUNG
    if not low <= young <= high:
        yield (
            f"modulus: the initial Young's modulus is {young:.3g} Pa, rubbers have {low:g} to "
            f"{high:g} Pa; check the units of stress (and size of the specimen) and strain"
        )


def _outliers(fit: Fit, used: Measurement) -> Iterator[str]:
    """Yield which points lie apart from both neighbours, whatever the law."""
    rows, jumps = [], []
    for mode in used.modes:
        own = np.flatnonzero(used.mode == mode)
        own = own[np.argsort(used.stretch[own], kind="stable")]
        misfit = used.stress[own] - nominal_stress(fit.material(), used.stretch[own], mode)
        apart = np.zeros(own.size)
        apart[1:-1] = np.abs(misfit[1:-1] - 0.5 * (misfit[2:] + misfit[:-2]))
        scale = 1.4826 * float(np.median(apart[1:-1])) if own.size > 2 else 0.0
        least = max(_DEVIATIONS * scale, _OFF * fit.largest_stress_pa)
        peak = np.maximum(apart, np.maximum(np.roll(apart, 1), np.roll(apart, -1)))
        found = (apart > least) & (apart == peak)
        rows += own[found].tolist()
        jumps += apart[found].tolist()
    if rows:
        names = used.line if used.line is not None else np.arange(1, used.stress.size + 1)
        what = "line" if used.line is not None else "point"
        worst = [rows[k] for k in np.argsort(jumps)[::-1]]
        listed = _listed([str(names[row]) for row in worst[:_SHOWN]])
        more = f" and {len(rows) - _SHOWN} more" if len(rows) > _SHOWN else ""
        yield (
            f"outliers: {what} {listed}{more} of {used.source}, up to "
            f"{max(jumps) / fit.largest_stress_pa:.0%} of the largest stress apart from the "
            "neighbours; check"
        )


def _mixed(used: Measurement) -> Iterator[str]:
    """Yield that stresses at the same stretch differ: a loop that was sorted by strain."""
    for mode in used.modes:
        points = used.kept(used.mode == mode)
        stretch, where, count = np.unique(points.stretch, return_inverse=True, return_counts=True)
        most, least = np.full(stretch.size, -np.inf), np.full(stretch.size, np.inf)
        np.maximum.at(most, where, points.stress)
        np.minimum.at(least, where, points.stress)
        twice = (count > 1) & (np.maximum(np.abs(most), np.abs(least)) > 0.0)
        if np.sum(count[twice]) < _REPEATED * points.stretch.size:
            continue
        size = np.maximum(np.abs(most), np.abs(least))[twice]
        gap = float(np.median((most - least)[twice] / size))
        if gap > _GAP:
            yield (
                f"mixed: {mode} stresses at the same strain differ by {gap:.0%} (median); if these "
                "are loading and unloading, leave them in the order of the test or name them in a "
                "column branch"
            )


def _left_out(fit: Fit) -> Iterator[str]:
    for mode, loop in fit.loops.items():
        total = loop.loading + loop.unloading
        yield (
            f"branches: of {total} {mode} points in {loop.cycles} "
            f"cycle{'s' if loop.cycles > 1 else ''} ({loop.loading} loading, {loop.unloading} "
            f"unloading) only the {fit.branch} of cycle {fit.cycle} is fitted"
            + (
                ""
                if np.isnan(loop.hysteresis)
                else f"; area below the unloading {loop.hysteresis:.1%} less than below the loading"
            )
        )


def _constants(fit: Fit) -> Iterator[str]:
    if fit.condition_number > ILL_CONDITIONED:
        yield (
            f"ill-conditioned: condition number {fit.condition_number:.3g} > {ILL_CONDITIONED:g}, "
            "the points hardly tell the constants apart; more modes or a wider window would"
        )
    if fit.at_bound:
        yield (
            f"at bound: {_listed(fit.at_bound)} at the end of what {fit.law} allows; the law does "
            "not suit the data, standard errors hold for the other constants alone"
        )
    errors = fit.standard_errors
    vague = [name for name, value in fit.constants.items() if errors[name] > 0.5 * abs(value)]
    vague = [name for name in vague if name not in fit.at_bound]
    if vague:
        yield f"uncertain: {_listed(vague)} known to no better than half its value"
    if not fit.stability.stable:
        yield f"unstable: {fit.stability.text}"


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names)
