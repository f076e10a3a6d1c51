"""Between which strains each imperfect sheet wrinkles."""

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.pages import number

_COLUMNS = ("imperfection", "birth_strain", "decay_strain", "windows", "bifurcation", "reason")
_HEAD = ("sheet", "birth", "decay", "all ranges", "bifurcation", "not known because")


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each imperfect sheet."""
    try:
        rows = study.table("imperfection").drop_duplicates(["material", "imperfection"])
    except MissingError as lack:
        return ExtraTable(_COLUMNS, (), note=f"Not in the study: {lack}.")
    chosen = [tuple(row) for row in rows[list(_COLUMNS)].itertuples(index=False)]
    cells = tuple(
        (name, number(birth, ".4f", ""), number(decay, ".4f", ""), *(_text(v) for v in rest))
        for name, birth, decay, *rest in chosen
    )
    return ExtraTable(
        _COLUMNS,
        tuple(chosen),
        _HEAD,
        cells,
        "A sheet whose clamps are shifted or turned may wrinkle from the least strain on, and has "
        "then no strain of birth. Sharp: the wrinkles break a symmetry of the sheet and appear at "
        "a strain of their own; rounded: they grow out of what the sheet does before.",
    )


def _text(value: object) -> str:
    return "" if value is None or value != value else str(value)
