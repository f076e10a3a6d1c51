"""Words and limits that the whole library shares."""

from dataclasses import dataclass
from math import inf, isfinite
from typing import Literal, get_args

Parity = Literal["antisymmetric", "symmetric"]
# Which part of the sheet is solved: what is left out follows from mirrors.
Part = Literal["quarter", "half", "half-width", "whole"]
Status = Literal["wrinkled", "flat", "not-converged"]
# Of a flat state, whether small wrinkles grow on sheets that are thin enough.
MapStatus = Literal["unstable", "stable", "not-converged"]
# Of a sheet without mirrors: unwrinkled is not flat, but too thick to wrinkle.
WholeStatus = Literal["wrinkled", "unwrinkled", "flat", "not-converged"]

PARITIES: tuple[Parity, ...] = get_args(Parity)
PARTS: tuple[Part, ...] = get_args(Part)
STATUSES: tuple[Status, ...] = get_args(Status)
WHOLE_STATUSES: tuple[WholeStatus, ...] = get_args(WholeStatus)
MAP_STATUSES: tuple[MapStatus, ...] = get_args(MapStatus)


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

    lowest: float = -inf
    highest: float = inf
    above_lowest: bool = False
    unit: str = ""

    def __contains__(self, value: float) -> bool:
        """Whether a number lies between the limits; NaN and infinities do not."""
        above = value > self.lowest if self.above_lowest else value >= self.lowest
        return above and value <= self.highest and isfinite(value)

    def __str__(self) -> str:
        """Return the limits in the words of a message."""
        ends = []
        if self.lowest > -inf:
            ends.append(f"{'>' if self.above_lowest else '>='} {_plain(self.lowest)}")
        if self.highest < inf:
            ends.append(f"<= {_plain(self.highest)}")
        unit = f" ({self.unit})" if self.unit else ""
        return f"{' and '.join(ends) or 'a finite number'}{unit}"


def printable(text: str) -> str:
    r"""Return a text that does nothing to a terminal but show itself.

    Examples
    --------
    >>> print(printable("no such file: \x1b[2J"))
    no such file: \x1b[2J
    """
    return "".join(
        letter if letter.isprintable() else letter.encode("unicode_escape").decode()
        for letter in text
    )


def one_line(text: str) -> str:
    """Return a text as one line, printable."""
    return printable(" ".join(text.split()))


def _plain(number: float) -> str:
    return f"{number:g}".replace("e-0", "e-")


ASPECT = Limits(0.5, 20.0, unit="L/W")
# The mesh of a thinner sheet fits in no memory; at smaller strains energies are mostly rounding.
THICKNESS = Limits(1e-6, 0.05, unit="t/W")
STRAIN = Limits(1e-7, 1.0)
# Softer and stiffer than anything there is; beyond lie numbers with fewer digits, or none.
SHEAR_MODULUS = Limits(1e-9, 1e18, unit="Pa")
JOBS = Limits(1, 1000)  # processes at the same time
# Cells of the quarter of the reference sheet, along or across.
CELLS = Limits(2, 500)
# Of a wrinkled state, in one wavelength across: with fewer the mesh is too coarse for its wrinkles.
FEWEST_CELLS = 6.0
# Beside a clamp, in units of W: at the corner of clamp and free edge a thin sheet has a flap, which
# stands higher than its wrinkles and is none.
FLAP = 0.1
STANDARD_GRAVITY = 9.80665  # m/s^2
# What of a sheet may be off, in the words of the command line and of the config.
SIZED_IMPERFECTIONS = {
    "shear": "shift of one clamp against the other across the pull, over W",
    "rotate": "turn of the right clamp in the plane about its own centre, in rad",
    "twist": "turn of one clamp against the other about the pull, in rad, half on each",
    "pitch": "slope of the right clamp: its turn about its own line, in rad",
    "lift": "shift of one clamp against the other out of the plane, over W",
    "thickness_along": "difference of the thickness from end to end, over its mean",
    "thickness_across": "difference of the thickness from edge to edge, over its mean",
}
# How far clamps and thickness of a whole sheet may be off: beyond that they are no imperfections.
SHIFT = Limits(-0.5, 0.5, unit="in units of W")
ANGLE = Limits(-0.5, 0.5, unit="in radians")
UNEVENNESS = Limits(-0.5, 0.5, unit="in parts of the mean thickness")
RELATIVE_THICKNESS = Limits(0.2, 5.0)
WAVELENGTH = Limits(0.01, 100.0, unit="in units of W")
WEIGHT = Limits(0.0, 0.1, unit="rho g W/mu")
DENSITY = Limits(0.0, 3.0e4, unit="kg/m^3")
GRAVITY = Limits(0.0, 1.0e3, unit="m/s^2")
