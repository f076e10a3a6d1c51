"""Claims on length and thickness: which sheets wrinkle."""

from itertools import pairwise

import numpy as np

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.study.claims.finding import Finding, Value, claim, number_text, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

SHORT, LONG = 1.5, 3.0  # L/W
CUTOFF_RANGE = (1.5, 3.5)  # L/W: the shortest and longest sheets of the paper
# L/W, upper end that Li and Healey predict (J. Mech. Phys. Solids 97, 2016), and its rounding
EARLIER_ISLAND, SAME_END = 2.6, 0.05

_PEAK = "max_amplitude_over_thickness"


def _margin(sheet: SheetStates) -> float:
    return sheet.max_critical_thickness / sheet.thickness


@claim(
    order=(3, 4, 1),
    place="Sec. III.D, Fig. 6a",
    statement="A sheet of L/W = 1.5 stays flat at every strain.",
    tolerance="no birth strain (eigenvalue problem) and no wrinkled state",
)
def none_when_short(study: StudyTables) -> Finding:
    """Look for wrinkles of the short sheet."""
    sheet = study.sheet_with(aspect=SHORT)
    return Finding(
        verdict_of(not sheet.wrinkles),
        (
            Value("largest critical thickness τ/W", sheet.max_critical_thickness),
            Value("the same over t/W", _margin(sheet)),
            Value("at strain", sheet.strain_at_max),
            Value("wrinkled states", sheet.status.count("wrinkled")),
        ),
        f"The largest critical thickness is {_margin(sheet):.3g} of the thickness; a sheet thinner "
        f"than {sheet.max_critical_thickness:.3g} W wrinkles at this length.",
        sheets=(sheet,),
    )


@claim(
    order=(3, 4, 2),
    place="Sec. III.D, Fig. 6a",
    statement="A sheet of L/W = 3 wrinkles over some range of strain.",
    tolerance="a birth strain (eigenvalue problem)",
)
def wrinkles_when_long(study: StudyTables) -> Finding:
    """Look for wrinkles of the long sheet."""
    sheet = study.sheet_with(aspect=LONG)
    return Finding(
        verdict_of(bool(np.isfinite(sheet.birth))),
        (
            Value("birth strain", sheet.birth),
            Value("decay strain", sheet.end if sheet.wrinkles else np.nan),
            Value("largest A/t", sheet.peak.get(_PEAK, np.nan)),
            Value("largest critical thickness over t", _margin(sheet)),
        ),
        f"The largest critical thickness is {_margin(sheet):.3g} of the thickness.",
        sheets=(sheet,),
    )


@claim(
    order=(3, 4, 3),
    place="Sec. III.D, Fig. 6a",
    statement="That a sheet of L/W = 3 wrinkles is at variance with Li and Healey, who predict "
    "that it stays flat.",
    reading="Their boundaries hold length and thickness while the width varies, so that t/L is "
    "that of the sheet of the text; here width and thickness are held. That they hold this t/L is "
    "inferred from the agreement of the upper ends. It is at variance if a sheet of L/W = 3 with "
    "this t/L wrinkles too.",
    tolerance="the largest critical thickness over strain exceeds that thickness",
)
def at_variance_with_earlier_island(study: StudyTables) -> Finding:
    """Ask whether the long sheet wrinkles with t/L in place of t/W held."""
    sheet, own = study.sheet_with(aspect=LONG), study.sheet
    over_length = own.thickness / own.aspect
    given, highest = over_length * LONG, sheet.max_critical_thickness
    if not np.isfinite(highest):
        raise MissingError(f"the largest critical thickness of {sheet.label}")
    sheets = list(study.sheets_by("aspect").values())
    _, end = _ends(
        [(s.aspect, s.max_critical_thickness / (over_length * s.aspect)) for s in sheets]
    )
    does = "wrinkles" if highest > given else "stays flat"
    return Finding(
        verdict_of(highest > given),
        (
            Value("largest critical thickness τ/W", highest),
            Value("t/W with the t/L of the sheet of the text", given),
            Value("that t/L", over_length),
            Value("upper cutoff in L/W with t/L held", end),
            Value("that of Li and Healey", EARLIER_ISLAND),
        ),
        f"With t/L = {over_length:g} held, a sheet of L/W = {LONG:g} is {given:.3g} W thick and "
        f"{does}; with t/W = {sheet.thickness:g} held it "
        f"{'wrinkles' if sheet.wrinkles else 'stays flat'}. With t/L held the range of L/W ends at "
        f"{number_text(end)}, Li and Healey's at {EARLIER_ISLAND:g}.",
        sheets=tuple(dict.fromkeys((sheet, *sheets))),
    )


@claim(
    order=(3, 4, 4),
    place="Abstract, Sec. III.D, Fig. 6a",
    statement="L/W has a lower and an upper limit, outside of which sheets do not wrinkle.",
    reading="At this thickness the lengths at which sheets wrinkle form an island, and it ends "
    "within the paper's own range of L/W.",
    tolerance=f"flat sheets on both sides of those that wrinkle, from L/W = {CUTOFF_RANGE[0]:g} to "
    f"{CUTOFF_RANGE[1]:g}",
)
def island_of_lengths(study: StudyTables) -> Finding:
    """Find both ends of the range of L/W, where the largest critical thickness equals t."""
    sheets = list(study.sheets_by("aspect").values())
    aspects = [sheet.aspect for sheet in sheets]
    wrinkle = [k for k, sheet in enumerate(sheets) if sheet.wrinkles]
    if not wrinkle or aspects[0] > CUTOFF_RANGE[0] or aspects[-1] < CUTOFF_RANGE[1]:
        low, high = CUTOFF_RANGE
        raise MissingError(f"sheets that wrinkle and others with L/W from {low:g} to {high:g}")
    first, last = wrinkle[0], wrinkle[-1]
    lower, upper = _ends([(sheet.aspect, _margin(sheet)) for sheet in sheets])
    names = ", ".join(f"{aspects[k]:g}" for k in wrinkle)
    both = bool(np.isfinite([lower, upper]).all())
    return Finding(
        verdict_of(both and len(wrinkle) == last - first + 1),
        (
            Value("lower cutoff in L/W", lower),
            Value("upper cutoff in L/W", upper),
            Value("shortest sheet that wrinkles: L/W", float(aspects[first])),
            Value("longest sheet that wrinkles: L/W", float(aspects[last])),
        ),
        f"Sheets with L/W = {names} wrinkle. Between them and their flat neighbours the largest "
        f"critical thickness equals t at L/W = {number_text(lower)} and {number_text(upper)}.",
        sheets=tuple(sheets),
    )


def _ends(margins: list[tuple[float, float]]) -> tuple[float, float]:
    """Return the first and the last L/W at which the largest critical thickness equals t.

    Parameters
    ----------
    margins : list of (float, float)
        L/W, and the largest critical thickness over t, by L/W; linear between neighbours. An end
        beyond them is NaN.
    """
    ups: list[float] = []
    downs: list[float] = []
    for (a, here), (b, there) in pairwise(margins):
        if (here > 1.0) != (there > 1.0):
            crossing = a + (b - a) * (here - 1.0) / (here - there)
            (ups if there > 1.0 else downs).append(crossing)
    return (ups[0] if ups else np.nan, downs[-1] if downs else np.nan)


@claim(
    order=(3, 4, 5),
    place="Abstract, Secs. III.D and V, Fig. 6b",
    statement="Only sheets that are thin enough for their width wrinkle.",
    reading="At the length of the paper's sheet thick sheets never wrinkle and all thinner ones "
    "do.",
    tolerance="at least one sheet of the series never wrinkles, one does, and each of those that "
    "do is thinner than each of those that do not",
)
def thin_enough(study: StudyTables) -> Finding:
    """Compare the thicknesses that wrinkle with those that do not."""
    sheets = list(study.sheets_by("thickness").values())
    flat = [sheet for sheet in sheets if not sheet.wrinkles]
    wrinkled = [sheet for sheet in sheets if sheet.wrinkles]
    limit = max(sheet.max_critical_thickness for sheet in sheets)
    if not (wrinkled and flat):
        raise MissingError(
            f"sheets thinner and thicker than {limit:.3g} W like {study.sheet.label}"
        )
    holds = max(s.thickness for s in wrinkled) < min(s.thickness for s in flat)
    peaks = ", ".join(f"{s.peak.get(_PEAK, np.nan):.3g} at {s.thickness:g}" for s in wrinkled)
    return Finding(
        verdict_of(holds),
        (
            Value("largest critical thickness τ/W", limit),
            Value("thickest sheet that wrinkles: t/W", max(s.thickness for s in wrinkled)),
            Value("thinnest sheet that does not: t/W", min(s.thickness for s in flat)),
            *(
                Value(f"largest A/t, t/W = {s.thickness:g}", s.peak.get(_PEAK, np.nan))
                for s in sheets
            ),
        ),
        f"Sheets thinner than {limit:.3g} W wrinkle at some strain. Largest A/t by t/W: {peaks}.",
        sheets=tuple(sheets),
    )


@claim(
    order=(4, 1, 1),
    place="Sec. IV.A",
    statement="The strain at which wrinkles appear goes to zero with the thickness.",
    reading="The birth strain falls with the thickness, like a positive power of it.",
    tolerance="lower for each thinner sheet of the series",
)
def threshold_vanishes(study: StudyTables) -> Finding:
    """Fit a power of the thickness to the birth strains of the thickness series."""
    sheets = [s for s in study.sheets_by("thickness").values() if np.isfinite(s.birth)]
    if len(sheets) < 2:
        raise MissingError(f"two sheets like {study.sheet.label}, of other thickness, that wrinkle")
    thickness = np.array([sheet.thickness for sheet in sheets])
    birth = np.array([sheet.birth for sheet in sheets])
    power = float(np.polyfit(np.log(thickness), np.log(birth), 1)[0])
    return Finding(
        verdict_of(bool((np.diff(birth) > 0.0).all())),
        (
            *(
                Value(f"birth strain, t/W = {t:g}", e)
                for t, e in zip(thickness, birth, strict=True)
            ),
            Value("power of the thickness", power),
        ),
        f"Over t/W from {thickness[0]:g} to {thickness[-1]:g} the birth strain goes like "
        f"t^{power:.2g}.",
        sheets=tuple(sheets),
    )
