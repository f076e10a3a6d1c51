"""A buckling mode that others published, against the critical mode of the sheet at small strain."""

from verification.checks import Check
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.sheet import Sheet
from wrinklestudy.studies.literature.published_mode import STRAIN, mode_numbers

TEXT = (
    "A buckling mode of the sheet L/W = 2 is published as data in the repository "
    "gismo/gsStructuralAnalysis (`filedata/deformations/wrinklingPanaitescu_quarter.xml`), without "
    "a word on its origin. Its crests, troughs and length are compared with those of "
    f"`Sheet.mode({STRAIN:g})`: the limit of small strains, where all bending laws are one."
)


def checks(material: Material) -> list[Check]:
    """Return the nine numbers of the mode of this library against the published ones."""
    why = "published mode, points 0.007 W apart"
    return [
        Check(f"mode, {n.name}", n.computed, n.published, n.bar, "absolute", why)
        for n in mode_numbers(Sheet(2.0, 1.0e-3, material).mode(STRAIN))
    ]
