"""Birth, decay and height of a sheet as functions of C01/C10, and a fit's error carried through."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.typing import Array

# Numbers of a sheet that follow from its rubber, by name in texts.
NUMBERS: Mapping[str, str] = {
    "birth strain": "birth_strain",
    "decay strain": "decay_strain",
    "largest A/t": "max_amplitude_over_thickness",
}
# Error of a measured decay strain, absolute: the step between the strains of an experiment.
MEASURED = 0.02
SAMPLES = 20000
SEED = 20190503
_PERCENTILES = (2.5, 50.0, 97.5)


def share(material: Material) -> float:
    """Return C01/(C10 + C01) of a Mooney-Rivlin or neo-Hookean rubber: 0 to 1, all ratios."""
    constants = material.law.physical(1.0)
    c01 = constants.get("c01", 0.0)
    return float(c01 / (constants["c10"] + c01))


def ratio(of_share: Array | float) -> Array:
    """Return C01/C10 from C01/(C10 + C01)."""
    return np.asarray(of_share) / (1.0 - np.asarray(of_share))


@dataclass(frozen=True, eq=False)
class Curves:
    """Cubic splines through the numbers of computed sheets over C01/(C10 + C01).

    Parameters
    ----------
    shares : ndarray, shape (n,)
        Increasing.
    values : mapping
        Keys of `NUMBERS`; arrays of shape (n,).
    """

    shares: Array
    values: Mapping[str, Array]

    def at(self, number: str, shares: Array | float) -> Array:
        """Return a number at other shares; NaN beyond those computed."""
        from scipy.interpolate import CubicSpline

        spline = CubicSpline(self.shares, self.values[number], extrapolate=False)
        return np.asarray(spline(np.asarray(shares, dtype=np.float64)))

    def shares_with(self, number: str, low: float, high: float) -> Array:
        """Return shares, out of many, at which a number lies in an interval."""
        fine = np.linspace(self.shares[0], self.shares[-1], 20001)
        value = self.at(number, fine)
        return fine[(value >= low) & (value <= high)]


def curves(
    sheets: Sequence[SheetStates],
    materials: Sequence[Material],
    numbers: Mapping[str, str] = NUMBERS,
) -> Curves:
    """Return the curves through some sheets of one size, each with its material.

    Parameters
    ----------
    sheets : sequence of SheetStates
    materials : sequence of Material
    numbers : mapping
        Those of `NUMBERS` that are wanted.

    Raises
    ------
    MissingError
        If there are fewer than four, or a sheet has no birth, decay or amplitude.
    """
    if len(sheets) < 4:
        raise MissingError(f"sheets of four ratios C01/C10, there are {len(sheets)}")
    shares = np.array([share(material) for material in materials])
    order = np.argsort(shares)
    values = {
        name: np.array([sheets[k].peak_value(column) for k in order])
        for name, column in numbers.items()
    }
    return Curves(shares[order], values)


@dataclass(frozen=True)
class Interval:
    """A median with the interval that holds 95% of the samples."""

    low: float
    median: float
    high: float

    def covers(self, number: float) -> bool:
        """Whether a number lies in it."""
        return self.low <= number <= self.high

    def text(self, digits: int = 3) -> str:
        """Return the median and the interval in words."""
        return f"{self.median:.{digits}g} ({self.low:.{digits}g} to {self.high:.{digits}g})"


def interval(samples: Array) -> Interval:
    """Return the median and the central 95% of samples; NaN are left out."""
    return Interval(*(float(q) for q in np.nanpercentile(samples, _PERCENTILES)))


def sampled_shares(fit: Fit) -> Array:
    """Return C01/(C10 + C01) of constants drawn from the covariance of a fit.

    Constants that the law does not allow (below 0) are drawn again.
    """
    generator = np.random.default_rng(SEED)
    mean = [fit.constants["c10"], fit.constants["c01"]]
    drawn = generator.multivariate_normal(mean, fit.covariance, SAMPLES)
    allowed = drawn[(drawn >= 0.0).all(axis=1)]
    return np.asarray(allowed[:, 1] / allowed.sum(axis=1))
