"""Claims on the range of strain over which the paper's sheet wrinkles."""

import numpy as np

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.panaitescu2019.solid import SolidEnd, solid_ends
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    Verdict,
    claim,
    listed,
    number_text,
    verdict_across,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables

LEAST_BIRTH = 1e-3  # strain
EARLIER_RANGE = (0.1, 0.23)  # strains up to which wrinkles were reported before
FAR_BEYOND = 1.25  # times the upper end of that range
SLOWER = 1.5  # times
GREATEST_STRAIN = 0.46  # of the images of Fig. 2
PERSISTENCE = 0.4  # strain
ABOUT = 0.1  # of a strain that the text gives roughly

# between the decay strains of the plate, on the mesh of the study, and of the solid
OF_SOLID = 1.0e-3

BENDING = "the bending law"


def ends(sheets: dict[str, SheetStates]) -> dict[str, float]:
    """Return the strain up to which wrinkles persist, by version of the sheet."""
    return {name: sheet.end for name, sheet in sheets.items()}


def shorter(sheet: SheetStates, other: SheetStates, factor: float) -> bool:
    """Return whether wrinkles end below a multiple of the strain up to which those of another do.

    Raises
    ------
    MissingError
        If the other sheet never wrinkles, or neither has a decay strain in the range computed.
    """
    if not other.wrinkles:
        raise MissingError(f"wrinkles of {other.label}")
    if sheet.end == other.end == np.inf:
        raise MissingError(f"a decay strain of {sheet.label} or {other.label}")
    return sheet.end <= factor * other.end


def bending_values(persist: dict[str, float]) -> tuple[Value, ...]:
    """Return these strains as values of a finding."""
    return tuple(Value(f"decay strain, {name}", end) for name, end in persist.items())


@claim(
    order=(3, 0, 1),
    place="Sec. III, Fig. 2",
    statement="The flat sheet is stable up to some strain above zero; there it becomes unstable, "
    "and wrinkles come up.",
    tolerance=f"birth strain (eigenvalue problem) at least {LEAST_BIRTH:g}, and no wrinkled state "
    "below it",
)
def appear_at_finite_strain(study: StudyTables) -> Finding:
    """Find the birth strain and look for wrinkled states below it."""
    sheet = study.sheet
    if not np.isfinite(sheet.birth):
        return Finding("disagree", (Value("birth strain", np.nan),), "The sheet never wrinkles.")
    (strain,) = sheet.wrinkled("strain")
    early = int((strain < sheet.birth).sum())
    return Finding(
        verdict_of(sheet.birth >= LEAST_BIRTH and early == 0),
        (
            Value("birth strain", sheet.birth),
            Value("smallest strain of a wrinkled state", float(strain.min())),
        ),
        f"The flat sheet is unstable from ε = {sheet.birth:.4f} on; {early} wrinkled states lie "
        "below.",
        sheets=(sheet,),
    )


@claim(
    order=(3, 0, 2),
    place="Sec. III, Fig. 2",
    statement="Beyond some larger strain the wrinkles are gone.",
    reading="The flat sheet is stable again beyond a decay strain, and all states there are flat.",
    tolerance="a decay strain exists (eigenvalue problem) and no wrinkled state lies beyond it",
)
def disappear_at_large_strain(study: StudyTables) -> Finding:
    """Find the decay strain and look for wrinkled states beyond it."""
    sheet = study.sheet
    (strain,) = sheet.wrinkled("strain")
    late = int((strain > sheet.decay).sum()) if np.isfinite(sheet.decay) else len(strain)
    return Finding(
        verdict_of(bool(np.isfinite(sheet.decay)) and late == 0),
        (
            Value("decay strain", sheet.end),
            Value("largest strain of a wrinkled state", float(strain.max())),
        ),
        f"Wrinkles persist up to ε = {number_text(sheet.end)}.",
        sheets=(sheet,),
    )


@claim(
    order=(3, 0, 3),
    place="Sec. III",
    statement="The sheet stays wrinkled up to strains much larger than those known from earlier "
    "work, 0.1 to 0.23.",
    reading="The decay strain lies well above 0.23.",
    tolerance=f"decay strain at least {FAR_BEYOND:g} x {EARLIER_RANGE[1]:g}, for every bending law "
    "that was computed",
)
def beyond_earlier_range(study: StudyTables) -> Finding:
    """Compare the decay strain with the largest one of earlier work."""
    sheets = study.sheets_by("bending")
    persist = ends(sheets)
    limit = FAR_BEYOND * EARLIER_RANGE[1]
    verdict, what = verdict_across({name: end >= limit for name, end in persist.items()}, BENDING)
    return Finding(
        verdict,
        bending_values(persist),
        f"Decay strains: {listed(persist)}; the limit is {limit:.3g}.",
        what,
        tuple(sheets.values()),
    )


@claim(
    order=(3, 1, 4),
    place="Sec. III.A, Fig. 4",
    statement="With growing strain the amplitude rises fast and falls slowly.",
    reading="The strain interval from birth to the largest amplitude is much shorter than that "
    "from there to the decay.",
    tolerance=f"the decreasing part is at least {SLOWER:g} times as long",
)
def rise_and_decay(study: StudyTables) -> Finding:
    """Compare the strain intervals of growth and decay."""
    sheet = study.sheet
    birth, decay = sheet.limits()
    peak = sheet.peak_value("strain_at_max_amplitude")
    ratio = (decay - peak) / (peak - birth)
    return Finding(
        verdict_of(ratio >= SLOWER),
        (
            Value("strain from birth to peak", peak - birth),
            Value("strain from peak to decay", decay - peak),
            Value("ratio", ratio),
            Value("largest A/t", sheet.peak_value("max_amplitude_over_thickness")),
        ),
        f"The amplitude grows from ε = {birth:.4f} to {peak:.3f} and falls until {decay:.3f}, over "
        f"{ratio:.2g} times the strain.",
        sheets=(sheet,),
    )


@claim(
    order=(3, 1, 5),
    place="Sec. III.A, Figs. 2 and 4",
    statement="At the largest strain of the experiment hardly any amplitude is left.",
    reading=f"The sheet is flat at ε = {GREATEST_STRAIN:g}, the largest strain of Fig. 2.",
    tolerance=f"decay strain at most {GREATEST_STRAIN:g}, for every bending law that was computed",
)
def flat_at_greatest_strain(study: StudyTables) -> Finding:
    """Compare the decay strain with the greatest strain shown."""
    sheets = study.sheets_by("bending")
    persist = ends(sheets)
    outcomes = {name: 0.0 < end <= GREATEST_STRAIN for name, end in persist.items()}
    verdict, what = verdict_across(outcomes, BENDING)
    return Finding(
        verdict,
        bending_values(persist),
        f"Decay strains: {listed(persist)}.",
        what,
        tuple(sheets.values()),
    )


@claim(
    order=(5, 0, 2),
    place="Sec. V",
    statement="Wrinkles last up to a strain near 0.4.",
    tolerance=f"decay strain within {ABOUT:.0%} of {PERSISTENCE:g}, for every bending law that was "
    "computed",
)
def persist_to_two_fifths(study: StudyTables) -> Finding:
    """Compare the decay strains of all bending laws with 0.4."""
    sheets = study.sheets_by("bending")
    persist = ends(sheets)
    near = {name: abs(end - PERSISTENCE) <= ABOUT * PERSISTENCE for name, end in persist.items()}
    verdict, what = verdict_across(near, BENDING)
    text = f"With the same material wrinkles vanish at ε = {listed(persist)}."
    if verdict == "depends on":
        text += (
            " The membrane energy is the same in each: whether the bending stiffness falls as the "
            "stretched sheet thins, stays, or acts on the reference shape decides the number."
        )
    solid = _solid_decay(study)
    return Finding(
        verdict,
        (*bending_values(persist), *_solid_values(solid)),
        f"{text} {_solid_text(solid, persist)}".rstrip(),
        what,
        tuple(sheets.values()),
    )


@claim(
    order=(3, 3, 3),
    place="Sec. III.C",
    statement="In other Mooney-Rivlin simulations of a sheet of this size wrinkles vanish near a "
    "strain of 0.3; other constants of the material may be the reason.",
    reading="A decay strain of 0.3 is a matter of the constants. Tested with the same constants "
    "under other bending laws, and with the limit C01 = 0 (neo-Hookean) fitted to the same data. A "
    "bending law whose sheet decays elsewhere than the same sheet as a three-dimensional solid "
    "(make verify-solid) is an error of the plate and no reason; the solid is known for the "
    "paper's own constants and size.",
    tolerance=f"agree if C01 = 0 brings the decay strain to {1 + ABOUT:g} x 0.3 or below and no "
    f"other bending law that the solid allows, within {OF_SOLID:g} of its decay strain, brings it "
    f"within {ABOUT:.0%} of 0.3",
)
def around_three_tenths(study: StudyTables) -> Finding:
    """Ask whether constants or the bending law move the decay strain to 0.3."""
    target = 0.3
    sheets = study.sheets_by("bending")
    others = [name for name in sheets if name != study.sheet.bending]
    if not others:
        raise MissingError(f"a sheet like {study.sheet.label} but another bending law")
    limit = study.sheet_with(law="neo-hookean")
    persist = ends(sheets)
    solid = _solid_decay(study)
    near = [name for name in others if abs(persist[name] - target) <= ABOUT * target]
    allowed = [n for n in near if solid is None or abs(persist[n] - solid.strain) <= OF_SOLID]
    by_constants = limit.end <= (1.0 + ABOUT) * target
    verdict: Verdict = "agree" if by_constants else "disagree"
    what = ""
    if by_constants and allowed:
        verdict, what = "depends on", "whether the constants or the bending law differed"
    text = f"The same constants give {listed(persist)}, C01 = 0 gives {limit.end:.3g}."
    if near:
        text += (
            f" The bending law {' or '.join(near)} alone, with the paper's own constants, already "
            "gives a decay strain around 0.3."
        )
    return Finding(
        verdict,
        (
            *bending_values(persist),
            Value("decay strain, neo-Hookean", limit.end),
            *_solid_values(solid),
        ),
        f"{text} {_solid_text(solid, persist)}".rstrip(),
        what,
        (*sheets.values(), limit),
    )


def _solid_decay(study: StudyTables) -> SolidEnd | None:
    """Return the decay of the sheet of the text as a solid; None if that is not known."""
    end = solid_ends()["decay"]
    return end if end.is_of(study.sheet, study.material) else None


def _solid_values(end: SolidEnd | None) -> tuple[Value, ...]:
    if end is None:
        return ()
    return (
        Value("decay strain of the solid", end.strain, digits=4),
        Value("its error bar", end.bar, digits=1),
    )


def _solid_text(end: SolidEnd | None, persist: dict[str, float]) -> str:
    """Return which bending laws the solid bears out, as a sentence; empty without a solid."""
    if end is None:
        return ""
    like = [name for name, strain in persist.items() if abs(strain - end.strain) <= OF_SOLID]
    unlike = [name for name in persist if name not in like]
    plate = f"the plate does so with {' or '.join(like)}" if like else "no plate here does so"
    but = f", not with {' or '.join(unlike)}" if like and unlike else ""
    return f"As a solid the sheet decays at {end.strain:.4f} ± {end.bar:.0e}; {plate}{but}."
