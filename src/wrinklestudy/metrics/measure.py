"""Amplitude, wavelength, arc width and confinement of a profile.

Defined as by Panaitescu et al., PRE 100, 053003 (2019): A is the largest deflection, lambda the
distance from one central peak to the next, W_act the arc length across the sheet, W_proj its
projection, Phi^2 = (W_act - W_proj)/W_proj and C = A/(lambda Phi) (their equation A = C lambda Phi;
a sinusoid of small slope has C = 1/pi). The paper does not say over which width Phi^2 is averaged,
so that both averages are returned: over the full width and over the central wrinkle alone.
"""

from dataclasses import dataclass, field

import numpy as np

from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.profile import Profile, profile_from_state
from wrinklestudy.metrics.spline import ProfileSpline
from wrinklestudy.typing import Array

# An extremum counts if it stands out by this fraction of the range of z; ripples of noise do not.
PROMINENCE = 0.1
# A profile whose largest deflection is below this fraction of its width is flat.
FLAT = 1e-9

_GAUSS_POINTS, _GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(4)


@dataclass(frozen=True)
class Measures:
    """What is measured on a profile; lengths have the unit of the profile.

    Parameters
    ----------
    amplitude : float
        A, largest absolute deflection; 0 if flat.
    wavelength : float
        lambda, distance between the two neighbouring peaks, or troughs, nearest the centre; NaN if
        there are fewer than two.
    wavelength_zero : float
        Distance between the two neighbouring zero crossings in the same direction nearest the
        centre; NaN if there are none.
    arc_width, projected_width : float
        W_act and W_proj across the full width.
    phi_squared : float
        (W_act - W_proj)/W_proj over the full width.
    phi_squared_central : float
        The same over one wavelength around the centre; NaN without a wavelength, 0 if flat.
    shape_constant, shape_constant_central : float
        C = A/(lambda Phi) with either average; NaN without a wavelength.
    extrema : ndarray, shape (k,)
        Where the peaks and troughs are, in increasing y.
    """

    amplitude: float
    wavelength: float
    wavelength_zero: float
    arc_width: float
    projected_width: float
    phi_squared: float
    phi_squared_central: float
    shape_constant: float
    shape_constant_central: float
    extrema: Array = field(repr=False, compare=False)

    def cells_per_wavelength(self, cells_across: int) -> float:
        """Return how many of the cells from edge to edge lie in a wavelength, NaN without one.

        The cells are equal, and the sheet contracts across by about the same factor everywhere.
        """
        return cells_across * self.wavelength / self.projected_width


def measure(profile: Profile) -> Measures:
    """Measure a profile on the cubic spline z(y) through its points.

    Peaks are the roots of z'(y), so that they do not fall on samples; the excess length is
    integrated as z'^2/(1 + sqrt(1 + z'^2)), so that its digits are not lost in the width. Peaks
    that stand out by less than 10% of the range of z are ripples of noise and do not count. Scans
    are measured by `metrics.scan.measure_scan`.

    Parameters
    ----------
    profile : Profile
        Over the full width.

    Returns
    -------
    Measures
    """
    y, z = profile.y, profile.z
    width = float(y[-1] - y[0])
    if np.abs(z).max() <= FLAT * width:
        nan, empty = float("nan"), np.empty(0)
        return Measures(0.0, nan, nan, width, width, 0.0, 0.0, nan, nan, empty)
    curve = ProfileSpline.through(y, z)
    turning = curve.turning_points()
    marks = np.concatenate([y[:1], turning[(turning > y[0]) & (turning < y[-1])], y[-1:]])
    heights = curve(marks)
    kept = prominent(heights, PROMINENCE * float(np.ptp(heights)))[1:-1]
    extrema, levels = marks[kept], heights[kept]
    centre = 0.5 * float(y[0] + y[-1])
    wavelength = _spacing(extrema, centre)
    crossings = _crossings(curve, extrema, levels)
    phi_squared = _excess(curve, float(y[0]), float(y[-1])) / width
    central = _central_phi_squared(curve, y, centre, wavelength)
    amplitude = float(np.abs(heights).max())
    return Measures(
        amplitude=amplitude,
        wavelength=wavelength,
        wavelength_zero=_spacing(crossings, centre),
        arc_width=width * (1.0 + phi_squared),
        projected_width=width,
        phi_squared=phi_squared,
        phi_squared_central=central,
        shape_constant=amplitude / (wavelength * phi_squared**0.5),
        shape_constant_central=amplitude / (wavelength * central**0.5),
        extrema=extrema,
    )


def measure_sheet(sheet: DeformedSheet) -> Measures:
    """Measure a computed state on the line half-way between the clamps, lengths in units of W."""
    return measure(profile_from_state(sheet))


def prominent(heights: Array, threshold: float) -> list[int]:
    """Return which of the alternating heights remain when small ups and downs are ironed out.

    As long as two neighbours differ by less than the threshold, the closest two are
    removed together, which leaves the sequence alternating; the two ends always stay.

    Parameters
    ----------
    heights : ndarray, shape (n,)
        One end, the extrema in order, the other end.
    threshold : float
        Smallest difference that counts.

    Returns
    -------
    list of int
        Indices into ``heights``, first and last included.
    """
    kept = list(range(len(heights)))
    while len(kept) > 2:
        steps = np.abs(np.diff(heights[kept]))
        k = int(np.argmin(steps))
        if steps[k] >= threshold:
            break
        first = max(k, 1)
        last = min(k + 1, len(kept) - 2)
        del kept[first : last + 1]
    return kept


def _crossings(curve: ProfileSpline, extrema: Array, levels: Array) -> Array:
    """Return a zero crossing between any two neighbouring extrema of opposite sign."""
    zeros = curve.zeros()
    crossings = []
    for k in range(len(extrema) - 1):
        if levels[k] * levels[k + 1] < 0.0:
            inside = zeros[(zeros > extrema[k]) & (zeros < extrema[k + 1])]
            crossings.append(float(inside.mean()))
        else:
            crossings.append(float("nan"))  # keeps the directions alternating
    return np.array(crossings)


def _spacing(positions: Array, centre: float) -> float:
    """Return the distance between the next-but-one neighbours whose midpoint is nearest the centre.

    Kinds (peak and trough, up and down) alternate, so that next-but-one neighbours are alike.
    """
    first, second = positions[:-2], positions[2:]
    middle = np.abs(0.5 * (first + second) - centre)
    if not np.isfinite(middle).any():
        return float("nan")
    nearest = int(np.nanargmin(middle))
    return float(second[nearest] - first[nearest])


def _excess(curve: ProfileSpline, start: float, stop: float) -> float:
    """Return arc length minus projected length of z(y) between two points."""
    knots = curve.y
    inside = knots[(knots > start) & (knots < stop)]
    edges = np.concatenate([[start], inside, [stop]])
    half = 0.5 * np.diff(edges)
    points = (edges[:-1] + half)[:, None] + half[:, None] * _GAUSS_POINTS
    slope = curve(points, 1)
    density = slope**2 / (1.0 + np.sqrt(1.0 + slope**2))
    return float(half @ (density @ _GAUSS_WEIGHTS))


def _central_phi_squared(curve: ProfileSpline, y: Array, centre: float, wavelength: float) -> float:
    start, stop = centre - 0.5 * wavelength, centre + 0.5 * wavelength
    if not (start >= y[0] and stop <= y[-1]):
        return float("nan")
    return _excess(curve, start, stop) / wavelength
