"""The slope condition of clamps that are turned: z,1 there follows from x,1 and y,1."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.typing import Array, Indices


@dataclass(frozen=True, eq=False)
class TiedSlopes:
    """Degrees of freedom of z that follow from those of x and y of the same number.

    Parameters
    ----------
    dofs : (k,) array
        Their numbers.
    factors : (2, k) array
        z = factors[0] x + factors[1] y.
    """

    dofs: Indices
    factors: Array

    @property
    def key(self) -> bytes:
        """What tells these from others."""
        return self.dofs.tobytes() + self.factors.tobytes()

    def complete(self, field: Array) -> Array:
        """Return a field (3, size) in which these degrees of freedom follow the others."""
        field = field.copy()
        field[2, self.dofs] = (self.factors * field[:2, self.dofs]).sum(axis=0)
        return field

    def pull_back(self, residual: Array) -> Array:
        """Return the derivative (3, size) of an energy once these follow from the others."""
        residual = residual.copy()
        residual[:2, self.dofs] += self.factors * residual[2, self.dofs]
        residual[2, self.dofs] = 0.0
        return residual

    def masters(self, size: int) -> Array:
        """Return the factors of x and y for all degrees of freedom, NaN where z is on its own."""
        factors = np.full((2, size), np.nan)
        factors[:, self.dofs] = self.factors
        return factors
