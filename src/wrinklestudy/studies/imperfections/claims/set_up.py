"""Item 1: how well clamps must be aligned, and how even the rubber must be."""

import math

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.imperfections.effects import (
    AMPLITUDE,
    DECAY,
    Effect,
    effects_of,
    rows_of,
    unit,
    words,
)
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

ALIGNED = 0.01  # W or rad
EVEN = 0.03  # parts of the thickness
TILTED = 0.5  # of the tilt
CLAMPS = ("shear", "rotate", "twist", "pitch", "lift")
GRADIENTS = ("thickness-along", "thickness-across")


def _allowed(study: StudyTables, kinds: tuple[str, ...]) -> list[Effect]:
    found = [effect for effect in effects_of(study) if effect.kind.split()[0] in kinds]
    if not found:
        raise MissingError(f"imperfections of the kinds {', '.join(kinds)}")
    return found


def _enough(study: StudyTables, kinds: tuple[str, ...], size: float) -> Finding:
    """Judge whether imperfections up to a size change nothing that an experiment can tell."""
    found = _allowed(study, kinds)
    bounds = {effect.kind: min(limit.bound for limit in effect.limits) for effect in found}
    worst = min(found, key=lambda effect: bounds[effect.kind])
    texts = [
        f"{words(effect.kind)}: "
        + ", ".join(
            [
                *(
                    f"A at ε = {strain:g} {effect.amplitude_limit(strain).text(unit(effect.kind))}"
                    for strain in effect.amplitude
                ),
                f"decay {effect.decay_limit.text(unit(effect.kind))}",
            ]
        )
        for effect in found
    ]
    return Finding(
        verdict_of(all(bound >= size for bound in bounds.values())),
        tuple(
            Value(f"{words(e.kind)}, largest size within both limits", bounds[e.kind], unit(e.kind))
            for e in found
        ),
        f"Sizes at which A changes by {AMPLITUDE:.0%} and the decay strain by {DECAY:g}: "
        f"{'; '.join(texts)}. What matters most is: {words(worst.kind)}.",
    )


@claim(
    order=(1, 0, 1),
    place="every imperfect sheet",
    statement="Every state of a sheet that is not perfect is found from a seed of its own.",
    reading="No state starts from another one.",
    tolerance="all states converge, and all decay strains are known",
)
def every_state_converges(study: StudyTables) -> Finding:
    """Count the states that did not converge."""
    rows = study.table("imperfection")
    failed = rows[rows["status"] == "not-converged"]
    unknown = rows[rows["decay_strain"].isna()]
    names = sorted({*failed["imperfection"], *unknown["imperfection"]})
    return Finding(
        verdict_of(failed.empty and unknown.empty),
        (
            Value("states", float(len(rows))),
            Value("that did not converge", float(len(failed))),
            Value("without a decay strain", float(len(unknown))),
            Value("most Newton iterations, both parities", float(rows["newton_iterations"].max())),
            Value("largest residual over the energy", float(rows["residual"].max())),
        ),
        f"{len(rows) - len(failed)} of {len(rows)} states converged"
        + (f"; not all is known of {', '.join(names)}." if names else "."),
    )


@claim(
    order=(1, 0, 2),
    place="clamps",
    statement=f"Clamps aligned to {ALIGNED:.0%} of the width and to {ALIGNED:g} rad are enough.",
    reading="Each of shear, turn, twist, pitch and lift for itself.",
    tolerance=f"up to these sizes A changes by at most {AMPLITUDE:.0%} and the decay strain by at "
    f"most {DECAY:g}",
)
def aligned_clamps_are_enough(study: StudyTables) -> Finding:
    """Compare the sizes at which the changes can be told with those of the claim."""
    return _enough(study, CLAMPS, ALIGNED)


@claim(
    order=(1, 0, 3),
    place="thickness",
    statement=f"Rubber whose thickness is even to {EVEN:.0%} from end to end and from edge to edge "
    "is enough.",
    tolerance=f"up to these gradients A changes by at most {AMPLITUDE:.0%} and the decay strain by "
    f"at most {DECAY:g}",
)
def even_rubber_is_enough(study: StudyTables) -> Finding:
    """Compare the gradients at which the changes can be told with those of the claim."""
    return _enough(study, GRADIENTS, EVEN)


@claim(
    order=(1, 0, 4),
    place="a clamp shifted across",
    statement="Wrinkles of a sheared sheet are oblique by the angle of its diagonal.",
    reading="The tilt of the crests at the centre against the shift s/L of the clamps.",
    tolerance=f"within {TILTED:.0%} of s/L' at every size and strain",
)
def tilt_of_a_sheared_sheet(study: StudyTables) -> Finding:
    """Compare the tilt of the crests with the shift over the length."""
    own = [r for r in rows_of(study) if r["kind"] == "shear" and not math.isnan(r["tilt"])]
    if not own:
        raise MissingError("a wrinkled sheet whose clamps are sheared")
    ratios = [r["tilt"] * r["aspect"] * (1.0 + r["strain"]) / r["size"] for r in own]
    return Finding(
        verdict_of(all(abs(ratio - 1.0) <= TILTED for ratio in ratios)),
        tuple(
            Value(f"tilt at s = {r['size']:g} W, ε = {r['strain']:g}", r["tilt"], "rad")
            for r in own
        ),
        f"The crests at the centre tilt by {min(ratios):.2f} to {max(ratios):.2f} times s/L'.",
    )
