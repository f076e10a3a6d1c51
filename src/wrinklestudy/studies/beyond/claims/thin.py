"""Items 1 and 2: the tension field, and how sheets come to it."""

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond.thin_limit import LEAST, approaches
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

MESH = 0.003  # of Phi^2
FIRST_ORDER = 0.15  # of the exponent
NEAR = {2.0e-5: 0.04, 1.0e-5: 0.02}  # of Phi^2, by the largest t/W for which it must hold
EXTRAPOLATED = 0.003
_FIELD = "tension field theory, solved on the mesh of the study"


@claim(
    order=(1, 0, 1),
    place=_FIELD,
    statement="Tension field theory has a solution for the clamped sheet, with its Φ².",
    tolerance=f"every strain converges with no part of the law itself left in the energy, and half "
    f"the cells in each direction change Φ² by at most {MESH:.1%}",
)
def field_is_solved(study: StudyTables) -> Finding:
    """Look at what is left of the law and at the error of the mesh."""
    table = study.table("tension")
    sheet = study.sheet
    own = table[(table["material"] == sheet.material) & (table["aspect"] == sheet.aspect)]
    if not len(own):
        raise MissingError(f"tension fields of {sheet.material}, L/W = {sheet.aspect:g}")
    wrinkled = own[own["status"] == "wrinkled"]
    error = float((wrinkled["phi_squared_error"] / wrinkled["phi_squared"]).max())
    solved = bool((own["status"] != "not-converged").all() and (own["remainder"] == 0.0).all())
    values = [
        Value(f"Φ² at ε = {row['strain']:g}", float(row["phi_squared"]), digits=4)
        for row in wrinkled.to_dict("records")
    ]
    return Finding(
        verdict_of(solved and error <= MESH),
        (*values, Value("largest relative error of the mesh", error, digits=2)),
        f"{len(own)} strains, {int((own['status'] == 'not-converged').sum())} not converged; "
        f"Φ² at the centre line is good to {error:.2%}.",
        sheets=(sheet,),
    )


@claim(
    order=(2, 0, 1),
    place=_FIELD,
    statement="Φ² of thin sheets comes to that of the tension field from below, at first order in "
    "the thickness.",
    tolerance="at every strain with three thicknesses Φ² rises as the sheet gets thinner, stays "
    f"below the field, and the exponent of the deficit is within {FIRST_ORDER:g} of 1",
)
def first_order_in_thickness(study: StudyTables) -> Finding:
    """Fit a power of t/W to what sheets lack at each strain."""
    strains = approaches(study.sheets, study.table("tension"), study.sheet)
    if not strains:
        raise MissingError(f"a tension field and {LEAST} wrinkled sheets at one strain")
    below = all(
        bool((each.deficit > 0.0).all() and (np.diff(each.phi_squared) < 0.0).all())
        for each in strains
    )
    exponents = {each.strain: each.law.exponents["thickness"].value for each in strains if below}
    holds = below and all(abs(p - 1.0) <= FIRST_ORDER for p in exponents.values())
    values = [Value(f"exponent at ε = {e:g}", p, digits=3) for e, p in exponents.items()]
    values += [
        Value(f"extrapolated over field at ε = {each.strain:g}", each.extrapolated, digits=4)
        for each in strains
    ]
    thinnest = strains[0]
    return Finding(
        verdict_of(holds),
        tuple(values),
        "; ".join(
            f"at ε = {each.strain:g} a sheet of t/W = {each.thickness[0]:g} lacks "
            f"{each.deficit[0]:.1%}"
            for each in strains
        )
        + ". The exponent is that of the three thinnest sheets"
        + (
            ", which are not thin enough for one power of t."
            if not holds
            else f", from t/W = {thinnest.thickness[0]:g} on."
        ),
        sheets=(study.sheet,),
    )


@claim(
    order=(2, 0, 2),
    place=_FIELD,
    statement="Sheets of t/W = 2e-5 and 1e-5 are at the tension field but for a few per cent.",
    tolerance="; ".join(f"t/W = {t:g}: within {bar:.0%} of its Φ²" for t, bar in NEAR.items())
    + f"; the parabola through the three thinnest sheets within {EXTRAPOLATED:.1%} at t = 0",
)
def thinnest_are_near(study: StudyTables) -> Finding:
    """Compare the thinnest sheets with the field, at the strains where they were computed."""
    strains = [
        each
        for each in approaches(study.sheets, study.table("tension"), study.sheet)
        if each.thickness[0] <= min(NEAR)
    ]
    if not strains:
        raise MissingError(f"a tension field and a sheet of t/W = {min(NEAR):g} at one strain")
    holds, values = True, []
    for each in strains:
        for bar_thickness, bar in NEAR.items():
            at = int(np.argmin(np.abs(each.thickness - bar_thickness)))
            lacks = float(each.deficit[at])
            holds &= bool(0.0 <= lacks <= bar)
            name = f"part lacking at ε = {each.strain:g}, t/W = {each.thickness[at]:g}"
            values.append(Value(name, lacks, digits=3))
        holds &= abs(each.extrapolated - 1.0) <= EXTRAPOLATED
        name = f"extrapolated over field at ε = {each.strain:g}"
        values.append(Value(name, each.extrapolated, digits=5))
    return Finding(
        verdict_of(holds),
        tuple(values),
        "; ".join(
            f"at ε = {each.strain:g} the thinnest sheet, t/W = {each.thickness[0]:g}, lacks "
            f"{each.deficit[0]:.2%}, and the extrapolation is off by "
            f"{100.0 * (each.extrapolated - 1.0):+.2f}%"
            for each in strains
        )
        + ".",
        sheets=(study.sheet,),
    )
