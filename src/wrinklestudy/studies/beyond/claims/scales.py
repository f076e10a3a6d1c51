"""Item 5: wavelength and length of the wrinkles against thickness, strain and length."""

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond.lengths import LONG, Lengths, lengths
from wrinklestudy.studies.beyond.power_law import PowerLaw, line, power_law
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

CLOSE = 0.1  # of the wavelength
HALF, QUARTER = 0.5, -0.25  # exponents of thickness and strain
OFF = 0.05  # of an exponent
SLOPE = 0.1  # of the slope of l over L
NEO_HOOKEAN = "latex-nh"
_SYMBOLS = {"thickness": "t", "strain": "ε", "aspect": "L", "length": "l"}
ENDS = 0.1  # X/L beyond which the highest wrinkle is not in the middle


def of_the_rubber(study: StudyTables) -> Lengths:
    """Return the lengths of all wrinkled sheets of the paper's rubber."""
    return lengths(sheet for sheet in study.sheets if sheet.material == study.wanted[0])


def _ranges(found: Lengths) -> str:
    def span(values: np.ndarray) -> str:
        low, high = values.min(), values.max()
        return f"{low:g}" if low == high else f"{low:g} to {high:g}"

    return (
        f"{len(found.strain)} states, L/W = {span(found.aspect)}, t/W = {span(found.thickness)}, "
        f"ε = {span(found.strain)}"
    )


def wavelength_law(found: Lengths, material: bool) -> PowerLaw:
    """Return lambda as a power law of t/W and eps with a factor of its own for each L/W.

    Raises
    ------
    MissingError
        If there are too few states.
    """
    bases = {"thickness": found.thickness, "strain": found.strain}
    varied = {name: base for name, base in bases.items() if np.ptp(base) > 0.0}
    wavelength = found.material_wavelength if material else found.wavelength
    return power_law(wavelength, found.aspect, **varied)


def _exponents(law: PowerLaw) -> str:
    return ", ".join(f"{_SYMBOLS[name]}: {e.text}" for name, e in law.exponents.items())


def _values(law: PowerLaw, what: str) -> list[Value]:
    return [
        value
        for name, exponent in law.exponents.items()
        for value in (
            Value(f"exponent of {_SYMBOLS[name]}, {what}", exponent.value),
            Value(f"half of its 95% interval, {_SYMBOLS[name]}, {what}", exponent.error, digits=2),
        )
    ]


@claim(
    order=(5, 0, 1),
    place="all wrinkled sheets of the paper's rubber",
    statement="The wavelength goes as the square root of the thickness and falls as the fourth "
    "root of the strain.",
    reading="Exponents of t/W and ε that all lengths share, with a factor for each L/W.",
    tolerance=f"exponents within {OFF:g} of {HALF:g} and {QUARTER:g}, on the deformed sheet",
)
def wavelength_exponents(study: StudyTables) -> Finding:
    """Fit the wavelength on the deformed and on the undeformed sheet."""
    found = of_the_rubber(study)
    deformed, material = (wavelength_law(found, coordinates) for coordinates in (False, True))
    if not {"thickness", "strain"} <= deformed.exponents.keys():
        raise MissingError("wrinkled states of two thicknesses and two strains")
    p, q = (deformed.exponents[name].value for name in ("thickness", "strain"))
    return Finding(
        verdict_of(abs(p - HALF) <= OFF and abs(q - QUARTER) <= OFF),
        (*_values(deformed, "deformed"), *_values(material, "undeformed")),
        f"Over {_ranges(found)}: exponents on the deformed sheet {_exponents(deformed)}; on the "
        f"undeformed sheet {_exponents(material)}. A power law leaves {deformed.scatter:.1%} and "
        f"{material.scatter:.1%} of the wavelength.",
    )


@claim(
    order=(5, 0, 2),
    place="neo-Hookean sheet, L/W = 2.5",
    statement="Published slopes of the wavelength of neo-Hookean sheets are those on the "
    "undeformed sheet.",
    reading="The exponent of the strain is nearer to -1/4 on the undeformed sheet.",
    tolerance=f"on the undeformed sheet within {OFF:g} of {QUARTER:g}, and nearer than on the "
    "deformed one",
)
def coordinates_of_the_wavelength(study: StudyTables) -> Finding:
    """Compare the exponent of the strain in both coordinates."""
    sheets = [sheet for sheet in study.sheets if sheet.material == NEO_HOOKEAN]
    found = lengths(sheets)
    deformed, material = (
        wavelength_law(found, coordinates).exponents["strain"] for coordinates in (False, True)
    )
    off, nearer = abs(material.value - QUARTER), abs(deformed.value - QUARTER)
    return Finding(
        verdict_of(off <= OFF and off < nearer),
        (
            Value("exponent of the strain, deformed", deformed.value),
            Value("half of its 95% interval", deformed.error, digits=2),
            Value("exponent of the strain, undeformed", material.value),
            Value("half of its 95% interval, undeformed", material.error, digits=2),
        ),
        f"Over {_ranges(found)} the exponent is {deformed.text} on the deformed sheet and "
        f"{material.text} on the undeformed one.",
        sheets=tuple(sheets),
    )


@claim(
    order=(5, 0, 3),
    place="all wrinkled sheets of the paper's rubber",
    statement="The Cerda-Mahadevan wavelength with the paper's factor holds at every length and "
    "thickness.",
    reading=f"{theory.WAVELENGTH_FACTOR:g} sqrt(2 π L t) / [3 (1 - ν²) ε]^(1/4) with ν = 1/2.",
    tolerance=f"within {CLOSE:.0%} of the computed wavelength of every state",
)
def scaled_wavelength_everywhere(study: StudyTables) -> Finding:
    """Compare every wavelength with the scaled equation."""
    found = of_the_rubber(study)
    off = 1.0 / found.against_theory - 1.0
    worst = int(np.argmax(np.abs(off)))
    holds = np.abs(off) <= CLOSE
    by_length = {
        aspect: float(off[found.aspect == aspect].mean()) for aspect in np.unique(found.aspect)
    }
    where = ", ".join(f"{mean:+.0%} at L/W = {aspect:g}" for aspect, mean in by_length.items())
    return Finding(
        verdict_of(bool(holds.all())),
        (
            Value("states within the tolerance", int(holds.sum())),
            Value("of", len(holds)),
            Value("largest deviation of the equation", float(off[worst])),
            *(Value(f"mean deviation at L/W = {a:g}", mean) for a, mean in by_length.items()),
        ),
        f"The equation is within {CLOSE:.0%} for {int(holds.sum())} of {len(holds)} states and "
        f"farthest off, {off[worst]:+.0%}, at {found.text(worst)}. On average it is off by "
        f"{where}.",
    )


@claim(
    order=(5, 0, 4),
    place="all wrinkled sheets of the paper's rubber",
    statement="The length of the wrinkles is a fixed fraction of that of the sheet.",
    reading="l ~ L^α W^(1-α), with l the length along the pull over which the wrinkles are above "
    "half of their height, of states that are so from end to end; α = 1 is what the "
    "Cerda-Mahadevan equation takes, and the paper leaves α open.",
    tolerance="1 lies within the 95% interval of α, on the undeformed sheet",
)
def wrinkles_as_long_as_the_sheet(study: StudyTables) -> Finding:
    """Fit the length of the wrinkles against L/W, thickness and strain."""
    found = of_the_rubber(study)
    found = found.where(found.joined)
    bases = {"aspect": found.aspect, "thickness": found.thickness, "strain": found.strain}
    varied = {name: base for name, base in bases.items() if np.ptp(base) > 0.0}
    if "aspect" not in varied or len(found.strain) < len(varied) + 2:
        raise MissingError("wrinkled states of enough lengths L/W")
    material = power_law(found.material_envelope, **varied)
    deformed = power_law(found.envelope, **varied)
    alpha, other = material.exponents["aspect"], deformed.exponents["aspect"]
    share = found.material_envelope / found.aspect
    return Finding(
        verdict_of(alpha.covers(1.0)),
        (*_values(material, "undeformed"), *_values(deformed, "deformed")),
        f"Over {_ranges(found)}: α = {alpha.text} on the undeformed sheet, {other.text} on the "
        f"deformed one; exponents {_exponents(material)}. l is {share.min():.2f} to "
        f"{share.max():.2f} of L. A power law leaves {material.scatter:.1%} of l.",
    )


@claim(
    order=(5, 0, 4, 1),
    place="wrinkled sheets of the paper's rubber that are long",
    statement="The wrinkles of a long sheet end at a fixed distance from the clamps, whatever its "
    "length.",
    reading=f"l = a L - c W over sheets of L/W >= {LONG:g} with wrinkles from end to end, on the "
    "undeformed sheet.",
    tolerance=f"a within {SLOPE:g} of 1, and the line leaves less of l than a power law does",
)
def wrinkles_end_before_the_clamps(study: StudyTables) -> Finding:
    """Fit a line to the length of the wrinkles of long sheets."""
    found = of_the_rubber(study)
    found = found.where(found.joined & (found.aspect >= LONG))
    if len(np.unique(found.aspect)) < 3:
        raise MissingError(f"wrinkled states of three lengths L/W >= {LONG:g}")
    straight = line(found.material_envelope, found.aspect)
    law = power_law(found.material_envelope, aspect=found.aspect)
    slope, end = straight.slope, straight.offset
    return Finding(
        verdict_of(abs(slope.value - 1.0) <= SLOPE and straight.scatter < law.scatter),
        (
            Value("slope a", slope.value),
            Value("half of its 95% interval", slope.error, digits=2),
            Value("c", -end.value),
            Value("half of its 95% interval, c", end.error, digits=2),
            Value("left by the line, over l", straight.scatter, digits=2),
            Value("exponent of a power law", law.exponents["aspect"].value),
            Value("left by the power law, over l", law.scatter, digits=2),
        ),
        f"Over {_ranges(found)}: l/W = ({slope.text}) L/W - ({-end.value:.2f} ± {end.error:.2f}). "
        f"The line leaves {straight.scatter:.1%} of l, a power law (α = "
        f"{law.exponents['aspect'].text}) {law.scatter:.1%}.",
    )


@claim(
    order=(5, 0, 4, 2),
    place="wrinkled sheets of the paper's rubber that are long",
    statement="However long a sheet, its wrinkles run from end to end.",
    tolerance="half-way between the clamps every state is more than half as high as at its highest",
)
def wrinkles_from_end_to_end(study: StudyTables) -> Finding:
    """Look for states with two zones of wrinkles."""
    found = of_the_rubber(study)
    split = found.where(~found.joined)
    if not len(split.strain):
        text = f"All {len(found.strain)} states are."
        return Finding("agree", (Value("states", len(found.strain)),), text)
    low, high = float(split.material_envelope.min()), float(split.material_envelope.max())
    others = found.where(found.joined & np.isin(found.aspect, split.aspect))
    thinner = ""
    if len(others.strain):
        thinner = f"At these lengths the wrinkles of others do ({_ranges(others)})."
    return Finding(
        "disagree",
        (
            Value("states with two zones", len(split.strain)),
            Value("of", len(found.strain)),
            Value("smallest length of both zones over W", low),
            Value("largest length of both zones over W", high),
        ),
        f"{len(split.strain)} states have two zones, one towards each clamp ({_ranges(split)}); "
        f"both together are {low:.2f} to {high:.2f} W long. {thinner}".rstrip(),
    )


@claim(
    order=(5, 0, 5),
    place="all wrinkled sheets of the paper's rubber",
    statement="The wrinkles are highest in the middle of the sheet.",
    tolerance=f"the highest wrinkle of every state within {ENDS:g} L of the middle",
)
def highest_in_the_middle(study: StudyTables) -> Finding:
    """Look where along the pull the highest wrinkle is."""
    found = of_the_rubber(study)
    middle = found.place <= ENDS
    apart = np.unique(found.aspect[~middle])
    where = ", ".join(f"{aspect:g}" for aspect in apart)
    return Finding(
        verdict_of(bool(middle.all())),
        (
            Value("states with the highest wrinkle in the middle", int(middle.sum())),
            Value("of", len(middle)),
            Value("largest |X|/L of a highest wrinkle", float(found.place.max())),
        ),
        f"In {int(middle.sum())} of {len(middle)} states"
        + (f"; not at L/W = {where}, with a zone towards each clamp." if len(apart) else "."),
    )


@claim(
    order=(5, 0, 6),
    place="all wrinkled sheets of the paper's rubber",
    statement="The wavelength follows the length of the wrinkles rather than that of the sheet: "
    "it goes as the square root of l.",
    reading="λ ~ l^(1/2) t^(1/2) ε^(-1/4), the balance of bending and tension over l in place of "
    "L, of states with wrinkles from end to end.",
    tolerance=f"exponent of l within {OFF:g} of {HALF:g}, and a power law of l leaves less than "
    "one of L",
)
def wavelength_follows_the_wrinkles(study: StudyTables) -> Finding:
    """Fit the wavelength with the length of the wrinkles in place of that of the sheet."""
    found = of_the_rubber(study)
    found = found.where(found.joined)
    if len(found.strain) < 5 or np.ptp(found.aspect) == 0.0 or np.ptp(found.thickness) == 0.0:
        raise MissingError("wrinkled states of two lengths and two thicknesses")
    shared = {"thickness": found.thickness, "strain": found.strain}
    of_sheet = power_law(found.wavelength, aspect=found.aspect, **shared)
    of_wrinkles = power_law(found.wavelength, length=found.envelope, **shared)
    exponent = of_wrinkles.exponents["length"]
    holds = abs(exponent.value - HALF) <= OFF and of_wrinkles.scatter < of_sheet.scatter
    return Finding(
        verdict_of(holds),
        (
            *_values(of_wrinkles, "deformed"),
            Value("left by a power law of l, over λ", of_wrinkles.scatter, digits=2),
            Value("left by a power law of L, over λ", of_sheet.scatter, digits=2),
        ),
        f"Over {_ranges(found)}: exponents {_exponents(of_wrinkles)}. That leaves "
        f"{of_wrinkles.scatter:.1%} of the wavelength, a power law of L in place of l "
        f"{of_sheet.scatter:.1%} (exponent of L {of_sheet.exponents['aspect'].text}).",
    )
