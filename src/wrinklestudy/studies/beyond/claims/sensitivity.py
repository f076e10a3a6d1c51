"""Item 7: how well the rubber must be known, and what a decay strain tells about it."""

import numpy as np

from wrinklestudy.material.result import Fit
from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.beyond.rubber import (
    MEASURED,
    NUMBERS,
    Curves,
    Interval,
    curves,
    interval,
    ratio,
    sampled_shares,
    share,
)
from wrinklestudy.studies.beyond.selections import CHECK, POISSON, RATIO, named
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

BIRTH_SPREAD = 0.02  # of the birth strain
CHECKED = 0.01  # of birth, decay and largest A/t
RELATIVE = 0.1  # of C01/C10
KNOWN = 0.01  # of the decay strain, absolute
FACTOR = 2.0  # within which C01/C10 would be known
UNIAXIAL, ALL_MODES = "treloar-uniaxial", "treloar"


def size_of(study: StudyTables) -> list[SheetStates]:
    """Return the sheets of the size of the figure sheet."""
    _, aspect, thickness = study.wanted
    return [s for s in study.sheets if (s.aspect, s.thickness) == (aspect, thickness)]


def rubber_curves(study: StudyTables) -> Curves:
    """Return the curves through the rubbers of given ratios and that of the paper."""
    sheets = named(size_of(study), RATIO)
    materials = [study.given[sheet.material] for sheet in sheets]
    own = study.material.fit.material()
    return curves([*sheets, study.sheet], [*materials, own])


def fit_of(study: StudyTables, name: str) -> Fit:
    """Return a fit of the study.

    Raises
    ------
    MissingError
        If there is none of that name.
    """
    for material in study.materials:
        if material.name == name:
            return material.fit
    raise MissingError(f"the fit {name}")


def _poisson(study: StudyTables) -> list[tuple[float, SheetStates]]:
    sheets = named(size_of(study), POISSON)
    if not sheets:
        raise MissingError("a sheet with a Poisson's ratio of its own")
    return sorted(
        ((study.given[sheet.material].law.poisson, sheet) for sheet in sheets),
        key=lambda pair: pair[0],
    )


@claim(
    order=(7, 0, 1),
    place="given ratios C01/C10",
    statement="The larger C01/C10, the later the wrinkles decay.",
    tolerance="the decay strain rises from each computed ratio to the next",
)
def later_decay_with_more_c01(study: StudyTables) -> Finding:
    """Compare the decay strains of neighbouring ratios."""
    found = rubber_curves(study)
    decay = found.values["decay strain"]
    fine = np.linspace(found.shares[0], found.shares[-1], 2001)
    curve = found.at("decay strain", fine)
    top = int(np.argmax(curve))
    rises = bool((np.diff(decay) > 0.0).all())
    first, last = ratio(found.shares[[0, -1]])
    return Finding(
        verdict_of(rises),
        (
            Value(f"decay strain at C01/C10 = {first:g}", float(decay[0]), digits=4),
            Value(f"decay strain at C01/C10 = {last:g}", float(decay[-1]), digits=4),
            Value("largest decay strain", float(curve[top]), digits=4),
            Value("at C01/C10", float(ratio(fine[top]))),
        ),
        f"The decay strain rises from {decay[0]:.4f} at C01/C10 = {first:g} to {curve[top]:.4f} at "
        f"{float(ratio(fine[top])):.2g} and is {decay[-1]:.4f} at {last:g}: "
        + (
            "it rises throughout."
            if rises
            else "beyond the maximum a stiffer second term ends the wrinkles earlier again, so "
            "that one decay strain can belong to two ratios."
        ),
    )


@claim(
    order=(7, 0, 2),
    place="given ratios C01/C10",
    statement="Birth tells nothing about the ratio C01/C10.",
    tolerance=f"the birth strains of all ratios agree to {BIRTH_SPREAD:.0%}",
)
def birth_without_the_ratio(study: StudyTables) -> Finding:
    """Compare the spreads of birth, decay and largest amplitude."""
    found = rubber_curves(study)
    spread = {
        name: float(np.ptp(values) / np.mean(values)) for name, values in found.values.items()
    }
    first, last = ratio(found.shares[[0, -1]])
    return Finding(
        verdict_of(spread["birth strain"] <= BIRTH_SPREAD),
        tuple(Value(f"range of the {name} over its mean", spread[name]) for name in NUMBERS),
        f"From C01/C10 = {first:g} to {last:g} the birth strain varies by "
        f"{spread['birth strain']:.1%}, the decay strain by {spread['decay strain']:.0%} and the "
        f"largest A/t by {spread['largest A/t']:.0%}.",
    )


@claim(
    order=(7, 0, 3),
    place="ratios left out of the curves",
    statement="Curves through few computed ratios give birth, decay and height at any other.",
    reading="Cubic splines over C01/(C10 + C01), against sheets that were solved at other ratios.",
    tolerance=f"each number of each sheet left out within {CHECKED:.0%}",
)
def curves_hold_between(study: StudyTables) -> Finding:
    """Compare the curves with direct solutions at ratios that they do not go through."""
    found = rubber_curves(study)
    sheets = named(size_of(study), CHECK)
    if not sheets:
        raise MissingError("a sheet at a ratio C01/C10 that is left out of the curves")
    worst = dict.fromkeys(NUMBERS, 0.0)
    for sheet in sheets:
        at = share(study.given[sheet.material])
        for name, column in NUMBERS.items():
            off = abs(float(found.at(name, at)) / sheet.peak_value(column) - 1.0)
            worst[name] = max(worst[name], off)
    ratios = ", ".join(f"{float(ratio(share(study.given[s.material]))):g}" for s in sheets)
    return Finding(
        verdict_of(max(worst.values()) <= CHECKED),
        tuple(Value(f"largest error of the {name}", off) for name, off in worst.items()),
        f"Against direct solutions at C01/C10 = {ratios} the curves are off by at most "
        + ", ".join(f"{off:.2%} ({name})" for name, off in worst.items())
        + ".",
        sheets=tuple(sheets),
    )


def carried(study: StudyTables, name: str) -> dict[str, Interval]:
    """Return what a fit says of C01/C10 and of the numbers of the sheet, its error included."""
    found, shares = rubber_curves(study), sampled_shares(fit_of(study, name))
    known = {"C01/C10": interval(ratio(shares))}
    return known | {number: interval(found.at(number, shares)) for number in NUMBERS}


@claim(
    order=(7, 0, 4),
    place="Treloar's rubber, stretch up to 1.65",
    statement="A uniaxial test is enough to say when the wrinkles decay.",
    reading="The decay strain from constants drawn with the covariance of the uniaxial fit, "
    "against that of the fit to uniaxial, equibiaxial and pure shear data.",
    tolerance=f"the 95% interval of the uniaxial fit is at most ±{KNOWN:g} wide and holds the "
    "decay strain of the fit to all modes",
)
def uniaxial_fit_is_enough(study: StudyTables) -> Finding:
    """Carry the covariance of two fits to the same rubber through to the decay strain."""
    one, every = carried(study, UNIAXIAL), carried(study, ALL_MODES)
    decay, other = one["decay strain"], every["decay strain"]
    half = 0.5 * (decay.high - decay.low)
    holds = half <= KNOWN and decay.covers(other.median)
    return Finding(
        verdict_of(holds),
        (
            Value("C01/C10, uniaxial", one["C01/C10"].median),
            Value("C01/C10, all modes", every["C01/C10"].median),
            Value("decay strain, uniaxial", decay.median, digits=4),
            Value("half of its 95% interval", half, digits=2),
            Value("decay strain, all modes", other.median, digits=4),
            Value("half of its 95% interval, all modes", 0.5 * (other.high - other.low), digits=2),
        ),
        f"The uniaxial fit gives C01/C10 = {one['C01/C10'].text()} and a decay strain of "
        f"{decay.text(4)}; all modes together give {every['C01/C10'].text()} and "
        f"{other.text(4)}. The two fits differ by {abs(decay.median - other.median):.3f} in the "
        f"decay strain, the half-width of the uniaxial interval is {half:.4f}: what is not known "
        "is not the scatter of the points but whether the law holds in other deformations than "
        "that tested.",
    )


@claim(
    order=(7, 0, 3, 1),
    place="given ratios C01/C10",
    statement=f"A ratio C01/C10 known to {RELATIVE:.0%} gives the decay strain to {KNOWN:g}.",
    tolerance="at every computed ratio",
)
def ratio_to_ten_per_cent(study: StudyTables) -> Finding:
    """Find how much the decay strain changes with the ratio."""
    found = rubber_curves(study)
    shares = np.linspace(found.shares[0], found.shares[-1], 2001)[1:]
    # a small change of r changes s = r / (1 + r) by s (1 - s) d(ln r)
    step = 0.5 * RELATIVE * shares * (1.0 - shares)
    inside = shares + step <= found.shares[-1]
    shares, step = shares[inside], step[inside]
    low, high = (found.at("decay strain", shares + sign * step) for sign in (-1.0, 1.0))
    change = np.abs(high - low)
    worst = int(np.argmax(change))
    at, most = float(ratio(shares[worst])), float(change[worst])
    needed = KNOWN / most * RELATIVE
    return Finding(
        verdict_of(most <= KNOWN),
        (
            Value("largest change of the decay strain", most),
            Value("at C01/C10", at),
            Value(f"error of C01/C10 that changes it by {KNOWN:g} there", needed, digits=2),
        ),
        f"An error of {RELATIVE:.0%} changes the decay strain most at C01/C10 = {at:.2g}, by "
        f"{most:.4f}; there the ratio must be known to {needed:.0%} for {KNOWN:g}. At large ratios "
        "the decay strain hardly depends on it.",
    )


@claim(
    order=(7, 0, 5),
    place="the paper's sheet",
    statement="A measured decay strain tells the ratio C01/C10.",
    reading=f"The computed decay strain of the paper's sheet, taken as measured to ±{MEASURED:g} "
    "(the distance of the strains of such an experiment; the paper gives no error of its own).",
    tolerance=f"the ratios that agree with it lie within a factor of {FACTOR:g} of each other",
)
def decay_tells_the_ratio(study: StudyTables) -> Finding:
    """Invert the curve of the decay strain."""
    found, decay = rubber_curves(study), study.sheet.peak_value("decay_strain")
    shares = found.shares_with("decay strain", decay - MEASURED, decay + MEASURED)
    low, high = (float(end) for end in ratio(shares[[0, -1]]))
    open_end = bool(shares[-1] >= found.shares[-1])
    true = float(ratio(share(study.material.fit.material())))
    soft = found.at("decay strain", 0.0) if found.shares[0] == 0.0 else np.nan
    bound = f"{low:.2f} upward" if open_end else f"{low:.2f} to {high:.2f}"
    return Finding(
        verdict_of(not open_end and high <= FACTOR * low),
        (
            Value("decay strain", decay, digits=4),
            Value("smallest C01/C10 that agrees", low),
            *([] if open_end else [Value("largest C01/C10 that agrees", high)]),
            Value("C01/C10 of the sheet", true, digits=4),
        ),
        f"A decay strain of {decay:.3f} ± {MEASURED:g} belongs to every ratio from {bound} "
        f"(computed up to {float(ratio(found.shares[-1])):g}); the sheet has {true:.3f}. It does "
        f"exclude a neo-Hookean rubber, whose wrinkles decay at {float(soft):.3f}.",
        sheets=(study.sheet,),
    )


@claim(
    order=(7, 0, 6),
    place="Saint Venant-Kirchhoff sheets",
    statement="A sheet wrinkles at every positive Poisson's ratio, more the larger it is.",
    tolerance="every computed sheet with ν > 0 has a birth strain, and the largest critical "
    "thickness rises with ν",
)
def wrinkles_at_every_poisson_ratio(study: StudyTables) -> Finding:
    """Look for birth and decay of the SVK sheets."""
    pairs = _poisson(study)
    flat = [nu for nu, sheet in pairs if not sheet.wrinkles]
    critical = [sheet.max_critical_thickness for _, sheet in pairs]
    wrinkled = [(nu, sheet) for nu, sheet in pairs if sheet.wrinkles]
    holds = all(nu == 0.0 for nu in flat) and bool((np.diff(np.nan_to_num(critical)) > 0.0).all())
    values = [
        Value(f"{what} strain at ν = {nu:g}", number, digits=4)
        for nu, sheet in wrinkled
        for what, number in (("birth", sheet.birth), ("decay", sheet.decay))
    ]
    ends = "; ".join(
        f"{sheet.birth:.3f} to {sheet.decay:.3f} at ν = {nu:g}" for nu, sheet in wrinkled
    )
    none = f" At ν = {', '.join(f'{nu:g}' for nu in flat)} it stays flat." if flat else ""
    return Finding(
        verdict_of(holds),
        tuple(values),
        f"This sheet (t/W = {pairs[0][1].thickness:g}) is wrinkled from {ends}.{none}",
        sheets=tuple(sheet for _, sheet in pairs),
    )
