"""A cheap curve scaled to a costly one at the strains where both are known."""

import math
from bisect import bisect_left
from collections.abc import Callable
from dataclasses import dataclass, field

_DIFFERENT = 0.2  # least difference of 1/guide^2, in parts of it, by which to interpolate
_BACK = 0.95  # where a curve ends, what the guide gave just below is not trusted


@dataclass(eq=False)
class ScaledCurve:
    """The function guide(eps) x ratio(eps), where the ratio makes it exact at some strains.

    Beyond those the ratio is constant. Between two of them it is linear in 1/guide^2, since what a
    coarse mesh leaves unresolved grows as tau_1 and with it the wavelength fall, and is least at
    the maximum; between strains with nearly the same value it is linear in the strain.

    Parameters
    ----------
    curve, guide : callable
        tau_1/W at a strain > 0; raise ArithmeticError where it cannot be computed.

    Attributes
    ----------
    exact : dict
        Values of the curve by strain.
    rough : dict
        Values of the guide by strain.
    end : float
        Strain from which on one of them cannot be computed.
    broken : bool
        Whether it is the curve that cannot, so that its values below must be checked.
    late : bool
        Whether the guide cannot be computed at strains below its first value.
    reason : str
        Why not at the end; one line.
    """

    curve: Callable[[float], float]
    guide: Callable[[float], float]
    exact: dict[float, float] = field(default_factory=dict, init=False)
    rough: dict[float, float] = field(default_factory=dict, init=False)
    end: float = field(default=math.inf, init=False)
    broken: bool = field(default=False, init=False)
    late: bool = field(default=False, init=False)
    reason: str = field(default="", init=False)

    def __call__(self, strain: float) -> float:
        """Return the scaled value.

        Raises
        ------
        ArithmeticError
            If the guide or the curve cannot be computed there or at a smaller strain.
        """
        if strain >= self.end:
            raise ArithmeticError(self.reason)
        if strain not in self.rough:
            try:
                self.rough[strain] = self.guide(strain)
            except ArithmeticError as error:
                if self.rough and strain > min(self.rough):
                    self.end, self.reason = strain, str(error)
                else:
                    self.late = True
                raise
        return self.rough[strain] * self.ratio(strain)

    def known(self) -> list[tuple[float, float]]:
        """Return the scaled values at all strains where the guide is known."""
        return [(strain, self(strain)) for strain in self.rough if strain < self.end]

    def correct(self, strain: float) -> None:
        """Make the scaled curve exact at a strain, or end it a little below.

        Raises
        ------
        ArithmeticError
            If the guide cannot be computed there.
        """
        self(strain)  # the ratio needs both
        try:
            self.exact[strain] = self.curve(strain)
        except ArithmeticError as error:
            self.end, self.broken, self.reason = _BACK * strain, True, str(error)

    def distance(self, strain: float) -> float:
        """Return how far the nearest strain is at which the curve itself was computed."""
        return min((abs(strain - exact) for exact in self.exact), default=math.inf)

    def ratio(self, strain: float) -> float:
        """Return the factor from the guide to the scaled curve."""
        strains = sorted(e for e in self.exact if self.rough[e] > 0.0)
        if not strains or self.rough[strain] == 0.0:
            return 1.0
        place = bisect_left(strains, strain)
        left, right = strains[max(place - 1, 0)], strains[min(place, len(strains) - 1)]
        first, last = self.exact[left] / self.rough[left], self.exact[right] / self.rough[right]
        if strain <= left or strain >= right:
            return last if strain >= right else first
        start, here, end = (self.rough[e] ** -2.0 for e in (left, strain, right))
        if abs(end - start) < _DIFFERENT * max(start, end):
            start, here, end = left, strain, right
        return first + (last - first) * min(max((here - start) / (end - start), 0.0), 1.0)
