"""The amplitude of wrinkles whose pattern may sit anywhere across the sheet.

The amplitude of an odd pattern is a few per cent below that of an even one, since the envelope of
the wrinkles falls off on both sides of the mid-line and the two have their crests in different
places. Where nothing says where the pattern sits, the amplitude is known as a band.
"""

from typing import NamedTuple

import numpy as np

from wrinklestudy.metrics.interpolant import DeformedSheet, evaluate, subdivided
from wrinklestudy.typing import Array

_SAMPLES_PER_CELL = 32
_PHASES = 90  # over half a wave: the other half is the same upside down


class PhaseBand(NamedTuple):
    """Amplitude on the line half-way between the clamps, lengths in units of W.

    Parameters
    ----------
    low, high : float
        Least and largest |z| of the highest crest over all phases of the pattern.
    envelope : float
        Largest value of the envelope sqrt(w^2 + v^2), v the wrinkles a quarter of a wave further:
        what a crest would reach that sits at the best place. It does not depend on the phase.
    """

    low: float
    high: float
    envelope: float


def phase_band(sheet: DeformedSheet, wrinkles: Array, partner: Array) -> PhaseBand:
    """Return the amplitude of wrinkles over all phases of their pattern.

    Parameters
    ----------
    sheet : DeformedSheet
        The state that was solved.
    wrinkles, partner : (4, nx + 1, ny + 1) arrays
        Deflection of the wrinkles on its grid, and the same a quarter of a wave further.
    """
    y = subdivided(sheet.grid.y, _SAMPLES_PER_CELL)
    middle = np.array([0.0])
    first, second = (evaluate(sheet.grid, nodes, middle, y)[0] for nodes in (wrinkles, partner))
    phases = np.pi / _PHASES * np.arange(_PHASES)
    heights = np.array(
        [_largest(first * np.cos(phase) + second * np.sin(phase)) for phase in phases]
    )
    return PhaseBand(
        float(heights.min()), float(heights.max()), _largest(np.hypot(first, second))
    )


def _largest(values: Array) -> float:
    """Return the largest absolute value of a sampled function, by a parabola through its peak."""
    height = np.abs(values)
    k = int(height.argmax())
    if not 0 < k < len(height) - 1:
        return float(height[k])
    left, top, right = (float(value) for value in height[k - 1 : k + 2])
    bend = left - 2.0 * top + right
    return top if bend == 0.0 else top - (right - left) ** 2 / (8.0 * bend)
