"""Item 2: whether an imperfection chooses the parity of the wrinkles."""

import math

import numpy as np

from wrinklestudy.results.imperfect_sheets import PERFECT
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.imperfections.effects import (
    RIPPLE,
    Effect,
    effects_of,
    rows_of,
    unit,
    words,
)
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

UNEVEN = 1.0e-3  # amplitude of a ripple, parts of t, that no rubber is free of
HALF = 0.15  # of lambda/2, within which a ripple counts as one of half the wavelength
PROPORTIONAL = 0.1  # of the exponent
NOTHING = 1.0e-9  # of what the pin carries


def _ripple(study: StudyTables) -> Effect:
    """Return the effect of the shortest ripple: that of half the wavelength of the wrinkles."""
    ripples = [effect for effect in effects_of(study) if effect.kind.startswith(RIPPLE)]
    if not ripples:
        raise MissingError("a ripple of the thickness")
    return min(ripples, key=lambda effect: float(effect.kind.split()[1]))


def per_amplitude(ripple: Effect, strain: float) -> float:
    """Return the change of the energy of one parity against the other per amplitude of a ripple.

    From its smallest amplitude.
    """
    return abs(float(ripple.parity[strain][0])) / float(ripple.sizes[0])


@claim(
    order=(2, 0, 1),
    place="clamps, gradients, weight",
    statement="Something smooth chooses the parity of the wrinkles.",
    reading="An imperfection at its largest size computed, long waves of the thickness too, "
    f"against a ripple of half the wavelength with an amplitude of {UNEVEN:g} t, which no rubber "
    "is free of. The energies are those of the antisymmetric and the symmetric state.",
    tolerance="agree if the two energies differ by more than with such a ripple for one of them",
)
def something_smooth_chooses(study: StudyTables) -> Finding:
    """Compare what smooth imperfections and a small ripple change in the energies."""
    ripple = _ripple(study)
    others = [effect for effect in effects_of(study) if effect.kind != ripple.kind]
    if not others:
        raise MissingError("imperfections other than a ripple")
    equal = {}
    for effect in others:
        strains = [strain for strain in effect.parity if strain in ripple.parity]
        worst = max(
            (abs(float(effect.parity[e][-1])) / per_amplitude(ripple, e) for e in strains),
            default=math.nan,
        )
        equal[effect.kind] = worst
    known = {kind: value for kind, value in equal.items() if not math.isnan(value)}
    if len(known) < len(equal):
        lacking = ", ".join(words(kind) for kind in equal if kind not in known)
        raise MissingError(f"both parities with {lacking}")
    most = max(known, key=known.__getitem__)
    size = next(effect for effect in others if effect.kind == most).sizes[-1]
    chooses = known[most] > UNEVEN
    return Finding(
        verdict_of(chooses),
        tuple(
            Value(f"{words(kind)}: amplitude of a ripple that does as much", value, "t", digits=2)
            for kind, value in known.items()
        ),
        f"The most is done by: {words(most)}, {size:g} {unit(most)}, as much as a ripple of "
        f"{known[most]:.1g} t. "
        + (
            "That is more than the roughness of a sheet does."
            if chooses
            else "The roughness of any sheet does more: nothing smooth explains why one parity "
            "should be seen."
        ),
    )


@claim(
    order=(2, 0, 2),
    place="a ripple of the thickness",
    statement="A ripple of half the wavelength of the wrinkles chooses the parity, in proportion "
    "to its amplitude.",
    reading="A ripple with a crest on the mid-line; thick where the wrinkles have their zeros.",
    tolerance="the energies of the two parities differ by a power of its amplitude with an "
    f"exponent within {PROPORTIONAL:g} of 1, at every strain, and the wavelength is within "
    f"{HALF:.0%} of half that of the wrinkles at one of them",
)
def a_ripple_chooses(study: StudyTables) -> Finding:
    """Fit the power of the amplitude."""
    ripple = _ripple(study)
    if len(ripple.sizes) < 2:
        raise MissingError("two amplitudes of one ripple")
    wavelength = float(ripple.kind.split()[1])
    sheet = study.sheet
    strains, waves = sheet.wrinkled("strain", "wavelength_over_width")
    off = min(
        (
            abs(wavelength / (0.5 * wave) - 1.0)
            for e, wave in zip(strains, waves, strict=True)
            if e in ripple.parity
        ),
        default=math.nan,
    )
    exponents, values = {}, []
    for strain, change in ripple.parity.items():
        slope = np.polyfit(np.log(ripple.sizes), np.log(np.abs(change)), 1)[0]
        exponents[strain] = float(slope)
        lower = "antisymmetric" if change[0] < 0.0 else "symmetric"
        values += [
            Value(f"exponent at ε = {strain:g}", float(slope)),
            Value(
                f"difference per amplitude at ε = {strain:g}, {lower} lower",
                per_amplitude(ripple, strain),
            ),
        ]
    holds = off <= HALF and all(abs(n - 1.0) <= PROPORTIONAL for n in exponents.values())
    return Finding(
        verdict_of(bool(holds)),
        (*values, Value("wavelength off half that of the wrinkles by", off)),
        f"A ripple of wavelength {wavelength:g} W changes the energies, over that of bending, by "
        + ", ".join(
            f"{per_amplitude(ripple, e):.2g} per part of the thickness at ε = {e:g} "
            f"(exponent {exponents[e]:.2f})"
            for e in exponents
        )
        + ".",
        sheets=(sheet,),
    )


@claim(
    order=(2, 0, 3),
    place="the perfect sheet",
    statement="The pin against sliding carries nothing in a perfect sheet.",
    tolerance=f"at most {NOTHING:g} of its stiffness times t, at every strain",
)
def the_pin_carries_nothing(study: StudyTables) -> Finding:
    """Look at what the pin carries, in the perfect sheet and at the most."""
    rows = [row for row in rows_of(study) if not math.isnan(row["pin_reaction"])]
    perfect = [row for row in rows if row["imperfection"] == PERFECT]
    if not perfect:
        raise MissingError("the perfect sheet, solved without mirrors")
    most = max(abs(row["pin_reaction"]) for row in perfect)
    where = max(rows, key=lambda row: abs(row["pin_reaction"]))
    largest = abs(where["pin_reaction"])
    softest = min(row["softest_eigenvalue"] for row in perfect)
    return Finding(
        verdict_of(most <= NOTHING),
        (
            Value("largest reaction, perfect sheet", most, digits=2),
            Value("largest of all sheets", largest, digits=2),
            Value("softest eigenvalue, perfect sheet", softest),
        ),
        f"The pin carries {most:.1g} in the perfect sheet, and at the most "
        f"{largest:.1g} ({where['imperfection']}, ε = "
        f"{where['strain']:g})"
        + (
            ", where the pattern is pushed to a place between the two parities."
            if largest > NOTHING
            else ": no imperfection of the study pushes the pattern across."
        ),
    )
