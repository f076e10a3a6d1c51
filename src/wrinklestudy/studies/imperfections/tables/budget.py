"""What a measured decay strain is uncertain by."""

import math

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.imperfections.budget import budget, total
from wrinklestudy.studies.imperfections.effects import effects_of
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number

_COLUMNS = ("source", "what", "error_of_decay_strain")


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each source of error, and their sum."""
    try:
        shares = budget(study, effects_of(study))
    except MissingError as lack:
        return ExtraTable(_COLUMNS, (), note=f"Not in the study: {lack}.")
    cells = [(one.source, one.what, number(one.error, ".2g", "not known")) for one in shares]
    if not any(math.isnan(one.error) for one in shares):
        cells.append(("all", "square root of the sum of squares", f"{total(shares):.2g}"))
    return ExtraTable(
        _COLUMNS,
        tuple((one.source, one.what, one.error) for one in shares),
        ("source", "what", "error of the decay strain"),
        tuple(cells),
        "Imperfections at sizes that a careful set-up keeps to. What one mode of test leaves open "
        "is taken from Treloar's rubber, of which all modes were measured: a sheet of either fit.",
    )
