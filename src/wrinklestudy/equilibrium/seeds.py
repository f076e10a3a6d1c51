"""First guesses of wrinkled states from the reduced energy of the modes, see `modes`."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.modes import Modes
from wrinklestudy.equilibrium.quartic import pairs
from wrinklestudy.typing import Array

_MAX_ITERATIONS = 100


@dataclass(frozen=True)
class Reduced:
    """Energy of the amplitudes of the modes, for each unit of thickness, see `modes`.

    Parameters
    ----------
    stiffness : (m,) array
        t^2 - tau_i^2.
    quartic : (m, m, m, m) array
        G as a fully symmetric tensor.
    """

    stiffness: Array
    quartic: Array

    def energy(self, q: Array) -> float:
        """Return 1/2 sum (t^2 - tau_i^2) q_i^2 + 1/2 sum G_ijkl q_i q_j q_k q_l."""
        square = np.outer(q, q).ravel()
        quartic = square @ self.quartic.reshape(len(square), -1) @ square
        return 0.5 * float(self.stiffness @ q**2 + quartic)

    def derivatives(self, q: Array) -> tuple[Array, Array]:
        """Return the gradient and the Hessian."""
        square = (self.quartic.reshape(q.size**2, -1) @ np.outer(q, q).ravel()).reshape(q.size, -1)
        return self.stiffness * q + 2.0 * square @ q, np.diag(self.stiffness) + 6.0 * square


def reduced_energy(modes: Modes, thickness: float) -> Reduced:
    """Return the reduced energy of the wrinkle modes (not of the corners) for a thickness t/W."""
    count = len(modes.squared)
    number = np.zeros((count, count), dtype=int)
    for k, (i, j) in enumerate(pairs(count)):
        number[i, j] = number[j, i] = k
    # G counts both orders of a pair of unequal modes
    halves = np.where(np.eye(count, dtype=bool), 1.0, 0.5)
    full = modes.quartic[number[:, :, None, None], number[None, None]]
    full = full * halves[:, :, None, None] * halves
    full = (full + full.transpose(0, 2, 1, 3) + full.transpose(0, 3, 2, 1)) / 3.0
    keep = modes.wrinkles
    tensor = full[np.ix_(keep, keep, keep, keep)]
    return Reduced(thickness**2 - modes.squared[keep], tensor)


class _ReducedMinimum(NamedTuple):
    """A minimum of the reduced energy."""

    energy: float
    amplitudes: Array


def seeds(modes: Modes, thickness: float) -> list[Array]:
    """Return the minima of the reduced energy for a thickness, the lowest first.

    Parameters
    ----------
    modes : Modes
    thickness : float
        t in units of W.

    Returns
    -------
    list of (m,) arrays
        Amplitudes q of the modes; empty where no wrinkle is unstable.
    """
    reduced = reduced_energy(modes, thickness)
    minima: list[_ReducedMinimum] = []
    for mode in np.flatnonzero(reduced.stiffness < 0.0):
        start = np.zeros(len(reduced.stiffness))
        stiff = reduced.quartic[mode, mode, mode, mode]
        start[mode] = np.sqrt(-reduced.stiffness[mode] / (2.0 * stiff))
        # a small admixture of the others leaves the saddle that a pure mode may be
        q = _minimise_reduced(reduced, start + 1e-3 * start[mode])
        energy = reduced.energy(q)
        if all(abs(energy - other.energy) > 1e-6 * abs(other.energy) for other in minima):
            minima.append(_ReducedMinimum(energy, q))
    minima.sort(key=lambda minimum: minimum.energy)
    amplitudes = np.zeros((len(minima), len(modes.squared)))
    for row, minimum in zip(amplitudes, minima, strict=True):
        row[modes.wrinkles] = minimum.amplitudes
    return list(amplitudes)


def _minimise_reduced(reduced: Reduced, start: Array) -> Array:
    """Minimise the reduced energy by Newton steps with the moduli of the eigenvalues."""
    q, energy = start, reduced.energy(start)
    for _ in range(_MAX_ITERATIONS):
        slope, hessian = reduced.derivatives(q)
        values, vectors = np.linalg.eigh(hessian)
        step = -vectors @ ((vectors.T @ slope) / np.maximum(np.abs(values), 1e-3 * values.max()))
        decrement = -float(slope @ step)
        if decrement <= 1e-14 * abs(energy):
            break
        length = 1.0
        while (lower := reduced.energy(q + length * step)) > energy - 1e-4 * length * decrement:
            length /= 2.0
        q, energy = q + length * step, lower
    return q


def seed_position(flat: Flat, modes: Modes, amplitudes: Array) -> Array:
    """Return the position (3, size) that belongs to amplitudes q of the modes."""
    first, second = np.array(pairs(len(amplitudes))).T
    position = flat.sheet_position
    products = amplitudes[first] * amplitudes[second]
    position[:2] += np.tensordot(products, modes.relaxation, axes=1)
    position[2] = amplitudes @ modes.shapes
    return position
