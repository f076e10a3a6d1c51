"""The membrane of Foppl and von Karman: Hooke's law with small in-plane strains."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.mechanics.laws.base import Material
from wrinklestudy.mechanics.laws.saint_venant_kirchhoff import SaintVenantKirchhoff
from wrinklestudy.typing import Array


@dataclass(frozen=True)
class FopplVonKarman(SaintVenantKirchhoff):
    """Hookean sheet in plane stress whose strain is linear in the displacement in the plane.

    W is that of `SaintVenantKirchhoff`, but of the strain E_ab = (u_a,b + u_b,a + w,a w,b)/2, so
    that g = 1 + 2 E is not the metric. With bending by the initial stiffness, the law `fvk`, these
    are the equations of Foppl and von Karman (S. Timoshenko and S. Woinowsky-Krieger, Theory of
    Plates and Shells, 1959, art. 100), which hold at small strains.

    Parameters
    ----------
    poisson : float
        Poisson's ratio nu, 0 <= nu <= 1/2.
    """

    name = "foppl-von-karman"
    label = "F\N{LATIN SMALL LETTER O WITH DIAERESIS}ppl\N{EN DASH}von K\u00e1rm\u00e1n"
    short_label = "FvK"
    linear_in_plane = True
    bendings = ("fvk",)

    def thickness_stretch(self, metric: Array) -> tuple[Array, Array, Array]:
        """Return lambda3 = 1 - nu/(1 - nu) (E11 + E22) and its derivatives."""
        ratio = self.poisson / (1.0 - self.poisson)
        stretch = 1.0 - 0.5 * ratio * (metric[0] + metric[1] - 2.0)
        gradient = np.zeros_like(metric)
        gradient[:2] = -0.5 * ratio
        return stretch, gradient, np.zeros((3, *metric.shape))

    def natural_width(self, stretch: Array) -> Array:
        """Return the transverse stretch under uniaxial tension, 1 - nu (lambda - 1)."""
        return 1.0 - self.poisson * (stretch - 1.0)

    def stretched(self, along: Array, across: Array) -> tuple[Array, Array]:
        """Return 1 + 2 E of principal stretches, (3, ...), and its derivative 2 along the first."""
        strain = np.stack([2.0 * along - 1.0, 2.0 * across - 1.0, np.zeros_like(along)])
        return strain, np.full_like(along, 2.0)


def foppl_von_karman(young: float = 1.0e6, poisson: float = 0.5) -> Material:
    """Return a Foppl-von Karman membrane from Young's modulus in Pa and Poisson's ratio.

    Raises
    ------
    ValueError
        If Young's modulus is not positive or Poisson's ratio is outside [0, 0.5].
    """
    return FopplVonKarman.material(young=young, poisson=poisson)
