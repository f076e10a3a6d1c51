"""Claims on the shape of the wrinkled sheet: where it wrinkles, how high, with which parity."""

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

CENTRAL = 0.1  # |X|/L and |Y|/W
SHOWN_STRAIN = 0.12  # of Fig. 3
COLOUR_BAR = 3.5e-3  # W
COLOUR_BAR_IN_THICKNESS = 2.5  # t
BAR = 0.1  # of the number of thicknesses
FILLED = (0.8, 1.05)  # part of a colour bar that the deflection fills
DEGENERATE = 0.01  # of the energy that is gained by wrinkling
RELEVANT = 0.1  # of the largest gain

_AMPLITUDE = "amplitude_over_thickness"


@claim(
    order=(2, 0, 3),
    place="Sec. III, captions of Figs. 2 and 3",
    statement="The wrinkles lie in the middle of the sheet.",
    reading="The largest deflection of the whole sheet lies near its centre, at every strain.",
    tolerance=f"|X| at most {CENTRAL:g} L and |Y| at most {CENTRAL:g} W",
)
def central_region(study: StudyTables) -> Finding:
    """Find where the largest deflection of the wrinkled states lies."""
    sheet = study.sheet
    along, across = sheet.wrinkled("sheet_amplitude_x_over_length", "sheet_amplitude_y_over_width")
    far_x, far_y = float(np.abs(along).max()), float(np.abs(across).max())
    return Finding(
        verdict_of(far_x <= CENTRAL and far_y <= CENTRAL),
        (
            Value("farthest place of the largest |z|: |X|/L", far_x),
            Value("farthest place of the largest |z|: |Y|/W", far_y),
            Value("wrinkled states", len(along)),
        ),
        f"The largest deflection lies up to {far_x:.2g} L along and {far_y:.2g} W across from the "
        "centre.",
        sheets=(sheet,),
    )


@claim(
    order=(3, 1, 2),
    place="Sec. III.A, Fig. 3",
    statement="The colours of Fig. 3 span deflections up to 3.5e-3 W either way.",
    reading=f"At ε = {SHOWN_STRAIN:g} the largest |z| fills most of 3.5e-3 W and does not exceed "
    "it.",
    tolerance=f"largest |z| from {FILLED[0]:.0%} to {FILLED[1]:.0%} of 3.5e-3 W",
)
def colour_bar(study: StudyTables) -> Finding:
    """Compare the amplitude at the strain of Fig. 3 with its colour bar."""
    sheet = study.sheet
    height = sheet.at(_AMPLITUDE, SHOWN_STRAIN) * sheet.thickness
    filled = height / COLOUR_BAR
    return Finding(
        verdict_of(FILLED[0] <= filled <= FILLED[1]),
        (
            Value(f"A/W at ε = {SHOWN_STRAIN:g}", height),
            Value("A over the colour bar", filled),
        ),
        f"The deflection reaches {height:.3g} W, {filled:.0%} of the colour bar.",
        sheets=(sheet,),
    )


@claim(
    order=(3, 1, 3),
    place="Sec. III.A, Fig. 3",
    statement="In units of the thickness, this colour bar spans some 2.5 t either way.",
    reading="3.5e-3 W are 2.5 thicknesses. The two numbers of one colour bar contradict each "
    f"other unless t/W = {COLOUR_BAR / COLOUR_BAR_IN_THICKNESS:.2g}; 3.5e-3 W is taken.",
    tolerance=f"3.5e-3 W within {BAR:.0%} of 2.5 t",
)
def colour_bar_in_thicknesses(study: StudyTables) -> Finding:
    """Express the colour bar in thicknesses, beside the amplitude that was computed."""
    sheet = study.sheet
    bar = COLOUR_BAR / sheet.thickness
    height = sheet.at(_AMPLITUDE, SHOWN_STRAIN)
    return Finding(
        verdict_of(abs(bar / COLOUR_BAR_IN_THICKNESS - 1.0) <= BAR),
        (
            Value("colour bar over t", bar),
            Value(f"A/t at ε = {SHOWN_STRAIN:g}", height),
        ),
        f"At t/W = {sheet.thickness:g} the colour bar is ±{bar:.3g} t. The computed amplitude at "
        f"ε = {SHOWN_STRAIN:g} is {height:.3g} t: a bar of ±{COLOUR_BAR_IN_THICKNESS:g} t would "
        + ("hold it." if height <= COLOUR_BAR_IN_THICKNESS else "not hold it."),
        sheets=(sheet,),
    )


@claim(
    order=(3, 1, 1),
    place="Caption of Fig. 3",
    statement="The strain of Fig. 3, 0.12, is the elongation over the width.",
    reading="Section II defines ε as the elongation over the length and is followed everywhere "
    f"else. Tested by which definition gives a deflection that fills ({FILLED[0]:.0%} to "
    f"{FILLED[1]:.0%}) the colour bar, 3.5e-3 W or 2.5 t.",
    tolerance="agree if the caption's strain fills the bar and that of Sec. II does not, disagree "
    "if it fills neither of the two bars",
)
def strain_definition(study: StudyTables) -> Finding:
    """Compare the amplitudes at both strains with both numbers for the colour bar."""
    sheet = study.sheet
    caption = SHOWN_STRAIN / sheet.aspect
    bars = {"3.5e-3 W": COLOUR_BAR / sheet.thickness, "2.5 t": COLOUR_BAR_IN_THICKNESS}
    low, high = sheet.at(_AMPLITUDE, caption), sheet.at(_AMPLITUDE, SHOWN_STRAIN)
    fits = {name for name, bar in bars.items() if FILLED[0] <= low / bar <= FILLED[1]}
    usual = {name for name, bar in bars.items() if FILLED[0] <= high / bar <= FILLED[1]}
    values = (
        Value(f"A/t at ε = {caption:g} (caption)", low),
        Value(f"A/t at ε = {SHOWN_STRAIN:g} (Sec. II)", high),
        *(Value(f"colour bar {name} over t", bar) for name, bar in bars.items()),
    )
    text = (
        f"A/t is {low:.3g} with the caption's definition (ε = {caption:g} of the length), which "
        f"fills {_names(fits)}, and {high:.3g} with that of Sec. II, which fills {_names(usual)}."
    )
    if fits and not usual:
        return Finding("agree", values, text, sheets=(sheet,))
    if not fits:
        return Finding("disagree", values, text, sheets=(sheet,))
    what = "which of the two numbers of the colour bar is right"
    return Finding("depends on", values, text, what, (sheet,))


def _names(bars: set[str]) -> str:
    return f"the bar of {' and of '.join(sorted(bars))}" if bars else "neither bar"


@claim(
    order=(3, 2, 1),
    place="Sec. III.B, Fig. 4",
    statement="Measured and computed profiles alike are antisymmetric across the width.",
    reading="Of the two wrinkled states, antisymmetric and symmetric across the width, the sheet "
    "takes the antisymmetric one because it has the lower energy.",
    tolerance=f"energies that differ by less than {DEGENERATE:.0%} of the energy gained by "
    "wrinkling do not choose; otherwise agree if the antisymmetric state is lower at all strains "
    f"(with at least {RELEVANT:.0%} of the largest gain), disagree if the symmetric one is",
)
def antisymmetric(study: StudyTables) -> Finding:
    """Compare the energies of the two parities at the strains that both have."""
    odd, even = study.sheet_with(parity="antisymmetric"), study.sheet_with(parity="symmetric")
    strain, energy, flat = odd.wrinkled("strain", "energy", "flat_energy")
    even_strain, even_energy = even.wrinkled("strain", "energy")
    common, odd_at, even_at = np.intersect1d(strain, even_strain, return_indices=True)
    if not len(common):
        raise MissingError("a strain at which both parities are computed and wrinkled")
    gain = flat[odd_at] - energy[odd_at]
    above = (energy[odd_at] - even_energy[even_at]) / gain  # > 0 where the symmetric state is lower
    kept = gain >= RELEVANT * gain.max()
    above = above[kept]
    largest, lower = float(np.abs(above).max()), int((above < 0.0).sum())
    values = (
        Value("largest difference over the energy gained by wrinkling", largest),
        Value("strains compared", len(above)),
        Value("strains at which the antisymmetric state is lower", lower),
    )
    text = (
        f"The energies of the two parities differ by at most {largest:.2g} of what wrinkling "
        f"gains; the antisymmetric state is the lower one at {lower} of {len(above)} strains."
    )
    if largest < DEGENERATE:
        text += " The pattern can slide across the sheet almost freely."
        what = "imperfections of the sheet: the two states are nearly degenerate"
        return Finding("depends on", values, text, what, (odd, even))
    if 0 < lower < len(above):
        return Finding("depends on", values, text, "the strain", (odd, even))
    return Finding(verdict_of(lower > 0), values, text, sheets=(odd, even))
