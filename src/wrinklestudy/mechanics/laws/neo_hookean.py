"""The neo-Hookean law."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from wrinklestudy.mechanics.laws.base import Constant, Law, Material
from wrinklestudy.mechanics.laws.mooney_rivlin import MooneyRivlin


@dataclass(frozen=True)
class NeoHookean(MooneyRivlin):
    """Incompressible neo-Hookean sheet in plane stress: Mooney-Rivlin with c01 = 0.

    W = c10 (I1 - 3), I1 = tr g + 1/det g.

    Parameters
    ----------
    c10 : float
        Constant in units of the initial shear modulus 2 C10, so that c10 = 1/2.
    """

    name = "neo-hookean"
    label = "neo-Hookean"
    short_label = "NH"
    constants: ClassVar[tuple[Constant, ...]] = (
        Constant("c10", "C_{10}", "Pa", "factor of I1 - 3 in the energy", low=0.0, above=True),
    )

    c01: float = field(default=0.0, init=False)

    @classmethod
    def covers(cls, law: Law) -> bool:
        """Return whether a law is neo-Hookean, by this class or as Mooney-Rivlin with c01 = 0."""
        return isinstance(law, MooneyRivlin) and law.c01 == 0.0

    @classmethod
    def shear_modulus(cls, constants: Mapping[str, float]) -> float:
        """Return 2 C10."""
        return 2.0 * constants["c10"]


def neo_hookean(c10: float) -> Material:
    """Return an incompressible neo-Hookean material from C10 in Pa.

    Raises
    ------
    ValueError
        If the constant is not positive.
    """
    return NeoHookean.material(c10=c10)
