"""Power laws through computed numbers, with how well a power law describes them."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.typing import Array

# Two-sided confidence of the intervals.
CONFIDENCE = 0.95


@dataclass(frozen=True)
class Estimated:
    """An exponent, or another fitted number, with the half-width of its interval."""

    value: float
    error: float

    def covers(self, number: float) -> bool:
        """Whether a number lies in the interval."""
        return abs(number - self.value) <= self.error

    @property
    def text(self) -> str:
        """Value and half-width."""
        return f"{self.value:.3f} ± {self.error:.3f}"


@dataclass(frozen=True)
class PowerLaw:
    """value = factor x product of base^exponent.

    Parameters
    ----------
    factor : float
    exponents : dict of Estimated
        By name of the base.
    scatter : float
        Root mean square of the residuals of the logarithm, with the degrees of freedom left.
    count : int
        Numbers that it goes through.
    """

    factor: float
    exponents: dict[str, Estimated]
    scatter: float
    count: int

    def at(self, **bases: Array | float) -> Array:
        """Return the power law at some bases."""
        product = np.asarray(self.factor, dtype=np.float64)
        for name, exponent in self.exponents.items():
            product = product * np.asarray(bases[name], dtype=np.float64) ** exponent.value
        return product


def power_law(value: Array, groups: Array | None = None, **bases: Array) -> PowerLaw:
    """Fit log value linearly in the logarithms of the bases by least squares.

    What is fitted is computed and has no noise: the intervals (Student's t) measure how far the
    numbers are from a power law over their range, not a scatter of repeated measurements.

    Parameters
    ----------
    value : ndarray, shape (n,)
        Positive; n is larger than the number of bases plus that of the groups.
    groups : ndarray, shape (n,), optional
        Numbers of one group share a factor of their own; `PowerLaw.factor` is then the mean.
    **bases : ndarray, shape (n,)
        Positive.

    Raises
    ------
    MissingError
        If there are too few numbers, or these cannot tell the exponents apart.
    """
    from scipy.stats import t

    names = list(bases)
    group = np.zeros(len(value)) if groups is None else groups
    factors = [(group == one).astype(np.float64) for one in np.unique(group)]
    design = np.column_stack([*factors, *(np.log(bases[name]) for name in names)])
    free = len(value) - design.shape[1]
    if free < 1 or np.linalg.matrix_rank(design) < design.shape[1]:
        raise MissingError(f"numbers that tell the exponents of {', '.join(names)} apart")
    solution, *_ = np.linalg.lstsq(design, np.log(value), rcond=None)
    residual = np.log(value) - design @ solution
    variance = float(residual @ residual) / free
    spread = np.sqrt(variance * np.diag(np.linalg.inv(design.T @ design)))
    half = float(t.ppf(0.5 + 0.5 * CONFIDENCE, free)) * spread
    first = len(factors)
    exponents = {
        name: Estimated(float(solution[k]), float(half[k])) for k, name in enumerate(names, first)
    }
    factor = float(np.exp(solution[:first].mean()))
    return PowerLaw(factor, exponents, float(np.sqrt(variance)), len(value))


@dataclass(frozen=True)
class Line:
    """value = slope x base + offset.

    Parameters
    ----------
    slope, offset : Estimated
        Each with the half-width of its interval.
    scatter : float
        Root mean square of the residuals over the values.
    """

    slope: Estimated
    offset: Estimated
    scatter: float

    def at(self, base: Array) -> Array:
        """Return the line at some bases."""
        return self.slope.value * base + self.offset.value


def line(value: Array, base: Array) -> Line:
    """Fit a straight line by least squares of the relative residuals, as a power law weighs them.

    Raises
    ------
    MissingError
        If there are fewer than three numbers, or all of one base.
    """
    from scipy.stats import t

    free = len(value) - 2
    if free < 1 or np.ptp(base) == 0.0:
        raise MissingError("numbers that tell slope and offset of a line apart")
    design = np.column_stack([base, np.ones(len(base))]) / value[:, None]
    solution, *_ = np.linalg.lstsq(design, np.ones(len(value)), rcond=None)
    residual = 1.0 - design @ solution
    variance = float(residual @ residual) / free
    spread = np.sqrt(variance * np.diag(np.linalg.inv(design.T @ design)))
    half = float(t.ppf(0.5 + 0.5 * CONFIDENCE, free)) * spread
    slope, offset = (Estimated(float(v), float(e)) for v, e in zip(solution, half, strict=True))
    return Line(slope, offset, float(np.sqrt(variance)))
