"""Section 2: small strain and finite strain in the plane."""

import math

import numpy as np

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.literature import sources
from wrinklestudy.studies.literature.membranes import FINITE_STRAIN, SMALL_STRAIN, sheets_by_model
from wrinklestudy.studies.literature.statement import Published, statement
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    listed,
    number_text,
    verdict_across,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables

QUARTER, OFF = 0.25, 0.05  # exponent of the strain, and its tolerance
FROM = 0.06  # strain from which sheets count as far from threshold
_HEIGHT = "amplitude_over_thickness"
_MEMBRANE = "the membrane"
_ASPECT, _THICKNESS = "not read; here 2", "not read; here t/W = 1e-3"


@statement(
    Published(
        source=sources.HEALEY_2013,
        where="as the abstract of Sipos and Fehér 2016 quotes it",
        reliability="C",
        said="wrinkles disappear with finite in-plane strain",
        law="Saint Venant-Kirchhoff membrane, plate of Föppl and von Kármán",
        aspect=_ASPECT,
        thickness=_THICKNESS,
    ),
    order=(2, 0, 1),
    says="with finite strain in the plane, the plate of Föppl and von Kármán becomes flat again.",
    tolerance="a decay strain of the Saint Venant-Kirchhoff sheet with bending law fvk",
)
def decay_with_finite_strain(study: StudyTables) -> Finding:
    """Look for the decay strain."""
    sheet = sheets_by_model(study)[FINITE_STRAIN[0]]
    return Finding(
        verdict_of(math.isfinite(sheet.decay)),
        (Value("birth strain, fvk", sheet.birth), Value("decay strain, fvk", sheet.end)),
        f"Wrinkles come at ε = {number_text(sheet.birth, 4)} and {_until(sheet)}.",
        sheets=(sheet,),
    )


def _until(sheet: SheetStates) -> str:
    return f"vanish at {sheet.decay:.4g}" if math.isfinite(sheet.decay) else "do not vanish"


@statement(
    Published(
        source=sources.FU_2019,
        where="abstract",
        reliability="B",
        said="wrinkles can vanish with SVK, neo-Hookean, Mooney-Rivlin",
        law="these, plate of Föppl and von Kármán at finite strain",
        aspect=_ASPECT,
        thickness=_THICKNESS,
    ),
    order=(2, 0, 2),
    says="wrinkles vanish upon excess stretching with each of several laws of finite strain.",
    tolerance="a decay strain with each law, bending law fvk",
)
def decay_with_every_law(study: StudyTables) -> Finding:
    """Look for the decay strain of each law."""
    sheets = sheets_by_model(study)
    finite = {model: sheets[model] for model in FINITE_STRAIN}
    verdict, what = verdict_across(
        {model: math.isfinite(sheet.decay) for model, sheet in finite.items()}, "the law"
    )
    ends = {sheet.law: sheet.end for sheet in finite.values()}
    return Finding(
        verdict,
        tuple(Value(f"decay strain of {law}, fvk", end) for law, end in ends.items()),
        f"Wrinkles vanish at {listed(ends, 4)}.",
        what,
        tuple(finite.values()),
    )


@statement(
    Published(
        source=sources.SIPOS_2016,
        where="abstract",
        reliability="B",
        said="no disappearance with infinitesimal strain",
        law="equations of Föppl and von Kármán",
        aspect=_ASPECT,
        thickness=_THICKNESS,
    ),
    order=(2, 0, 3),
    says="the equations of Föppl and von Kármán, with infinitesimal strain, know no disappearance "
    "of the wrinkles.",
    reading="The same sheet and bending law with a membrane whose strain is linear in the "
    "displacement in the plane: no decay strain, and an amplitude that grows with every strain, "
    "beyond those at which sheets of finite strain are flat.",
    tolerance="that, and a decay strain of each law of finite strain below the largest strain of "
    "the membrane",
)
def growth_without_end(study: StudyTables) -> Finding:
    """Compare the membrane of small strain with those of finite strain."""
    sheets = sheets_by_model(study)
    small = sheets[SMALL_STRAIN]
    strain, height = small.wrinkled("strain", _HEIGHT)
    if len(strain) < 2:
        raise MissingError(f"two wrinkled states of {small.label}")
    grows = bool((np.diff(height) > 0.0).all()) and small.end == math.inf
    ends = {sheets[model].law: sheets[model].end for model in FINITE_STRAIN}
    flat = all(end < strain[-1] for end in ends.values())
    return Finding(
        verdict_of(grows and flat),
        (
            Value("decay strain of the small-strain membrane, fvk", small.end),
            Value("its A/t at the smallest strain computed", float(height[0])),
            Value("its A/t at the largest strain computed", float(height[-1])),
            Value("that strain", float(strain[-1])),
            *(Value(f"decay strain of {law}, fvk", end) for law, end in ends.items()),
        ),
        f"A/t of the small-strain membrane goes from {height[0]:.3g} at ε = {strain[0]:g} to "
        f"{height[-1]:.3g} at {strain[-1]:g}; with finite strain wrinkles vanish at "
        f"{listed(ends)}.",
        sheets=tuple(sheets.values()),
    )


@statement(
    Published(
        source=sources.CERDA_2003,
        where="as Panaitescu et al. 2019 state it",
        reliability="C",
        said="A ∝ ε^(1/4)",
        law="Hookean, small strain",
        aspect="long",
        thickness="thin",
    ),
    order=(2, 0, 4),
    says="the amplitude grows as the fourth root of the strain.",
    reading=f"Slope of log A over log ε of all wrinkled states from ε = {FROM:g} on.",
    tolerance=f"within {OFF:g} of {QUARTER:g} with every membrane",
)
def amplitude_as_the_fourth_root(study: StudyTables) -> Finding:
    """Fit the exponent of the amplitude for each membrane."""
    sheets = sheets_by_model(study)
    exponents = {sheet.law: _exponent(sheet) for sheet in sheets.values()}
    holds = {law: abs(exponent - QUARTER) <= OFF for law, exponent in exponents.items()}
    verdict, what = verdict_across(holds, _MEMBRANE)
    return Finding(
        verdict,
        tuple(Value(f"exponent of A, {law}, fvk", exponent) for law, exponent in exponents.items()),
        f"Exponents: {listed(exponents)}.",
        what,
        tuple(sheets.values()),
    )


def _exponent(sheet: SheetStates) -> float:
    strain, height = sheet.wrinkled("strain", _HEIGHT, above=FROM - 1e-9)
    if len(strain) < 2:
        raise MissingError(f"two wrinkled states from strain {FROM:g} on, of {sheet.label}")
    return float(np.polyfit(np.log(strain), np.log(height), 1)[0])
