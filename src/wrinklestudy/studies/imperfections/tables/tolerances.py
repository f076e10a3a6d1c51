"""The size at which each imperfection changes what an experiment can tell."""

import math

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.imperfections.effects import (
    AMPLITUDE,
    DECAY,
    Effect,
    Reached,
    effects_of,
    unit,
    words,
)
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables

_COLUMNS = ("imperfection", "unit", "what", "strain", "size", "how")


def table(study: StudyTables) -> ExtraTable:
    """Return a row for each kind of imperfection, on the page; one for each limit, in the file."""
    try:
        found = effects_of(study)
    except MissingError as lack:
        return ExtraTable(_COLUMNS, (), note=f"Not in the study: {lack}.")
    strains = sorted({strain for effect in found for strain in effect.amplitude})
    head = (
        *("imperfection", "sizes computed"),
        *(f"A at ε = {strain:g} by {AMPLITUDE:.0%}" for strain in strains),
        f"decay by {DECAY:g}",
    )
    return ExtraTable(
        _COLUMNS,
        tuple(row for effect in found for row in _rows(effect)),
        head,
        tuple(_cells(effect, strains) for effect in found),
        "Between two sizes a change is taken as a power of the size; 'about' is below the smallest "
        "size computed. W is the width, t the mean thickness; differences of the thickness are "
        "over the whole length or width.",
    )


def _rows(effect: Effect) -> list[tuple[str | float, ...]]:
    limits: list[tuple[str, float, Reached]] = [
        ("amplitude", strain, effect.amplitude_limit(strain)) for strain in effect.amplitude
    ]
    limits.append(("decay", math.nan, effect.decay_limit))
    return [
        (effect.kind, unit(effect.kind), what, strain, limit.size, limit.how)
        for what, strain, limit in limits
    ]


def _cells(effect: Effect, strains: list[float]) -> tuple[str, ...]:
    of = unit(effect.kind)
    return (
        words(effect.kind),
        ", ".join(f"{size:g}" for size in effect.sizes),
        *(
            effect.amplitude_limit(strain).text(of) if strain in effect.amplitude else ""
            for strain in strains
        ),
        effect.decay_limit.text(of),
    )
