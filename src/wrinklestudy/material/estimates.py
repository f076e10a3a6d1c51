"""Bounded least squares with covariance: linear, with an exact minimum, and by search."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from wrinklestudy.typing import Array, Mask

# Columns (of unit length) with a larger condition number are the same column up to rounding.
SINGULAR = 1e8

_AT_BOUND = 1e-9  # in parts of the scale of a parameter
_COARSE, _FINE = 1e-9, 1e-15  # tolerances of a search
_EVALUATIONS = 200


@dataclass(frozen=True, eq=False)
class Estimate:
    """Parameters found by least squares.

    Parameters
    ----------
    values : (p,) array
    covariance : (p, p) array
        Zero in the rows and columns of parameters on their bounds.
    free : (p,) array of bool
        Which parameters are not on a bound.
    """

    values: Array
    covariance: Array
    free: Mask

    def permuted(self, order: Sequence[int]) -> "Estimate":
        """Return the estimate with its parameters in another order."""
        pick = np.array(order)
        return Estimate(self.values[pick], self.covariance[np.ix_(pick, pick)], self.free[pick])


def condition_number(columns: Array) -> float:
    """Return the condition number of columns scaled to unit length, infinite if one is zero."""
    length = np.linalg.norm(columns, axis=0)
    if not length.all():
        return float("inf")
    singular = np.linalg.svd(columns / length, compute_uv=False)
    return float(singular[0] / singular[-1]) if singular[-1] > 0.0 else float("inf")


def linear_estimate(
    design: Array, stress: Array, error: Array | None, low: Array, high: Array
) -> Estimate:
    """Return the minimum of |design x - stress|^2 within bounds, exact for the free parameters.

    Parameters
    ----------
    design : (n, p) array
    stress : (n,) array
    error : (n,) array, optional
        Standard errors of the stress.
    low, high : (p,) arrays
        Bounds, infinite where there is none.
    """
    weight = 1.0 if error is None else 1.0 / error
    columns, target = (design.T * weight).T, stress * weight
    bounds = _active_bounds(columns, target, low, high)
    free = np.isnan(bounds)
    values, covariance = np.where(free, 0.0, bounds), np.zeros((free.size, free.size))
    if not free.any():
        return Estimate(values, covariance, free)
    rest = target - columns @ values if values.any() else target
    q, r = np.linalg.qr(columns[:, free])
    values[free] = np.linalg.solve(r, q.T @ rest)
    covariance[np.ix_(free, free)] = _covariance(r, columns @ values - target, target, error)
    return Estimate(values, covariance, free)


def _active_bounds(columns: Array, target: Array, low: Array, high: Array) -> Array:
    """Return for each parameter the bound that holds it, NaN if none does."""
    from scipy.optimize import lsq_linear, nnls  # here because they cost more than all the rest

    scale = float(np.abs(target).max()) or 1.0
    none = np.full(low.shape, np.nan)
    if np.isneginf(low).all() and np.isposinf(high).all():
        return none
    if not low.any() and np.isposinf(high).all():
        return np.where(nnls(columns, target / scale)[0] > 0.0, np.nan, 0.0)
    best = np.linalg.lstsq(columns, target, rcond=None)[0]
    if (low <= best).all() and (best <= high).all():
        return none
    length = np.linalg.norm(columns, axis=0)
    found = lsq_linear(
        columns / length, target / scale, (low * length / scale, high * length / scale), "bvls"
    )
    return np.select([found.active_mask < 0, found.active_mask > 0], [low, high], np.nan)


def _covariance(r: Array, residual: Array, target: Array, error: Array | None) -> Array:
    """Return s^2 (J^T J)^-1 from the triangle r of the weighted J."""
    # Data that the law interpolates exactly are still known to rounding only.
    rounding = np.finfo(np.float64).eps * (float(np.abs(target).max()) or 1.0)
    variance = max(float(residual @ residual) / (residual.size - len(r)), rounding**2)
    if error is not None:
        variance = max(variance, 1.0)
    inverse = np.linalg.inv(r)
    covariance: Array = variance * (inverse @ inverse.T)
    return covariance


@dataclass(frozen=True, eq=False)
class Search:
    """A least-squares problem that is not linear in its parameters.

    Parameters
    ----------
    model : function
        From parameters (p,) to values (n,).
    target : (n,) array
        What the values should be.
    error : (n,) array, optional
        Standard errors of the target.
    starts : sequence of (p,) arrays
        Parameters to start from. A parameter keeps the sign that it has there.
    low, high : (p,) arrays
        Bounds, infinite where there is none.
    signed : (p,) array of bool
        Which parameters must not end at zero.
    """

    model: Callable[[Array], Array]
    target: Array
    error: Array | None
    starts: Sequence[Array]
    low: Array
    high: Array
    signed: Mask

    def _run(self, start: Array, box: tuple[Array, Array], tolerance: float, jac: str) -> Any:
        from scipy.optimize import least_squares

        return least_squares(
            self._misfit,
            start,
            jac=jac,
            bounds=box,
            x_scale=np.abs(start),
            ftol=tolerance,
            xtol=tolerance,
            gtol=tolerance,
            max_nfev=_EVALUATIONS,
        )

    def _misfit(self, values: Array) -> Array:
        # The weights are at most 1, so that tolerances mean the same with and without errors.
        weight = 1.0 if self.error is None else self.error.min() / self.error
        misfit: Array = (self.model(values) - self.target) * weight
        return misfit

    def _box(self, start: Array) -> tuple[Array, Array]:
        low = np.where(start > 0.0, np.maximum(self.low, 0.0), self.low)
        high = np.where(start < 0.0, np.minimum(self.high, 0.0), self.high)
        return low, high

    def _best(self) -> tuple[Array, Array, Array, Array]:
        """Return the best parameters from all starts, the derivatives there, and the box."""
        found = []
        for start in self.starts:
            box = self._box(start)
            run = self._run(start, box, _COARSE, "2-point")
            # A pure number that ends at 0 has lost its sign on the way: there is no such law.
            lost = self.signed & (np.abs(run.x) < _AT_BOUND * np.abs(start))
            if not lost.any():
                found.append((float(run.cost), run.x, box))
        if found:
            _, values, box = min(found, key=lambda one: one[0])
            run = self._run(values, box, _FINE, "3-point")
            if run.status > 0:
                return run.x, run.jac, *box
        raise ValueError("no start leads to a minimum; take a law of fewer constants")

    def estimate(self) -> tuple[Estimate, Array]:
        """Return the best estimate from all starts, and the derivatives of the model there.

        Raises
        ------
        ValueError
            If no start leads to a minimum.
        """
        values, slopes, low, high = self._best()
        near = _AT_BOUND * np.maximum(np.abs(values), 1.0)
        values = np.select([values - low < near, high - values < near], [low, high], values)
        free = (values != low) & (values != high)
        covariance = np.zeros((free.size, free.size))
        r = np.linalg.qr(slopes[:, free])[1]
        if condition_number(r) < SINGULAR:
            error = None if self.error is None else np.full(len(slopes), self.error.min())
            scale = 1.0 if self.error is None else 1.0 / self.error.min()
            covariance[np.ix_(free, free)] = _covariance(
                r * scale, self._misfit(values) * scale, self.target * scale, error
            )
        weight = 1.0 if self.error is None else self.error.min() / self.error
        return Estimate(values, covariance, free), (slopes.T / weight).T
