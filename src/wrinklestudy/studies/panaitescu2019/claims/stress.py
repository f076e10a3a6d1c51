"""Claims on the stress-strain curve and the constants of the material."""

import re

import numpy as np

from wrinklestudy.material.homogeneous import nominal_stress
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_of
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.typing import Array

MODULUS = 0.05  # of the stated modulus
NONLINEAR_FROM = 0.1  # strain
DEPARTURE = 0.1  # of the initial slope
FIT = 0.02  # root mean square misfit over the largest stress
SYSTEMATIC = 0.1  # of the stress
VOLUME = 1e-9  # of the volume

_MPA = 1.0e-6
_REBUILT = re.compile(r"not measured|rebuilt", re.IGNORECASE)


def _curve(study: StudyTables, start: float = 1e-3) -> tuple[Array, Array, float]:
    """Return strain, nominal stress in Pa over the fitted range and the initial modulus in Pa."""
    fit = study.material.fit
    end = fit.stretch_range[1] - 1.0
    if not end > start:
        raise MissingError(f"a fit of {study.material.name} beyond strain {start:g}")
    strain = np.linspace(start, end, 2001)
    material = fit.material()
    return strain, nominal_stress(material, 1.0 + strain), material.young_modulus


@claim(
    order=(2, 0, 1),
    place="Sec. II, caption of Fig. 1",
    statement="Young's modulus of the latex, by which stresses are divided, is 1 MPa.",
    reading="Young's modulus is defined there as the initial slope. For the constants of the "
    "same section it is 6 (C10 + C01): the text contradicts itself. Figures divide by the stated "
    "1 MPa.",
    tolerance=f"initial slope of the fitted law within {MODULUS:.0%} of 1 MPa",
)
def young_modulus(study: StudyTables) -> Finding:
    """Compare the initial slope of the fitted law with the modulus that the paper states."""
    strain, stress, slope = _curve(study)
    stated = theory.STATED_YOUNG_MODULUS
    off = slope / stated - 1.0
    mean = stress / strain
    reached = strain[np.argmax(mean <= stated)] if (mean <= stated).any() else np.nan
    where = (
        f"The mean slope T/ε falls to the stated value only at ε = {reached:.2f}, so that 1 MPa "
        "describes the curve as a whole, not its beginning."
        if reached > strain[0]
        else "The mean slope T/ε does not have the stated value anywhere on the curve."
    )
    return Finding(
        verdict_of(abs(off) <= MODULUS),
        (
            Value("initial slope of the fitted law", slope * _MPA, "MPa"),
            Value("stated modulus", stated * _MPA, "MPa"),
            Value("difference over the stated modulus", off),
            Value("strain at which T/ε equals the stated modulus", float(reached)),
        ),
        f"The fitted constants start with {slope * _MPA:.2f} MPa, {off:+.0%} from the stated "
        f"value. {where}",
    )


@claim(
    order=(2, 0, 2),
    place="Sec. II, Fig. 1",
    statement="Above a strain of about 0.1 stress is no longer proportional to strain.",
    reading="From ε = 0.1 on the nominal stress departs visibly from Y ε, Y the initial slope.",
    tolerance=f"departure of at least {DEPARTURE:.0%} at every strain from {NONLINEAR_FROM:g} to "
    "the end of the fit",
)
def nonlinear_stress(study: StudyTables) -> Finding:
    """Measure how far the fitted law departs from its initial slope."""
    strain, stress, slope = _curve(study)
    departure = np.abs(1.0 - stress / (slope * strain))
    beyond = departure[strain >= NONLINEAR_FROM]
    if not len(beyond):
        raise MissingError(f"a fit of {study.material.name} beyond strain {NONLINEAR_FROM:g}")
    reached = (
        strain[np.argmax(departure >= DEPARTURE)] if (departure >= DEPARTURE).any() else np.nan
    )
    return Finding(
        verdict_of(bool((beyond >= DEPARTURE).all())),
        (
            Value(f"departure at ε = {NONLINEAR_FROM:g}", float(beyond[0])),
            Value(f"departure at ε = {strain[-1]:g}", float(beyond[-1])),
            Value(f"strain at which it is {DEPARTURE:.0%}", float(reached)),
        ),
        f"At ε = {NONLINEAR_FROM:g} the curve lies {beyond[0]:.1%} off its initial slope; "
        f"{DEPARTURE:.0%} are reached at ε = {reached:.3f}.",
    )


@claim(
    order=(2, 0, 5),
    place="Sec. II, Fig. 1",
    statement="The Mooney-Rivlin law with the fitted constants describes the measured points "
    "very well.",
    tolerance=f"root mean square misfit at most {FIT:.0%} of the largest stress",
)
def law_fits_data(study: StudyTables) -> Finding:
    """Compare the misfit of the fit with the stress, if the points were measured."""
    _, stress, _ = _curve(study)
    material = study.material
    if _REBUILT.search(material.note):
        raise MissingError(
            f"measured points; the curve in {material.fit.source} is rebuilt from the published "
            "constants, so that the law fits it by construction"
        )
    misfit = material.fit.rms_pa / float(np.abs(stress).max())
    return Finding(
        verdict_of(misfit <= FIT),
        (Value("root mean square misfit over the largest stress", misfit),),
        f"The {material.fit.law} law misses the {material.fit.count} points of "
        f"{material.fit.source} by {misfit:.1%} of the largest stress.",
    )


@claim(
    order=(2, 0, 6),
    place="Sec. II, Fig. 1",
    statement="Saint Venant-Kirchhoff misses the measured curve systematically.",
    reading="With the same initial slope it departs from the fitted curve to one side "
    f"everywhere above ε = {NONLINEAR_FROM:g}.",
    tolerance=f"at least {SYSTEMATIC:.0%} of the stress, always of one sign",
)
def svk_deviates(study: StudyTables) -> Finding:
    """Compare the fitted curve with Saint Venant-Kirchhoff of the same initial slope."""
    strain, stress, slope = _curve(study)
    beyond = strain >= NONLINEAR_FROM
    if not beyond.any():
        raise MissingError(f"a fit of {study.material.name} beyond strain {NONLINEAR_FROM:g}")
    off = (theory.uniaxial_svk(strain, slope) / stress - 1.0)[beyond]
    systematic = bool((off >= SYSTEMATIC).all() or (off <= -SYSTEMATIC).all())
    return Finding(
        verdict_of(systematic),
        (
            Value(f"SVK over the fitted curve, less 1, at ε = {NONLINEAR_FROM:g}", float(off[0])),
            Value(f"the same at ε = {strain[-1]:g}", float(off[-1])),
        ),
        f"SVK lies {off[0]:+.0%} off the fitted curve at ε = {NONLINEAR_FROM:g} and {off[-1]:+.0%} "
        f"off it at ε = {strain[-1]:g}.",
    )


@claim(
    order=(2, 0, 4),
    place="Sec. II",
    statement="The constant D1 of the volumetric response is zero.",
    reading="Incompressible. (In Abaqus D1 is a compliance, 2 over the bulk modulus, in 1/Pa; "
    "zero stands for an infinite bulk modulus.)",
    tolerance=f"volume of the stretched sheet constant to {VOLUME:g}",
)
def incompressible(study: StudyTables) -> Finding:
    """Compute the volume ratio of the law over a range of in-plane metrics."""
    law = study.material.fit.material().law
    along = np.linspace(1.0, study.material.fit.stretch_range[1], 21)[:, None]
    across = np.linspace(0.85, 1.0, 7)[None, :]
    metric = np.stack(np.broadcast_arrays(along**2, across**2, 0.0 * along * across))
    thickness, _, _ = law.thickness_stretch(metric)
    change = float(np.nanmax(np.abs(thickness * along * across - 1.0)))
    return Finding(
        verdict_of(change <= VOLUME),
        (
            Value("largest change of volume", change),
            Value("Poisson's ratio of the law", law.poisson),
        ),
        f"The volume of the sheet in the {study.material.fit.law} law changes by up to "
        f"{change:.2g} of itself.",
    )
