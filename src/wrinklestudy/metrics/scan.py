"""Laser scans: what a noisy, tilted profile with gaps says of the wrinkles, and how surely.

A scan is brought to a smooth profile in four steps, each linear or robust, and measured by the code
that measures simulations (`measure`). Noise is then drawn again and again onto the smooth profile
and measured in the same way: the spread gives standard errors, the shift the bias that is taken
off (noise makes a profile longer and higher than it is).

1. Points where the scanner lost the surface, and spikes, are left out.
2. The dominant wavelength comes from a periodogram of what remains.
3. A spline with knots a fraction of that wavelength apart is fitted by least squares: ripples much
   shorter than the wrinkles are noise. Points far from it are left out, too.
4. Offset and tilt are those of a robust line, to which wrinkles in the middle are outliers.
"""

from dataclasses import dataclass, field

import numpy as np

from wrinklestudy.metrics.measure import FLAT, Measures, measure
from wrinklestudy.metrics.profile import Profile
from wrinklestudy.metrics.scan_edges import Edges
from wrinklestudy.metrics.scan_errors import Drawn, reached_by
from wrinklestudy.metrics.scan_points import (
    DENSE,
    LEAST_POINTS,
    LEAST_POINTS_PER_WAVELENGTH,
    Waves,
    confused,
    points_per_wavelength,
    unclear,
    usable,
    waves,
)
from wrinklestudy.metrics.smoothing import ScanFit, grouped, near_spline
from wrinklestudy.typing import Array, Mask

_COARSER = 1.2  # knots of the spline that tells what the choice of the knots changes
_FINEST = 8  # waves across the width that a flat scan is searched for
_DRAWS = 60
_NOTHING = "nothing stands out of the noise"
_ONE_HUMP = "there are no two neighbouring peaks"
_FALSE_ALARM = 1e-3  # a wave less sure than this is no wrinkle
_LOST_END = 0.01  # of the width, about which nothing need be said
_HUMP = 1.5  # times what noise alone reaches: higher is no noise


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
    used : (n,) bool array
        Which points were used; the others were lost or spikes.
    profile : Profile or None
        The smooth profile, without offset and tilt, the middle of the width at y = 0.
    line : tuple of float
        Offset and slope that were removed; NaN where nothing was fitted.
    note : str
        What the errors do not cover; empty mostly.
    """

    wrinkled: bool
    reason: str
    measures: Measures | None
    amplitude_error: float
    wavelength_error: float
    phi_squared_error: float
    noise: float
    used: Mask = field(repr=False)
    profile: Profile | None = field(repr=False)
    line: tuple[float, float]
    note: str = ""

    @property
    def left_out(self) -> int:
        """How many points were lost or spikes."""
        return int(np.sum(~self.used))


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
    used = usable(z)
    if used.sum() < LEAST_POINTS:
        return _unknown(f"{used.sum()} usable points; at least {LEAST_POINTS} are needed", used)
    found = waves(*grouped(y[used], z[used]))
    if points_per_wavelength(y[used], found) >= DENSE:
        used = usable(z, window=7)
        found = waves(*grouped(y[used], z[used]))
    if found.alarm > _FALSE_ALARM:
        return _without_wave(y, z, used, draws, np.random.default_rng(seed))
    if not (reason := unclear(y[used], found)):
        used[used] = near_spline(y[used], z[used], found.wavelength)
        reason = unclear(y[used], found)
    if reason:
        return _unknown(reason, used)
    fit, coarser = (ScanFit.of(y, z, used, found.wavelength, k) for k in (1.0, _COARSER))
    return _measured(fit, coarser, found, draws, np.random.default_rng(seed))


def _measured(
    fit: ScanFit, coarser: ScanFit, found: Waves, draws: int, rng: np.random.Generator
) -> ScanMeasures:
    noise = fit.drawn(draws, rng)
    drawn = Drawn.of(fit, noise)
    measures = drawn.corrected()
    if measures.amplitude <= drawn.reached:
        return _flat(fit)
    edges = Edges.of(fit.profile, noise, found.wavelength)
    if reason := confused(found, measures.amplitude) or edges.bowed(measures.amplitude):
        return _unknown(reason, fit.used)
    if np.isnan(measures.wavelength):
        return _unknown(_ONE_HUMP, fit.used)
    ripples = found.second, edges.ripple(measures.amplitude, found.wavelength)
    amplitude, wavelength, phi_squared = drawn.errors(measure(coarser.profile), ripples)
    return ScanMeasures(
        wrinkled=True,
        reason="",
        measures=measures,
        amplitude_error=amplitude,
        wavelength_error=wavelength,
        phi_squared_error=phi_squared,
        noise=fit.noise,
        used=fit.used,
        profile=fit.profile,
        line=fit.line,
        note="; ".join(filter(None, (edges.note(measures.amplitude), _lost_ends(fit)))),
    )


def _unknown(reason: str, used: Mask) -> ScanMeasures:
    """Return that the scan cannot tell."""
    nan = float("nan")
    return ScanMeasures(False, reason, None, nan, nan, nan, nan, used, None, (nan, nan))


def _lost_ends(fit: ScanFit) -> str:
    """Return what to say of points at the ends that were left out; empty if they are few."""
    known = np.flatnonzero(fit.used)
    lost = known[0] + len(fit.used) - 1 - known[-1]
    if lost <= _LOST_END * len(fit.used):
        return ""
    return f"{lost} points at the ends were left out: the width is that of the others"


def _without_wave(
    y: Array, z: Array, used: Mask, draws: int, rng: np.random.Generator
) -> ScanMeasures:
    """Return what to say of a scan without a wave: flat, or a hump or step."""
    count, least = int(used.sum()), _FINEST * LEAST_POINTS_PER_WAVELENGTH
    if count < least:
        return _unknown(
            f"no wave is sure in {count} usable points; at least {least} are needed to tell that "
            "there is none",
            used,
        )
    fit = ScanFit.of(y, z, used, float(y[-1] - y[0]) / _FINEST)
    height = float(np.abs(fit.heights).max())
    reached = reached_by(fit.drawn(draws, rng))
    if height > max(_HUMP * reached, FLAT * float(y[-1] - y[0])):
        return _unknown(f"{_ONE_HUMP}, but a hump or step of {height:.3g}", used)
    return _flat(fit)


def _flat(fit: ScanFit) -> ScanMeasures:
    """Return that there are no wrinkles; those that hide in the noise are the errors."""
    nan, profile = float("nan"), fit.profile
    hidden = measure(profile)
    width = hidden.projected_width
    return ScanMeasures(
        wrinkled=False,
        reason=_NOTHING,
        measures=Measures(0.0, nan, nan, width, width, 0.0, 0.0, nan, nan, np.empty(0)),
        amplitude_error=0.5 * hidden.amplitude,
        wavelength_error=nan,
        phi_squared_error=0.5 * hidden.phi_squared,
        noise=fit.noise,
        used=fit.used,
        profile=profile,
        line=fit.line,
    )
