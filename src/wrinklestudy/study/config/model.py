"""The config of a study as a whole, and what follows from it: cases, sheets, settings."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from itertools import groupby
from operator import attrgetter
from typing import Annotated, Any

from pydantic import Field
from pydantic.fields import FieldInfo

from wrinklestudy.results import cases
from wrinklestudy.results.cases import Case, StudySheet
from wrinklestudy.results.imperfect_sheets import ImperfectSheet
from wrinklestudy.results.paths import sheet_wildcards
from wrinklestudy.study.catalogue import Catalogue, FigureEntry
from wrinklestudy.study.config.blocks import (
    AnalysisBlock,
    Block,
    FiguresBlock,
    FoldersBlock,
    GateBlock,
    LengthsBlock,
    MaterialBlock,
    MeshBlock,
    PlateBlock,
    SheetsBlock,
    SolverBlock,
    VariantBlock,
)
from wrinklestudy.study.config.imperfect import ImperfectBlock
from wrinklestudy.study.config.values import Filled, Name, Place
from wrinklestudy.study.loading import load_catalogue


class StudyConfig(Block):
    """A whole study."""

    study: Place = Field(
        default="panaitescu2019",
        description="figures and claims: a study of this package, or a folder or .py file",
    )
    folders: FoldersBlock = Field(default_factory=FoldersBlock, description="where files are")
    materials: Annotated[
        dict[Name, MaterialBlock],
        Field(
            min_length=1,
            json_schema_extra={"errorMessage": "must be a block with at least one material"},
        ),
    ] = Field(description="materials by name")
    variants: dict[Name, VariantBlock] = Field(
        default_factory=dict, description="variants of the materials by name"
    )
    sheets: Filled[SheetsBlock] = Field(description="the sheets and strains to compute")
    map_series: tuple[AnalysisBlock, ...] = Field(
        default=(), alias="maps", description="L/W and strains of maps of the critical thickness"
    )
    tension_series: tuple[AnalysisBlock, ...] = Field(
        default=(), alias="tension", description="L/W and strains of tension fields"
    )
    compression_series: tuple[LengthsBlock, ...] = Field(
        default=(), alias="compression", description="L/W at which the end of compression is sought"
    )
    imperfection_series: tuple[ImperfectBlock, ...] = Field(
        default=(),
        alias="imperfections",
        description="sheets whose clamps are off, whose thickness varies or that have a weight",
    )
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
        """The figures that the config names, or all of the catalogue if it names none."""
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
            Material or variant; a variant takes precedence over the block plate.
        """
        taken = {
            key: getattr(block, key)
            for block in (self.mesh, self.plate, self.solver)
            for key, field in type(block).model_fields.items()
            if stage in _stages(field)
        }
        if model in self.variants:
            own = self.variants[model].model_dump(exclude_none=True)
            taken |= {key: own[key] for key in taken.keys() & own.keys()}
        return dict(sorted(taken.items()))

    @cached_property
    def cases(self) -> tuple[Case, ...]:
        """All cases, sorted and without repetitions."""
        return cases.cases((s.material, s.aspect, s.thickness, s.strains) for s in self.sheets)

    @cached_property
    def _cases_by_sheet(self) -> dict[StudySheet, tuple[Case, ...]]:
        groups = groupby(self.cases, key=attrgetter("sheet"))
        return {sheet: tuple(of_sheet) for sheet, of_sheet in groups}

    @property
    def all_sheets(self) -> tuple[StudySheet, ...]:
        """All sheets, sorted and without repetitions."""
        return tuple(self._cases_by_sheet)

    def cases_of(self, sheet: StudySheet) -> tuple[Case, ...]:
        """Return the cases of a sheet by strain; none if the study lacks it."""
        return self._cases_by_sheet.get(sheet, ())

    @cached_property
    def maps(self) -> Mapping[tuple[str, float], tuple[float, ...]]:
        """The strains of each map, by model and L/W."""
        return cases.strains_by_length((s.material, s.aspect, s.strains) for s in self.map_series)

    @cached_property
    def tension(self) -> Mapping[tuple[str, float], tuple[float, ...]]:
        """The strains of the tension fields, by material and L/W."""
        return cases.strains_by_length(
            (s.material, s.aspect, s.strains) for s in self.tension_series
        )

    @cached_property
    def compression(self) -> Mapping[tuple[str, float], tuple[float, ...]]:
        """The materials and L/W of which the end of compression is sought; they name no strains."""
        return {
            (series.material, cases.canonical(aspect)): ()
            for series in self.compression_series
            for aspect in series.aspect
        }

    @cached_property
    def imperfect_sheets(self) -> Mapping[ImperfectSheet, tuple[float, ...]]:
        """The strains of each imperfect sheet, sorted and without repetitions."""
        strains: dict[ImperfectSheet, set[float]] = {}
        for series in self.imperfection_series:
            for sheet, own in series.cases():
                strains.setdefault(sheet, set()).update(own)
        order = sorted(strains, key=lambda sheet: (sheet.sheet, sheet.name))
        return {sheet: tuple(sorted(strains[sheet])) for sheet in order}

    def imperfect_sheet(self, sheet: StudySheet, name: str) -> ImperfectSheet:
        """Return the imperfect sheet of a name, see `ImperfectSheet.name`."""
        return next(s for s in self.imperfect_sheets if (s.sheet, s.name) == (sheet, name))

    def analyses(self, stage: str) -> Mapping[tuple[str, float], tuple[float, ...]]:
        """Return the strains of a stage that is an analysis, by model and L/W."""
        by_stage = {
            "map": self.maps,
            "tension": self.tension,
            "compression": self.compression,
            "imperfection": cases.strains_by_length(
                (s.sheet.material, (s.sheet.aspect,), strains)
                for s, strains in self.imperfect_sheets.items()
            ),
        }
        return by_stage[stage]

    def analysis_jobs(self, stage: str) -> list[dict[str, str | float]]:
        """Return the wildcards of each job of a stage that is an analysis."""
        if stage == "imperfection":
            return [
                {**sheet_wildcards(sheet.sheet), "imperfection": sheet.name}
                for sheet in self.imperfect_sheets
            ]
        return [{"material": model, "aspect": aspect} for model, aspect in self.analyses(stage)]

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


def _stages(field: FieldInfo) -> Any:
    """Return the stages that take a key: `blocks.of_stages`."""
    extra = field.json_schema_extra
    return extra.get("stages", []) if isinstance(extra, dict) else []
