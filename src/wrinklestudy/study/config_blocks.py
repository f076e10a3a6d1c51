"""The blocks of a config: their keys, what each may be, and its default."""

from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag

from wrinklestudy.results import cases
from wrinklestudy.study.config_values import (
    Aspect,
    Filled,
    Name,
    Strain,
    Text,
    Thickness,
    Window,
    count,
    number,
    registered,
    requirement,
)

Law = Annotated[str, registered("laws", "LAWS")]
Bending = Annotated[str, registered("bending", "BENDING_LAWS")]
Parity = Literal["antisymmetric", "symmetric"]


class Block(BaseModel):
    """Keys that are known, and no others."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class MaterialBlock(Block):
    """Measured stress-strain data and the law that is fitted to it."""

    data: Text = Field(description="CSV file with stress against strain")
    law: Law = Field(description="law to fit")
    stretch: Window | None = Field(
        default=None, description="lowest and highest stretch to fit; all of the data if left out"
    )
    modes: Filled[Literal["uniaxial", "biaxial", "shear"]] | None = Field(
        default=None, description="deformation modes to fit; all of the data if left out"
    )


class VariantBlock(Block):
    """A material with another model of the sheet than the block plate says."""

    material: Name = Field(description="one of the materials")
    bending: Bending | None = Field(default=None, description="law of bending")
    parity: Parity | None = Field(
        default=None, description="symmetry of the wrinkles across the sheet"
    )


class StrainRange(Block):
    """Equally spaced strains, both ends included."""

    start: Strain = Field(description="first strain")
    stop: Strain = Field(description="last strain")
    step: Strain = Field(description="distance of the strains")


def _strain_kind(value: Any) -> str:
    return "range" if isinstance(value, Mapping | StrainRange) else "list"


class SheetsBlock(Block):
    """All combinations of the aspects, thicknesses and strains that are listed."""

    material: Name = Field(description="one of the materials or variants")
    aspect: Filled[Aspect] = Field(description="length over width, L/W")
    thickness: Filled[Thickness] = Field(description="thickness over width, t/W")
    strain: Annotated[
        Annotated[Filled[Strain], Tag("list")] | Annotated[StrainRange, Tag("range")],
        Discriminator(_strain_kind),
    ] = Field(description="strains (L' - L)/L, as a list or as {start, stop, step}")

    @property
    def strains(self) -> tuple[float, ...]:
        """The strains, each once, sorted."""
        if isinstance(self.strain, StrainRange):
            return cases.strain_range(self.strain.start, self.strain.stop, self.strain.step)
        return tuple(sorted({cases.canonical(strain) for strain in self.strain}))


class MeshBlock(Block):
    """Cells of the quarter sheet, for L/W = 2 and t/W = 1e-3; scaled for other sheets."""

    cells_across: Annotated[int, count(2, 500)] = Field(
        default=36, description="cells from the mid-line to the free edge"
    )
    cells_along: Annotated[int, count(2, 500)] = Field(
        default=24, description="cells from the middle to the clamp"
    )
    grading: Annotated[float, number(">= 1 and <= 4", lambda v: 1 <= v <= 4)] = Field(
        default=1.5, description="exponent by which the cells shrink toward the clamp; 1 is uniform"
    )


class PlateBlock(Block):
    """Model of the sheet."""

    bending: Bending = Field(default="thinning", description="law of bending")
    parity: Parity = Field(
        default="antisymmetric", description="symmetry of the wrinkles across the sheet"
    )


class SolverBlock(Block):
    """Numerical settings of the solves."""

    modes: Annotated[int, count(1, 50)] = Field(
        default=8, description="leading critical thicknesses and modes that are computed"
    )
    tolerance: Annotated[float, number("> 0 and <= 1e-6", lambda v: 0 < v <= 1e-6)] = Field(
        default=1e-22, description="Newton decrement over energy at which a state has converged"
    )
    max_iterations: Annotated[int, count(1, 10000)] = Field(
        default=200, description="Newton iterations from each seed"
    )
    seeds: Annotated[int, count(1, 50)] = Field(
        default=1, description="starting points of each wrinkled state; the lowest energy is kept"
    )


class GateBlock(Block):
    """When a finished study counts as failed."""

    allow_not_converged: Annotated[int, count(0, 1000000)] = Field(
        default=0, description="number of cases that may end without convergence"
    )


class FigureSheetBlock(Block):
    """The sheet that the figures of a single sheet show."""

    material: Name = Field(description="one of the materials or variants")
    aspect: Aspect = Field(description="length over width, L/W")
    thickness: Thickness = Field(description="thickness over width, t/W")


class FiguresBlock(Block):
    """Which figures are made."""

    names: Filled[Name] | None = Field(
        default=None, description="figures to make; all of the study if left out"
    )
    sheet: FigureSheetBlock = Field(description="the sheet that the figures of a single sheet show")
    compare: Annotated[
        tuple[Name, ...], requirement("must be a list", lambda v: isinstance(v, list | tuple))
    ] = Field(
        default=(),
        description="materials or variants that figures compare; that of the sheet if left out",
    )


class FoldersBlock(Block):
    """Where files are."""

    results: Text = Field(default="results", description="folder of the results")
    figures: Text = Field(default="figures", description="folder of the figures")
    experiment: Text = Field(
        default="data/experiment", description="folder of your own measurements, if there is one"
    )
