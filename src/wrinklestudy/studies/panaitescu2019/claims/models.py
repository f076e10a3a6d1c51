"""Claims that compare the Mooney-Rivlin sheet with neo-Hookean and Saint Venant-Kirchhoff ones."""

import numpy as np

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.panaitescu2019.claims.persistence import BENDING, ends, shorter
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    claim,
    listed,
    number_text,
    verdict_across,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables

ACCURACY = 0.005  # of the largest amplitude, error of the mesh
SHORTER = 0.9  # of the decay strain
MUCH_LOWER = 0.5  # of the decay strain
STRONG = 0.2  # of the largest decay strain

_AMPLITUDE = "amplitude_over_thickness"
NEO_HOOKEAN, SVK = "neo-hookean", "svk"


@claim(
    order=(3, 3, 1),
    place="Sec. III.C, Fig. 5a",
    statement="Measured amplitudes are larger throughout than those of neo-Hookean simulations.",
    reading="A neo-Hookean sheet fitted to the same data has the smaller amplitude at every "
    "strain.",
    tolerance=f"at no strain larger by more than {ACCURACY:.1%} of the largest amplitude",
)
def neo_hookean_smaller(study: StudyTables) -> Finding:
    """Compare the amplitudes at the strains of the wrinkled states of the paper's sheet."""
    sheet, other = study.sheet, study.sheet_with(law=NEO_HOOKEAN)
    strain, mine = sheet.wrinkled("strain", _AMPLITUDE)
    common = [k for k, eps in enumerate(strain) if _has(other, eps)]
    if not common:
        raise MissingError(f"an amplitude at the strains of {sheet.label}, of {other.label}")
    of_other = np.array([other.at(_AMPLITUDE, eps) for eps in strain[common]])
    excess = float((of_other - mine[common]).max() / mine.max())
    largest = sheet.peak_value("max_amplitude_over_thickness")
    lower = other.peak_value("max_amplitude_over_thickness")
    return Finding(
        verdict_of(excess <= ACCURACY),
        (
            Value("largest A/t", largest),
            Value("largest A/t, neo-Hookean", lower),
            Value("largest excess of the neo-Hookean amplitude over the peak", excess),
            Value("strains compared", len(common)),
        ),
        f"The largest amplitudes are {largest:.3g} t and {lower:.3g} t (neo-Hookean); at the "
        f"strain where the neo-Hookean amplitude does best it differs by {excess:+.1%} of the "
        "former.",
        sheets=(sheet, other),
    )


def _has(sheet: SheetStates, strain: float) -> bool:
    try:
        sheet.at(_AMPLITUDE, strain)
    except MissingError:
        return False
    return True


@claim(
    order=(3, 3, 2),
    place="Sec. III.C, Fig. 5a",
    statement="Measured wrinkles last up to a clearly larger strain than those of neo-Hookean "
    "simulations.",
    reading="A neo-Hookean sheet fitted to the same data has the lower decay strain.",
    tolerance=f"at most {SHORTER:g} of the decay strain",
)
def neo_hookean_shorter(study: StudyTables) -> Finding:
    """Compare the decay strains."""
    sheet, other = study.sheet, study.sheet_with(law=NEO_HOOKEAN)
    if not other.wrinkles:
        raise MissingError(f"wrinkles of {other.label}")
    return Finding(
        verdict_of(shorter(other, sheet, SHORTER)),
        (Value("decay strain", sheet.end), Value("decay strain, neo-Hookean", other.end)),
        f"Wrinkles vanish at ε = {number_text(sheet.end)}, neo-Hookean at "
        f"{number_text(other.end)}.",
        sheets=(sheet, other),
    )


@claim(
    order=(3, 3, 4),
    place="Sec. III.C",
    statement="How far wrinkles last depends strongly on the nonlinearity of the material.",
    reading="Laws with about the same initial response have very different decay strains.",
    tolerance=f"decay strains of the laws spread over at least {STRONG:.0%} of the largest",
)
def material_nonlinearity(study: StudyTables) -> Finding:
    """Compare the decay strains of all laws under one bending law."""
    sheets = study.sheets_by("law")
    if len(sheets) < 2:
        raise MissingError(f"a sheet like {study.sheet.label} but another law")
    persist = ends(sheets)
    low, high = min(persist.values()), max(persist.values())
    if low == np.inf or high == 0.0:
        raise MissingError(f"a decay strain of any sheet like {study.sheet.label}")
    spread = 1.0 - low / high
    return Finding(
        verdict_of(spread >= STRONG),
        (
            *(Value(f"decay strain, {name}", end) for name, end in persist.items()),
            Value("spread over the largest", spread),
        ),
        f"Decay strains: {listed(persist)}.",
        sheets=tuple(sheets.values()),
    )


@claim(
    order=(3, 3, 5),
    place="Sec. III.C",
    statement="With Saint Venant-Kirchhoff wrinkles vanish as well, at far smaller strains.",
    reading="A Saint Venant-Kirchhoff sheet with the initial modulus of the data wrinkles and "
    "has a much lower decay strain under the same bending law.",
    tolerance=f"wrinkles, and a decay strain of at most {MUCH_LOWER:g} of that of the paper's "
    "sheet, for every bending law that was computed",
)
def svk_much_lower(study: StudyTables) -> Finding:
    """Compare the decay strains, each bending law by itself."""
    sheets, svk = study.sheets_by("bending"), study.sheets_by("bending", law=SVK)
    if not svk:
        raise MissingError(f"a sheet like {study.sheet.label} but law = {SVK}")
    persist = ends(svk)
    own = {name: sheets.get(name, study.sheet) for name in svk}
    lower = {name: svk[name].wrinkles and shorter(svk[name], own[name], MUCH_LOWER) for name in svk}
    verdict, what = verdict_across(lower, BENDING)
    return Finding(
        verdict,
        (
            *(Value(f"decay strain, SVK, {name}", end) for name, end in persist.items()),
            *(Value(f"decay strain, {s.law}, {s.bending}", s.end) for s in _distinct(own)),
        ),
        f"SVK decays at {listed(persist)}. {_holes(svk)}".strip(),
        what,
        (*svk.values(), *_distinct(own)),
    )


def _distinct(sheets: dict[str, SheetStates]) -> list[SheetStates]:
    return list({id(sheet): sheet for sheet in sheets.values()}.values())


def _holes(sheets: dict[str, SheetStates]) -> str:
    """Return a sentence on the states that did not converge."""
    for name, sheet in sheets.items():
        holes = [k for k, status in enumerate(sheet.status) if status == "not-converged"]
        if holes:
            first = holes[0]
            strain, reason = sheet.columns["strain"][first], sheet.reasons[first]
            return (
                f"With {name} {len(holes)} states from ε = {strain:g} on did not converge "
                f"({reason})."
            )
    return ""


@claim(
    order=(5, 0, 1),
    place="Secs. I and V, abstract",
    statement="Wrinkles last to larger strains than with Saint Venant-Kirchhoff or neo-Hookean.",
    reading="Of the three laws Mooney-Rivlin has the largest decay strain.",
    tolerance=f"the others have at most {SHORTER:g} of it",
)
def mooney_rivlin_highest(study: StudyTables) -> Finding:
    """Compare the decay strain with those of both other laws."""
    sheet = study.sheet
    others = {law: study.sheet_with(law=law) for law in (NEO_HOOKEAN, SVK)}
    persist = ends(others)
    outcomes = {law: shorter(other, sheet, SHORTER) for law, other in others.items()}
    verdict, what = verdict_across(outcomes, "the law")
    return Finding(
        verdict,
        (
            Value(f"decay strain, {sheet.law}", sheet.end),
            *(Value(f"decay strain, {law}", end) for law, end in persist.items()),
        ),
        f"Decay strain {number_text(sheet.end)} ({sheet.law}) against {listed(persist)}.",
        what,
        (sheet, *others.values()),
    )
