"""Claims on the confinement Phi^2 = (W_act - W_proj)/W_proj."""

import numpy as np

from wrinklestudy.material.homogeneous import nominal_stress
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.studies.panaitescu2019.field import sheet_field
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    claim,
    verdict_across,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables

ZERO = 1e-8
WIGGLE = 0.01  # of the largest Phi^2
HOOKEAN = 0.1  # departure of the stress from its initial slope
SAME = 0.2  # of Phi^2

AVERAGES = {"full width": "phi_squared", "central wavelength": "phi_squared_central"}
AVERAGING = "the width over which Φ² is averaged, which the paper does not state"


@claim(
    order=(4, 3, 5),
    place="Sec. IV.C, Fig. 7b",
    statement="Φ² is zero below the threshold and again from some finite strain on.",
    reading="Φ² vanishes before birth and after decay, and only there.",
    tolerance=f"at most {ZERO:g} in every state outside, more in every state between",
)
def zero_outside(study: StudyTables) -> Finding:
    """Compare the confinement of the states outside and inside birth and decay."""
    sheet = study.sheet
    birth, decay = sheet.limits()
    strain, phi = sheet.converged("strain", "phi_squared")
    inside = (strain > birth) & (strain < decay)
    if inside.all() or not inside.any():
        raise MissingError(f"states inside and outside of birth and decay, of {sheet.label}")
    outside, smallest = float(phi[~inside].max()), float(phi[inside].min())
    return Finding(
        verdict_of(outside <= ZERO < smallest),
        (
            Value("largest Φ² outside", outside),
            Value("smallest Φ² inside", smallest),
            Value("states outside", int((~inside).sum())),
            Value("states inside", int(inside.sum())),
        ),
        f"Φ² is at most {outside:.2g} outside ε = {birth:.4f} to {decay:.4f} and at least "
        f"{smallest:.2g} inside.",
        sheets=(sheet,),
    )


@claim(
    order=(4, 3, 6),
    place="Sec. IV.C, Fig. 7b",
    statement="With growing strain Φ² rises first and falls later.",
    reading="One maximum over strain, at neither end of the wrinkled range.",
    tolerance=f"rises before its maximum and falls after it, but for {WIGGLE:.0%} of the maximum",
)
def non_monotonic(study: StudyTables) -> Finding:
    """Look for a single maximum of the confinement over strain."""
    sheet = study.sheet
    strain, phi = sheet.wrinkled("strain", "phi_squared")
    top = int(np.argmax(phi))
    step = np.diff(phi) / phi[top]
    single = bool((step[:top] > -WIGGLE).all() and (step[top:] < WIGGLE).all())
    return Finding(
        verdict_of(single and 0 < top < len(phi) - 1),
        (
            Value("largest Φ²", sheet.peak_value("max_phi_squared")),
            Value("at strain", sheet.peak_value("strain_at_max_phi_squared")),
            Value("Φ² at the first wrinkled state", float(phi[0])),
            Value("Φ² at the last", float(phi[-1])),
        ),
        f"Φ² is {phi[0]:.2g} at ε = {strain[0]:g}, {phi[top]:.3g} at {strain[top]:g} and "
        f"{phi[-1]:.2g} at {strain[-1]:g}.",
        sheets=(sheet,),
    )


@claim(
    order=(4, 3, 7),
    place="Sec. IV.C, Fig. 7b",
    statement="Φ² is about ten times smaller than ν ε, what the original Cerda-Mahadevan model "
    "takes for it.",
    reading="The largest ratio of Φ² to ν ε over strain, ν = 1/2, is about 1/10; a much smaller "
    "one is more than an order of magnitude. Both averages of Φ² are tested.",
    tolerance="the nearest power of ten of the largest ratio is 1/10, for both averages",
)
def order_of_magnitude(study: StudyTables) -> Finding:
    """Compare the confinement with nu eps, for both ways of averaging it."""
    sheet = study.sheet
    values, outcomes, words = [], {}, []
    for name, column in AVERAGES.items():
        strain, phi = sheet.wrinkled("strain", column)
        ratio = phi / theory.cm_confinement(strain)
        top = float(ratio.max())
        outcomes[name] = top > 0.0 and round(float(np.log10(top))) == -1
        values.append(Value(f"largest Φ²/(ν ε), {name}", top))
        words.append(f"1/{1.0 / top:.3g} ({name})" if top > 0.0 else f"0 ({name})")
    verdict, what = verdict_across(outcomes, AVERAGING)
    return Finding(
        verdict,
        tuple(values),
        f"Φ² is at most {' and '.join(words)} of ν ε.",
        what,
        (sheet,),
    )


@claim(
    order=(4, 3, 9),
    place="Sec. IV.C",
    statement="Φ² starts to fall at strains so small that the material is still nearly Hookean.",
    reading="At the strain where Φ² is largest the stress is still close to its initial slope.",
    tolerance=f"within {HOOKEAN:.0%} of the initial slope at that strain",
)
def hookean_maximum(study: StudyTables) -> Finding:
    """Compute the departure of the stress from Hooke's law where the confinement is largest."""
    sheet, material = study.sheet, study.material.fit.material()
    peak = sheet.peak_value("strain_at_max_phi_squared")
    stress = float(nominal_stress(material, 1.0 + peak))
    departure = stress / (material.young_modulus * peak) - 1.0
    return Finding(
        verdict_of(abs(departure) <= HOOKEAN),
        (
            Value("strain of the largest Φ²", peak),
            Value("stress over its initial slope there, less 1", departure),
        ),
        f"Φ² turns at ε = {peak:.3f}, where the stress in simple tension is {departure:+.0%} off "
        "its initial slope.",
        sheets=(sheet,),
    )


@claim(
    order=(4, 3, 8),
    place="Sec. IV.C, Fig. 7b, Table I",
    statement="Φ² follows from tension field theory.",
    reading="Tension field theory, which knows no thickness, is solved for the paper's rubber and "
    "L/W, and its Φ² compared with that of the sheet where the sheet's is largest, farthest from "
    "both ends of the wrinkled range.",
    tolerance=f"Φ² of the sheet within {SAME:.0%} of that of the tension field there",
)
def tension_field(study: StudyTables) -> Finding:
    """Compare the confinement of the paper's sheet with that of its tension field."""
    sheet, field = study.sheet, sheet_field(study)
    strain, phi = sheet.wrinkled("strain", "phi_squared")
    limit = field.at("phi_squared", strain)
    if not (np.isfinite(limit) & (limit > 0.0)).any():
        raise MissingError(f"a tension field at a strain with wrinkles of {sheet.label}")
    shared = np.flatnonzero(np.isfinite(limit) & (limit > 0.0))
    top = int(shared[np.argmax(phi[shared])])
    at, part = float(strain[top]), phi[shared] / limit[shared]
    ratio = float(phi[top] / limit[top])
    values = [
        Value("strain of the largest Φ²", at),
        Value("Φ² of the tension field there", float(limit[top])),
        Value("Φ² of the sheet over that of the field there", ratio),
        Value("largest such ratio over strain", float(part.max())),
    ]
    others = _thinner(study, at)
    values += [Value(f"the same ratio at t/W = {t:g}", p / float(limit[top])) for t, p in others]
    words = f"At ε = {at:g} Φ² of the sheet is {ratio:.0%} of {limit[top]:.3g}, the tension field's"
    if others:
        thinnest, its = others[0]
        words += f"; at t/W = {thinnest:g} it is {its / limit[top]:.0%}"
    return Finding(
        verdict_of(abs(ratio - 1.0) <= SAME),
        tuple(values),
        f"{words}."
        + (
            ""
            if abs(ratio - 1.0) <= SAME
            else " Tension field theory is the limit of vanishing thickness, and a sheet of the "
            "paper's thickness is far from it: bending and the nearness of the threshold matter."
        ),
        sheets=(sheet,),
    )


def _thinner(study: StudyTables, strain: float) -> list[tuple[float, float]]:
    """Return t/W and Phi^2 at a strain of the sheets like the paper's but thinner, thinnest first.

    Sheets without wrinkled states on both sides of the strain are left out.
    """
    own = study.sheet
    thinner = []
    for sheet in study.sheets_by("thickness").values():
        if sheet.thickness >= own.thickness:
            continue
        try:
            thinner.append((sheet.thickness, float(sheet.at("phi_squared", strain))))
        except MissingError:
            continue
    return [(t, phi) for t, phi in sorted(thinner) if np.isfinite(phi)]
