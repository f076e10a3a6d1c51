"""The block of imperfect sheets: what of an experiment is not as it should be, and how much."""

import math
from collections.abc import Iterator
from itertools import product
from typing import Annotated, Any

from pydantic import Field

from wrinklestudy.results.cases import StudySheet, canonical
from wrinklestudy.results.imperfect_sheets import Amount, ImperfectSheet
from wrinklestudy.study.config.blocks import Block, SheetsBlock
from wrinklestudy.study.config.values import Filled, Number, OneOf, Place, within
from wrinklestudy.vocabulary import (
    ANGLE,
    DENSITY,
    GRAVITY,
    PARTS,
    SHIFT,
    SIZED_IMPERFECTIONS,
    STANDARD_GRAVITY,
    UNEVENNESS,
    WAVELENGTH,
    Limits,
    Part,
)

Shifts = Filled[Annotated[float, within(SHIFT), Number]]
Angles = Filled[Annotated[float, within(ANGLE), Number]]
Parts = Filled[Annotated[float, within(UNEVENNESS), Number]]
_Free = Annotated[float, within(Limits(-1e3, 1e3, unit="in radians")), Number]


class RippleBlock(Block):
    """A wave of the thickness: all of the listed amplitudes, one by one."""

    amplitude: Parts = Field(description="amplitudes, in parts of the mean thickness")
    wavelength: Annotated[float, within(WAVELENGTH), Number] = Field(
        description="wavelength, in units of W"
    )
    angle: _Free = Field(
        default=math.pi / 2, description="angle of the normal of its crests with the pull, in rad"
    )
    phase: _Free = Field(default=0.0, description="phase in rad; 0 has a crest at the centre")


def _sized(key: str) -> Any:
    """Return the field of a key that lists sizes; without it there is nothing off."""
    return Field(default=None, description=SIZED_IMPERFECTIONS[key])


class ImperfectBlock(SheetsBlock):
    """All combinations of the listed sheets, strains and sizes; without any, perfect sheets."""

    symmetry: Annotated[Part, OneOf(PARTS)] = Field(
        default="whole", description="part of the sheet that is solved"
    )
    shear: Shifts | None = _sized("shear")
    rotate: Angles | None = _sized("rotate")
    twist: Angles | None = _sized("twist")
    pitch: Angles | None = _sized("pitch")
    lift: Shifts | None = _sized("lift")
    thickness_along: Parts | None = _sized("thickness_along")
    thickness_across: Parts | None = _sized("thickness_across")
    thickness_ripple: RippleBlock | None = Field(default=None, description="wave of the thickness")
    thickness_table: Place | None = Field(
        default=None, description="CSV file of measured thickness: x, y (over W) and thickness"
    )
    density: Filled[Annotated[float, within(DENSITY), Number]] | None = Field(
        default=None, description="kg/m^3: the sheet is level and bears its own weight"
    )
    gravity: Annotated[float, within(GRAVITY), Number] = Field(
        default=STANDARD_GRAVITY, description="m/s^2, with density"
    )
    width_mm: (
        Annotated[float, within(Limits(0.0, 1e6, above_lowest=True, unit="mm")), Number] | None
    ) = Field(default=None, description="width of the sheet, with density")

    def cases(self) -> Iterator[tuple[ImperfectSheet, tuple[float, ...]]]:
        """Yield each imperfect sheet with its strains; it needs a width if it has a density."""
        options = list(self._options())
        for aspect, thickness in product(self.aspect, self.thickness):
            sheet = StudySheet(self.material, canonical(aspect), canonical(thickness))
            for given in product(*options):
                entries = tuple(entry for group in given for entry in group)
                yield ImperfectSheet(sheet, self.symmetry, entries), self.strains

    def _options(self) -> Iterator[list[tuple[tuple[str, Amount], ...]]]:
        """Yield the alternatives of each key; those of a key belong together."""
        for key in SIZED_IMPERFECTIONS:
            if (sizes := getattr(self, key)) is not None:
                yield [((key, size),) for size in sizes]
        if (ripple := self.thickness_ripple) is not None:
            rest = (ripple.wavelength, ripple.angle, ripple.phase)
            yield [(("thickness_ripple", (size, *rest)),) for size in ripple.amplitude]
        if self.thickness_table is not None:
            yield [(("thickness_table", self.thickness_table),)]
        if self.density is not None and self.width_mm is not None:
            rest_of = (("gravity", self.gravity), ("width_mm", self.width_mm))
            yield [(("density", size), *rest_of) for size in self.density]
