"""A cheap curve scaled to a costly one at the strains where both are known."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np


@dataclass(eq=False)
class ScaledCurve:
    """The function guide(eps) x ratio(eps), where the ratio makes it exact at some strains.

    Between those the ratio is linear in log(eps), beyond them it is constant: for small strains
    both curves go like the root of the strain.

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
    reason : str
        Why not; one line.
    """

    curve: Callable[[float], float]
    guide: Callable[[float], float]
    exact: dict[float, float] = field(default_factory=dict, init=False)
    rough: dict[float, float] = field(default_factory=dict, init=False)
    end: float = field(default=math.inf, init=False)
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
                self.end, self.reason = strain, str(error)
                raise
        return self.rough[strain] * self.ratio(strain)

    def known(self) -> list[tuple[float, float]]:
        """Return the scaled values at all strains where the guide is known."""
        return [(strain, self(strain)) for strain in self.rough if strain < self.end]

    def correct(self, strain: float) -> None:
        """Make the scaled curve exact at a strain, or end it there."""
        try:
            self(strain)  # the ratio needs both
            self.exact[strain] = self.curve(strain)
        except ArithmeticError as error:
            self.end, self.reason = strain, str(error)

    def distance(self, strain: float) -> float:
        """Return how far the nearest strain is at which the curve itself was computed."""
        return min((abs(strain - exact) for exact in self.exact), default=math.inf)

    def ratio(self, strain: float) -> float:
        """Return the factor from the guide to the scaled curve."""
        strains = sorted(e for e in self.exact if self.rough[e] > 0.0)
        if not strains:
            return 1.0
        ratios = [self.exact[e] / self.rough[e] for e in strains]
        return float(np.interp(math.log(strain), np.log(strains), ratios))
