"""The blocks of a config: each key with its limits, its default and the stages that take it."""

from collections.abc import Mapping
from typing import Annotated, Any, Self

from pydantic import (
    BaseModel,
    ConfigDict,
    Discriminator,
    Field,
    Tag,
    ValidationInfo,
    field_validator,
    model_validator,
)
from pydantic_core import PydanticCustomError

from wrinklestudy.material.branches import BRANCHES
from wrinklestudy.material.homogeneous import MODES as DEFORMATIONS
from wrinklestudy.material.preload import TREATMENTS
from wrinklestudy.mechanics.bending import BENDING_LAWS
from wrinklestudy.mechanics.laws import LAWS, law_of
from wrinklestudy.results import cases
from wrinklestudy.study.config.values import (
    SAID,
    Aspect,
    Count,
    Filled,
    Name,
    Number,
    OneOf,
    Place,
    Strain,
    Thickness,
    Window,
    within,
)
from wrinklestudy.vocabulary import CELLS, Limits, Parity

LawName = Annotated[str, OneOf(LAWS)]
BendingName = Annotated[str, OneOf(BENDING_LAWS)]
DeformationMode = Annotated[str, OneOf(DEFORMATIONS)]
Cells = Annotated[int, within(CELLS), Count]
Few = Annotated[int, within(Limits(1, 50)), Count]


def of_stages(*stages: str) -> dict[str, Any]:
    """Return the note in the schema that stages take a key; `StudyConfig.settings` reads it."""
    return {"stages": list(stages)}


class Block(BaseModel):
    """A block of known keys, and no others."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class MaterialBlock(Block):
    """A law with measured stress-strain data that it is fitted to, or with its constants."""

    data: Place | None = Field(default=None, description="CSV file with stress against strain")
    law: LawName = Field(description="law to fit")
    constants: dict[Name, Annotated[float, Field(allow_inf_nan=False), Number]] | None = Field(
        default=None, description="constants of the law in place of data: in Pa, or pure numbers"
    )
    stretch: Window | None = Field(
        default=None, description="lowest and highest stretch to fit; all of the data if left out"
    )
    modes: Filled[DeformationMode] | None = Field(
        default=None, description="deformation modes to fit; all of the data if left out"
    )
    branch: Annotated[str, OneOf(BRANCHES)] = Field(
        default="loading", description="branch of cyclic data to fit"
    )
    cycle: Annotated[int, within(Limits(1, 1000)), Count] = Field(
        default=1, description="cycle of cyclic data to fit, from 1"
    )
    preload: Annotated[str, OneOf(TREATMENTS)] = Field(
        default="keep",
        description="a stress at stretch 1: kept, or removed from all stresses",
    )

    @field_validator("constants")
    @classmethod
    def _allowed(
        cls, constants: dict[str, float] | None, info: ValidationInfo
    ) -> dict[str, float] | None:
        """Refuse constants that the law does not have or allow, in the words of the law."""
        if constants is not None and "law" in info.data:
            try:
                law_of(info.data["law"]).material(**constants)
            except ValueError as error:
                raise PydanticCustomError(SAID, "{text}", {"text": str(error)}) from None
        return constants

    @model_validator(mode="after")
    def _fitted_or_given(self) -> Self:
        """Refuse data beside constants, keys of a fit beside constants, and neither."""
        given = self.model_fields_set
        if self.constants is None and self.data is None:
            text = "must have data (a CSV file) or constants"
        elif self.constants is not None and given - {"law", "constants"}:
            text = f"{min(given - {'law', 'constants'})} is for a fit, and this has constants"
        else:
            return self
        raise PydanticCustomError(SAID, "{text}", {"text": text})


class VariantBlock(Block):
    """A material with a model of the sheet that differs from the block plate."""

    material: Name = Field(description="one of the materials")
    bending: BendingName | None = Field(default=None, description="law of bending")
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


class LengthsBlock(Block):
    """A material with all listed aspects, for what holds at any thickness and strain."""

    material: Name = Field(description="one of the materials or variants")
    aspect: Filled[Aspect] = Field(description="length over width, L/W")


class AnalysisBlock(LengthsBlock):
    """All combinations of the listed aspects and strains, for what holds at any thickness."""

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


class SheetsBlock(AnalysisBlock):
    """All combinations of the listed aspects, thicknesses and strains."""

    thickness: Filled[Thickness] = Field(description="thickness over width, t/W")


class MeshBlock(Block):
    """Cells of the quarter sheet, for L/W = 2 and t/W = 1e-3; scaled for other sheets."""

    cells_across: Cells = Field(
        default=36,
        description="cells from the mid-line to the free edge",
        json_schema_extra=of_stages("mesh"),
    )
    cells_along: Cells = Field(
        default=24,
        description="cells from the middle to the clamp",
        json_schema_extra=of_stages("mesh"),
    )
    grading: Annotated[float, within(Limits(1, 4)), Number] = Field(
        default=1.5,
        description="exponent by which the cells shrink toward the clamp; 1 is uniform",
        json_schema_extra=of_stages("mesh"),
    )


class PlateBlock(Block):
    """Model of the sheet."""

    bending: BendingName = Field(
        default="thinning",
        description="law of bending",
        json_schema_extra=of_stages("planar", "stability", "map", "imperfection"),
    )
    parity: Parity = Field(
        default="antisymmetric",
        description="symmetry of the wrinkles across the sheet",
        json_schema_extra=of_stages("planar", "stability", "imperfection"),
    )


class SolverBlock(Block):
    """Numerical settings of the solves."""

    modes: Few = Field(
        default=8,
        description="leading critical thicknesses and modes that are computed",
        json_schema_extra=of_stages("planar", "stability", "imperfection"),
    )
    tolerance: Annotated[float, within(Limits(0, 1e-6, above_lowest=True)), Number] = Field(
        default=1e-22,
        description="Newton decrement over energy at which a state has converged",
        json_schema_extra=of_stages("wrinkle", "imperfection"),
    )
    max_iterations: Annotated[int, within(Limits(1, 10000)), Count] = Field(
        default=200,
        description="Newton iterations from each seed",
        json_schema_extra=of_stages("wrinkle", "imperfection"),
    )
    seeds: Few = Field(
        default=1,
        description="starting points of each wrinkled state; the lowest energy is kept",
        json_schema_extra=of_stages("wrinkle", "imperfection"),
    )


class GateBlock(Block):
    """When a finished study counts as failed."""

    allow_not_converged: Annotated[int, within(Limits(0, 1000000)), Count] = Field(
        default=0, description="number of cases that may end without convergence"
    )


class FigureSheetBlock(Block):
    """The sheet shown by the figures of a single sheet."""

    material: Name = Field(description="one of the materials or variants")
    aspect: Aspect = Field(description="length over width, L/W")
    thickness: Thickness = Field(description="thickness over width, t/W")


class FiguresBlock(Block):
    """Which figures are made."""

    names: Filled[Name] | None = Field(
        default=None, description="figures to make; all of the study if left out"
    )
    sheet: FigureSheetBlock = Field(description="the sheet that the figures of a single sheet show")
    compare: tuple[Name, ...] = Field(
        default=(),
        description="materials or variants that figures compare; that of the sheet if left out",
    )


class FoldersBlock(Block):
    """Where files are."""

    results: Place = Field(default="results", description="folder of the results")
    figures: Place = Field(default="figures", description="folder of the figures")
    experiment: Place = Field(
        default="data/experiment", description="folder of your own measurements, if there is one"
    )
