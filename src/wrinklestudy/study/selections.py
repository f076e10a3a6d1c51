"""Selections of sheets for figures, which any study can use."""

from typing import Protocol

from wrinklestudy.results.cases import StudySheet

Sheets = tuple[StudySheet, ...]


class SheetsOfConfig(Protocol):
    """What a selection sees of a config, so that a catalogue need not know the whole of it."""

    @property
    def all_sheets(self) -> Sheets:
        """All sheets of the study."""

    @property
    def figure_sheet(self) -> StudySheet:
        """The sheet that the figures of a single sheet show."""

    @property
    def compared_sheets(self) -> Sheets:
        """The sheet of `figures.sheet` in each of the models that figures compare."""


def no_sheets(_config: SheetsOfConfig) -> Sheets:
    """Select none: the figure is drawn from states or materials."""
    return ()


def figure_sheet(config: SheetsOfConfig) -> Sheets:
    """Select the sheet of `figures.sheet` alone."""
    return (config.figure_sheet,)


def compared_models(config: SheetsOfConfig) -> Sheets:
    """Select the sheet of `figures.sheet` in each of the models of `figures.compare`."""
    return config.compared_sheets


def same_thickness(config: SheetsOfConfig) -> Sheets:
    """Select the sheets that differ from `figures.sheet` in L/W at most."""
    own = config.figure_sheet
    return tuple(
        sheet
        for sheet in config.all_sheets
        if (sheet.material, sheet.thickness) == (own.material, own.thickness)
    )


def figure_sheet_then_lengths(config: SheetsOfConfig) -> Sheets:
    """Select the sheet of `figures.sheet`, then those that differ from it in L/W alone."""
    return tuple(dict.fromkeys((config.figure_sheet, *same_thickness(config))))


def same_but_one(config: SheetsOfConfig) -> Sheets:
    """Select the sheet of `figures.sheet`, then those that differ from it in L/W or t/W alone."""
    own = config.figure_sheet
    return tuple(dict.fromkeys((own, *same_thickness(config), *same_aspect(config))))


def same_aspect(config: SheetsOfConfig) -> Sheets:
    """Select the sheets that differ from `figures.sheet` in t/W at most."""
    own = config.figure_sheet
    return tuple(
        sheet
        for sheet in config.all_sheets
        if (sheet.material, sheet.aspect) == (own.material, own.aspect)
    )
