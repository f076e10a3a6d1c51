"""Section 5: wavelength, parity and shape of the wrinkles, and what compresses the sheet."""

import math
from dataclasses import replace

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond.claims.scales import QUARTER, wavelength_law
from wrinklestudy.studies.beyond.lengths import lengths
from wrinklestudy.studies.literature import sources
from wrinklestudy.studies.literature.claims.strains import LONG, NAYYAR, THIN
from wrinklestudy.studies.literature.islands import HOOKEAN, map_of
from wrinklestudy.studies.literature.statement import (
    Published,
    bending_values,
    sheet_of,
    statement,
    under_each_bending_law,
)
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    listed,
    number_text,
    verdict_across,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables

OFF = 0.02  # of the exponent of the strain
HALF, HALF_OFF = 0.5, 0.05  # exponent of the thickness, and its tolerance
CLOSE = 0.1  # of the wavelength
SAME = 1.0e-5  # of strains and forces of both parities
WITHOUT_POISSON = "svk-00"
_CERDA = Published(
    source=sources.CERDA_2003,
    where="as Panaitescu et al. 2019 state it",
    reliability="C",
    said="",
    law="Hookean, small strain; here neo-Hookean",
    aspect="long; here 2.5",
)


@statement(
    replace(NAYYAR, said="λ ∝ ε^(-1/4)"),
    order=(5, 0, 1),
    says="the wavelength falls with the strain as the scaling of Cerda and Mahadevan says.",
    reading="The coordinates are not said: tried on the undeformed and on the deformed sheet.",
    tolerance=f"exponent within {OFF:g} of {QUARTER:g} in both, bending law thinning; the others "
    "are shown",
)
def wavelength_over_strain(study: StudyTables) -> Finding:
    """Fit the exponent of the strain on the undeformed and on the deformed sheet."""
    sheets = under_each_bending_law(study, "nayyar", LONG, THIN)
    exponents = {
        where: {
            name: wavelength_law(lengths([sheet]), material).exponents["strain"].value
            for name, sheet in sheets.items()
        }
        for where, material in (("undeformed", True), ("deformed", False))
    }
    if "thinning" not in sheets:
        raise MissingError("the sheet of Nayyar et al. with bending law thinning")
    own = {where: numbers["thinning"] for where, numbers in exponents.items()}
    holds = {f"the {where} sheet": abs(e - QUARTER) <= OFF for where, e in own.items()}
    verdict, what = verdict_across(holds, "the coordinates")
    return Finding(
        verdict,
        tuple(
            value
            for where, numbers in exponents.items()
            for value in bending_values(f"exponent, {where}", numbers)
        ),
        f"Exponents {listed(own)}.",
        what,
        tuple(sheets.values()),
    )


@statement(
    replace(_CERDA, said="λ ∝ t^(1/2)", thickness="t/W = 1e-3 and half of it"),
    order=(5, 0, 2),
    says="the wavelength goes as the square root of the thickness.",
    tolerance=f"mean exponent between both thicknesses within {HALF_OFF:g} of {HALF:g}",
)
def wavelength_over_thickness(study: StudyTables) -> Finding:
    """Compare the wavelengths of two thicknesses at the same strains."""
    thick, thin = (sheet_of(study, "nayyar", LONG, t) for t in (THIN, 0.5 * THIN))
    name = "wavelength_over_width"
    known, other = (dict(zip(*s.wrinkled("strain", name), strict=True)) for s in (thick, thin))
    common = sorted(known.keys() & other.keys())
    if not common:
        raise MissingError(f"wrinkled states of {thick.label} and {thin.label} at one strain")
    powers = [math.log2(known[strain] / other[strain]) for strain in common]
    mean = float(np.mean(powers))
    return Finding(
        verdict_of(abs(mean - HALF) <= HALF_OFF),
        (
            Value("exponent of t", mean),
            Value("smallest", min(powers)),
            Value("largest", max(powers)),
        ),
        f"At {len(common)} strains it is {min(powers):.3f} to {max(powers):.3f}.",
        sheets=(thick, thin),
    )


@statement(
    replace(
        _CERDA,
        said="λ = sqrt(2 π L t)/[3 (1 - ν²) ε]^(1/4)",
        thickness="thin; here t/W = 1e-3",
    ),
    order=(5, 0, 3),
    says="the wavelength is the square root of 2 π L t over the fourth root of 3 (1 - ν²) ε.",
    reading="Distance of neighbouring crests nearest the centre, on the deformed sheet, ν = 1/2.",
    tolerance=f"within {CLOSE:.0%} at every strain and for every bending law",
)
def wavelength_of_the_formula(study: StudyTables) -> Finding:
    """Compare the wavelengths with the formula."""
    ratios = {}
    sheets = under_each_bending_law(study, "nayyar", LONG, THIN)
    for name, sheet in sheets.items():
        strain, wavelength = sheet.wrinkled("strain", "wavelength_over_width")
        ratios[name] = wavelength / theory.cm_wavelength(strain, LONG, THIN)
    holds = {name: bool((np.abs(r - 1.0) <= CLOSE).all()) for name, r in ratios.items()}
    verdict, what = verdict_across(holds, "the bending law")
    low, high = (min(r.min() for r in ratios.values()), max(r.max() for r in ratios.values()))
    return Finding(
        verdict,
        (
            *bending_values("smallest λ over formula", {n: r.min() for n, r in ratios.items()}),
            *bending_values("largest λ over formula", {n: r.max() for n, r in ratios.items()}),
        ),
        f"λ is {low:.3g} to {high:.3g} of the formula. It balances bending and tension along "
        "wrinkles as long as the sheet; those computed end before the clamps. Panaitescu et al. "
        f"2019 multiply it by {theory.WAVELENGTH_FACTOR:g} at L/W = 2.",
        what,
        tuple(sheets.values()),
    )


@statement(
    Published(
        source=sources.MARTINS_2020,
        where="highlights",
        reliability="B",
        said="modes come in pairs",
        law="Hookean membrane; here Mooney-Rivlin C10 = 10 C01",
        aspect="not read; here 2",
        thickness="not read; here t/W = 1e-3",
    ),
    order=(5, 0, 4),
    says="symmetric and antisymmetric wrinkling modes are duplicates.",
    reading="Both parities have the same birth and decay strain. (The quadruplicity that the "
    "highlights name too needs modes that are odd along the sheet, which are not computed here.)",
    tolerance=f"birth and decay strains differ by at most {SAME:g} of themselves",
)
def parities_are_duplicates(study: StudyTables) -> Finding:
    """Compare birth, decay and force of both parities."""
    odd, even = (
        sheet_of(study, "mr-010", 2.0, THIN, parity=parity)
        for parity in ("antisymmetric", "symmetric")
    )
    apart = {
        name: abs(ours / other - 1.0)
        for name, ours, other in zip(("birth", "decay"), odd.limits(), even.limits(), strict=True)
    }
    force = relative_force(study)
    return Finding(
        verdict_of(max(apart.values()) <= SAME),
        (
            Value("birth strain, antisymmetric", odd.birth, digits=7),
            Value("birth strain, symmetric", even.birth, digits=7),
            Value("decay strain, antisymmetric", odd.decay, digits=7),
            Value("decay strain, symmetric", even.decay, digits=7),
            Value("largest relative difference of the force of wrinkled states", force, digits=2),
        ),
        f"Birth differs by {apart['birth']:.1g} of itself, decay by {apart['decay']:.1g}, the "
        f"force of wrinkled states by at most {number_text(force, 2)}.",
        sheets=(odd, even),
    )


def relative_force(study: StudyTables) -> float:
    """Return by how much the forces of wrinkled states of both parities differ at most.

    Raises
    ------
    MissingError
        If there is no strain at which both are wrinkled.
    """
    forces = []
    for parity in ("antisymmetric", "symmetric"):
        sheet = sheet_of(study, "mr-010", 2.0, THIN, parity=parity)
        columns = sheet.wrinkled("strain", "nominal_stress_pa")
        forces.append(dict(zip(*columns, strict=True)))
    common = forces[0].keys() & forces[1].keys()
    if not common:
        raise MissingError("wrinkled states of both parities at one strain")
    return max(abs(forces[0][eps] / forces[1][eps] - 1.0) for eps in common)


@statement(
    Published(
        source=sources.SILVESTRE_2016,
        where="abstract",
        reliability="B",
        said="restrained Poisson effect is one cause",
        law="Hookean",
        aspect="not read; here all of the map",
        thickness="any",
    ),
    order=(5, 0, 5),
    says="one cause of the compression that wrinkles the sheet is Poisson's contraction, which the "
    "clamps restrain.",
    reading="A Saint Venant-Kirchhoff sheet with ν = 0 has no thickness that wrinkles, one with "
    "ν = 1/2 has.",
    tolerance="that, at every strain and L/W of the map with ν = 0",
)
def poisson_contraction_compresses(study: StudyTables) -> Finding:
    """Look for critical thicknesses with and without Poisson's contraction."""
    table = study.table("map")
    without, with_it = (map_of(table, model).values for model in (WITHOUT_POISSON, HOOKEAN))
    if not (np.isfinite(without).any() and np.isfinite(with_it).any()):
        raise MissingError("critical thicknesses on both maps")
    highest, other = float(np.nanmax(without)), float(np.nanmax(with_it))
    return Finding(
        verdict_of(highest == 0.0 and other > 0.0),
        (
            Value("largest τ/W with ν = 0", highest),
            Value("largest τ/W with ν = 1/2", other),
        ),
        f"The largest critical thickness is {highest:.3g} W with ν = 0 and {other:.3g} W with "
        "ν = 1/2.",
    )
