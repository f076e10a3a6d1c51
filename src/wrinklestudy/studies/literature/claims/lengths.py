"""Section 3: which lengths wrinkle, and where along the sheet."""

import math

import numpy as np

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond.zones import zones
from wrinklestudy.studies.literature import sources
from wrinklestudy.studies.literature.islands import (
    HELD,
    HOOKEAN,
    largest_at,
    last_lengths,
    map_of,
)
from wrinklestudy.studies.literature.statement import Published, bending_values, statement
from wrinklestudy.studies.panaitescu2019.claims.dimensions import (
    EARLIER_ISLAND,
    LONG,
    SAME_END,
)
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    listed,
    verdict_across,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables

# Bending law of each model of the 10:1 sheet, and the neo-Hookean sheet that Li and Healey have too
TEN_TO_ONE = {
    "mr-010": "thinning",
    "mr-010-fixed": "fixed-thickness",
    "mr-010-fvk": "fvk",
}
NEO_HOOKEAN = "nayyar-fvk"


@statement(
    Published(
        source=sources.LI_2016,
        where="as Panaitescu et al. 2019, Sec. III.D, quote it",
        reliability="C",
        said=f"last L/W {EARLIER_ISLAND:g}",
        law="Mooney-Rivlin C10 = 10 C01, neo-Hookean; plate of Föppl and von Kármán",
        aspect="varied",
        thickness=f"t/L held; inferred: {HELD['t/L']:g}",
    ),
    order=(3, 0, 1),
    says=f"with length and thickness held, sheets longer than L/W = {EARLIER_ISLAND:g} do not "
    "wrinkle.",
    reading=f"At t/L = {HELD['t/L']:g}, that of the paper's sheet. Which t/L was held is inferred "
    "from the agreement; the ends are computed.",
    tolerance=f"last L/W within {SAME_END:g}, the rounding of the published number, with t/L held, "
    "and not with t/W held, for every bending law and for the neo-Hookean sheet",
)
def last_length_that_wrinkles(study: StudyTables) -> Finding:
    """Compare the last L/W that wrinkles with the published one, for either ratio held."""
    by_held = {held: last_lengths(study, held) for held in HELD}
    names = TEN_TO_ONE | {NEO_HOOKEAN: "neo-Hookean with fvk"}
    ends = {
        held: {names[model]: last for model, last in lasts.items() if model in names}
        for held, lasts in by_held.items()
    }
    if not ends["t/L"]:
        raise MissingError(f"an upper end of {', '.join(names)}")
    holds = {
        name: abs(last - EARLIER_ISLAND) <= SAME_END
        and not abs(ends["t/W"].get(name, math.nan) - EARLIER_ISLAND) <= SAME_END
        for name, last in ends["t/L"].items()
    }
    verdict, what = verdict_across(holds, "the model")
    inferred = largest_at(study.table("map"), EARLIER_ISLAND)
    ratios = {
        names[model]: highest / EARLIER_ISLAND
        for model, highest in inferred.items()
        if model in names
    }
    return Finding(
        verdict,
        (
            *bending_values("last L/W, t/L held", ends["t/L"], 4),
            *bending_values("last L/W, t/W held", ends["t/W"], 4),
            *bending_values(f"t/L that ends at {EARLIER_ISLAND:g}", ratios),
        ),
        f"Computed with t/L = {HELD['t/L']:g} held: {listed(ends['t/L'], 4)}; with t/W = "
        f"{HELD['t/W']:g} held: {listed(ends['t/W'], 4)}. Inferred: a last L/W of "
        f"{EARLIER_ISLAND:g} belongs to t/L = {listed(ratios)}.",
        what,
    )


@statement(
    Published(
        source=sources.PANAITESCU_2019,
        where="Sec. III.D",
        reliability="A",
        said=f"L/W = {LONG:g} wrinkles; Li and Healey: flat",
        law="latex; Mooney-Rivlin and neo-Hookean",
        aspect=f"{LONG:g}",
        thickness="t/W = 1e-3 here, t/L there",
    ),
    order=(3, 0, 2),
    says=f"that a sheet of L/W = {LONG:g} wrinkles is at variance with Li and Healey.",
    reading="It is if a model is flat where the experiment wrinkles, at t/W = "
    f"{HELD['t/W']:g}, or wrinkles where Li and Healey have a flat sheet, at t/L = "
    f"{HELD['t/L']:g}.",
    tolerance="that, for every model with a map",
)
def contradiction_at_three(study: StudyTables) -> Finding:
    """Ask which models wrinkle at L/W = 3 with either ratio held."""
    found = largest_at(study.table("map"), LONG)
    highest = {m: t for m, t in found.items() if t > 0.0}
    if not highest:
        raise MissingError(f"L/W = {LONG:g} on a map")
    wide, long = HELD["t/W"], HELD["t/L"] * LONG
    at_odds = {model: not wide < top < long for model, top in highest.items()}
    verdict, what = verdict_across(at_odds, "the model")
    return Finding(
        verdict,
        (
            *(Value(f"largest τ/W at L/W = {LONG:g}, {m}", top) for m, top in highest.items()),
            Value("t/W if t/W is held", wide),
            Value("t/W if t/L is held", long),
        ),
        f"At L/W = {LONG:g} sheets thinner than {listed(highest)} in units of W wrinkle at some "
        f"strain: of {len(highest)} models {sum(t > wide for t in highest.values())} with t/W = "
        f"{wide:g} held and {sum(t > long for t in highest.values())} with t/L = "
        f"{HELD['t/L']:g} held, {long:g} W thick.",
        what,
    )


@statement(
    Published(
        source=sources.HEALEY_2013,
        where="as the abstract of Sipos and Fehér 2016 quotes it",
        reliability="C",
        said="none at some L/W, at any strain",
        law="Saint Venant-Kirchhoff membrane, plate of Föppl and von Kármán",
        aspect="varied",
        thickness="not read; here t/L = 5e-4",
    ),
    order=(3, 0, 3),
    says="at some aspect ratios there are no wrinkles at any strain.",
    tolerance=f"with t/L = {HELD['t/L']:g} held, flat sheets on both sides of the L/W that wrinkle",
)
def no_wrinkles_at_some_lengths(study: StudyTables) -> Finding:
    """Compare the largest critical thickness of each L/W with t/L."""
    ridges = map_of(study.table("map"), HOOKEAN).ridges()
    wrinkled = {a: ridge.thickness > HELD["t/L"] * a for a, ridge in ridges.items()}
    inside = [a for a, yes in wrinkled.items() if yes]
    holds = bool(inside) and min(wrinkled) < min(inside) and max(inside) < max(wrinkled)
    texts = [f"{a:g}" for a in inside] or ["none"]
    return Finding(
        verdict_of(holds),
        (Value("L/W on the map", len(wrinkled)), Value("of these wrinkle, fvk", len(inside))),
        f"Of L/W = {min(wrinkled):g} to {max(wrinkled):g} there wrinkle: {', '.join(texts)}.",
    )


@statement(
    Published(
        source=sources.SIPOS_2016,
        where="abstract",
        reliability="B",
        said="finite decay at any aspect ratio",
        law="orthotropic, Saint Venant-Kirchhoff type; here isotropic, ν = 1/2",
        aspect="any",
        thickness="any",
    ),
    order=(3, 0, 4),
    says="the stretch at which wrinkles vanish is finite at any aspect ratio.",
    reading="At the largest strain of the map no thickness wrinkles.",
    tolerance="for every L/W of the map",
)
def finite_decay_at_any_length(study: StudyTables) -> Finding:
    """Look for critical thicknesses at the largest strain."""
    shown = map_of(study.table("map"), HOOKEAN)
    final = shown.values[:, -1]
    known = np.isfinite(final)
    if not known.any():
        raise MissingError(f"a critical thickness at the largest strain of {HOOKEAN}")
    lengths = [f"L/W = {aspect:g}" for aspect in shown.aspects]
    gone = {lengths[k]: bool(final[k] == 0.0) for k in np.flatnonzero(known)}
    verdict, what = verdict_across(gone, "the length")
    ends = {
        length: float(shown.strains[row > 0.0].max(initial=0.0))
        for length, row in zip(lengths, shown.values, strict=True)
    }
    return Finding(
        verdict,
        tuple(Value(f"last strain with a mode, {name}, fvk", end) for name, end in ends.items()),
        f"The last strains of the map at which some thickness wrinkles: {listed(ends)}; the map "
        f"ends at {shown.strains[-1]:g}.",
        what,
    )


@statement(
    Published(
        source=sources.SIPOS_2016,
        where="abstract",
        reliability="B",
        said="more than one wrinkled zone",
        law="orthotropic, Saint Venant-Kirchhoff type; here isotropic, ν = 1/2",
        aspect="elongated",
        thickness="20 µm film; here the critical one",
    ),
    order=(3, 0, 5),
    says="elongated sheets have more than one highly wrinkled zone.",
    reading="From some L/W on the critical mode is largest away from the centre, on both sides.",
    tolerance="at the largest L/W of the map it is, at the smallest it is not",
)
def zones_of_long_sheets(study: StudyTables) -> Finding:
    """Look where along the sheet the mode is largest."""
    table = study.table("map")
    found = zones(table[table["material"] == HOOKEAN]).get(HOOKEAN)
    if found is None:
        map_of(table, HOOKEAN)
        return Finding("disagree", (), "On this map the mode is largest at one place throughout.")
    return Finding(
        verdict_of(found.settled),
        (
            Value("first L/W with two zones, fvk", found.first_apart),
            Value(f"their |x|/L at L/W = {found.longest:g}, fvk", found.place_at_longest),
        ),
        f"The mode leaves the centre between L/W = {found.last_central:g} and "
        f"{found.first_apart:g}; at {found.longest:g} it is largest at x/L = "
        f"±{found.place_at_longest:.2f}.",
    )
