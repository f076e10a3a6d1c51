"""What an experiment's sheet is like that a perfect one is not, and which symmetry that leaves."""

from dataclasses import dataclass
from typing import Literal, NamedTuple

from wrinklestudy.fem.boundary import PERFECT, Symmetry
from wrinklestudy.fem.clamps import Clamps
from wrinklestudy.fem.thickness import UNIFORM, ThicknessField
from wrinklestudy.vocabulary import WEIGHT, Parity, Part


@dataclass(frozen=True)
class Imperfections:
    """Clamps that are off, a thickness that varies, and the weight of the sheet.

    Parameters
    ----------
    clamps : Clamps
    thickness : ThicknessField
    weight : float
        rho g W/mu of a sheet that is stretched level; see `self_weight`.

    Raises
    ------
    ValueError
        If the weight is not allowed; one line.
    """

    clamps: Clamps = PERFECT
    thickness: ThicknessField = UNIFORM
    weight: float = 0.0

    def __post_init__(self) -> None:
        if self.weight not in WEIGHT:
            raise ValueError(f"weight = {self.weight:g}: must be {WEIGHT}")

    @property
    def none(self) -> bool:
        """Whether the sheet is perfect."""
        return self == Imperfections()

    @property
    def stays_flat(self) -> bool:
        """Whether nothing lifts the sheet out of its plane, so that z -> -z is a symmetry."""
        return self.clamps.planar and self.weight == 0.0

    @property
    def lifting(self) -> list[str]:
        """What lifts the sheet out of its plane, in words."""
        clamps = [
            f"the {name} of the clamps"
            for name in ("twist", "pitch", "lift")
            if getattr(self.clamps, name) != 0.0
        ]
        return [*clamps, *(["the weight of the sheet"] if self.weight != 0.0 else [])]

    def keep(self, signs: tuple[int, int, int], aspect: float) -> bool:
        """Return whether the sheet is the same after changes of sign of x, y and z."""
        x, y, z = signs
        level = self.weight == 0.0 or z > 0
        return level and self.clamps.keep(signs) and self.thickness.keeps(x < 0, y < 0, aspect)

    def check_part(self, part: Part, aspect: float) -> None:
        """Raise a ValueError of one line if a part of the sheet does not tell the whole."""
        Symmetry.of_part(part, clamps=self.clamps)
        mirrors = {
            "quarter": ((-1, 1, 1), (1, -1, 1)),
            "half": ((-1, 1, 1),),
            "half-width": ((1, -1, 1),),
            "whole": (),
        }[part]
        if self.weight != 0.0 and part in ("quarter", "half-width"):
            raise ValueError(
                f"symmetry = {part!r}: the weight of the sheet needs 'half' or 'whole'"
            )
        for x, y, z in mirrors:
            if not self.keep((x, y, z), aspect):
                line = "x" if x < 0 else "y"
                raise ValueError(
                    f"symmetry = {part!r}: the thickness is not the same on both sides of "
                    f"{line} = 0; symmetry must be 'whole'"
                )


def self_weight(density: float, width: float, shear_modulus: float, gravity: float) -> float:
    """Return rho g W/mu from kg/m^3, m, Pa and m/s^2."""
    return density * gravity * width / shear_modulus


class Bifurcation(NamedTuple):
    """How wrinkles appear.

    Parameters
    ----------
    kind : {'sharp', 'rounded'}
        Whether wrinkles break a symmetry of the sheet, so that they appear at a strain of their
        own; otherwise they grow out of what the sheet does before.
    reason : str
        Which symmetry, in words.
    """

    kind: Literal["sharp", "rounded"]
    reason: str


_WORDS = {
    (-1, 1, 1): "x -> -x",
    (1, -1, 1): "y -> -y",
    (-1, -1, 1): "of a turn by pi about z",
    (-1, 1, -1): "of a turn by pi about y",
    (1, -1, -1): "of a turn by pi about x",
    (-1, -1, -1): "of an inversion at the centre",
}


def bifurcation(imperfections: Imperfections, aspect: float, parity: Parity) -> Bifurcation:
    """Return whether the wrinkles of a sheet appear at a sharp strain.

    They do where a symmetry of the sheet turns the wrinkles upside down: those of a perfect sheet
    are even along the pull, and odd or even across it. Where z -> -z is one, it is broken by both.

    Parameters
    ----------
    imperfections : Imperfections
    aspect : float
        L/W.
    parity : {'antisymmetric', 'symmetric'}
        Of the pattern at the centre.
    """
    across = -1 if parity == "antisymmetric" else 1
    if imperfections.stays_flat:
        return Bifurcation(
            "sharp", "the sheet is flat until it wrinkles, and wrinkles break z -> -z"
        )
    causes = imperfections.lifting
    wrinkles = f"wrinkles that are {'odd' if across < 0 else 'even'} across"
    lost = f"{' and '.join(causes)} {'breaks' if len(causes) == 1 else 'break'} z -> -z"
    for x, y, z in sorted(_WORDS, key=lambda signs: signs.count(-1)):
        turned = z * (across if y < 0 else 1)
        if turned < 0 and imperfections.keep((x, y, z), aspect):
            kept = f"the symmetry {_WORDS[x, y, z]} is left for {wrinkles} to break"
            return Bifurcation("sharp", f"{lost}, but {kept}")
    return Bifurcation("rounded", f"{lost}, and {wrinkles} break no symmetry that is left")
