"""The config of a study: what may stand in it, and one clear line for each thing that may not."""

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag, ValidationError

from wrinklestudy import cases
from wrinklestudy.cases import Case, Sheet
from wrinklestudy.config_errors import closest, line
from wrinklestudy.config_values import (
    Aspect,
    Figure,
    Filled,
    Name,
    Strain,
    Text,
    Thickness,
    Window,
    count,
    number,
    requirement,
)
from wrinklestudy.figures import FIGURES

MAX_STRAINS = 1000

# Config keys that a stage depends on.
_SETTINGS = {
    "mesh": ("cells_across", "cells_along", "grading"),
    "planar": ("bending", "parity", "modes"),
    "stability": ("bending", "parity", "modes"),
    "wrinkle": ("tolerance", "max_iterations", "seeds"),
}


class ConfigError(ValueError):
    """The config is wrong; the message has one line per problem."""


class _Block(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Material(_Block):
    """Measured stress-strain data and the law that is fitted to it."""

    data: Text = Field(description="CSV file with stress against strain")
    law: Literal["mooney-rivlin", "neo-hookean", "svk"] = Field(description="law to fit")
    stretch: Window | None = Field(
        default=None, description="lowest and highest stretch to fit; all of the data if left out"
    )
    modes: Filled[Literal["uniaxial", "biaxial", "shear"]] | None = Field(
        default=None, description="deformation modes to fit; all of the data if left out"
    )


class StrainRange(_Block):
    """Equally spaced strains, both ends included."""

    start: Strain = Field(description="first strain")
    stop: Strain = Field(description="last strain")
    step: Strain = Field(description="distance of the strains")


def _strain_kind(value: Any) -> str:
    return "range" if isinstance(value, Mapping | StrainRange) else "list"


class Series(_Block):
    """All combinations of the aspects, thicknesses and strains that are listed."""

    material: Name = Field(description="one of the materials")
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


class Mesh(_Block):
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


class Plate(_Block):
    """Model of the sheet."""

    bending: Literal["thinning", "fixed-thickness", "fvk"] = Field(
        default="thinning", description="law of bending"
    )
    parity: Literal["antisymmetric", "symmetric"] = Field(
        default="antisymmetric", description="symmetry of the wrinkles across the sheet"
    )


class Solver(_Block):
    """Numerical settings of the solves."""

    modes: Annotated[int, count(1, 50)] = Field(
        default=8, description="leading critical thicknesses and modes that are computed"
    )
    tolerance: Annotated[float, number("> 0 and <= 1e-6", lambda v: 0 < v <= 1e-6)] = Field(
        default=1e-20, description="Newton decrement over energy at which a state has converged"
    )
    max_iterations: Annotated[int, count(1, 10000)] = Field(
        default=60, description="Newton iterations from each seed"
    )
    seeds: Annotated[int, count(1, 50)] = Field(
        default=1, description="starting points of each wrinkled state; the lowest energy is kept"
    )


class Gate(_Block):
    """When a finished study counts as failed."""

    allow_not_converged: Annotated[int, count(0, 1000000)] = Field(
        default=0, description="number of cases that may end without convergence"
    )


class FigureSheet(_Block):
    """The sheet that the figures of a single sheet show."""

    material: Name = Field(description="one of the materials")
    aspect: Aspect = Field(description="length over width, L/W")
    thickness: Thickness = Field(description="thickness over width, t/W")


class Figures(_Block):
    """Which figures are made."""

    names: Filled[Figure] = Field(default=tuple(FIGURES), description="figures to make")
    sheet: FigureSheet = Field(description="the sheet that the figures of a single sheet show")


class Folders(_Block):
    """Where the outputs go."""

    results: Text = Field(default="results", description="folder of the results")
    figures: Text = Field(default="figures", description="folder of the figures")


class Study(_Block):
    """A whole study."""

    folders: Folders = Field(default_factory=Folders, description="where the outputs go")
    materials: Annotated[
        dict[Name, Material],
        requirement(
            "must be a block with at least one material", lambda v: isinstance(v, Mapping) and v
        ),
    ] = Field(description="materials by name")
    sheets: Filled[Series] = Field(description="the sheets and strains to compute")
    mesh: Mesh = Field(default_factory=Mesh, description="mesh of the quarter sheet")
    plate: Plate = Field(default_factory=Plate, description="model of the sheet")
    solver: Solver = Field(default_factory=Solver, description="settings of the solves")
    gate: Gate = Field(default_factory=Gate, description="when the study counts as failed")
    figures: Figures = Field(description="which figures are made")

    def settings(self, stage: str) -> dict[str, Any]:
        """Return the settings that a stage takes, sorted: only what it depends on."""
        blocks = {**self.mesh.model_dump(), **self.plate.model_dump(), **self.solver.model_dump()}
        return {key: blocks[key] for key in sorted(_SETTINGS[stage])}

    @property
    def cases(self) -> tuple[Case, ...]:
        """All cases, each once, sorted."""
        return cases.cases((s.material, s.aspect, s.thickness, s.strains) for s in self.sheets)

    @property
    def figure_sheet(self) -> Sheet:
        """The sheet that the figures of a single sheet show."""
        sheet = self.figures.sheet
        return Sheet(
            sheet.material, cases.canonical(sheet.aspect), cases.canonical(sheet.thickness)
        )


def parse_config(raw: Any, source: str) -> Study:
    """Check the content of a config file.

    Parameters
    ----------
    raw : object
        What the YAML file holds.
    source : str
        Name of the file, for the messages.

    Returns
    -------
    Study
        The checked study.

    Raises
    ------
    ConfigError
        If anything is wrong: one line per problem with the dotted key, the value and what is
        allowed.
    """
    try:
        study = Study.model_validate(raw)
    except ValidationError as error:
        lines = [line(Study, entry) for entry in error.errors(include_url=False)]
    else:
        lines = list(_contradictions(study))
        if not lines:
            return study
    raise ConfigError("\n".join(f"{source}: {line}" for line in dict.fromkeys(lines)))


def _contradictions(study: Study) -> Iterator[str]:
    """Yield the problems between keys that are right by themselves."""
    known = list(study.materials)
    for i, series in enumerate(study.sheets):
        key, span = f"sheets[{i}]", series.strain
        if series.material not in known:
            hint = closest(series.material, known)
            yield f"{key}.material = {series.material!r}: is not in materials{hint}"
        if isinstance(span, StrainRange) and span.stop < span.start:
            yield f"{key}.strain.stop = {span.stop:g}: must be >= start = {span.start:g}"
        elif isinstance(span, StrainRange) and span.stop - span.start > MAX_STRAINS * span.step:
            yield f"{key}.strain.step = {span.step:g}: must leave at most {MAX_STRAINS} strains"
    shown = study.figures.sheet
    if not any(_holds(series, shown) for series in study.sheets):
        yield (
            f"figures.sheet = {shown.material}, {shown.aspect:g}, {shown.thickness:g}: "
            "must be a sheet of sheets (material, aspect, thickness)"
        )


def _holds(series: Series, sheet: FigureSheet) -> bool:
    return (
        series.material == sheet.material
        and cases.canonical(sheet.aspect) in map(cases.canonical, series.aspect)
        and cases.canonical(sheet.thickness) in map(cases.canonical, series.thickness)
    )
