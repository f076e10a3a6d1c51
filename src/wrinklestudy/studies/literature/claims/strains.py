"""Section 1: at which strains wrinkles come, are highest, and go."""

import math
from dataclasses import replace

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.literature import sources
from wrinklestudy.studies.literature.statement import (
    Published,
    bending_values,
    sheet_of,
    statement,
    under_each_bending_law,
)
from wrinklestudy.studies.panaitescu2019.claims.persistence import ABOUT, BENDING
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    listed,
    verdict_across,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables

THIN = 1.0e-3  # t/W of all sheets but where it is said otherwise
LONG = 2.5  # L/W of Nayyar et al.
FU_DECAY = 0.3
SOFT_RANGE = 0.3  # strain up to which soft films are said to wrinkle
PEAK, NEAR = 0.1, 0.02  # strain of the highest wrinkles of polyethylene, and its rounding
SENSITIVE = 2.0  # times, while the thickness doubles
_HEIGHT = "max_amplitude_over_thickness"
NAYYAR = Published(
    source=sources.NAYYAR_2011,
    where="abstract",
    reliability="B",
    said="",
    law="neo-Hookean, μ = 6 MPa",
    aspect="2.5",
    thickness="t/W = 1e-3",
    clamps="one end fixed, one displaced",
)
_POLYETHYLENE = Published(
    source=sources.NAYYAR_2014,
    where="abstract",
    reliability="B",
    said="",
    law="polyethylene, an experiment",
)


def birth_and_decay(sheets: dict[str, SheetStates]) -> tuple[Value, ...]:
    """Return both strains of each version of a sheet as values."""
    return (
        *bending_values("birth strain", {name: sheet.birth for name, sheet in sheets.items()}),
        *bending_values("decay strain", {name: sheet.end for name, sheet in sheets.items()}),
    )


@statement(
    Published(
        source=sources.FU_2019,
        where="as Panaitescu et al. 2019, Sec. III.C, quote it",
        reliability="C",
        said="decay near 0.3",
        law="Mooney-Rivlin, C10 = 10 C01, plate of Föppl and von Kármán at finite strain",
        aspect="2",
        thickness="t/W = 1e-3",
    ),
    order=(1, 0, 1),
    says=f"wrinkles of a sheet with C10 = 10 C01 vanish near a strain of {FU_DECAY:g}.",
    tolerance=f"decay strain within {ABOUT:.0%} of {FU_DECAY:g}, the number being rounded to one "
    "digit, for every bending law",
)
def decay_of_ten_to_one(study: StudyTables) -> Finding:
    """Compare the decay strain under each bending law."""
    sheets = under_each_bending_law(study, "mr-010", 2.0, THIN)
    ends = {name: sheet.end for name, sheet in sheets.items()}
    near = {name: abs(end - FU_DECAY) <= ABOUT * FU_DECAY for name, end in ends.items()}
    verdict, what = verdict_across(near, BENDING)
    return Finding(
        verdict,
        birth_and_decay(sheets),
        f"Decay strains {listed(ends, 4)}. Their plate is that of fvk.",
        what,
        tuple(sheets.values()),
    )


@statement(
    replace(NAYYAR, said="amplitude rises, falls, and the sheet is flat again"),
    order=(1, 0, 2),
    says="with growing strain wrinkles grow, become lower and vanish at a moderately large strain.",
    tolerance="birth and decay strain, and the largest amplitude between them, for every bending "
    "law",
)
def rise_and_fall(study: StudyTables) -> Finding:
    """Look for birth, largest amplitude and decay."""
    sheets = under_each_bending_law(study, "nayyar", LONG, THIN)
    peaks = {name: sheet.peak["strain_at_max_amplitude"] for name, sheet in sheets.items()}
    heights = {name: sheet.peak[_HEIGHT] for name, sheet in sheets.items()}
    holds = {
        name: math.isfinite(sheet.decay) and sheet.birth < peaks[name] < sheet.decay
        for name, sheet in sheets.items()
    }
    verdict, what = verdict_across(holds, BENDING)
    return Finding(
        verdict,
        (
            *birth_and_decay(sheets),
            *bending_values("strain of the largest A/t", peaks),
            *bending_values("largest A/t", heights),
        ),
        f"Wrinkles vanish at {listed({name: sheet.end for name, sheet in sheets.items()}, 4)}; A/t "
        f"is largest, {listed(heights)}, at {listed(peaks)}.",
        what,
        tuple(sheets.values()),
    )


@statement(
    replace(NAYYAR, said="critical condition depends sensitively on t", thickness="varied"),
    order=(1, 0, 3),
    says="at which strain wrinkles come depends sensitively on the thickness.",
    reading=f"Half of the thickness lowers the birth strain {SENSITIVE:g} times or more.",
    tolerance=f"birth strain at t/W = {THIN:g} at least {SENSITIVE:g} times that at half of it",
)
def sensitive_to_thickness(study: StudyTables) -> Finding:
    """Compare the birth strains of two thicknesses."""
    thick, thin = (sheet_of(study, "nayyar", LONG, t) for t in (THIN, 0.5 * THIN))
    if not (math.isfinite(thick.birth) and math.isfinite(thin.birth)):
        raise MissingError(f"birth strains of {thick.label} and {thin.label}")
    ratio = thick.birth / thin.birth
    return Finding(
        verdict_of(ratio >= SENSITIVE),
        (
            Value(f"birth strain, t/W = {thick.thickness:g}", thick.birth),
            Value(f"birth strain, t/W = {thin.thickness:g}", thin.birth),
            Value("their ratio", ratio),
        ),
        f"The birth strain goes like t to the power {math.log2(ratio):.2g} between both.",
        sheets=(thick, thin),
    )


@statement(
    replace(_POLYETHYLENE, said="largest amplitude at about 0.10"),
    order=(1, 0, 4),
    says=f"the wrinkles of a polyethylene sheet are highest near a strain of {PEAK:g}, as those of "
    "a hyperelastic sheet.",
    reading="Compared with the neo-Hookean sheet of Nayyar et al. 2011.",
    tolerance=f"strain of the largest amplitude within {NEAR:g} of {PEAK:g}, for every bending law",
)
def highest_at_a_tenth(study: StudyTables) -> Finding:
    """Compare where the amplitude is largest."""
    sheets = under_each_bending_law(study, "nayyar", LONG, THIN)
    peaks = {name: s.peak_value("strain_at_max_amplitude") for name, s in sheets.items()}
    holds = {name: abs(peak - PEAK) <= NEAR for name, peak in peaks.items()}
    verdict, what = verdict_across(holds, BENDING)
    return Finding(
        verdict,
        bending_values("strain of the largest A/t", peaks),
        f"A/t is largest at {listed(peaks)}.",
        what,
        tuple(sheets.values()),
    )


@statement(
    replace(_POLYETHYLENE, said="not fully flat at large strain"),
    order=(1, 0, 5),
    says="a polyethylene sheet does not become fully flat again at large strains.",
    reading="Compared with the neo-Hookean sheet of Nayyar et al. 2011.",
    tolerance="no decay strain, for any bending law",
)
def polyethylene_stays_wrinkled(study: StudyTables) -> Finding:
    """Look for a decay strain."""
    sheets = under_each_bending_law(study, "nayyar", LONG, THIN)
    stays = {name: sheet.end == math.inf for name, sheet in sheets.items()}
    verdict, what = verdict_across(stays, BENDING)
    return Finding(
        verdict,
        birth_and_decay(sheets),
        "The laws here are elastic; the abstract puts what is left of the wrinkles down to "
        "polyethylene not being so.",
        what,
        tuple(sheets.values()),
    )


@statement(
    Published(
        source=sources.WANG_2022,
        where="abstract, a review",
        reliability="B",
        said="up to 30%",
        law="soft films in general",
    ),
    order=(1, 0, 6),
    says=f"soft films wrinkle and are flat again within strains of {SOFT_RANGE:g}.",
    tolerance=f"decay strain at most {1 + ABOUT:g} x {SOFT_RANGE:g} of each rubber here, bending "
    "law thinning",
)
def soft_films(study: StudyTables) -> Finding:
    """Compare the decay strains of all rubbers."""
    sheets = {
        "the neo-Hookean one": sheet_of(study, "nayyar", LONG, THIN),
        "C10 = 10 C01": sheet_of(study, "mr-010", 2.0, THIN),
        "latex": study.sheet,
    }
    ends = {name: sheet.end for name, sheet in sheets.items()}
    holds = {name: end <= (1.0 + ABOUT) * SOFT_RANGE for name, end in ends.items()}
    verdict, what = verdict_across(holds, "the rubber")
    return Finding(
        verdict,
        tuple(Value(f"decay strain of {name}", end) for name, end in ends.items()),
        f"Wrinkles last up to {listed(ends)}.",
        what,
        tuple(sheets.values()),
    )
