"""What a minimisation needs to know about an energy."""

from typing import NamedTuple, Protocol

from scipy import sparse

from wrinklestudy.typing import Array


class EnergyExpansion(NamedTuple):
    """An energy to second order around a point."""

    energy: float
    residual: Array  # its gradient, (n,)
    tangent: sparse.csr_array  # upper triangle of its Hessian


class Problem(Protocol):
    """An energy over a vector of unknowns."""

    def energy(self, unknowns: Array) -> float:
        """Return the energy, or infinity where it is not defined."""

    def derivatives(self, unknowns: Array) -> EnergyExpansion:
        """Return the energy, the residual and the upper triangle of the tangent."""

    def residual(self, unknowns: Array) -> Array:
        """Return the residual alone."""

    def shift(self) -> sparse.csr_array | None:
        """Return a positive semidefinite matrix that, added to the tangent, makes it definite."""
