"""Words and limits that the whole library shares: one place for what may be said of a sheet."""

from dataclasses import dataclass
from typing import Literal, get_args

Parity = Literal["antisymmetric", "symmetric"]
Status = Literal["wrinkled", "flat", "not-converged"]

PARITIES: tuple[Parity, ...] = get_args(Parity)
STATUSES: tuple[Status, ...] = get_args(Status)


@dataclass(frozen=True)
class Limits:
    """The numbers that are allowed: ``value in limits``; as text, what a message says of them.

    Parameters
    ----------
    lowest, highest : float
        Ends of the interval.
    above_lowest : bool
        Whether the lower end itself is not allowed.
    unit : str
        What the number is or is measured in, for messages.

    Examples
    --------
    >>> 0.4 in ASPECT, str(ASPECT)
    (False, '>= 0.5 and <= 20 (L/W)')
    """

    lowest: float
    highest: float
    above_lowest: bool = False
    unit: str = ""

    def __contains__(self, value: float) -> bool:
        """Whether a number lies between the limits; NaN does not."""
        above = value > self.lowest if self.above_lowest else value >= self.lowest
        return above and value <= self.highest

    def __str__(self) -> str:
        """Return the limits in the words of a message."""
        sign = ">" if self.above_lowest else ">="
        unit = f" ({self.unit})" if self.unit else ""
        lowest = f"{self.lowest:g}".replace("e-0", "e-")
        return f"{sign} {lowest} and <= {self.highest:g}{unit}"


ASPECT = Limits(0.5, 20.0, unit="L/W")
# The mesh of a thinner sheet fits in no memory; at smaller strains energies are mostly rounding.
THICKNESS = Limits(1e-6, 0.05, unit="t/W")
STRAIN = Limits(1e-7, 1.0)
# Cells of the quarter of the reference sheet, along or across.
CELLS = Limits(2, 500)
