"""A buckling mode that others published, against the critical mode of the sheet at small strain."""

import numpy as np

from verification.checks import Check
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.sheet import Sheet

# Nine numbers of the antisymmetric mode of the sheet L/W = 2, largest value 1, taken by parabolas
# through points 0.007 W apart in filedata/deformations/wrinklingPanaitescu_quarter.xml of the
# repository gismo/gsStructuralAnalysis. Across the sheet at x = 0: y/W of the crests and troughs
# and their heights; along it, through the highest, the x/W of half its height.
PEAKS = (0.0459, 0.1396, 0.2404, 0.3581)
HEIGHTS = (1.0, -0.5624, 0.1652, -0.0212)
HALF_HEIGHT = 0.3629
STRAIN = 1.0e-5
PEAK_BAR, HEIGHT_BAR, HALF_HEIGHT_BAR = 1.0e-3, 2.0e-3, 2.0e-3
TEXT = (
    "A buckling mode of the sheet L/W = 2 is published as data in the repository "
    "gismo/gsStructuralAnalysis (`filedata/deformations/wrinklingPanaitescu_quarter.xml`), without "
    "a word on its origin. Its crests, troughs and length are compared with those of "
    f"`Sheet.mode({STRAIN:g})`: the limit of small strains, where all bending laws are one."
)
_SAMPLES = 10001


def checks(material: Material) -> list[Check]:
    """Return the nine numbers of the mode of this library against the published ones."""
    mode = Sheet(2.0, 1.0e-3, material).mode(STRAIN)
    y = np.linspace(0.0, 0.5, _SAMPLES)
    across = mode.deflection(0.0, y)
    slope = np.diff(across)
    turning = np.flatnonzero(slope[:-1] * slope[1:] < 0.0)[: len(PEAKS)] + 1
    x = np.linspace(0.0, 1.0, _SAMPLES)
    along = mode.deflection(x, y[turning[0]])
    half = float(x[np.argmax(along < 0.5 * along[0])])
    why = "published mode, points 0.007 W apart"
    nine = []
    for number, (place, height) in enumerate(zip(PEAKS, HEIGHTS, strict=True)):
        at = turning[number] if number < len(turning) else -1
        name = f"mode, extremum {number + 1} across:"
        nine += [
            Check(f"{name} y/W", float(y[at]), place, PEAK_BAR, "absolute", why),
            Check(f"{name} height", float(across[at]), height, HEIGHT_BAR, "absolute", why),
        ]
    name = "mode, half height along: x/W"
    return [*nine, Check(name, half, HALF_HEIGHT, HALF_HEIGHT_BAR, "absolute", why)]
