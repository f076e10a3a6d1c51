"""A buckling mode that others published, as nine numbers, and the same numbers of a sheet.

The mode of the antisymmetric sheet L/W = 2, largest value 1. Its numbers were taken by parabolas
through points 0.007 W apart in filedata/deformations/wrinklingPanaitescu_quarter.xml of the
repository gismo/gsStructuralAnalysis, which says nothing of how the file was made.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from wrinklestudy.equilibrium.critical_shape import WrinkleMode

# Across the sheet at x = 0: y/W of the crests and troughs and their heights; along it, through the
# highest, the x/W of half its height.
PEAKS = (0.0459, 0.1396, 0.2404, 0.3581)
HEIGHTS = (1.0, -0.5624, 0.1652, -0.0212)
HALF_HEIGHT = 0.3629
# What the points of the file allow
PEAK_BAR, HEIGHT_BAR, HALF_HEIGHT_BAR = 1.0e-3, 2.0e-3, 2.0e-3
STRAIN = 1.0e-5  # the limit of small strains, where all bending laws are one
_SAMPLES = 10001


class ModeNumber(NamedTuple):
    """One of the nine numbers."""

    name: str
    computed: float
    published: float
    bar: float


def mode_numbers(mode: WrinkleMode) -> tuple[ModeNumber, ...]:
    """Return the nine numbers of a critical mode at `STRAIN` beside the published ones."""
    return tuple(_numbers(mode))


def _numbers(mode: WrinkleMode) -> Iterator[ModeNumber]:
    y = np.linspace(0.0, 0.5, _SAMPLES)
    across = mode.deflection(0.0, y)
    slope = np.diff(across)
    turning = np.flatnonzero(slope[:-1] * slope[1:] < 0.0)[: len(PEAKS)] + 1
    for number, (place, height) in enumerate(zip(PEAKS, HEIGHTS, strict=True)):
        at = turning[number] if number < len(turning) else -1
        name = f"extremum {number + 1} across:"
        yield ModeNumber(f"{name} y/W", float(y[at]), place, PEAK_BAR)
        yield ModeNumber(f"{name} height", float(across[at]), height, HEIGHT_BAR)
    x = np.linspace(0.0, 1.0, _SAMPLES)
    along = mode.deflection(x, y[turning[0]])
    half = float(x[np.argmax(along < 0.5 * along[0])])
    yield ModeNumber("half height along: x/W", half, HALF_HEIGHT, HALF_HEIGHT_BAR)
