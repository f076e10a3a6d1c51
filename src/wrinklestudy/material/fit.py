"""Fit of a law to measured stress-strain data.

Where the stress is linear in the constants a fit is one bounded linear least-squares problem with
an exact minimum: no start values, no iteration that may stop early. For other laws it is a search
from several starts that the law names.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from wrinklestudy.material.choice import Choice, Chosen, choose
from wrinklestudy.material.data import Measurement, read
from wrinklestudy.material.estimates import (
    SINGULAR,
    Estimate,
    Search,
    condition_number,
    linear_estimate,
)
from wrinklestudy.material.homogeneous import dimensionless_stress, nominal_stress
from wrinklestudy.material.preload import REMOVE, SMALL, propagated
from wrinklestudy.material.remarks import remarks
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import Constant, Law, MooneyRivlin, NeoHookean, law_of
from wrinklestudy.typing import AnyPath, Array

# Stretches that count as initial when a law of small strains is fitted without a window.
INITIAL_STRETCH = SMALL


def fit(
    data: AnyPath | Measurement,
    law: str,
    *,
    stretch: tuple[float, float] | None = None,
    modes: Sequence[str] | None = None,
    branch: str = "loading",
    cycle: int = 1,
    preload: str = "keep",
) -> Fit:
    """Fit a law to measured nominal stresses by bounded least squares.

    Minimises the sum of (T_law - T)^2, each divided by the square of its standard error where the
    data have one, over the constants that the law allows.

    A law of small strains (``svk``) is fitted to the initial slope: T = Y B0 / 6 + c (B1 - B0) with
    the stresses B of Mooney-Rivlin per unit of its two constants and a free c that carries the
    curvature of the data, so that Y is the intercept of the Mooney plot: exactly 6 (C10 + C01) for
    data that follow Mooney-Rivlin, within 1 % for other softening curves over the default window
    (a stiffening one needs a narrower window). Its `rms_pa` is that of the law itself, not of the
    auxiliary curve.

    The covariance is s^2 (J^T J)^-1 with the derivatives J of the stress with respect to the
    constants and s^2 = residual sum of squares / (points - free constants); with standard errors J
    is weighted by them and s^2 is at least 1.

    Parameters
    ----------
    data : path-like or Measurement
        File (see `wrinklestudy.material.data`) or data already read.
    law : str
        A name in `LAWS`.
    stretch : tuple of float, optional
        Smallest and largest stretch to use; all points by default, `INITIAL_STRETCH` for a law of
        small strains.
    modes : sequence of str, optional
        Deformation modes to use, all in the file by default.
    branch, cycle : str, int
        Which branch, loading or unloading, of which cycle, from 1; the first loading by default.
    preload : str
        What to do with a stress at stretch 1: keep it, which `Fit.warnings` then says, or remove
        it from all stresses of its mode (see `wrinklestudy.material.preload`).

    Returns
    -------
    Fit

    Raises
    ------
    ValueError
        If the file, law, window or mode is bad, too few points are left, the points cannot tell
        the constants apart, or no constants that are allowed give a rising stress.
    """
    return fit_choice(data, law, Choice(stretch, modes, branch, cycle, preload))


def fit_choice(data: AnyPath | Measurement, law: str, choice: Choice) -> Fit:
    """Fit a law to a choice of points: `fit` with its options in one."""
    kind = law_of(law)
    if kind.small_strain and choice.stretch is None:
        choice = replace(choice, stretch=INITIAL_STRETCH)
    chosen = choose(data if isinstance(data, Measurement) else read(data), choice)
    used = chosen.points
    fitted = [constant for constant in kind.constants if constant.fitted]
    solution = (_linear if kind.linear or kind.small_strain else _nonlinear)(kind, fitted, used)
    estimate = solution.estimate
    constants = {c.name: float(v) for c, v in zip(fitted, estimate.values, strict=False)}
    defaults = {c.name: c.default for c in kind.constants if c.default is not None}
    if not kind.shear_modulus(defaults | constants) > 0.0:
        raise _no_rise(kind, used)
    misfit = nominal_stress(kind.material(**constants), used.stretch, used.mode) - used.stress
    if not np.isfinite(misfit).all():
        raise ValueError(f"{used.source}: {law} leaves no width at a stretch within the window")
    covariance = _covariance(solution, chosen, choice)
    free = int(estimate.free.sum())
    result = Fit(
        law=law,
        constants=constants,
        covariance=covariance[: len(fitted), : len(fitted)],
        at_bound=tuple(c.name for c, free in zip(fitted, estimate.free, strict=False) if not free),
        rms_pa=float(np.sqrt(np.mean(misfit**2))),
        count=used.stretch.size,
        stretch_range=(float(used.stretch.min()), float(used.stretch.max())),
        modes=used.modes,
        condition_number=solution.condition,
        source=used.source,
        largest_stress_pa=float(np.abs(used.stress).max()),
        aicc=math.nan if kind.small_strain else _aicc(misfit, used, free),
        branch=choice.branch,
        cycle=choice.cycle,
        preload=choice.preload,
        offsets={mode: one.offset for mode, one in chosen.extrapolations.items()},
        loops=chosen.loops,
    )
    return replace(result, warnings=remarks(result, chosen))


@dataclass(frozen=True, eq=False)
class _Solution:
    """Estimated parameters, how well they are told apart, and (n, p) derivatives of the stress."""

    estimate: Estimate
    condition: float
    slopes: Array


def _covariance(solution: _Solution, chosen: Chosen, choice: Choice) -> Array:
    """Return the covariance of the parameters, with that of offsets that were removed before."""
    covariance, free = solution.estimate.covariance, solution.estimate.free
    if choice.preload != REMOVE or not covariance[np.ix_(free, free)].any():
        return covariance
    corrected = np.zeros_like(covariance)
    corrected[np.ix_(free, free)] = propagated(
        covariance[np.ix_(free, free)],
        solution.slopes[:, free],
        chosen.whole,
        chosen.rows,
        chosen.extrapolations,
    )
    return corrected


def _aicc(misfit: Array, used: Measurement, free: int) -> float:
    """Return Akaike's information criterion for few points; see `Fit`."""
    count = misfit.size
    if count <= free + 1:
        return math.nan
    weight = np.ones(count) if used.standard_error is None else used.standard_error**-2
    mean_square = float(np.sum(weight * misfit**2) / np.sum(weight))
    # Data that the law interpolates exactly are still known to rounding only.
    rounding = np.finfo(np.float64).eps * float(np.abs(used.stress).max())
    fit_term = count * math.log(max(mean_square, rounding**2))
    return fit_term + 2.0 * free + 2.0 * free * (free + 1) / (count - free - 1)


def _linear(kind: type[Law], fitted: Sequence[Constant], used: Measurement) -> _Solution:
    """Return the estimate of a law whose stress is linear in its constants; they come first."""
    design = _initial_slope(used) if kind.small_strain else _basis(kind, used)
    _check_points(kind, used, design.shape[1])
    condition = _told_apart(design, kind, used)
    low, high = np.full(design.shape[1], -np.inf), np.full(design.shape[1], np.inf)
    if not kind.small_strain:  # otherwise a negative slope is an error, not a fit on the bound
        low, high = (np.array([getattr(c, end) for c in fitted]) for end in ("low", "high"))
    estimate = linear_estimate(design, used.stress, used.standard_error, low, high)
    return _Solution(estimate, condition, design)


def _nonlinear(kind: type[Law], fitted: Sequence[Constant], used: Measurement) -> _Solution:
    """Return the estimate of any law, found from the starts that it names."""
    _check_points(kind, used, len(fitted))
    column = _basis(NeoHookean, used)[:, 0]
    modulus = 2.0 * float(column @ used.stress) / float(column @ column)
    if not modulus > 0.0:
        raise _no_rise(kind, used)
    names = [constant.name for constant in fitted]
    unit = np.array([modulus if constant.unit == "Pa" else 1.0 for constant in fitted])

    def stress(values: Array) -> Array:
        law = kind(**dict(zip(names, values.tolist(), strict=True)))
        return dimensionless_stress(law, used.stretch, used.mode)

    search = Search(
        stress,
        used.stress / modulus,
        None if used.standard_error is None else used.standard_error / modulus,
        [np.array([start[name] for name in names]) for start in kind.starts],
        np.array([constant.low for constant in fitted]) / unit,
        np.array([constant.high for constant in fitted]) / unit,
        np.array([constant.unit == "" for constant in fitted]),
    )
    try:
        scaled, slopes = search.estimate()
    except ValueError as error:
        raise ValueError(f"{used.source}: fit of {kind.name}: {error}") from None
    effects = slopes[:, scaled.free] * scaled.values[scaled.free]
    length = np.linalg.norm(effects, axis=0)
    effects[:, length * SINGULAR < length.max()] = 0.0  # without effect on the stress: not told
    condition = _told_apart(effects, kind, used)
    covariance = scaled.covariance * np.outer(unit, unit)
    estimate = Estimate(scaled.values * unit, covariance, scaled.free)
    order = kind.canonical_order(dict(zip(names, estimate.values.tolist(), strict=True)))
    places = [names.index(name) for name in order]
    return _Solution(estimate.permuted(places), condition, (slopes * modulus / unit)[:, places])


def _basis(kind: type[Law], used: Measurement) -> Array:
    """Return the stress per unit of each constant of a linear law, shape ``(n, p)``."""
    columns = [dimensionless_stress(law, used.stretch, used.mode) for law in kind.unit_laws()]
    return np.stack(columns, axis=1)


def _initial_slope(used: Measurement) -> Array:
    """Return the columns of Young's modulus and of the curvature of the data, ``(n, 1 or 2)``."""
    basis = _basis(MooneyRivlin, used)
    slope, curvature = basis[:, 0] / 6.0, basis[:, 1] - basis[:, 0]
    # Pure shear alone has no curvature column: the two columns of its basis coincide.
    told = np.linalg.norm(curvature) * SINGULAR > np.linalg.norm(basis[:, 0])
    return np.stack([slope, curvature] if told else [slope], axis=1)


def _check_points(kind: type[Law], used: Measurement, columns: int) -> None:
    """Refuse too few points, or none that is deformed."""
    count = used.stretch.size
    if count <= columns:
        low, high = INITIAL_STRETCH
        hint = f" (default window of {kind.name}: {low:g} to {high:g})" if kind.small_strain else ""
        raise ValueError(
            f"{used.source}: {count} points in the chosen stretch window and modes; "
            f"a {kind.name} fit needs at least {columns + 1}{hint}"
        )
    if (used.stretch == 1.0).all():
        raise ValueError(f"{used.source}: every point chosen is undeformed (stretch 1)")


def _told_apart(columns: Array, kind: type[Law], used: Measurement) -> float:
    """Return the condition number of the columns, after checking that they are independent."""
    condition = condition_number(columns)
    if not condition < SINGULAR:
        modes = ", ".join(used.modes)
        raise ValueError(
            f"{used.source}: the points chosen ({modes}) cannot tell the constants of {kind.name}"
            " apart; take more modes, a wider stretch window, or a law of fewer constants"
        )
    return condition


def _no_rise(kind: type[Law], used: Measurement) -> ValueError:
    return ValueError(
        f"{used.source}: the stress does not rise with stretch; no {kind.name} law fits"
    )
