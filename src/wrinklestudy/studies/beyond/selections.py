"""The sheets that the figures and claims of this study are about, told by their names and sizes."""

from collections.abc import Iterable

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.selections import Sheets, SheetsOfConfig

# How names of materials begin in config/beyond.yaml: ratios C01/C10 that curves go through, ratios
# at which these are checked, and Poisson's ratios.
RATIO, CHECK, POISSON = "mr-", "check-", "svk-"


def rubbers(config: SheetsOfConfig) -> Sheets:
    """Select the figure sheet, and sheets of its size of the rubbers of given constants."""
    own = config.figure_sheet
    return tuple(
        sheet
        for sheet in config.all_sheets
        if (sheet.aspect, sheet.thickness) == (own.aspect, own.thickness)
        and (sheet.material == own.material or sheet.material.startswith((RATIO, CHECK, POISSON)))
    )


def own_rubber(config: SheetsOfConfig) -> Sheets:
    """Select all sheets of the rubber of the figure sheet."""
    material = config.figure_sheet.material
    return tuple(sheet for sheet in config.all_sheets if sheet.material == material)


def same_length(config: SheetsOfConfig) -> Sheets:
    """Select the sheets of the rubber and L/W of the figure sheet."""
    return tuple(
        sheet for sheet in own_rubber(config) if sheet.aspect == config.figure_sheet.aspect
    )


def thinnest(config: SheetsOfConfig) -> Sheets:
    """Select the thinnest sheet of the rubber and L/W of the figure sheet."""
    return (min(same_length(config), key=lambda sheet: sheet.thickness),)


def named(sheets: Iterable[SheetStates], *beginnings: str) -> list[SheetStates]:
    """Return the sheets whose material has a name that begins in one of some ways."""
    return [sheet for sheet in sheets if sheet.material.startswith(beginnings)]
