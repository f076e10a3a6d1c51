"""BFGS updates of a factorised tangent, which is not factorised again."""

from collections.abc import Sequence
from typing import NamedTuple

from wrinklestudy.fem.factorisation import Solver
from wrinklestudy.typing import Array


class Update(NamedTuple):
    """A step and the change of the residual along it."""

    step: Array
    change: Array


def inverse_times(vector: Array, updates: Sequence[Update], solver: Solver) -> Array:
    """Return the product of the inverse of the updated tangent with a vector.

    H -> (1 - s y'/y's) H (1 - y s'/y's) + s s'/y's for each step s with the change y of the
    residual, applied to the inverse H of the factorised tangent by the two-loop recursion (Nocedal,
    Math. Comput. 35, 773, 1980).

    Parameters
    ----------
    vector : (n,) array
    updates : sequence of Update
        The oldest first.
    solver : Solver
        With the factorised tangent.
    """
    vector = vector.copy()
    weights = []
    for step, change in reversed(updates):
        weight = float(step @ vector) / float(step @ change)
        vector -= weight * change
        weights.append(weight)
    product = solver.solve(vector)
    for (step, change), weight in zip(updates, reversed(weights), strict=True):
        product = product + (weight - float(change @ product) / float(step @ change)) * step
    return product
