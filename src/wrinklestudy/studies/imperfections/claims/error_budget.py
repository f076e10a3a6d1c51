"""Item 4: what the error of a measured decay strain is made of."""

from wrinklestudy.studies.imperfections.budget import budget, total
from wrinklestudy.studies.imperfections.effects import effects_of
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables


@claim(
    order=(4, 0, 1),
    place="a measured decay strain",
    statement="What the rubber is matters more for the decay strain than how it is clamped.",
    reading="Errors are added as squares: imperfections at the sizes of a careful set-up, against "
    "the scatter of the fit and what one mode of test leaves open.",
    tolerance="the error by the rubber is the larger one",
)
def rubber_before_clamps(study: StudyTables) -> Finding:
    """Compare the two parts of the budget."""
    shares = budget(study, effects_of(study))
    set_up, rubber = total(shares, "set-up"), total(shares, "rubber")
    every = total(shares)
    most = max(shares, key=lambda share: share.error)
    return Finding(
        verdict_of(rubber > set_up),
        (
            Value("error by the set-up", set_up, digits=2),
            Value("error by the rubber", rubber, digits=2),
            Value("all, steps between strains included", every, digits=2),
        ),
        f"Clamps and thickness make the decay strain of {study.sheet.decay:.4f} uncertain by "
        f"{set_up:.4f}, the rubber by {rubber:.4f}, all together by {every:.4f}. The largest part "
        f"is: {most.what} ({most.error:.4f}).",
        sheets=(study.sheet,),
    )
