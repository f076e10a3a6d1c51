"""The amplitude of wrinkles whose pattern may sit anywhere across the sheet.

The amplitude of an odd pattern is a few per cent below that of an even one, since the envelope of
the wrinkles falls off on both sides of the mid-line and the two have their crests in different
places. Where nothing says where the pattern sits, the amplitude is known as a band.
"""

from typing import NamedTuple

import numpy as np

from wrinklestudy.fem.grid import Grid
from wrinklestudy.metrics.interpolant import evaluate, subdivided
from wrinklestudy.typing import Array

_SAMPLES_PER_CELL = 64
_FEW_PER_CELL = 4  # of integrals over the sheet
_PHASES = 90  # over half a wave: the other half is the same upside down


class PhaseBand(NamedTuple):
    """Amplitude on the line half-way between the clamps, lengths in units of W.

    Parameters
    ----------
    low, high : float
        Least and largest |z| of the highest crest over all phases of the pattern.
    envelope : float
        Largest value of the envelope sqrt(w^2 + v^2), v the wrinkles a quarter of a wave further:
        what a crest reaches that sits at the best place. It does not depend on the phase.
    """

    low: float
    high: float
    envelope: float


def phase_band(grid: Grid, wrinkles: Array, partner: Array) -> PhaseBand:
    """Return the amplitude of wrinkles over all phases of their pattern.

    Parameters
    ----------
    grid : Grid
        Of the part of the sheet that was solved.
    wrinkles, partner : (4, nx + 1, ny + 1) arrays
        Deflections w and v at the nodes of an odd and an even state, in either order, beyond that
        of the sheet without wrinkles. Sliding by a phase p makes w cos p + v sin p of w.
    """
    y = subdivided(grid.y, _SAMPLES_PER_CELL)
    middle = np.array([0.0])
    w, v = (evaluate(grid, nodes, middle, y)[0] for nodes in (wrinkles, partner))
    phases = np.pi / _PHASES * np.arange(_PHASES)
    heights = [_largest(w * np.cos(phase) + v * np.sin(phase)) for phase in phases]
    return PhaseBand(min(heights), max(heights), _largest(np.hypot(w, v)))


def envelope_middle(grid: Grid, wrinkles: Array, partner: Array) -> tuple[float, float]:
    """Return the mean place (x, y) of wrinkles, weighted with the square w^2 + v^2 of the envelope.

    See `phase_band` for the parameters; the grid is of the whole sheet.
    """
    x, y = (subdivided(lines, _FEW_PER_CELL) for lines in (grid.x, grid.y))
    w, v = (evaluate(grid, nodes, x, y) for nodes in (wrinkles, partner))
    density = w**2 + v**2
    across, along = np.trapezoid(density, y, axis=1), np.trapezoid(density, x, axis=0)
    total = np.trapezoid(across, x)
    return (
        float(np.trapezoid(x * across, x) / total),
        float(np.trapezoid(y * along, y) / total),
    )


def _largest(values: Array) -> float:
    """Return the largest absolute value of a sampled function."""
    return float(np.abs(values).max())
