"""Profiles across the sheet: from a computed state or from a laser scan."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from wrinklestudy.metrics.interpolant import DeformedSheet, subdivided
from wrinklestudy.typing import Array

SAMPLES_PER_CELL = 64
LEAST_POINTS = 8

# Penalties of the smoothing spline that are tried, for points at unit spacing.
_PENALTIES = tuple(10.0 ** (0.5 * k) for k in range(-2, 20))


@dataclass(frozen=True)
class Profile:
    """A cross-section of the sheet.

    Parameters
    ----------
    y : ndarray, shape (n,)
        Deformed coordinate across the sheet, strictly increasing, over the full width.
    z : ndarray, shape (n,)
        Deflection, in the unit of ``y``.
    x : ndarray, shape (n,), optional
        Deformed coordinate along the pull (zero on the line half-way between the clamps).
    """

    y: Array
    z: Array
    x: Array | None = None

    def __post_init__(self) -> None:
        """Refuse what is no cross-section.

        Raises
        ------
        ValueError
            If the shapes differ, there are fewer than 8 points, a number is not finite or ``y``
            does not increase.
        """
        if self.y.ndim != 1 or self.y.shape != self.z.shape:
            raise ValueError(f"profile: y {self.y.shape} and z {self.z.shape} must be two columns")
        if len(self.y) < LEAST_POINTS:
            raise ValueError(f"profile: {len(self.y)} points, at least {LEAST_POINTS} are needed")
        if not (np.isfinite(self.y).all() and np.isfinite(self.z).all()):
            raise ValueError("profile: y and z must be finite")
        if not (np.diff(self.y) > 0.0).all():
            raise ValueError("profile: y must increase strictly")


def profile_from_state(
    sheet: DeformedSheet, x: float = 0.0, per_cell: int = SAMPLES_PER_CELL
) -> Profile:
    """Return the cross-section of a computed state on the material line X = ``x``.

    Parameters
    ----------
    sheet : DeformedSheet
    x : float
        Reference coordinate of the line, between -L/2 and L/2; 0 is half-way between the clamps.
    per_cell : int
        Samples of the finite element interpolant per cell.

    Returns
    -------
    Profile
        Over the full width, in units of W, in deformed coordinates.

    Raises
    ------
    ValueError
        If the line is outside the sheet.
    """
    whole = sheet.unfolded()
    end = whole.grid.x[-1]
    if not abs(x) <= end:
        raise ValueError(f"x = {x:g}: must lie between -L/2 and L/2 = {end:g} (in units of W)")
    line = whole.evaluate(np.array([x]), subdivided(whole.grid.y, per_cell))[:, 0, :]
    return Profile(y=line[1], z=line[2], x=line[0])


def cleaned(profile: Profile, samples: int = 4096) -> Profile:
    """Return a scanned profile without noise, offset and tilt, densely sampled.

    A cubic smoothing spline removes the noise, which would otherwise dominate the arc length; how
    strongly it smooths follows from the noise of the points (`noise_level`). Offset and tilt, which
    come from setting up the scanner, are removed as the least-squares line through the smooth
    profile. A computed state needs none of this: its clamps lie at z = 0.

    Parameters
    ----------
    profile : Profile
        As scanned.
    samples : int
        Points of the result, equally spaced.

    Returns
    -------
    Profile
        Same width and units.
    """
    smooth = _smooth(profile, noise_level(profile))
    y = np.linspace(profile.y[0], profile.y[-1], samples)
    z = smooth(y)
    centred = y - y.mean()
    tilt = (centred @ z) / (centred @ centred)
    return Profile(y=y, z=z - z.mean() - tilt * centred)


def noise_level(profile: Profile) -> float:
    """Return the standard deviation of the noise of single points.

    Each inner point is compared with the straight line between its neighbours, which removes the
    wrinkle as long as there are many points per wavelength (Gasser, Sroka and
    Jennen-Steinmetz, Biometrika 73, 625, 1986).

    Parameters
    ----------
    profile : Profile
        As scanned.

    Returns
    -------
    float
        In the unit of the profile.
    """
    y, z = profile.y, profile.z
    left = (y[2:] - y[1:-1]) / (y[2:] - y[:-2])
    right = 1.0 - left
    misfit = left * z[:-2] + right * z[2:] - z[1:-1]
    return float(np.sqrt(np.mean(misfit**2 / (1.0 + left**2 + right**2))))


def _smooth(profile: Profile, noise: float) -> Callable[[Array], Array]:
    """Return the cubic smoothing spline of the least expected error (Mallows' C_p).

    C_p = mean squared residual + 2 noise^2 tr(S)/n, where S is the matrix that smooths. On points
    of unit spacing it damps the wave number k by 1/(1 + p k^4), p the penalty; the integral of that
    over k gives tr(S) = n p^(-1/4) / (2 sqrt 2), besides the 2 of the straight line.
    """
    from scipy.interpolate import make_smoothing_spline  # imported here because it takes time

    count = len(profile.y)
    spacing = (profile.y[-1] - profile.y[0]) / (count - 1)
    scale = max(float(np.abs(profile.z).max()), 1e-300)
    steps = (profile.y - profile.y[0]) / spacing  # so that the penalty means the same in any unit

    def spline(penalty: float) -> Callable[[Array], Array]:
        return make_smoothing_spline(steps, profile.z / scale, lam=penalty)

    def error(penalty: float) -> float:
        freedom = min(count / (2.0 * np.sqrt(2.0) * penalty**0.25) + 2.0, count)
        residual = spline(penalty)(steps) - profile.z / scale
        return float(np.mean(residual**2) + 2.0 * (noise / scale) ** 2 * freedom / count)

    best = spline(min(_PENALTIES, key=error))
    return lambda y: scale * np.asarray(best((y - profile.y[0]) / spacing))
