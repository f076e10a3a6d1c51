"""Bias and standard errors of what is measured on a scan, from noise drawn onto it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from wrinklestudy.metrics.measure import Measures, measure
from wrinklestudy.metrics.profile import Profile
from wrinklestudy.metrics.scan_points import SecondWave
from wrinklestudy.metrics.smoothing import ScanFit
from wrinklestudy.typing import Array

# Peaks that are lower by less than this many standard errors may be as high as the highest
_RIVALS = 2.0


@dataclass(frozen=True, eq=False)
class Drawn:
    """A smooth profile measured again and again with noise drawn onto it.

    Parameters
    ----------
    value : Measures
        Of the profile itself.
    height : float
        Its amplitude, the mean of the peaks that noise could have made largest.
    amplitude, wavelength, phi_squared, phi_squared_central : (draws,) array
        Of the profile with noise.
    spread : float
        Standard deviation of the drawings where the profile is highest.
    reached : float
        Height that noise alone reaches in 95% of the drawings.
    """

    value: Measures
    height: float
    amplitude: Array
    wavelength: Array
    phi_squared: Array
    phi_squared_central: Array
    spread: float
    reached: float

    @classmethod
    def of(cls, fit: ScanFit, noise: Array) -> "Drawn":
        """Return those of a fit with drawings of its noise."""
        profile = fit.profile
        value = measure(profile)
        spread = float(noise[:, int(np.abs(profile.z).argmax())].std(ddof=1))
        drawn = [fit.smoother.profile(fit.heights + one) for one in noise]
        measured = [measure(one) for one in drawn]
        heights = [_height(one, its, spread) for one, its in zip(drawn, measured, strict=True)]
        return cls(
            value,
            _height(profile, value, spread),
            np.array(heights),
            np.array([one.wavelength for one in measured]),
            np.array([one.phi_squared for one in measured]),
            np.array([one.phi_squared_central for one in measured]),
            spread,
            reached_by(noise),
        )

    def corrected(self) -> Measures:
        """Return the measures without their bias.

        What noise adds to the smooth profile it has added to the true one already.
        """
        value = self.value
        central = 2.0 * value.phi_squared_central - _middle(self.phi_squared_central)
        new = replace(
            value,
            amplitude=max(2.0 * self.height - float(self.amplitude.mean()), 0.0),
            wavelength=2.0 * value.wavelength - _middle(self.wavelength),
            phi_squared=max(2.0 * value.phi_squared - float(self.phi_squared.mean()), 0.0),
            phi_squared_central=max(central, 0.0),
        )
        full, central = (
            new.amplitude / (new.wavelength * phi_squared**0.5) if phi_squared > 0.0 else np.nan
            for phi_squared in (new.phi_squared, new.phi_squared_central)
        )
        arc_width = new.projected_width * (1.0 + new.phi_squared)
        return replace(
            new, arc_width=arc_width, shape_constant=full, shape_constant_central=central
        )

    def errors(self, coarser: Measures, ripples: Sequence[SecondWave]) -> tuple[float, ...]:
        """Return standard errors of amplitude, wavelength and Phi^2.

        Parameters
        ----------
        coarser : Measures
            Of a spline with knots farther apart: the change is an error.
        ripples : sequence of SecondWave
            Waves that may lie under the wrinkles.
        """
        value, wavelength = self.value, self.value.wavelength
        # The mean of several peaks spreads less, but which are taken depends on the noise
        lacking = max(self.spread**2 - float(self.amplitude.var(ddof=1)), 0.0) ** 0.5
        return (
            _error(
                self.amplitude,
                self.height,
                lacking,
                coarser.amplitude - value.amplitude,
                *(one.height for one in ripples),
            ),
            _error(
                self.wavelength,
                wavelength,
                coarser.wavelength - wavelength,
                *(one.moves(self.height, wavelength) for one in ripples),
            ),
            _error(
                self.phi_squared,
                value.phi_squared,
                coarser.phi_squared - value.phi_squared,
                *(one.lengthens(value.phi_squared) for one in ripples),
            ),
        )


def reached_by(noise: Array) -> float:
    """Return the height that drawings of noise reach in 95% of the cases: shape (draws, s)."""
    return float(np.percentile(np.abs(noise).max(axis=1), 95))


def _height(profile: Profile, measures: Measures, spread: float) -> float:
    """Return the largest height, or the mean of those peaks that noise could have made largest.

    The largest of several equal peaks with noise on them is too high by a part of the noise.
    """
    peaks = np.abs(np.interp(measures.extrema, profile.y, profile.z))
    if not len(peaks):
        return measures.amplitude
    rivals = peaks[peaks >= peaks.max() - _RIVALS * spread]
    return measures.amplitude - float(peaks.max() - rivals.mean())


def _middle(drawn: Array) -> float:
    """Return the median of the drawings that have a number, NaN if most have none."""
    known = drawn[np.isfinite(drawn)]
    return float(np.median(known)) if 2 * len(known) > len(drawn) else float("nan")


def _error(drawn: Array, value: float, *others: float) -> float:
    """Return the spread of drawings with half their bias, no better than which it is known."""
    known = drawn[np.isfinite(drawn)]
    if len(known) < 2:
        return float("nan")
    return float(np.linalg.norm([known.std(ddof=1), 0.5 * (known.mean() - value), *others]))
