"""Item 6: the strain of birth of ever thinner sheets."""

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond.thresholds import (
    LINEAR,
    Threshold,
    by_mesh,
    largest_difference,
    threshold,
)
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

EXPONENT = 2.0
OFF_TWO = 0.01  # of the exponent
MESH = 0.005  # of the critical thickness
THINNEST = 1e-6  # t/W


def meshes(study: StudyTables) -> list[Threshold]:
    """Return the thresholds of the sheets like the paper's, the coarsest mesh first."""
    return by_mesh(study.select("thickness"))


@claim(
    order=(6, 0, 1),
    place="flat sheets at small strain",
    statement="The thinner a sheet, the earlier its wrinkles are born: as the square of t/W.",
    reading="At strain ε a sheet is born whose t/W is the critical thickness τ₁(ε) of the flat "
    "sheet; in linear elasticity its stress is proportional to ε and its bending stiffness is not, "
    "so that τ₁² is proportional to ε and the critical mode does not change.",
    tolerance=f"exponent within {OFF_TWO:g} of {EXPONENT:g} over strains up to {LINEAR:g}",
)
def birth_as_the_square_of_thickness(study: StudyTables) -> Finding:
    """Fit a power law to the birth strain of thin sheets."""
    found = threshold(study.sheet)
    law, whole = found.law(LINEAR), found.law()
    exponent, wide = law.exponents["thickness"], whole.exponents["thickness"]
    low, high = found.thickness[0], found.thickness[found.strain <= LINEAR][-1]
    at_thinnest = float(law.at(thickness=THINNEST))
    return Finding(
        verdict_of(abs(exponent.value - EXPONENT) <= OFF_TWO),
        (
            Value("exponent", exponent.value, digits=5),
            Value("half of its 95% interval", exponent.error, digits=2),
            Value("factor ε/(t/W)²", float(found.strain[0] / found.thickness[0] ** 2), digits=4),
            Value("exponent over all strains below birth", wide.value, digits=4),
            Value("half of its interval", wide.error, digits=2),
            Value(f"birth strain at t/W = {THINNEST:g}", at_thinnest),
        ),
        f"From t/W = {low:.3g} to {high:.3g} (ε = {found.strain[0]:g} to {LINEAR:g}) the exponent "
        f"is {exponent.value:.4f} ± {exponent.error:.1g}; up to t/W = {found.thickness[-1]:.3g} "
        f"(ε = {found.strain[-1]:g}) it is {wide.value:.3f} ± {wide.error:.1g}, as the width "
        "shrinks and the stress is no longer linear in the strain. The law gives a birth strain of "
        f"{at_thinnest:.3g} at t/W = {THINNEST:g}"
        + (
            ", below the smallest strain computed: this extrapolation rests on linear elasticity."
            if at_thinnest < found.strain[0]
            else "."
        ),
        sheets=(study.sheet,),
    )


@claim(
    order=(6, 0, 2),
    place="flat sheets at small strain",
    statement="One mesh serves for the birth of sheets of all thicknesses.",
    reading="Since the critical mode at small strain is that of linear elasticity, its wavelength "
    "does not fall with the thickness.",
    tolerance=f"the critical thickness on meshes with more cells across, made for thinner sheets, "
    f"agrees to {MESH:.1%}",
)
def one_mesh_for_birth(study: StudyTables) -> Finding:
    """Compare the critical thickness at small strain on meshes of different fineness."""
    found = meshes(study)
    if len(found) < 2:
        raise MissingError("critical thicknesses at small strain on two meshes")
    off = [largest_difference(found[0], finer) for finer in found[1:]]
    return Finding(
        verdict_of(max(off) <= MESH),
        tuple(
            Value(f"largest difference, {k}. finer mesh", number, digits=2)
            for k, number in enumerate(off, 1)
        ),
        f"The critical thickness changes by at most {max(off):.2%} on finer meshes ({len(off)}); "
        f"the birth strain at a thickness by twice that, {2.0 * max(off):.2%}, the error of the "
        "numbers above. These meshes have more cells across, as many along.",
        sheets=(study.sheet,),
    )
