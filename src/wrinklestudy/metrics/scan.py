"""Laser scans: what a noisy, tilted profile with gaps says of the wrinkles, and how surely.

A scan is brought to a smooth profile in four steps, each linear or robust, and measured by the code
that measures simulations (`measure`). Noise is then drawn again and again onto the smooth profile
and measured in the same way: the spread gives standard errors, the shift the bias that is taken
off (noise makes a profile longer and higher than it is).

1. Points where the scanner lost the surface, and spikes, are left out.
2. The dominant wavelength comes from a periodogram of what remains.
3. A cubic spline with knots a fraction of that wavelength apart is fitted by least squares: ripples
   much shorter than the wrinkles are noise.
4. Offset and tilt are those of a robust line, to which wrinkles in the middle are outliers.
"""

from dataclasses import dataclass, field, replace

import numpy as np

from wrinklestudy.metrics.measure import Measures, measure
from wrinklestudy.metrics.profile import LEAST_POINTS, Profile
from wrinklestudy.typing import Array, Mask

# Points farther from their running median than this many standard deviations are spikes
_SPIKE = 5.0
_FLOOR = 4e-3  # of the range of heights: a smaller deviation is no spike whatever the noise
# A run of points at one and the same value that far outside all others: the scanner's sign for lost
_LOST_VALUES = (-9999.0, -999.0, -99999.0, 9999.0, 99999.0)
_KNOTS_PER_WAVELENGTH = 6
_DEGREE = 5
_LEAST_POINTS_PER_WAVELENGTH = 8
_LARGEST_GAP = 0.25  # of a wavelength
_SAMPLES_PER_KNOT = 12
_DRAWS = 60
_NOTHING = "nothing stands out of the noise"
_FALSE_ALARM = 1e-3  # a wave less sure than this is no wrinkle
# Peaks that are lower by less than this many standard errors may be as high as the highest
_RIVALS = 2.0
# Wrinkles are higher than this many times what 95% of the drawings of noise alone reach
_SIGNIFICANT = 1.5


@dataclass(frozen=True, eq=False)
class ScanMeasures:
    """What a scan says, lengths in its unit.

    Parameters
    ----------
    wrinkled : bool
        Whether there are wrinkles that stand out of the noise.
    reason : str
        Why the scan cannot tell, or why there are none; empty where it is wrinkled.
    measures : Measures or None
        Of the smooth profile, the bias of the noise taken off; None where the scan cannot tell.
    amplitude_error, wavelength_error, phi_squared_error : float
        Standard errors; NaN where there is no number.
    noise : float
        Standard deviation of single points about the smooth profile.
    left_out : int
        Points that were lost or spikes.
    profile : Profile or None
        The smooth profile.
    """

    wrinkled: bool
    reason: str
    measures: Measures | None
    amplitude_error: float
    wavelength_error: float
    phi_squared_error: float
    noise: float
    left_out: int
    profile: Profile | None = field(repr=False)


def usable(z: Array) -> Mask:
    """Return which points are measurements: not lost, no spikes.

    Parameters
    ----------
    z : ndarray, shape (n,)
        Deflection from one edge to the other; NaN where the scanner lost the surface.
    """
    from scipy.ndimage import median_filter

    keep = np.isfinite(z) & ~np.isin(z, _LOST_VALUES)
    known = np.flatnonzero(keep)
    if len(known) < LEAST_POINTS:
        return keep
    for _ in range(3):
        values = z[known]
        rest = values - median_filter(values, size=7, mode="mirror")
        # Neighbours of a smooth profile differ by little: nine tenths of the points tell the noise
        spread = float(np.percentile(np.abs(rest), 90)) / 1.645
        spread = max(spread, _FLOOR * float(np.subtract(*np.percentile(values, [95, 5]))), 1e-300)
        good = np.abs(rest) <= _SPIKE * spread
        if good.all():
            break
        known = known[good]
    keep[:] = False
    keep[known] = True
    return keep


def dominant_wavelength(y: Array, z: Array) -> tuple[float, float]:
    """Return the wavelength of the largest peak of the periodogram, and its false alarm rate.

    Waves longer than half the width count as tilt and bow, not as wrinkles. The share P of the
    variance that a wave takes of white noise follows a beta distribution, so that one of M
    independent waves reaches P with the probability M (1 - P)^((n - 3)/2).

    Parameters
    ----------
    y, z : ndarray, shape (n,)
        Points, not necessarily evenly spaced.
    """
    from scipy.signal import lombscargle

    width = float(y[-1] - y[0])
    spacing = float(np.median(np.diff(y)))
    waves = np.arange(2.0, max(width / (4.0 * spacing), 3.0), 0.05)
    rest = z - np.polynomial.Polynomial.fit(y, z, 1)(y)
    if not rest.any():
        return float("nan"), 1.0
    share = lombscargle(
        y, rest, 2.0 * np.pi * waves / width, normalize=True, weights=np.hanning(len(y)) + 1e-3
    )
    highest = int(np.argmax(share))
    alarm = len(waves) * 0.05 * max(1.0 - float(share[highest]), 0.0) ** (0.5 * (len(y) - 3))
    return width / float(waves[highest]), alarm


def robust_line(y: Array, z: Array) -> Array:
    """Return offset and slope of a robust line through points: shape (2,).

    Minimises sum log(1 + (r/s)^2), first from the ordinary line and with its spread as s, then with
    the spread of the nearer half of the points: what is flat decides, wrinkles are outliers.
    """
    from scipy.optimize import least_squares

    design = np.column_stack([np.ones_like(y), y])
    line = np.linalg.lstsq(design, z, rcond=None)[0]
    for _ in range(2):
        scale = max(1.4826 * float(np.median(np.abs(design @ line - z))), 1e-12 * float(np.ptp(z)))
        if scale > 0.0:
            line = least_squares(
                lambda p: design @ p - z,
                line,
                jac=lambda _: design,
                loss="cauchy",
                f_scale=scale,
                x_scale=(1.0, 1.0 / float(np.ptp(y))),
            ).x
    return np.asarray(line)


@dataclass(frozen=True, eq=False)
class _Smoother:
    """Least-squares spline with equal knots over the points of a scan.

    Parameters
    ----------
    at_points : (n, m) array
        From the coefficients to the spline at the points.
    solution : (m, n) array
        From the deflections of the points to the coefficients.
    samples : (s,) array
        Where the smooth profile is sampled.
    at_samples : (s, m) array
        From the coefficients to the spline there.
    """

    at_points: Array
    solution: Array
    samples: Array
    at_samples: Array

    def fitted(self, deflection: Array) -> Array:
        """Return the spline at the points."""
        return self.at_points @ (self.solution @ deflection)

    def profile(self, deflection: Array) -> Profile:
        """Return the smooth profile of deflections at the points, without offset and tilt."""
        z = self.at_samples @ (self.solution @ deflection)
        thin = slice(None, None, _SAMPLES_PER_KNOT // 3)
        offset, tilt = robust_line(self.samples[thin], z[thin])
        return Profile(self.samples - self.samples.mean(), z - offset - tilt * self.samples)


def _smoother(y: Array, spacing: float) -> _Smoother:
    from scipy.interpolate import BSpline

    count = max(round(float(y[-1] - y[0]) / spacing), _DEGREE)
    inner = np.linspace(y[0], y[-1], count + 1)
    knots = np.concatenate([[inner[0]] * _DEGREE, inner, [inner[-1]] * _DEGREE])
    samples = np.linspace(y[0], y[-1], count * _SAMPLES_PER_KNOT + 1)
    at_points = BSpline.design_matrix(y, knots, _DEGREE).toarray()
    at_samples = BSpline.design_matrix(samples, knots, _DEGREE).toarray()
    return _Smoother(at_points, np.linalg.pinv(at_points), samples, at_samples)


def _noise_like(residual: Array, block: int, rng: np.random.Generator) -> Array:
    """Return noise like a residual: blocks of it at random places, with random signs.

    Source: the moving block bootstrap, Kuensch, Ann. Statist. 17, 1217 (1989).
    """
    count = len(residual)
    blocks = -(-count // block)
    starts = rng.integers(0, max(count - block, 0) + 1, size=blocks)
    signs = rng.choice([-1.0, 1.0], size=blocks)
    pieces = residual[np.minimum(starts[:, None] + np.arange(block), count - 1)]
    return (signs[:, None] * pieces).ravel()[:count]


def _unclear(y: Array, wavelength: float) -> str:
    """Return why points cannot tell a wrinkle of a wavelength; empty if they can."""
    steps = np.diff(y)
    per_wavelength = wavelength / float(np.median(steps))
    if per_wavelength < _LEAST_POINTS_PER_WAVELENGTH:
        return (
            f"{per_wavelength:.1f} points per wavelength; "
            f"at least {_LEAST_POINTS_PER_WAVELENGTH} are needed"
        )
    inside = np.abs(y[:-1] - y.mean()) < 0.25 * (y[-1] - y[0])
    gap = float(steps[inside].max(initial=0.0))
    if gap > _LARGEST_GAP * wavelength:
        return f"a gap of {gap:.3g} in the middle half, {gap / wavelength:.0%} of a wavelength"
    return ""


def measure_scan(y: Array, z: Array, draws: int = _DRAWS, seed: int = 0) -> ScanMeasures:
    """Measure a scanned profile.

    Parameters
    ----------
    y : ndarray, shape (n,)
        Coordinate across the sheet, strictly increasing, from edge to edge.
    z : ndarray, shape (n,)
        Deflection in the unit of ``y``; NaN where it is not known.
    draws : int
        How often noise is drawn for the standard errors.
    seed : int
        Of the random numbers: the same scan gives the same errors.

    Returns
    -------
    ScanMeasures
        Not wrinkled, with the reason, where the scan cannot tell.
    """
    keep = usable(z)
    left_out = int(np.sum(~keep))
    y, z = y[keep], z[keep]
    reason = f"{len(y)} usable points; at least {LEAST_POINTS} are needed"
    if len(y) >= LEAST_POINTS:
        wavelength, alarm = dominant_wavelength(y, z)
        reason = _NOTHING if alarm > _FALSE_ALARM else _unclear(y, wavelength)
    if reason:
        nan = float("nan")
        return ScanMeasures(False, reason, None, nan, nan, nan, nan, left_out, None)
    spacing = wavelength / _KNOTS_PER_WAVELENGTH
    smoother = _smoother(y, spacing)
    # Shorter than the knots are apart: over longer stretches a residual is free of what was fitted
    block = max(round(0.25 * spacing / float(np.median(np.diff(y)))), 1)
    return _measured(smoother, z, block, left_out, draws, np.random.default_rng(seed))


def _height(profile: Profile, measures: Measures, spread: float) -> float:
    """Return the largest height, or the mean of those peaks that noise could have made largest.

    The largest of several equal peaks with noise on them is too high by a part of the noise.
    """
    peaks = np.abs(np.interp(measures.extrema, profile.y, profile.z))
    if not len(peaks):
        return measures.amplitude
    rivals = peaks[peaks >= peaks.max() - _RIVALS * spread]
    return measures.amplitude - float(peaks.max() - rivals.mean())


def _error(drawn: Array, value: float, spread: float = 0.0) -> float:
    """Return the spread of drawings with their bias, which is known no better than by its size."""
    known = drawn[np.isfinite(drawn)]
    if len(known) < 2:
        return float("nan")
    return float(np.hypot(max(spread, known.std(ddof=1)), known.mean() - value))


def _measured(
    smoother: _Smoother,
    z: Array,
    block: int,
    left_out: int,
    draws: int,
    rng: np.random.Generator,
) -> ScanMeasures:
    fitted = smoother.fitted(z)
    count, freedom = smoother.at_points.shape
    residual = (z - fitted) * np.sqrt(count / max(count - freedom, 1))
    profile = smoother.profile(fitted)
    value = measure(profile)
    noises = [_noise_like(residual, block, rng) for _ in range(draws)]
    profiles = [smoother.profile(fitted + noise) for noise in noises]
    drawn = [measure(one) for one in profiles]
    highest = int(np.abs(profile.z).argmax())
    spread = float(np.std([one.z[highest] for one in profiles], ddof=1))
    height = _height(profile, value, spread)
    alone = [float(np.abs(smoother.profile(noise).z).max()) for noise in noises]
    amplitude = np.array(
        [_height(one, its, spread) for one, its in zip(profiles, drawn, strict=True)]
    )
    wavelength = np.array([one.wavelength for one in drawn])
    phi_squared = np.array([one.phi_squared for one in drawn])
    # what noise adds to the smooth profile it has added to the true one already
    corrected = replace(
        value,
        amplitude=max(2.0 * height - float(amplitude.mean()), 0.0),
        wavelength=2.0 * value.wavelength - float(np.nanmedian(wavelength)),
        phi_squared=max(2.0 * value.phi_squared - float(phi_squared.mean()), 0.0),
    )
    wrinkled = corrected.amplitude > _SIGNIFICANT * float(np.percentile(alone, 95))
    return ScanMeasures(
        wrinkled=wrinkled,
        reason="" if wrinkled else _NOTHING,
        measures=corrected,
        amplitude_error=_error(amplitude, height, spread),
        wavelength_error=_error(wavelength, value.wavelength),
        phi_squared_error=_error(phi_squared, value.phi_squared),
        noise=float(residual.std()),
        left_out=left_out,
        profile=profile,
    )
