"""Section 6: benchmarks and examples of other codes."""

import math
from dataclasses import replace

from wrinklestudy.equilibrium.critical_shape import wrinkle_mode
from wrinklestudy.fem.grid import make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.literature import published_mode, sources
from wrinklestudy.studies.literature.claims.strains import LONG, NAYYAR, THIN, birth_and_decay
from wrinklestudy.studies.literature.islands import birth_strain, critical_at
from wrinklestudy.studies.literature.statement import (
    Published,
    statement,
    under_each_bending_law,
)
from wrinklestudy.study.claims.finding import Finding, Value, listed, verdict_across, verdict_of
from wrinklestudy.study.claims.tables import StudyTables

SAME = 2.0e-3  # of birth and decay strain
CLOSE = 0.1  # of a load factor
PRESTRAIN = 0.01  # of the linear buckling analysis
# Load factors by L/W at t/W = 1e-3 in ground_truth_comsol_07070125.csv
LOAD_FACTORS = {2.0: 30.26, 3.0: 7.91, 3.5: 11.66, 5.0: 17.87}
NEO_HOOKEAN = "nayyar-fvk"
_BENDING = "the bending law"
_BENCHMARK = Published(
    source=sources.GISMO,
    where="",
    reliability="A",
    said="",
    aspect="2",
    thickness="t/W = 1e-3",
    clamps="no displacement across, no slope",
)


@statement(
    replace(
        _BENCHMARK,
        where="benchmarks/benchmark_Wrinkling.cpp",
        said="no number; C10 = 62148.5502 Pa, C01 = 158114.570 Pa",
        law="Mooney-Rivlin",
    ),
    order=(6, 0, 1),
    says="the benchmark is the sheet of Panaitescu et al.",
    reading="Its constants have more digits than those of the paper; the same strains follow from "
    "both.",
    tolerance=f"birth and decay strain within {SAME:.1%} of those of the paper's sheet, for every "
    "bending law",
)
def benchmark_is_the_sheet(study: StudyTables) -> Finding:
    """Compare birth and decay of both sets of constants."""
    theirs = under_each_bending_law(study, "gismo-mr", 2.0, THIN)
    ours = under_each_bending_law(study, study.wanted[0], 2.0, THIN)
    both = [name for name in theirs if name in ours]
    if not both:
        raise MissingError("a bending law of both sheets")
    apart = {name: _apart(theirs[name].limits(), ours[name].limits()) for name in both}
    verdict, what = verdict_across({n: d <= SAME for n, d in apart.items()}, _BENDING)
    return Finding(
        verdict,
        birth_and_decay({name: theirs[name] for name in both}),
        f"Birth and decay differ from those of the paper's constants by at most "
        f"{max(apart.values()):.2%}.",
        what,
        tuple(theirs[name] for name in both),
    )


def _apart(some: tuple[float, float], others: tuple[float, float]) -> float:
    return max(abs(a / b - 1.0) for a, b in zip(some, others, strict=True))


@statement(
    replace(
        _BENCHMARK,
        where="filedata/deformations/wrinklingPanaitescu_quarter.xml",
        said="nine numbers of a mode",
        law="not stated; Mooney-Rivlin of the benchmark",
    ),
    order=(6, 0, 2),
    says="a shape of the sheet, with which its benchmark is perturbed, is published as data.",
    reading="Read as the critical mode at small strain, where all bending laws are one: "
    f"`Sheet.mode({published_mode.STRAIN:g})`. How the file was made is not stated.",
    tolerance="places of crests and troughs within "
    f"{published_mode.PEAK_BAR:g} W, heights within {published_mode.HEIGHT_BAR:g} of the highest, "
    f"length within {published_mode.HALF_HEIGHT_BAR:g} W",
)
def shape_of_the_mode(study: StudyTables) -> Finding:
    """Compare the nine numbers."""
    if "gismo-mr" not in study.given:
        raise MissingError("the material gismo-mr")
    space = Space(make_grid(2.0, THIN))
    try:
        mode = wrinkle_mode(space, study.given["gismo-mr"].law, published_mode.STRAIN)
    except ArithmeticError as error:
        raise MissingError(f"the critical mode: {error}") from error
    numbers = published_mode.mode_numbers(mode)
    worst = max(numbers, key=lambda n: abs(n.computed - n.published) / n.bar)
    holds = all(abs(n.computed - n.published) <= n.bar for n in numbers)
    return Finding(
        verdict_of(holds),
        tuple(Value(f"{n.name} ({n.published:g})", n.computed, digits=4) for n in numbers),
        f"Farthest off: {worst.name} = {worst.computed:.4f}, published {worst.published:g}.",
    )


@statement(
    replace(NAYYAR, source=sources.COMSOL, where="page of its set-up", said="wrinkles; no number"),
    order=(6, 0, 3),
    says="the sheet of 25 cm x 10 cm x 0.1 mm wrinkles as it is stretched.",
    tolerance="a birth strain, for every bending law",
)
def example_wrinkles(study: StudyTables) -> Finding:
    """Look for a birth strain."""
    sheets = under_each_bending_law(study, "nayyar", LONG, THIN)
    births = {name: sheet.birth for name, sheet in sheets.items()}
    verdict, what = verdict_across({n: math.isfinite(b) for n, b in births.items()}, _BENDING)
    heights = {n: 0.1 * s.peak["max_amplitude_over_thickness"] for n, s in sheets.items()}
    return Finding(
        verdict,
        (
            *birth_and_decay(sheets),
            *(Value(f"largest amplitude, {n}", height, "mm") for n, height in heights.items()),
        ),
        f"Wrinkles come at {listed(births, 4)} and reach {listed(heights)} mm.",
        what,
        tuple(sheets.values()),
    )


@statement(
    Published(
        source=sources.WRINKLE_ABAQUS,
        where="ground_truth_comsol_07070125.csv",
        reliability="A",
        said=f"load factors {', '.join(f'{f:g}' for f in LOAD_FACTORS.values())}",
        law="neo-Hookean, μ = 6 MPa, W = 10 cm",
        aspect=", ".join(f"{a:g}" for a in LOAD_FACTORS),
        thickness="t/W = 1e-3",
        clamps="one end fixed, one displaced",
    ),
    order=(6, 0, 4),
    says="linear buckling from a strain of 1%, by COMSOL, has load factors from "
    f"{min(LOAD_FACTORS.values()):g} to {max(LOAD_FACTORS.values()):g}.",
    reading="Read as critical strain over that strain; computed here from the critical thickness "
    f"at ε = {PRESTRAIN:g}, (t/τ)².",
    tolerance=f"within {CLOSE:.0%} at every L/W that was computed",
)
def load_factors_of_comsol(study: StudyTables) -> Finding:
    """Compare the load factors."""
    critical = critical_at(study.table("map"), NEO_HOOKEAN, PRESTRAIN)
    ours = {
        aspect: birth_strain(THIN, critical[aspect], PRESTRAIN) / PRESTRAIN
        for aspect in LOAD_FACTORS
        if aspect in critical
    }
    if not ours:
        raise MissingError(f"a L/W of theirs on the map of {NEO_HOOKEAN}")
    texts = {f"L/W = {aspect:g}": factor for aspect, factor in ours.items()}
    holds = all(abs(LOAD_FACTORS[a] / factor - 1.0) <= CLOSE for a, factor in ours.items())
    excess = [LOAD_FACTORS[aspect] / factor for aspect, factor in ours.items()]
    return Finding(
        verdict_of(holds),
        tuple(Value(f"load factor at {where}", factor) for where, factor in texts.items()),
        f"Theirs are {min(excess):.3g} to {max(excess):.3g} times those computed here, "
        f"{listed(texts)}. Their mesh has 25 cells across the sheet, and the factor at L/W = 2 "
        f"would be a birth at ε = {PRESTRAIN * LOAD_FACTORS[2.0]:.2g}, where other sources of this "
        "page have the decay.",
    )
