"""Item 6, its second half: the strain at which the compressed zone vanishes as t goes to zero."""

import numpy as np

from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond.compression import Ending, endings, turns
from wrinklestudy.studies.beyond.rubber import ratio, share
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables


def study_endings(study: StudyTables) -> list[Ending]:
    """Return where compression ends on the sheets of a study.

    Raises
    ------
    MissingError
        If the study does not look for it.
    """
    fits: dict[str, Fit] = {fitted.name: fitted.fit for fitted in study.materials}

    def material(name: str) -> Material:
        return study.given[name] if name in study.given else fits[name].material()

    return endings(study.table("compression"), material)


@claim(
    order=(6, 0, 3),
    place="flat sheets up to large strain",
    statement="However thin the sheet, wrinkles at the centre end at a finite strain if the rubber "
    "is nearly neo-Hookean; for larger C01/C10, the paper's among them, they do not.",
    reading="As t goes to zero the sheet wrinkles wherever the flat state is compressed: narrower "
    "than uniaxial tension makes it. At the centre this ends at a strain that rises with C01/C10, "
    "and from some ratio on it never does.",
    tolerance="at every L/W the end is finite for the smallest ratio, rises with the ratio, and "
    "from a ratio below the paper's on there is none up to the largest strain",
)
def compression_ends_or_lasts(study: StudyTables) -> Finding:
    """Look for the end of compression over C01/C10 at each L/W."""
    found = study_endings(study)
    by_aspect = turns(found)
    if min(len([e for e in found if e.aspect == aspect]) for aspect in by_aspect) < 2:
        raise MissingError("the end of compression for two ratios C01/C10 at each L/W")
    own = float(ratio(share(study.material.fit.material())))
    first = {aspect: next(e for e in found if e.aspect == aspect) for aspect in by_aspect}
    holds = all(
        first[aspect].ends and turn.rises and turn.first_lasting <= own
        for aspect, turn in by_aspect.items()
    )
    values, words = [], []
    for aspect, turn in by_aspect.items():
        values += [
            Value(
                f"end at L/W = {aspect:g}, C01/C10 = {first[aspect].ratio:g}",
                first[aspect].strain,
                digits=4,
            ),
            Value(f"its error at L/W = {aspect:g}", first[aspect].error, digits=1),
            Value(f"largest C01/C10 with an end at L/W = {aspect:g}", turn.last_ending),
            Value(f"smallest without at L/W = {aspect:g}", turn.first_lasting),
        ]
        words.append(_words(aspect, first[aspect], turn.last_ending, turn.first_lasting))
    again = [e for e in found if np.isfinite(e.returns)]
    last = min(e.last for e in found)
    back = (
        ""
        if not again
        else (f" On {len(again)} of {len(found)} sheets compression is back at a larger strain.")
    )
    return Finding(
        verdict_of(holds),
        tuple(values),
        f"{'; '.join(words)}. Flat states were followed to ε = {last:g}.{back}",
        sheets=(study.sheet,),
    )


def _words(aspect: float, first: Ending, last_ending: float, first_lasting: float) -> str:
    text = f"at L/W = {aspect:g} compression "
    if not first.ends:
        return f"{text}lasts at C01/C10 = {first.ratio:g}"
    text += f"ends at ε = {first.strain:.3f} for C01/C10 = {first.ratio:g}, and "
    if not np.isfinite(first_lasting):
        return f"{text}at some strain for every ratio"
    return f"{text}goes on from a ratio between {last_ending:.3g} and {first_lasting:.3g} on"
