"""Claims on the width of the sheet, arc length and projection."""

import numpy as np

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    claim,
    largest,
    number_text,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.typing import Array

POISSON = 0.5
LINEAR_UP_TO = 0.1  # strain
LINEAR = 0.05  # of the contraction nu eps
RETAINED = 0.05  # of the contraction of the planar state

_ARC = "arc_width_over_width"


def _departure(sheet: SheetStates) -> tuple[Array, Array]:
    """Return strains and (W_act - W (1 - nu eps)) / (W nu eps) of all converged states."""
    strain, arc = sheet.converged("strain", _ARC)
    return strain, (arc - theory.actual_width(strain, POISSON)) / (POISSON * strain)


@claim(
    order=(4, 3, 3),
    place="Sec. IV.C, Fig. 7a",
    statement="Up to ε = 0.1 the arc length falls linearly, W_act = W (1 - ν ε).",
    reading="ν = 1/2.",
    tolerance=f"within {LINEAR:.0%} of the contraction ν ε at every strain up to {LINEAR_UP_TO:g}",
)
def linear_width(study: StudyTables) -> Finding:
    """Compare the arc width with 1 - nu eps at small strain."""
    strain, off = _departure(study.sheet)
    small = strain <= LINEAR_UP_TO + 1e-9
    if not small.any():
        raise MissingError(f"a state up to strain {LINEAR_UP_TO:g} of {study.sheet.label}")
    worst, where = largest("largest departure over the contraction", off[small], strain[small])
    return Finding(
        verdict_of(abs(worst.number) <= LINEAR),
        (
            worst,
            where,
            Value("the same in W", worst.number * POISSON * where.number),
            Value("states", int(small.sum())),
        ),
        f"Up to ε = {LINEAR_UP_TO:g} the arc width departs from 1 - ν ε by at most "
        f"{abs(worst.number):.1%} of the contraction, at ε = {where.number:g}.",
        sheets=(study.sheet,),
    )


@claim(
    order=(4, 3, 4),
    place="Sec. IV.C and caption of Fig. 7a",
    statement="At larger strains the arc length leaves the straight line.",
    reading=f"Beyond ε = {LINEAR_UP_TO:g}, as in the text; the caption has departures from ε = 0 "
    "on.",
    tolerance=f"more than {LINEAR:.0%} of the contraction at the largest strain of a wrinkled "
    "state",
)
def nonlinear_width(study: StudyTables) -> Finding:
    """Compare the arc width with 1 - nu eps at the largest wrinkled strain."""
    (wrinkled,) = study.sheet.wrinkled("strain", above=LINEAR_UP_TO)
    strain, off = _departure(study.sheet)
    at = float(off[int(np.argmin(np.abs(strain - wrinkled[-1])))])
    reached = strain[np.abs(off) > LINEAR]
    first = float(reached[0]) if len(reached) else np.nan
    return Finding(
        verdict_of(abs(at) > LINEAR),
        (
            Value(f"departure over the contraction, ε = {wrinkled[-1]:g}", at),
            Value(f"first strain at which it is over {LINEAR:.0%}", first),
        ),
        f"At ε = {wrinkled[-1]:g} the arc width is {at:+.0%} of the contraction off the straight "
        f"line; {LINEAR:.0%} are passed at ε = {number_text(first)}.",
        sheets=(study.sheet,),
    )


@claim(
    order=(4, 3, 2),
    place="Sec. IV.C, Table I",
    statement="Wrinkles leave the arc length across the sheet as it is in the flat state.",
    reading="On the mid-line the arc length of the wrinkled sheet equals the width of the flat "
    "state of the same strain: the transverse stress collapses, not the strain.",
    tolerance=f"within {RETAINED:.0%} of the contraction of the flat state at every wrinkled "
    "strain",
)
def planar_width_retained(study: StudyTables) -> Finding:
    """Compare the arc width with the width of the flat state."""
    sheet = study.sheet
    strain, arc, projected, flat = sheet.wrinkled(
        "strain", _ARC, "projected_width_over_width", "planar_width_over_width"
    )
    off = np.abs(arc - flat) / (1.0 - flat)
    worst, where = largest("largest difference over the contraction", off, strain)
    wasted = float(np.max((arc - flat) / (arc - projected)))
    return Finding(
        verdict_of(worst.number <= RETAINED),
        (
            worst,
            where,
            Value("largest difference in W", float(np.abs(arc - flat).max())),
            Value("largest difference over W_act - W_proj", wasted),
        ),
        f"Arc length and flat width differ by up to {worst.number:.2%} of the contraction "
        f"(collapse of the strain would make it 100%). Against the length that the wrinkles take "
        f"up, W_act - W_proj, the difference is up to {wasted:.0%}.",
        sheets=(sheet,),
    )
