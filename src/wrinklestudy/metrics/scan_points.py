"""Points of a laser scan: which of them are measurements, and what wave they have.

Lengths are in the unit of the scan.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from wrinklestudy.typing import Array, Mask

LEAST_POINTS_PER_WAVELENGTH = 10
LEAST_POINTS = 2 * LEAST_POINTS_PER_WAVELENGTH
# Filters that remove noise pass this many times the wave number of the wrinkles
HIGHEST_WAVE = 3.3
# Points farther from their running median, or from a spline through all, than this many standard
# deviations are spikes
SPIKE = 5.0
# Standard deviations that noise has at least, of the range of heights: neither a median of
# neighbours nor the spline is the profile itself
_MEDIAN_FLOORS = {3: 5e-2, 7: 1.5e-2}
DENSE = 28  # points per wavelength, of which seven are nearly equal
SPLINE_FLOOR = 4e-3
# What scanners write where they lost the surface
_LOST_VALUES = (-9999.0, -999.0, -99999.0, 9999.0, 99999.0)
_DISTINCT = 10  # heights that a profile has at least, so that one far off is none of them
_LARGEST_GAP = 0.35  # of a wavelength, in the middle half of the width
_LARGEST_GAP_OUTSIDE = 0.5
_PADDING = 16  # wave numbers of the spectrum per wave over the width
_SURE = 3.5  # a second wave is this many times as high as the noise's own waves
_CONFUSING = 0.1  # of the height of the wrinkles: a second wave as high leaves nothing to measure


def usable(z: Array, window: Literal[3, 7] = 3) -> Mask:
    """Return which points are measurements: not lost, no spikes.

    Parameters
    ----------
    z : ndarray, shape (n,)
        Deflection from one edge to the other; NaN where the scanner lost the surface.
    window : {3, 7}
        Points in the running median: 7 sees runs of three spikes, where there are at least `DENSE`
        points per wavelength.
    """
    from scipy.ndimage import median_filter

    keep = np.isfinite(z) & ~np.isin(z, _LOST_VALUES)
    keep[keep] = _without_signs(z[keep])
    known = np.flatnonzero(keep)
    if len(known) < LEAST_POINTS:
        return keep
    for _ in range(3):
        values = z[known]
        rest = values - median_filter(values, size=window, mode="mirror")
        # Neighbours of a smooth profile differ by little: nine tenths of the points tell the noise
        spread = float(np.percentile(np.abs(rest), 90)) / 1.645
        spread = max(
            spread,
            _MEDIAN_FLOORS[window] * float(np.subtract(*np.percentile(values, [95, 5]))),
            1e-300,
        )
        good = np.abs(rest) <= SPIKE * spread
        if good.all():
            break
        known = known[good]
    keep[:] = False
    keep[known] = True
    return keep


def _without_signs(z: Array) -> Mask:
    """Return which heights are not a sign of the scanner for a lost point.

    A sign is farther from all other heights than these are from each other.
    """
    heights = np.unique(z)
    low, high = 0, len(heights)
    while high - low > _DISTINCT:
        inside = heights[low:high]
        if inside[1] - inside[0] > inside[-1] - inside[1]:
            low += 1
        elif inside[-1] - inside[-2] > inside[-2] - inside[0]:
            high -= 1
        else:
            break
    return np.isin(z, heights[low:high])


@dataclass(frozen=True)
class SecondWave:
    """A wave of small height that goes through a profile beside the wrinkles.

    Parameters
    ----------
    wavelength : float
        NaN if there is none.
    height : float
        Its amplitude; 0 if there is none.
    alike : bool
        Whether it has the wavelength of the wrinkles, so that the two interfere.
    """

    wavelength: float = float("nan")
    height: float = 0.0
    alike: bool = False

    @property
    def slope(self) -> float:
        """Its largest slope."""
        return 2.0 * np.pi * self.height / self.wavelength if self.height else 0.0

    def lengthens(self, phi_squared: float) -> float:
        """Return what it may add to the Phi^2 of a profile.

        Its own is a quarter of the square of the slope. If it has the wavelength of the wrinkles,
        <z_1' z_2'> comes on top: at most 2 Phi_1 Phi_2, and a good part of that where the one fades
        and the other does not.
        """
        own = 0.25 * self.slope**2
        return own + (float(np.sqrt(own * max(phi_squared, 0.0))) if self.alike else 0.0)

    def moves(self, amplitude: float, wavelength: float) -> float:
        """Return how far it moves two peaks of a wave from each other: sqrt(2) z_2'/z''."""
        return float(np.sqrt(2.0) * self.slope / (amplitude * (2.0 * np.pi / wavelength) ** 2))


@dataclass(frozen=True)
class Waves:
    """What the spectrum of a scan has.

    Parameters
    ----------
    wavelength : float
        Of the highest peak; NaN for a straight line.
    alarm : float
        Probability that white noise alone has a peak that takes as much of the variance.
    second : SecondWave
        The highest other peak that stands out of the noise, as if it went from edge to edge.
    """

    wavelength: float
    alarm: float
    second: SecondWave = SecondWave()


def waves(y: Array, z: Array) -> Waves:
    """Find the dominant wave and the next of other wavelength, tapered towards the edges.

    Waves longer than half the width count as tilt and bow, not as wrinkles. The share P of the
    variance that a wave takes of white noise follows a beta distribution, so that one of M
    independent waves reaches P with the probability M (1 - P)^((n - 3)/2); M = n, because
    the peak is sought between the independent wave numbers, too.

    Parameters
    ----------
    y, z : ndarray, shape (n,)
        Points, not necessarily evenly spaced.
    """
    from scipy.signal import detrend, find_peaks, get_window, periodogram

    count, width = len(y), float(y[-1] - y[0])
    even = detrend(np.interp(np.linspace(y[0], y[-1], count), y, z))
    if not np.abs(even).max() > 1e-12 * np.abs(z).max():
        return Waves(float("nan"), 1.0)
    taper = get_window("hann", count)
    number, power = periodogram(
        even, fs=count, window=taper, nfft=_PADDING * count, scaling="spectrum", detrend=False
    )
    peaks, _ = find_peaks(np.append(power, 0.0))
    peaks = peaks[number[peaks] >= 2.0]
    if not len(peaks):
        return Waves(float("nan"), 1.0)
    top = int(peaks[np.argmax(power[peaks])])
    share = float(power[top] * taper.sum() / (taper @ even**2))
    effective = float(taper.sum() ** 2 / (taper @ taper))
    alarm = count * max(1.0 - share, 0.0) ** (0.5 * (effective - 3.0))
    peak = _second_peak(number, np.sqrt(2.0 * power), top)
    if peak is None:
        return Waves(width / float(number[top]), alarm)
    height = float(np.sqrt(2.0 * power[peak]))
    second = SecondWave(width / float(number[peak]), height)
    return Waves(width / float(number[top]), alarm, second)


def _second_peak(number: Array, height: Array, top: int) -> int | None:
    """Return where the highest peak is beside the first, None if noise may have made it."""
    from scipy.signal import find_peaks

    noise = height[number > HIGHEST_WAVE * number[top]]
    # The heights of white noise are Rayleigh distributed
    floor = float(np.median(noise)) / 1.177 if len(noise) else 0.0
    # The taper's own side waves are lower than a twentieth
    least = max(_SURE * np.sqrt(2.0) * floor, 0.05 * float(height[top]))
    peaks, _ = find_peaks(height, height=least, prominence=0.5 * least)
    inside = (number[peaks] >= 2.0) & (number[peaks] <= HIGHEST_WAVE * number[top])
    peaks = peaks[inside & (peaks != top)]
    return int(peaks[np.argmax(height[peaks])]) if len(peaks) else None


def points_per_wavelength(y: Array, found: Waves) -> float:
    """Return how many points there are to a wavelength, NaN if there is none."""
    return found.wavelength / float(np.median(np.diff(y)))


def unclear(y: Array, found: Waves) -> str:
    """Return why points cannot tell a wrinkle of a wavelength; empty if they can."""
    steps, wavelength = np.diff(y), found.wavelength
    per_wavelength = points_per_wavelength(y, found)
    if per_wavelength < LEAST_POINTS_PER_WAVELENGTH:
        return (
            f"{per_wavelength:.1f} points per wavelength; "
            f"at least {LEAST_POINTS_PER_WAVELENGTH} are needed"
        )
    inside = np.abs(0.5 * (y[:-1] + y[1:]) - y.mean()) < 0.25 * (y[-1] - y[0])
    for where, place, largest in (
        (inside, "in the middle half", _LARGEST_GAP),
        (~inside, "beside the middle", _LARGEST_GAP_OUTSIDE),
    ):
        gap = float(steps[where].max(initial=0.0))
        if gap > largest * wavelength:
            return (
                f"a gap of {gap:.3g} {place}, {gap / wavelength:.0%} of a wavelength; "
                f"at most {largest:.0%} is allowed"
            )
    return ""


def confused(found: Waves, amplitude: float) -> str:
    """Return why a second wave leaves nothing to measure; empty if it does not."""
    second = found.second
    if second.height <= _CONFUSING * amplitude:
        return ""
    return (
        f"a second wave of wavelength {second.wavelength:.3g} and {second.height / amplitude:.0%} "
        f"of the height lies too near the first of {found.wavelength:.3g} to be told from it"
    )
