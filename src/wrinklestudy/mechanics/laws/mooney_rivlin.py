"""The law of Mooney and Rivlin."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from wrinklestudy.mechanics.laws.base import Constant, Material
from wrinklestudy.mechanics.laws.incompressible import IncompressibleLaw, Slopes
from wrinklestudy.typing import Array


@dataclass(frozen=True)
class MooneyRivlin(IncompressibleLaw):
    """Incompressible Mooney-Rivlin sheet in plane stress; neo-Hookean for ``c01 = 0``.

    W = c10 (I1 - 3) + c01 (I2 - 3) with I1 = tr g + 1/det g, I2 = det g + tr g / det g.

    Parameters
    ----------
    c10, c01 : float
        Constants in units of the initial shear modulus 2 (C10 + C01), so that c10 + c01 = 1/2.
    """

    name = "mooney-rivlin"
    label = "Mooney\N{EN DASH}Rivlin"
    short_label = "MR"
    constants: ClassVar[tuple[Constant, ...]] = (
        Constant("c10", "C_{10}", "Pa", "factor of I1 - 3 in the energy", low=0.0),
        Constant("c01", "C_{01}", "Pa", "factor of I2 - 3 in the energy", low=0.0),
    )
    linear = True

    c10: float
    c01: float

    @classmethod
    def shear_modulus(cls, constants: Mapping[str, float]) -> float:
        """Return 2 (C10 + C01)."""
        return 2.0 * (constants["c10"] + constants["c01"])

    @classmethod
    def polyconvex(cls, constants: Mapping[str, float]) -> bool:  # noqa: ARG003
        """Return True: the bounds C10, C01 >= 0 make it so (Ball 1977)."""
        return True

    def density(self, trace: Array, det: Array) -> Array:
        """Return W(T, D)."""
        return self.c10 * (trace + 1.0 / det - 3.0) + self.c01 * (det + trace / det - 3.0)

    def slopes(self, trace: Array, det: Array) -> Slopes:
        """Return the first and second derivatives of W(T, D)."""
        inverse = 1.0 / det
        square = inverse * inverse
        by_trace = self.c10 + self.c01 * inverse
        by_det = self.c01 - (self.c10 + self.c01 * trace) * square
        mixed = -self.c01 * square
        by_det2 = 2.0 * (self.c10 + self.c01 * trace) * square * inverse
        return Slopes(by_trace, by_det, None, mixed, by_det2)


def mooney_rivlin(c10: float, c01: float) -> Material:
    """Return an incompressible Mooney-Rivlin material from its constants in Pa.

    Raises
    ------
    ValueError
        If a constant is negative or the initial shear modulus 2 (c10 + c01) is not positive.
    """
    return MooneyRivlin.material(c10=c10, c01=c01)
