"""Claims on the wavelength, and on the amplitude law of Cerda and Mahadevan."""

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.claims.finding import Finding, Value, claim, largest, verdict_of
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.typing import Array

CLOSE = 0.1  # of the wavelength
NEAR_THRESHOLD = 2.0  # times the birth strain
WORSE = 2.0  # times the usual discrepancy
INTERVAL = (0.09, 0.17)  # lambda/W, as read
PRINTED = (0.17, 0.9)  # lambda/W, as printed, in increasing order
EDGE = 0.05  # of the ends of the interval
NOT_ZERO = 0.1  # smallest exponent that counts
POWER_LAW = 0.05  # of the wavelength
SMALL_SLOPE = 0.1
SMALL_STRAIN = 0.2

_WAVELENGTH = "wavelength_over_width"


def _against_theory(study: StudyTables) -> tuple[Array, Array]:
    """Return the strains of the wrinkled states and lambda over the unscaled CM wavelength."""
    sheet = study.sheet
    strain, wavelength = sheet.wrinkled("strain", _WAVELENGTH)
    return strain, wavelength / theory.cm_wavelength(strain, sheet.aspect, sheet.thickness)


@claim(
    order=(4, 2, 1),
    place="Sec. IV.B, Fig. 5b",
    statement="The wavelength falls with strain as the Cerda-Mahadevan equation has it for ν = "
    "1/2, with a factor of 0.8.",
    reading="λ = 0.8 sqrt(2 π L t) / [3 (1 - ν²) ε]^(1/4). (The text puts the factor on the "
    "data; taken literally, that would be a factor of 1.25 on the equation.)",
    tolerance=f"within {CLOSE:.0%} of the computed wavelength at every wrinkled strain",
)
def scaled_wavelength(study: StudyTables) -> Finding:
    """Compare the wavelengths with the scaled Cerda-Mahadevan wavelength."""
    strain, ratio = _against_theory(study)
    off = np.abs(theory.WAVELENGTH_FACTOR / ratio - 1.0)
    best = float(1.0 / np.mean(1.0 / ratio))
    worst, where = largest("largest deviation", off, strain)
    return Finding(
        verdict_of(worst.number <= CLOSE),
        (
            worst,
            where,
            Value("mean deviation", float(off.mean())),
            Value("factor that fits best", best),
        ),
        f"The equation with 0.8 is off by up to {worst.number:.1%}, at ε = {where.number:g}; the "
        f"ratio of λ to the equation goes from {ratio[0]:.3f} at ε = {strain[0]:g} to "
        f"{ratio[-1]:.3f} at ε = {strain[-1]:g}, and {best:.3f} fits best.",
        sheets=(study.sheet,),
    )


@claim(
    order=(4, 2, 2),
    place="Sec. IV.B, Fig. 5b",
    statement="Close to the threshold, theory and data differ more, as expected.",
    reading="Near the birth strain the computed wavelength is farther from 0.8 times the "
    "equation than elsewhere.",
    tolerance=f"the deviation at the wrinkled state next to birth (below {NEAR_THRESHOLD:g} times "
    f"the birth strain) is at least {WORSE:g} times the median of all",
)
def discrepancy_near_threshold(study: StudyTables) -> Finding:
    """Compare the deviation next to birth with the usual one."""
    strain, ratio = _against_theory(study)
    if not strain[0] <= NEAR_THRESHOLD * study.sheet.birth:
        raise MissingError(
            f"a wrinkled state below {NEAR_THRESHOLD:g} times the birth strain of "
            f"{study.sheet.label}"
        )
    off = np.abs(theory.WAVELENGTH_FACTOR / ratio - 1.0)
    usual = float(np.median(off))
    worst, where = largest("largest deviation", off, strain)
    return Finding(
        verdict_of(float(off[0]) >= WORSE * usual),
        (
            Value(f"deviation next to birth, ε = {strain[0]:g}", float(off[0])),
            Value("median deviation", usual),
            worst,
            where,
        ),
        f"At ε = {strain[0]:g}, {strain[0] / study.sheet.birth:.2g} times the birth strain, the "
        f"deviation is {off[0]:.1%}; the median is {usual:.1%}, and the largest, "
        f"{worst.number:.1%}, lies at ε = {where.number:g}.",
        sheets=(study.sheet,),
    )


@claim(
    order=(4, 2, 3),
    place="Sec. IV.B, Fig. 5b",
    statement="λ/W lies between 0.9 and 0.17.",
    reading=f"{INTERVAL[0]:g} to {INTERVAL[1]:g}: as printed the first number is larger than the "
    "second.",
    tolerance=f"every wrinkled state within {INTERVAL[0]:g} to {INTERVAL[1]:g}, ends widened by "
    f"{EDGE:.0%}",
)
def wavelength_interval(study: StudyTables) -> Finding:
    """Compare the range of the wavelengths with the interval, as read and as printed."""
    strain, wavelength = study.sheet.wrinkled("strain", _WAVELENGTH)
    low, high = float(wavelength.min()), float(wavelength.max())
    inside = INTERVAL[0] * (1.0 - EDGE) <= low and high <= INTERVAL[1] * (1.0 + EDGE)
    printed = int(((wavelength >= PRINTED[0]) & (wavelength <= PRINTED[1])).sum())
    return Finding(
        verdict_of(inside),
        (
            Value("smallest λ/W", low),
            Value("largest λ/W", high),
            Value("states inside the interval as printed", printed),
        ),
        f"λ/W goes from {wavelength[0]:.3f} at ε = {strain[0]:g} to {wavelength[-1]:.3f} at "
        f"ε = {strain[-1]:g}. Between {PRINTED[0]:g} and {PRINTED[1]:g}, as printed, lie {printed} "
        f"of {len(wavelength)} states.",
        sheets=(study.sheet,),
    )


@claim(
    order=(4, 2, 4),
    place="Sec. IV.B",
    statement="The length ℓ that sets the wavelength may go like L^α W^(1-α) with α other than "
    "zero; sheets of many L/W would tell.",
    reading="With λ ~ (B ℓ²/T)^(1/4) the wavelength goes like L^(α/2) at one strain and "
    "thickness; Cerda and Mahadevan have α = 1. Tested on the L/W series.",
    tolerance=f"a power law describes λ within {POWER_LAW:.0%} and |α| is at least {NOT_ZERO:g}",
)
def length_exponent(study: StudyTables) -> Finding:
    """Fit the power of L to the wavelengths of the L/W series at the strain most of them share."""
    sheets = [sheet for sheet in study.sheets_by("aspect").values() if "wrinkled" in sheet.status]
    shared: dict[float, dict[float, float]] = {}
    for sheet in sheets:
        for eps, value in zip(*sheet.wrinkled("strain", _WAVELENGTH), strict=True):
            shared.setdefault(float(eps), {})[sheet.aspect] = float(value)
    strain = max(shared, key=lambda eps: (len(shared[eps]), -eps), default=0.0)
    if len(shared.get(strain, {})) < 3:
        raise MissingError(
            f"three sheets like {study.sheet.label} but other L/W, wrinkled at one strain"
        )
    aspect, wavelength = (np.log(list(part)) for part in zip(*shared[strain].items(), strict=True))
    slope, start = np.polyfit(aspect, wavelength, 1)
    misfit = float(np.abs(np.exp(start + slope * aspect - wavelength) - 1.0).max())
    alpha = 2.0 * float(slope)
    low, high = float(np.exp(aspect.min())), float(np.exp(aspect.max()))
    return Finding(
        verdict_of(misfit <= POWER_LAW and abs(alpha) >= NOT_ZERO),
        (
            Value("α", alpha),
            Value("largest deviation from the power law", misfit),
            Value("at strain", strain),
            Value("sheets", len(aspect)),
        ),
        f"From L/W = {low:g} to {high:g} at ε = {strain:g}, λ goes like L^{slope:.2f}, so that "
        f"α = {alpha:.2f}; α = 1 would be the Cerda-Mahadevan equation.",
        sheets=tuple(sheets),
    )


@claim(
    order=(4, 1, 2),
    place="Sec. IV.A",
    statement="The theory assumes of the wrinkles nothing but a small slope, A/λ far below 1.",
    reading="The amplitude is a small part of the wavelength at every strain.",
    tolerance=f"A/λ at most {SMALL_SLOPE:g}",
)
def small_slope(study: StudyTables) -> Finding:
    """Compute the largest ratio of amplitude to wavelength."""
    sheet = study.sheet
    strain, height, wavelength = sheet.wrinkled("strain", "amplitude_over_thickness", _WAVELENGTH)
    worst, where = largest("largest A/λ", height * sheet.thickness / wavelength, strain)
    return Finding(
        verdict_of(worst.number <= SMALL_SLOPE),
        (worst, where),
        f"A/λ reaches {worst.number:.3g}, at ε = {where.number:g}.",
        sheets=(sheet,),
    )


@claim(
    order=(4, 3, 1),
    place="Sec. IV.C",
    statement="Measured and computed amplitudes fall from small strains on, where Cerda and "
    "Mahadevan's grows like ε^(1/4).",
    reading="The amplitude has its maximum at a small strain and falls from there on.",
    tolerance=f"the largest A/t lies at a strain of at most {SMALL_STRAIN:g}, and ln A against ln "
    "ε has a negative slope beyond it",
)
def amplitude_decreases(study: StudyTables) -> Finding:
    """Find the strain of the largest amplitude and the power of the strain beyond it."""
    sheet = study.sheet
    peak = sheet.peak_value("strain_at_max_amplitude")
    strain, height = sheet.wrinkled("strain", "amplitude_over_thickness", above=peak)
    if len(strain) < 2:
        raise MissingError(f"two wrinkled states beyond the largest amplitude, of {sheet.label}")
    power = float(np.polyfit(np.log(strain), np.log(height), 1)[0])
    return Finding(
        verdict_of(peak <= SMALL_STRAIN and power < 0.0),
        (
            Value("strain of the largest A/t", peak),
            Value("power of ε beyond it", power),
            Value("power of ε of Cerda and Mahadevan", 0.25),
        ),
        f"A/t is largest at ε = {peak:.3f}; beyond it A goes like ε^{power:.2g} on average.",
        sheets=(sheet,),
    )
