"""The law of Yeoh."""

from collections.abc import Mapping
from dataclasses import dataclass

from wrinklestudy.mechanics.laws.base import Constant, Material
from wrinklestudy.mechanics.laws.incompressible import IncompressibleLaw, Slopes
from wrinklestudy.typing import Array


@dataclass(frozen=True)
class Yeoh(IncompressibleLaw):
    """Incompressible Yeoh sheet in plane stress.

    W = c10 x + c20 x^2 + c30 x^3 with x = I1 - 3 and I1 = tr g + 1/det g.

    O. H. Yeoh, Some forms of the strain energy function for rubber, Rubber Chem. Technol. 66,
    754 (1993).

    Parameters
    ----------
    c10, c20, c30 : float
        Constants in units of the initial shear modulus 2 C10, so that c10 = 1/2.
    """

    name = "yeoh"
    label = "Yeoh"
    short_label = "Yeoh"
    constants = (
        Constant("c10", "C_{10}", "Pa", "factor of I1 - 3 in the energy", low=0.0, above=True),
        Constant("c20", "C_{20}", "Pa", "factor of (I1 - 3)^2"),
        Constant("c30", "C_{30}", "Pa", "factor of (I1 - 3)^3"),
    )
    linear = True

    c10: float
    c20: float
    c30: float

    @classmethod
    def shear_modulus(cls, constants: Mapping[str, float]) -> float:
        """Return 2 C10."""
        return 2.0 * constants["c10"]

    @classmethod
    def polyconvex(cls, constants: Mapping[str, float]) -> bool | None:
        """Return True for C20, C30 >= 0: then convex and rising in the deformation gradient."""
        return True if min(constants["c20"], constants["c30"]) >= 0.0 else None

    def density(self, trace: Array, det: Array) -> Array:
        """Return W(T, D)."""
        x = trace + 1.0 / det - 3.0
        return x * (self.c10 + x * (self.c20 + x * self.c30))

    def slopes(self, trace: Array, det: Array) -> Slopes:
        """Return the first and second derivatives of W(T, D)."""
        inverse = 1.0 / det
        square = inverse * inverse  # -dI1/dD
        x = trace + inverse - 3.0
        first = self.c10 + x * (2.0 * self.c20 + 3.0 * self.c30 * x)
        second = 2.0 * self.c20 + 6.0 * self.c30 * x
        by_det2 = second * square * square + 2.0 * first * square * inverse
        return Slopes(first, -first * square, second, -second * square, by_det2)


def yeoh(c10: float, c20: float, c30: float) -> Material:
    """Return an incompressible Yeoh material from its constants in Pa.

    Raises
    ------
    ValueError
        If c10 is not positive.
    """
    return Yeoh.material(c10=c10, c20=c20, c30=c30)
