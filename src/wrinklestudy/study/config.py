"""The config of a study: what may stand in it, and one clear line for each thing that may not."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from itertools import groupby
from operator import attrgetter
from typing import Annotated, Any

from pydantic import Field, ValidationError

from wrinklestudy.results import cases
from wrinklestudy.results.cases import Case, StudySheet
from wrinklestudy.study.catalogue import Catalogue, FigureEntry
from wrinklestudy.study.config_blocks import (
    Block,
    FiguresBlock,
    FigureSheetBlock,
    FoldersBlock,
    GateBlock,
    MaterialBlock,
    MeshBlock,
    PlateBlock,
    SheetsBlock,
    SolverBlock,
    StrainRange,
    VariantBlock,
)
from wrinklestudy.study.config_errors import closest, line
from wrinklestudy.study.config_values import Filled, Name, Text, requirement
from wrinklestudy.study.loading import CatalogueError, load_catalogue

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


class StudyConfig(Block):
    """A whole study."""

    study: Text = Field(
        default="panaitescu2019",
        description="figures and claims: a study of this package, or a folder or .py file",
    )
    folders: FoldersBlock = Field(default_factory=FoldersBlock, description="where files are")
    materials: Annotated[
        dict[Name, MaterialBlock],
        requirement(
            "must be a block with at least one material", lambda v: isinstance(v, Mapping) and v
        ),
    ] = Field(description="materials by name")
    variants: Annotated[
        dict[Name, VariantBlock], requirement("must be a block", lambda v: isinstance(v, Mapping))
    ] = Field(default_factory=dict, description="variants of the materials by name")
    sheets: Filled[SheetsBlock] = Field(description="the sheets and strains to compute")
    mesh: MeshBlock = Field(default_factory=MeshBlock, description="mesh of the quarter sheet")
    plate: PlateBlock = Field(default_factory=PlateBlock, description="model of the sheet")
    solver: SolverBlock = Field(default_factory=SolverBlock, description="settings of the solves")
    gate: GateBlock = Field(
        default_factory=GateBlock, description="when the study counts as failed"
    )
    figures: FiguresBlock = Field(description="which figures are made")

    @cached_property
    def catalogue(self) -> Catalogue:
        """The catalogue of the study that the config names."""
        return load_catalogue(self.study)

    @property
    def figures_to_make(self) -> tuple[FigureEntry, ...]:
        """The figures that the config names, all of the catalogue if it names none."""
        names = self.figures.names or self.catalogue.figure_names
        return tuple(self.catalogue.figure(name) for name in names)

    def base(self, model: str) -> str:
        """Return the material of a model, which is a material or a variant of one."""
        return self.variants[model].material if model in self.variants else model

    def settings(self, stage: str, model: str = "") -> dict[str, Any]:
        """Return the settings that a stage takes, sorted: only what it depends on.

        Parameters
        ----------
        stage : str
            Name of the stage.
        model : str, optional
            Material or variant; what a variant sets goes over the block plate.
        """
        blocks = {**self.mesh.model_dump(), **self.plate.model_dump(), **self.solver.model_dump()}
        if model in self.variants:
            blocks |= self.variants[model].model_dump(exclude_none=True)
        return {key: blocks[key] for key in sorted(_SETTINGS[stage])}

    @cached_property
    def cases(self) -> tuple[Case, ...]:
        """All cases, each once, sorted."""
        return cases.cases((s.material, s.aspect, s.thickness, s.strains) for s in self.sheets)

    @cached_property
    def _cases_by_sheet(self) -> dict[StudySheet, tuple[Case, ...]]:
        groups = groupby(self.cases, key=attrgetter("sheet"))
        return {sheet: tuple(found) for sheet, found in groups}

    @property
    def all_sheets(self) -> tuple[StudySheet, ...]:
        """All sheets, each once, sorted."""
        return tuple(self._cases_by_sheet)

    def cases_of(self, sheet: StudySheet) -> tuple[Case, ...]:
        """Return the cases of a sheet by strain; none if the study lacks it."""
        return self._cases_by_sheet.get(sheet, ())

    @property
    def figure_sheet(self) -> StudySheet:
        """The sheet that the figures of a single sheet show."""
        sheet = self.figures.sheet
        return StudySheet(
            sheet.material, cases.canonical(sheet.aspect), cases.canonical(sheet.thickness)
        )

    @property
    def compared_sheets(self) -> tuple[StudySheet, ...]:
        """The sheets of the figures that compare models: that of `figure_sheet` in each model."""
        models = dict.fromkeys(self.figures.compare or (self.figures.sheet.material,))
        return tuple(replace(self.figure_sheet, material=model) for model in models)


def parse_config(raw: Any, source: str) -> StudyConfig:
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
        study = StudyConfig.model_validate(raw)
    except ValidationError as error:
        lines = [line(StudyConfig, entry) for entry in error.errors(include_url=False)]
    else:
        lines = list(_contradictions(study))
        if not lines:
            return study
    raise ConfigError("\n".join(f"{source}: {line}" for line in dict.fromkeys(lines)))


def _contradictions(study: StudyConfig) -> Iterator[str]:
    """Yield the problems between keys that are right by themselves."""
    yield from _wrong_study(study)
    yield from _wrong_variants(study)
    known = [*study.materials, *study.variants]
    for i, series in enumerate(study.sheets):
        key, span = f"sheets[{i}]", series.strain
        if series.material not in known:
            hint = closest(series.material, known)
            yield f"{key}.material = {series.material!r}: is not in materials or variants{hint}"
        if isinstance(span, StrainRange) and span.stop < span.start:
            yield f"{key}.strain.stop = {span.stop:g}: must be >= start = {span.start:g}"
        elif isinstance(span, StrainRange) and span.stop - span.start > MAX_STRAINS * span.step:
            yield f"{key}.strain.step = {span.step:g}: must leave at most {MAX_STRAINS} strains"
    yield from _missing_figure_sheets(study)


def _wrong_study(study: StudyConfig) -> Iterator[str]:
    try:
        known = study.catalogue.figure_names
    except CatalogueError as error:
        yield str(error)
        return
    for i, name in enumerate(study.figures.names or ()):
        if name not in known:
            hint = closest(name, known)
            yield f"figures.names[{i}] = {name!r}: is no figure of {study.study}{hint}"


def _wrong_variants(study: StudyConfig) -> Iterator[str]:
    for name, variant in study.variants.items():
        if name in study.materials:
            yield f"variants.{name}: is the name of a material; a variant needs one of its own"
        if variant.material not in study.materials:
            hint = closest(variant.material, study.materials)
            yield f"variants.{name}.material = {variant.material!r}: is not in materials{hint}"
        if variant.bending is None and variant.parity is None:
            yield f"variants.{name}: must have bending, parity or both"


def _missing_figure_sheets(study: StudyConfig) -> Iterator[str]:
    shown = study.figures.sheet
    models = {"sheet": shown.material}
    models |= {f"compare[{i}]": model for i, model in enumerate(study.figures.compare)}
    for key, model in models.items():
        sheet = shown.model_copy(update={"material": model})
        if not any(_holds(series, sheet) for series in study.sheets):
            yield (
                f"figures.{key} = {model}, {shown.aspect:g}, {shown.thickness:g}: "
                "must be a sheet of sheets (material, aspect, thickness)"
            )


def _holds(series: SheetsBlock, sheet: FigureSheetBlock) -> bool:
    return (
        series.material == sheet.material
        and cases.canonical(sheet.aspect) in map(cases.canonical, series.aspect)
        and cases.canonical(sheet.thickness) in map(cases.canonical, series.thickness)
    )
