"""The sheets that the figures of this study show, told by the names of their materials."""

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
