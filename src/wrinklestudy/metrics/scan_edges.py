"""What is left of a scanned wave at the edges of the sheet, where wrinkles have faded."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.metrics.profile import Profile
from wrinklestudy.metrics.scan_points import SecondWave
from wrinklestudy.typing import Array

# Parts of the height: wrinkles fade towards the edges of a sheet to less than the first; up to the
# second what is left there may be a ripple of the scanner, above it the scan may end too early
_FADED, _AT_EDGE = 0.03, 0.2
_BOWED = 0.2


@dataclass(frozen=True)
class Edges:
    """How high a smooth profile still is within half a wavelength of the edges.

    Parameters
    ----------
    height : float
        Largest absolute height there.
    level : float
        Larger mean over a whole wavelength at either edge.
    noise : float
        What noise alone reaches there, in 95% of the drawings.
    """

    height: float
    level: float
    noise: float

    @classmethod
    def of(cls, profile: Profile, noise: Array, wavelength: float) -> "Edges":
        """Return those of a profile with drawings of its noise."""
        y, z = profile.y, np.abs(profile.z)
        from_edge = np.minimum(y - y[0], y[-1] - y)
        near = from_edge <= 0.5 * wavelength
        means = [profile.z[np.abs(y - edge) <= wavelength].mean() for edge in (y[0], y[-1])]
        reached = np.percentile(np.abs(noise[:, near]).max(axis=1), 95)
        return cls(float(z[near].max()), float(np.abs(means).max()), float(reached))

    def bowed(self, amplitude: float) -> str:
        """Return why a bow hides the height of the wrinkles; empty if there is none."""
        if self.level - self.noise <= _BOWED * amplitude:
            return ""
        return (
            f"the profile is bowed: at an edge it lies {self.level:.3g} off the straight line, "
            f"{self.level / amplitude:.0%} of the height"
        )

    def ripple(self, amplitude: float, wavelength: float) -> SecondWave:
        """Return the wave that may go through the whole profile, as it is seen at the edges."""
        height = self.height if self.height <= _AT_EDGE * amplitude else self.level
        seen = height > _FADED * amplitude + self.noise
        return SecondWave(wavelength, height, alike=True) if seen else SecondWave()

    def note(self, amplitude: float) -> str:
        """Return what to say of a wave that goes on to an edge; empty if it does not."""
        if self.height - self.noise <= _AT_EDGE * amplitude:
            return ""
        return (
            f"at an edge the profile still has {self.height / amplitude:.0%} of the height: if the "
            "scan does not go from edge to edge, or a ripple of the scanner has the wavelength of "
            "the wrinkles, the errors do not cover it"
        )
