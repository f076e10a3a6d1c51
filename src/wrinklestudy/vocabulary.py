"""Words and limits that the whole library shares."""

from dataclasses import dataclass
from typing import Literal, get_args

Parity = Literal["antisymmetric", "symmetric"]
Status = Literal["wrinkled", "flat", "not-converged"]

PARITIES: tuple[Parity, ...] = get_args(Parity)
STATUSES: tuple[Status, ...] = get_args(Status)


@dataclass(frozen=True)
class Limits:
    """A range of numbers: ``value in limits`` tests a number, ``str(limits)`` words a message.

    Parameters
    ----------
    lowest, highest : float
        Ends of the interval.
    above_lowest : bool
        Whether the lower end itself is excluded.
    unit : str
        What the number is, or its unit, for messages.

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
        """Return whether a number lies within the limits; NaN never does."""
        above = value > self.lowest if self.above_lowest else value >= self.lowest
        return above and value <= self.highest

    def __str__(self) -> str:
        """Return the limits as a message words them."""
        sign = ">" if self.above_lowest else ">="
        unit = f" ({self.unit})" if self.unit else ""
        return f"{sign} {self.lowest:g} and <= {self.highest:g}{unit}"


ASPECT = Limits(0.5, 20.0, unit="L/W")
THICKNESS = Limits(0.0, 0.05, above_lowest=True, unit="t/W")
STRAIN = Limits(0.0, 1.0, above_lowest=True)
# Cells of the quarter of the reference sheet, along or across.
CELLS = Limits(2, 500)
