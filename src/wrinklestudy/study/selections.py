"""Which sheets of a config a figure is drawn from: the choices that any study can make."""

from typing import TYPE_CHECKING

from wrinklestudy.results.cases import StudySheet

if TYPE_CHECKING:
    from wrinklestudy.study.config import StudyConfig

Sheets = tuple[StudySheet, ...]


def no_sheets(_config: "StudyConfig") -> Sheets:
    """Return none: the figure is drawn from states or materials."""
    return ()


def figure_sheet(config: "StudyConfig") -> Sheets:
    """Return the sheet of `figures.sheet` alone."""
    return (config.figure_sheet,)


def compared_models(config: "StudyConfig") -> Sheets:
    """Return the sheet of `figures.sheet` in each of the models of `figures.compare`."""
    return config.compared_sheets


def same_thickness(config: "StudyConfig") -> Sheets:
    """Return the sheets that differ from `figures.sheet` in L/W at most."""
    own = config.figure_sheet
    return tuple(
        sheet
        for sheet in config.all_sheets
        if (sheet.material, sheet.thickness) == (own.material, own.thickness)
    )


def same_aspect(config: "StudyConfig") -> Sheets:
    """Return the sheets that differ from `figures.sheet` in t/W at most."""
    own = config.figure_sheet
    return tuple(
        sheet
        for sheet in config.all_sheets
        if (sheet.material, sheet.aspect) == (own.material, own.aspect)
    )
