"""The catalogue of a study: its figures, claims and further tables, as data.

A study is a package whose ``__init__`` defines one `Catalogue` under the name ``CATALOGUE``: one
of `wrinklestudy.studies`, or a folder (or a single ``.py`` file) of the user. The catalogue names
the modules that draw and judge; they are imported only in the jobs that need them.
"""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from wrinklestudy.results.cases import NAME_PATTERN
from wrinklestudy.results.paths import STAGES
from wrinklestudy.study.selections import Sheets, SheetsOfConfig, figure_sheet, no_sheets

# Kinds of measured data: `study.measurements`.
MEASURED_KINDS = ("stress", "amplitude", "wavelength", "profiles")


@dataclass(frozen=True, kw_only=True)
class FigureEntry:
    """One figure of a study: how the report presents it and what it is drawn from.

    Parameters
    ----------
    name : str
        Name of the files.
    title : str
        What it shows, in a few words.
    caption : str
        What it shows, in a sentence; the report adds cases, meshes and measurements.
    module : str
        Module with ``draw(inputs)``, from `study.figures.inputs.Inputs` to a matplotlib figure.
    panel : str
        Number and panel of the figure in the publication, if there is one.
    part : str
        Part of the report that it belongs to.
    sheets : callable
        Selects, from a config, the sheets whose tables the figure is drawn from:
        `study.selections`.
    strains : tuple of float or "all"
        Strains at which states are shown, or the nearest ones computed.
    states_of : callable
        Selects the sheets whose states are shown at these strains.
    measured : tuple of str
        Kinds of measured data drawn over it, out of `MEASURED_KINDS`.
    materials : bool
        Whether the figure compares the fitted materials of the study.
    constants : bool
        Whether the figure needs the constants of materials: those of its sheets and analyses, and
        all that are fitted.
    analyses : tuple of str
        Stages that are analyses (`results.paths.Stage`) whose files the figure is drawn from, those
        of the whole study.

    Raises
    ------
    ValueError
        If the name cannot be a file name, or a kind of measured data or an analysis is unknown.
    """

    name: str
    title: str
    caption: str
    module: str
    panel: str = ""
    part: str = "Figures"
    sheets: Callable[[SheetsOfConfig], Sheets] = no_sheets
    strains: tuple[float, ...] | Literal["all"] = ()
    states_of: Callable[[SheetsOfConfig], Sheets] = figure_sheet
    measured: tuple[str, ...] = ()
    materials: bool = False
    constants: bool = False
    analyses: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Refuse what would fail only in a job."""
        _check_name("figure", self.name)
        for kind in self.measured:
            if kind not in MEASURED_KINDS:
                allowed = ", ".join(MEASURED_KINDS)
                raise ValueError(f"figure {self.name!r}: measured = {kind!r}: allowed: {allowed}")
        known = [stage for stage in STAGES if STAGES[stage].analysis]
        for stage in self.analyses:
            if stage not in known:
                allowed = ", ".join(known)
                raise ValueError(f"figure {self.name!r}: analyses = {stage!r}: allowed: {allowed}")

    def strains_shown(self, available: Sequence[float]) -> list[float]:
        """Return the strains whose states the figure shows, out of those that a study has.

        For each strain wanted this is the nearest one of the study, without repetitions; the figure
        is labelled with what it shows. The undeformed sheet (strain 0) needs no state.

        Parameters
        ----------
        available : sequence of float
            Strains of the figure sheet.

        Returns
        -------
        list of float
            Increasing; empty if the figure shows no state.
        """
        if self.strains == "all":
            return sorted(available)
        tensile = [strain for strain in self.strains if strain > 0.0]
        if not available:
            return []
        nearest = (
            min(available, key=lambda strain: (abs(strain - want), strain)) for want in tensile
        )
        return sorted(set(nearest))


@dataclass(frozen=True, kw_only=True)
class TableEntry:
    """A further table that the claims stage writes.

    Parameters
    ----------
    name : str
        Name of its file.
    title : str
        Heading on the page of the claims.
    caption : str
        What it shows, for the report.
    module : str
        Module with ``table(study)``, from `study.claims.tables.StudyTables` to an `ExtraTable`.

    Raises
    ------
    ValueError
        If the name cannot be a file name.
    """

    name: str
    title: str
    caption: str
    module: str

    def __post_init__(self) -> None:
        """Refuse what would fail only in a job."""
        _check_name("table", self.name)
        if self.name == "claims":
            raise ValueError("table 'claims': the table of claims has this name")


@dataclass(frozen=True, kw_only=True)
class SectionEntry:
    """One question of a study, and what answers it, as a section of its Markdown page.

    Parameters
    ----------
    number : int
        Its claims are those whose `Claim.order` begins with this number.
    title : str
        Heading.
    asked : str
        What was asked, in a sentence or two; Markdown.
    figures, tables : tuple of str
        Names in the catalogue.
    """

    number: int
    title: str
    asked: str
    figures: tuple[str, ...] = ()
    tables: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class Catalogue:
    """Everything that a study shows.

    Parameters
    ----------
    name : str
        Short name.
    title : str
        What the study is about, or the title of the publication that it follows.
    citation : str
        The publication, without its title; empty if there is none.
    figures : tuple of FigureEntry
        In the order of the report.
    claims : str
        Module with claims, or package of such modules; empty without claims. The claims
        themselves say in which order they come.
    tables : tuple of TableEntry
        Further tables.
    tables_part : str
        Part of the report for tables and claims.
    sections : tuple of SectionEntry
        What the Markdown page of the claims is made of; one section with all claims if empty.

    Raises
    ------
    ValueError
        If two figures or two tables have the same name, or a section names one that is not there.
    """

    name: str
    title: str
    citation: str = ""
    figures: tuple[FigureEntry, ...] = ()
    claims: str = ""
    tables: tuple[TableEntry, ...] = ()
    tables_part: str = "Tables and claims"
    sections: tuple[SectionEntry, ...] = ()

    def __post_init__(self) -> None:
        """Refuse names that stand for two things, or for nothing."""
        for kind, names in (
            ("figure", self.figure_names),
            ("table", tuple(entry.name for entry in self.tables)),
        ):
            twice = [name for name in dict.fromkeys(names) if names.count(name) > 1]
            if twice:
                raise ValueError(f"{kind} {twice[0]!r}: is in the catalogue twice")
        for section in self.sections:
            for name in section.figures:
                self.figure(name)
            for name in section.tables:
                self.table(name)

    @property
    def figure_names(self) -> tuple[str, ...]:
        """The names of the figures, in order."""
        return tuple(entry.name for entry in self.figures)

    def figure(self, name: str) -> FigureEntry:
        """Return the entry of a figure.

        Raises
        ------
        ValueError
            If there is no such figure.
        """
        for entry in self.figures:
            if entry.name == name:
                return entry
        raise ValueError(f"figure {name!r}: must be one of {', '.join(self.figure_names)}")

    def table(self, name: str) -> TableEntry:
        """Return the entry of a further table.

        Raises
        ------
        ValueError
            If there is no such table.
        """
        for entry in self.tables:
            if entry.name == name:
                return entry
        names = ", ".join(entry.name for entry in self.tables)
        raise ValueError(f"table {name!r}: must be one of {names}")


def _check_name(kind: str, name: str) -> None:
    if re.fullmatch(NAME_PATTERN, name) is None:
        raise ValueError(f"{kind} {name!r}: must be of lower-case letters, digits, '-' and '_'")
