"""The cross-section of a sheet: its material law, thickness and bending law."""

from dataclasses import dataclass
from functools import cached_property

from wrinklestudy.mechanics.bending import (
    BendingLaw,
    SectionDerivatives,
    bending_law_of,
    check_bending,
)
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.mechanics.surface import SurfaceGeometry, linear_strain
from wrinklestudy.typing import Array


@dataclass(frozen=True)
class Section:
    """Energy of the cross-section as a function of metric and curvature of the mid-surface.

    Parameters
    ----------
    law : Law
        Dimensionless material law.
    thickness : float or array
        t in units of W; an array gives it at each of the points.
    bending : str
        The bending law, a name in `BENDING_LAWS`.

    Raises
    ------
    ValueError
        If there is no such bending law, or it does not go with the material law.
    """

    law: Law
    thickness: float | Array
    bending: str = "thinning"

    def __post_init__(self) -> None:
        check_bending(self.law, self.bending)

    @cached_property
    def bending_law(self) -> BendingLaw:
        """The bending law."""
        return bending_law_of(self.bending)

    def surface(self, derivatives: Array) -> SurfaceGeometry:
        """Return the geometry of the mid-surface from x,1 x,2 x,11 x,22 x,12, (5, 3, ...)."""
        surface = self.bending_law.surface(derivatives)
        return linear_strain(surface) if self.law.linear_in_plane else surface

    def energy(self, metric: Array, curvature: Array) -> Array:
        """Return the energy per reference area in units of mu W, shape ``(...)``."""
        return self.bending_law.energy(self.law, self.thickness, metric, curvature)

    def derivatives(self, metric: Array, curvature: Array) -> SectionDerivatives:
        """Return the first and second derivatives of the energy with respect to a and b."""
        return self.bending_law.derivatives(self.law, self.thickness, metric, curvature)
