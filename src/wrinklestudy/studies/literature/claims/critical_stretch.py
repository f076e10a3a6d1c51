"""Section 4: from which stretch on sheets of a length wrinkle."""

import math
from dataclasses import replace

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.literature import sources
from wrinklestudy.studies.literature.islands import HOOKEAN, birth_strain, critical_at
from wrinklestudy.studies.literature.membranes import SMALL_STRAIN, sheets_by_model
from wrinklestudy.studies.literature.statement import Published, statement
from wrinklestudy.study.claims.finding import Finding, Value, number_text, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

SMALL, VERY_THIN = 0.01, 1.0e-4  # strain and t/W of the power laws
LONG_POWER, WIDE_POWER, OFF = 4.0, 2.0, 0.5  # exponents of L/W, and their tolerance
LONG_FROM, WIDE_TO = 3.0, 1.5  # L/W

_PUNTEL = Published(
    source=sources.PUNTEL_2011,
    where="abstract",
    reliability="B",
    said="",
    law="Hookean, one-dimensional with a constraint on the area",
    thickness=f"not read; here t/W = {VERY_THIN:g}",
)
_WHY = (
    "That model imposes how much shorter the sheet becomes across, everywhere; in a clamped sheet "
    "the compression comes from the clamps and does not reach far into a long one."
)


def _birth_strains(study: StudyTables) -> dict[float, float]:
    """Return the birth strain of a thin Hookean sheet by L/W; inf where nothing wrinkles."""
    critical = critical_at(study.table("map"), HOOKEAN, SMALL)
    return {a: birth_strain(VERY_THIN, tau, SMALL) for a, tau in sorted(critical.items())}


def _power(strains: dict[float, float]) -> float:
    if len(strains) < 2:
        raise MissingError(f"two L/W that wrinkle at strain {SMALL:g}, on the map of {HOOKEAN}")
    return float(np.polyfit(np.log([*strains]), np.log([*strains.values()]), 1)[0])


def _birth_text(strains: dict[float, float]) -> str:
    return ", ".join(f"{number_text(e)} at L/W = {a:g}" for a, e in strains.items())


@statement(
    replace(_PUNTEL, said="critical stretch ∝ (L/W)^4", aspect="long"),
    order=(4, 0, 2),
    says="the critical stretch of long sheets grows as the fourth power of L/W.",
    reading=f"Power of L/W that the birth strain goes with from L/W = {LONG_FROM:g} on.",
    tolerance=f"within {OFF:g} of {LONG_POWER:g}",
)
def critical_stretch_of_long_sheets(study: StudyTables) -> Finding:
    """Fit the power of L/W for long sheets."""
    strains = _birth_strains(study)
    long = {a: e for a, e in strains.items() if a >= LONG_FROM and math.isfinite(e)}
    power = _power(long)
    return Finding(
        verdict_of(abs(power - LONG_POWER) <= OFF),
        (Value("power of L/W", power), *_strain_values(long)),
        f"Birth strains, {_birth_text(long)}, go as L/W to the power {power:.2g}. {_WHY}",
    )


def _strain_values(strains: dict[float, float]) -> tuple[Value, ...]:
    return tuple(Value(f"birth strain at L/W = {a:g}", e) for a, e in strains.items())


@statement(
    replace(_PUNTEL, said="critical stretch ∝ (L/W)^2", aspect="wide"),
    order=(4, 0, 3),
    says="the critical stretch of wide sheets grows as the square of L/W.",
    reading=f"Power of L/W that the birth strain goes with up to L/W = {WIDE_TO:g}; sheets that do "
    "not wrinkle are at variance with any power.",
    tolerance=f"all of these lengths wrinkle, and the power is within {OFF:g} of {WIDE_POWER:g}",
)
def critical_stretch_of_wide_sheets(study: StudyTables) -> Finding:
    """Fit the power of L/W for wide sheets, if they wrinkle."""
    wide = {a: e for a, e in _birth_strains(study).items() if a <= WIDE_TO}
    flat = [a for a, e in wide.items() if not math.isfinite(e)]
    if flat:
        text = ", ".join(f"{a:g}" for a in flat)
        values = (Value("lengths that wrinkle at no thickness", len(flat)), *_strain_values(wide))
        return Finding(
            "disagree", values, f"At L/W = {text} no thickness wrinkles at ε = {SMALL:g}. {_WHY}"
        )
    power = _power(wide)
    return Finding(
        verdict_of(abs(power - WIDE_POWER) <= OFF),
        (Value("power of L/W", power), *_strain_values(wide)),
        f"Birth strains: {_birth_text(wide)}. {_WHY}",
    )


@statement(
    replace(
        _PUNTEL,
        said="wrinkles only above a threshold",
        aspect="any; here 2",
        thickness="not read; here t/W = 1e-3",
    ),
    order=(4, 0, 1),
    says="wrinkled solutions exist only above a threshold of the stretch.",
    reading="The Hookean membrane of small strain.",
    tolerance="a birth strain, all states below it flat, at least one, and all above it wrinkled",
)
def threshold_of_stretch(study: StudyTables) -> Finding:
    """Compare the states with the birth strain."""
    sheet = sheets_by_model(study)[SMALL_STRAIN]
    (strain,) = sheet.converged("strain")
    wrinkled = set(sheet.wrinkled("strain")[0].tolist())
    below = [eps for eps in strain.tolist() if not eps >= sheet.birth]
    above = [eps for eps in strain.tolist() if eps >= sheet.birth]
    if math.isfinite(sheet.birth) and not below:
        raise MissingError(f"a state below the birth strain, of {sheet.label}")
    holds = bool(above) and not wrinkled & set(below) and set(above) <= wrinkled
    return Finding(
        verdict_of(holds),
        (
            Value("birth strain, fvk", sheet.birth),
            Value("flat states below it", len(set(below) - wrinkled)),
            Value("wrinkled states above it", len(set(above) & wrinkled)),
        ),
        f"Wrinkles come at ε = {number_text(sheet.birth, 4)}.",
        sheets=(sheet,),
    )
