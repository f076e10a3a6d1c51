"""Item 3: what the weight of the sheet changes."""

from wrinklestudy.studies.imperfections.effects import (
    AMPLITUDE,
    DECAY,
    GRAVITY,
    effect_of,
)
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables


@claim(
    order=(3, 0, 1),
    place="the sheet of the config, stretched level",
    statement="The weight of the sheet does not matter.",
    reading="The sheet with the smallest density of the study, that of its rubber.",
    tolerance=f"A changes by at most {AMPLITUDE:.0%} and the decay strain by at most {DECAY:g}",
)
def weight_does_not_matter(study: StudyTables) -> Finding:
    """Compare the sheet that bears its weight with one that has none."""
    effect = effect_of(study, GRAVITY)
    amplitude = {strain: float(change[0]) for strain, change in effect.amplitude.items()}
    decay, density = float(effect.decay[0]), float(effect.sizes[0])
    small = all(abs(change) <= AMPLITUDE for change in amplitude.values())
    return Finding(
        verdict_of(small and abs(decay) <= DECAY),
        (
            *(Value(f"change of A at ε = {e:g}", change) for e, change in amplitude.items()),
            Value("change of the decay strain", decay),
            Value("density", density, "kg/m³"),
        ),
        f"With {density:g} kg/m³ the amplitude changes by "
        + ", ".join(f"{change:+.2%} (ε = {e:g})" for e, change in amplitude.items())
        + f", the decay strain by {decay:+.4f}.",
    )
