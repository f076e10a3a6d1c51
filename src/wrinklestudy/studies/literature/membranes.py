"""One sheet under one bending law with four membranes: finite strain, and small strain."""

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.selections import Sheets, SheetsOfConfig

ASPECT, THICKNESS, BENDING = 2.0, 1.0e-3, "fvk"
SMALL_STRAIN = "membrane-fvk"
FINITE_STRAIN = ("svk-50-fvk", "nayyar-fvk", "mr-010-fvk")
MODELS = (SMALL_STRAIN, *FINITE_STRAIN)


def membranes(config: SheetsOfConfig) -> Sheets:
    """Select the sheets of all membranes."""
    return tuple(
        sheet
        for model in MODELS
        for sheet in config.all_sheets
        if (sheet.material, sheet.aspect, sheet.thickness) == (model, ASPECT, THICKNESS)
    )


def sheets_by_model(study: StudyTables) -> dict[str, SheetStates]:
    """Return the sheet of each membrane.

    Raises
    ------
    MissingError
        If one is missing.
    """
    found = {
        sheet.material: sheet
        for sheet in study.sheets
        if sheet.size == (ASPECT, THICKNESS) and sheet.material in MODELS
    }
    for model in MODELS:
        if model not in found:
            raise MissingError(f"a sheet of {model}, L/W = {ASPECT:g}, t/W = {THICKNESS:g}")
    return {model: found[model] for model in MODELS}
