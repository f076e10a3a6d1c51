"""Smooth profiles through the points of a scan: a least-squares spline about a robust line."""

import math
from dataclasses import dataclass

import numpy as np

from wrinklestudy.metrics.profile import Profile
from wrinklestudy.metrics.scan_points import HIGHEST_WAVE, SPIKE, SPLINE_FLOOR
from wrinklestudy.typing import Array, Mask

_MOST_POINTS = 4000  # more are averaged in groups
_DEGREE = 5
_KNOTS_PER_WAVELENGTH = 6
_POINTS_PER_KNOT = 2  # at least: fewer leave nothing that tells the noise
_FEWEST_WAVES = 4  # that tell the power of noise
_SAMPLES_PER_KNOT = 6
# Of the second differences of the coefficients: carries the spline over gaps, else without effect
_STIFFNESS = 1e-7


def robust_weights(y: Array, z: Array) -> Array:
    """Return the weights of points in a robust line through them.

    The line minimises sum log(1 + (r/s)^2), first from the ordinary line and with its spread as s,
    then with the spread of the nearer half of the points: what is flat decides, wrinkles are
    outliers. It is the line of weighted least squares with the weights 1/(1 + (r/s)^2).

    Parameters
    ----------
    y, z : ndarray, shape (n,)
    """
    from scipy.optimize import least_squares

    # The search stops at absolute tolerances: heights and places without a unit
    height = float(np.ptp(z))
    if height <= 0.0:
        return np.ones_like(z)
    design = np.column_stack([np.ones_like(y), (y - y[0]) / np.ptp(y)])
    heights = (z - z[0]) / height
    line = np.linalg.lstsq(design, heights, rcond=None)[0]
    scale = 0.0
    for _ in range(2):
        scale = max(1.4826 * float(np.median(np.abs(design @ line - heights))), 1e-12)
        line = least_squares(
            lambda p: design @ p - heights,
            line,
            jac=lambda _: design,
            loss="cauchy",
            f_scale=scale,
        ).x
    return np.asarray(1.0 / (1.0 + ((design @ line - heights) / scale) ** 2), dtype=np.float64)


def weighted_line(y: Array, weights: Array) -> Array:
    """Return the matrix from heights to offset and slope of a weighted line: shape (2, n)."""
    design = np.column_stack([np.ones_like(y), y])
    scaled = design * weights[:, None]
    return np.asarray(np.linalg.solve(design.T @ scaled, scaled.T), dtype=np.float64)


@dataclass(frozen=True, eq=False)
class Smoother:
    """Least-squares spline with equal knots over the points of a scan.

    Parameters
    ----------
    at_points : (n, m) array
        From the coefficients to the spline at the points.
    solution : (m, n) array
        From the heights of the points to the coefficients.
    samples : (s,) array
        Where the smooth profile is sampled.
    at_samples : (s, m) array
        From the coefficients to the spline there.
    """

    at_points: Array
    solution: Array
    samples: Array
    at_samples: Array

    @classmethod
    def through(cls, y: Array, wavelength: float, coarser: float = 1.0) -> "Smoother":
        """Return the spline that follows waves of a wavelength and a third of it.

        Parameters
        ----------
        y : ndarray, shape (n,)
            Increasing.
        wavelength : float
        coarser : float
            How many times farther the knots are apart.
        """
        from scipy.interpolate import BSpline

        least = _POINTS_PER_KNOT * float(np.median(np.diff(y)))
        spacing = coarser * max(wavelength / _KNOTS_PER_WAVELENGTH, least)
        # Rounding must not decide where the two differ by a half, as in another unit
        count = max(math.ceil(float(y[-1] - y[0]) / spacing - 1e-6), _DEGREE)
        inner = np.linspace(y[0], y[-1], count + 1)
        knots = np.concatenate([[inner[0]] * _DEGREE, inner, [inner[-1]] * _DEGREE])
        samples = np.linspace(y[0], y[-1], count * _SAMPLES_PER_KNOT + 1)
        at_points = BSpline.design_matrix(y, knots, _DEGREE).toarray()
        at_samples = BSpline.design_matrix(samples, knots, _DEGREE).toarray()
        bends = np.diff(np.eye(at_points.shape[1]), 2, axis=0)
        gram = at_points.T @ at_points
        gram += _STIFFNESS * len(y) / len(gram) * bends.T @ bends
        return cls(at_points, np.linalg.solve(gram, at_points.T), samples, at_samples)

    def fitted(self, heights: Array) -> Array:
        """Return the spline at the points."""
        return self.at_points @ (self.solution @ heights)

    def sampled(self, heights: Array) -> Array:
        """Return the spline at the samples; one row for each row of heights."""
        return (heights @ self.solution.T) @ self.at_samples.T

    def profile(self, sampled: Array) -> Profile:
        """Return samples as a profile, the middle of the width at y = 0."""
        middle = 0.5 * (self.samples[0] + self.samples[-1])
        return Profile(self.samples - middle, sampled)


def grouped(y: Array, z: Array) -> tuple[Array, Array]:
    """Return points, averaged in groups of neighbours where there are very many."""
    size = -(-len(y) // _MOST_POINTS)
    if size == 1:
        return y, z
    starts = np.arange(0, len(y), size)
    counts = np.diff(np.append(starts, len(y)))
    middle, height = (np.add.reduceat(values, starts) / counts for values in (y, z))
    middle[0], middle[-1] = y[0], y[-1]  # the width stays
    return middle, height


def near_spline(y: Array, z: Array, wavelength: float) -> Mask:
    """Return which points are near the spline through all that are: runs of spikes are not."""
    keep = np.ones(len(y), dtype=bool)
    least = SPLINE_FLOOR * float(np.subtract(*np.percentile(z, [95, 5])))
    for _ in range(3):
        middle, height = grouped(y[keep], z[keep])
        smoother = Smoother.through(middle, wavelength)
        offset = height.mean()
        rest = z - offset - np.interp(y, smoother.samples, smoother.sampled(height - offset))
        spread = max(float(np.percentile(np.abs(rest), 90)) / 1.645, least, 1e-300)
        good = np.abs(rest) <= SPIKE * spread
        if (good == keep).all():
            break
        keep = good
    return keep


@dataclass(frozen=True, eq=False)
class ScanFit:
    """A scan with the smooth profile through it.

    Parameters
    ----------
    used : Mask
        Points of the scan that were used.
    smoother : Smoother
        Through them, or through the means of groups.
    residual : (n,) array
        What remains at its points.
    noise : float
        Standard deviation of single points.
    heights : (s,) array
        The smooth profile at the samples, without the line.
    weights : (s,) array
        Of the samples in the robust line.
    line : tuple of float
        Offset and slope.
    wavelength : float
        For which the spline was made.
    """

    used: Mask
    smoother: Smoother
    residual: Array
    noise: float
    heights: Array
    weights: Array
    line: tuple[float, float]
    wavelength: float

    @classmethod
    def of(
        cls, y: Array, z: Array, used: Mask, wavelength: float, coarser: float = 1.0
    ) -> "ScanFit":
        """Return the fit to the used points of a scan; see `Smoother.through`."""
        y, z = y[used], z[used]
        middle, height = grouped(y, z)
        smoother = Smoother.through(middle, wavelength, coarser)
        mean = float(height.mean())  # the stiffness of the spline must not see the offset
        freedom = smoother.at_points.shape[1]
        residual = height - mean - smoother.fitted(height - mean)
        smooth = mean + smoother.sampled(height - mean)
        weights = robust_weights(smoother.samples, smooth)
        offset, tilt = weighted_line(smoother.samples, weights) @ smooth
        rest = z - np.interp(y, smoother.samples, smooth)
        return cls(
            used=used,
            smoother=smoother,
            residual=residual,
            noise=float(rest.std() * np.sqrt(len(y) / max(len(y) - freedom, 1))),
            heights=smooth - offset - tilt * smoother.samples,
            weights=weights,
            line=(float(offset), float(tilt)),
            wavelength=wavelength,
        )

    @property
    def profile(self) -> Profile:
        """The smooth profile."""
        return self.smoother.profile(self.heights)

    def drawn(self, draws: int, rng: np.random.Generator) -> Array:
        """Return what noise alone leaves in the smooth profile: shape (draws, s)."""
        y = self.smoother.samples
        fitted_waves = HIGHEST_WAVE * float(y[-1] - y[0]) / self.wavelength
        noise = self.smoother.sampled(_noise_like(self.residual, fitted_waves, draws, rng))
        lines = noise @ weighted_line(y, self.weights).T
        return noise - lines @ np.array([np.ones_like(y), y])


def _noise_like(
    residual: Array, fitted_waves: float, draws: int, rng: np.random.Generator
) -> Array:
    """Return Gaussian noise with the spectrum of a residual: shape (draws, n).

    A spline has taken the long waves out of the residual; their power is that of the waves just
    shorter, as in white noise. A ripple of short wavelength stays one, which the spline does not
    follow.

    Parameters
    ----------
    residual : ndarray, shape (n,)
    fitted_waves : float
        Waves over the width that the spline follows.
    draws : int
    rng : Generator

    Notes
    -----
    Source: surrogate data with random phases, Theiler, Eubank, Longtin, Galdrikian and Farmer,
    Physica D 58, 77 (1992).
    """
    count = len(residual)
    power = np.abs(np.fft.rfft(residual)) ** 2
    first = max(min(round(fitted_waves), len(power) - _FEWEST_WAVES), 0)
    # The median of an exponential distribution is ln 2 of its mean, and sees no single ripple
    power[:first] = np.median(power[first : max(2 * first, first + _FEWEST_WAVES)]) / np.log(2.0)
    waves = rng.standard_normal((draws, len(power), 2)) @ np.array([1.0, 1.0j]) / np.sqrt(2.0)
    return np.fft.irfft(waves * np.sqrt(power), n=count)
