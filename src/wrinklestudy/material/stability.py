"""Whether a fitted law is a material at all within the range of the data."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.material.homogeneous import MODES, nominal_stress
from wrinklestudy.mechanics.laws import Material

_POINTS = 400


@dataclass(frozen=True)
class StretchStability:
    """Where the stress of a law rises with stretch.

    Parameters
    ----------
    stretch_range : tuple of float
        The stretches looked at; 1 is among them.
    lost_at : dict
        By mode of deformation, the stretch nearest to 1 at which the stress no longer rises; modes
        in which it rises throughout are left out.
    """

    stretch_range: tuple[float, float]
    lost_at: dict[str, float]

    @property
    def stable(self) -> bool:
        """Whether the stress rises with stretch in all modes."""
        return not self.lost_at

    @property
    def text(self) -> str:
        """The finding in words."""
        low, high = self.stretch_range
        if self.stable:
            return f"stress rises with stretch in all modes from {low:.4g} to {high:.4g}"
        where = ", ".join(f"{mode} from stretch {at:.4g}" for mode, at in self.lost_at.items())
        return f"stress does not rise in {where}"


def stability(material: Material, stretch_range: tuple[float, float]) -> StretchStability:
    """Return where the nominal stress rises with stretch in the three modes of deformation.

    dT/dlambda > 0 in simple tension, equibiaxial tension and pure shear: Drucker's condition for
    these paths. Data of a single mode do not tell it of the others.

    Parameters
    ----------
    material : Material
    stretch_range : tuple of float
        Smallest and largest stretch of the data; the range is widened to include 1.
    """
    low, high = min(stretch_range[0], 1.0), max(stretch_range[1], 1.0)
    stretch = np.linspace(low, high, _POINTS)
    lost = {}
    for mode in MODES:
        with np.errstate(all="ignore"):
            rise = np.diff(nominal_stress(material, stretch, mode))
        bad = 0.5 * (stretch[1:] + stretch[:-1])[~(rise > 0.0)]
        if bad.size:
            lost[mode] = float(bad[np.argmin(np.abs(np.log(bad)))])
    return StretchStability((low, high), lost)
