"""Item 4: which sheets wrinkle at all, over strain and L/W."""

import math
from collections.abc import Mapping

import numpy as np

from wrinklestudy.equilibrium.islands import Held
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond import maps
from wrinklestudy.studies.beyond.tips import islands_between, of_models, tips
from wrinklestudy.studies.beyond.zones import distances_from_clamp, parities, zones
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    claim,
    number_text,
    verdict_across,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables

TO = 0.005  # of the L/W of a tip
# Found from single sheets before there were maps, at t/L = 5e-4
EARLIER: Mapping[str, Mapping[str, float]] = {
    "mr-010-fvk": {"first": 1.545, "last": 2.592},
    "latex-nh-fvk": {"last": 2.584},
    "svk-50-fvk": {"first": 1.711, "last": 2.941},
}
WRINKLED, FLAT = (1.8, 2.0, 2.5, 3.0), (1.5, 3.5)  # L/W of the paper's sheets at t/W = 1e-3
SAME = 1.0e-3  # of the critical thickness of both parities
COUNTED = 1.0e-4  # t/W from which parities are compared
SPLIT = (3.25, 3.75)  # L/W beyond which there would be two zones
STEADY = 0.1  # of the mean distance of a zone from the clamp
LONG = 4.0  # L/W from which zones count as far from each other


def tips_of(study: StudyTables, held: Held) -> dict[str, dict[str, float]]:
    """Return the L/W of the tips by model and end.

    Raises
    ------
    MissingError
        If no island has a tip on a map.
    """
    found = of_models(tips(study), held)
    if not found:
        raise MissingError(f"a tip of an island at fixed {held}")
    return {model: {end: tip.aspect for end, tip in ends.items()} for model, ends in found.items()}


def _spans(ends: Mapping[str, Mapping[str, float]]) -> str:
    def text(known: Mapping[str, float], end: str) -> str:
        return number_text(known[end], 4) if end in known else "beyond the map"

    return ", ".join(
        f"{text(known, 'first')} to {text(known, 'last')} ({model})"
        for model, known in ends.items()
    )


def _values(ends: Mapping[str, Mapping[str, float]]) -> tuple[Value, ...]:
    return tuple(
        Value(f"{end} L/W, {model}", aspect, digits=4)
        for model, known in ends.items()
        for end, aspect in known.items()
    )


@claim(
    order=(4, 0, 1),
    place=f"t/W = {maps.PAPER_THICKNESS:g}",
    statement="Whatever the law, sheets of one thickness wrinkle in one range of L/W.",
    reading="Ends solved directly near those of the map; a range is of sheets that wrinkle at some "
    "strain.",
    tolerance="one island on the map of each model whose islands end there, both ends found",
)
def one_island(study: StudyTables) -> Finding:
    """Count islands and give their tips."""
    between, ends = islands_between(study, "t/W"), tips_of(study, "t/W")
    outcomes = {
        model: len(islands) == 1 and all(math.isfinite(a) for a in ends[model].values())
        for model, islands in between.items()
        if all(island.first and island.last for island in islands)
    }
    if not outcomes:
        raise MissingError("a map that reaches beyond both ends of an island")
    verdict, depends = verdict_across(outcomes, "the model")
    return Finding(
        verdict,
        _values(ends),
        f"At t/W = {maps.PAPER_THICKNESS:g} sheets wrinkle for L/W = {_spans(ends)}.",
        depends,
    )


@claim(
    order=(4, 0, 2),
    place="the paper's rubber, t/W = 1e-3",
    statement="The map separates the paper's lengths that wrinkle from those that do not.",
    tolerance=f"L/W = {', '.join(f'{a:g}' for a in WRINKLED)} inside the island, "
    f"{' and '.join(f'{a:g}' for a in FLAT)} outside",
)
def island_separates_the_paper(study: StudyTables) -> Finding:
    """Compare the tips of the paper's rubber with the paper's lengths."""
    ends = tips_of(study, "t/W").get(maps.PAPER_MATERIAL, {})
    if set(ends) != {"first", "last"}:
        raise MissingError(f"both tips of {maps.PAPER_MATERIAL}")
    first, last = ends["first"], ends["last"]
    holds = all(first < a < last for a in WRINKLED) and not any(first < a < last for a in FLAT)
    return Finding(
        verdict_of(holds),
        (Value("first L/W", first, digits=4), Value("last L/W", last, digits=4)),
        f"The island spans L/W = {first:.4g} to {last:.4g}; the paper's flat sheets nearest to it "
        f"have L/W = {FLAT[0]:g} and {FLAT[1]:g}.",
    )


@claim(
    order=(4, 0, 3),
    place=f"t/L = {maps.PUBLISHED_OVER_LENGTH:g}",
    statement="Islands from maps end where single sheets solved before ended.",
    reading="Föppl-von Kármán bending; SVK with Poisson's ratio 1/2.",
    tolerance=f"each tip within {TO:.1%}: "
    + "; ".join(f"{m} {', '.join(f'{v:g}' for v in e.values())}" for m, e in EARLIER.items()),
)
def tips_as_of_single_sheets(study: StudyTables) -> Finding:
    """Compare tips at fixed t/L with earlier ones."""
    ends = tips_of(study, "t/L")
    off = {
        f"{end} L/W, {model}": ends[model][end] / expected - 1.0
        for model, known in EARLIER.items()
        for end, expected in known.items()
        if end in ends.get(model, {})
    }
    if not off:
        raise MissingError("tips of models with earlier ones")
    worst = max(off, key=lambda name: abs(off[name]))
    return Finding(
        verdict_of(all(abs(value) <= TO for value in off.values())),
        _values(ends),
        f"At t/L = {maps.PUBLISHED_OVER_LENGTH:g} sheets wrinkle for L/W = {_spans(ends)}. Of "
        f"{len(off)} tips known before the farthest off is the {worst}, by {off[worst]:+.2%}.",
    )


@claim(
    order=(4, 0, 4),
    place="all tips",
    statement="Between the L/W of a map its tips can be interpolated.",
    reading="Cubic splines through the largest critical thickness of each L/W, as on the figures, "
    "against direct solutions.",
    tolerance=f"each within {TO:.1%}",
)
def tips_between_lengths(study: StudyTables) -> Finding:
    """Compare interpolated tips with corrected ones."""
    off = {f"{t.model}, {t.held}, {t.end}": t.between / t.aspect - 1.0 for t in tips(study)}
    worst = max(off, key=lambda name: abs(off[name]) if math.isfinite(off[name]) else math.inf)
    return Finding(
        verdict_of(all(abs(value) <= TO for value in off.values())),
        (Value("tips", len(off)), Value("largest error of L/W", off[worst])),
        f"Of {len(off)} tips the worst ({worst}) is off by {number_text(off[worst], 2)} of L/W.",
    )


@claim(
    order=(4, 0, 5),
    place="all points of all maps",
    statement="Symmetric and antisymmetric wrinkles appear on sheets of the same thickness.",
    reading=f"Where sheets of t/W = {COUNTED:g} or more wrinkle.",
    tolerance=f"critical thicknesses equal to {SAME:.1%} at every such point",
)
def parities_agree(study: StudyTables) -> Finding:
    """Compare the critical thicknesses of both parities."""
    found = parities(study.table("map"), COUNTED)
    if found.empty:
        raise MissingError("points of a map with both parities")
    apart = found[found["apart"].abs() > SAME]
    worst = found.iloc[int(found["apart"].abs().argmax())]
    thickest = apart["critical_thickness"].max() if len(apart) else math.nan
    where = (
        f" They do at L/W = {apart['aspect'].min():g} to {apart['aspect'].max():g}, where sheets "
        f"up to t/W = {thickest:.3g} wrinkle: most at L/W = {worst['aspect']:g}, "
        f"ε = {worst['strain']:g} ({worst['material']}), by {worst['apart']:+.1%} "
        "(antisymmetric over symmetric)."
        if len(apart)
        else ""
    )
    return Finding(
        verdict_of(apart.empty),
        (
            Value("points", len(found), digits=6),
            Value("points where they differ", len(apart), digits=6),
            Value("largest difference", float(worst["apart"])),
            Value("median difference", float(found["apart"].abs().median())),
        ),
        f"At {len(apart)} of {len(found)} points the parities differ by more than {SAME:.1%}."
        f"{where}",
    )


@claim(
    order=(4, 0, 6),
    place="where the thickest sheet of each L/W wrinkles",
    statement="Short sheets wrinkle in the middle, long ones in two zones near the ends; the "
    "change is near L/W = 3.5.",
    reading="The critical mode is largest at the centre of a short sheet. It leaves the centre "
    "between two L/W of the map.",
    tolerance=f"middle of these two between {SPLIT[0]:g} and {SPLIT[1]:g}, and no return to the "
    "centre on longer sheets",
)
def two_zones(study: StudyTables) -> Finding:
    """Find the L/W at which the critical mode leaves the centre."""
    found = zones(study.table("map"))
    if not found:
        raise MissingError("a map on which the mode leaves the centre")
    outcomes = {
        model: z.settled and SPLIT[0] <= 0.5 * (z.last_central + z.first_apart) <= SPLIT[1]
        for model, z in found.items()
    }
    verdict, depends = verdict_across(outcomes, "the model")
    texts = [
        f"between L/W = {z.last_central:g} and {z.first_apart:g} ({model})"
        for model, z in found.items()
    ]
    longest = max(found.values(), key=lambda z: z.longest)
    return Finding(
        verdict,
        tuple(
            Value(f"first L/W with two zones, {model}", z.first_apart) for model, z in found.items()
        ),
        f"The largest wrinkle leaves the centre {', '.join(texts)}; at L/W = {longest.longest:g} "
        f"it is at x/L = ±{longest.place_at_longest:.3f}. That there are two maxima does not say "
        "how low the wrinkles between them are.",
        depends,
    )


@claim(
    order=(4, 0, 7),
    place=f"sheets with L/W of {LONG:g} and more",
    statement="On long sheets the zones stay at one distance from the clamps, in widths.",
    reading="At the strain of the map nearest 0.1, undeformed sheet.",
    tolerance=f"(1/2 - x/L) L/W within {STEADY:.0%} of its mean over the L/W of each model",
)
def zones_at_one_distance(study: StudyTables) -> Finding:
    """Compare the distances of the largest wrinkle from the clamp."""
    found = distances_from_clamp(study.table("map"), LONG, 0.1)
    found = {model: d for model, d in found.items() if len(d) > 1}
    if not found:
        raise MissingError(f"maps with two L/W from {LONG:g}")
    outcomes = {
        model: bool((np.abs(np.array([*d.values()]) / np.mean([*d.values()]) - 1) <= STEADY).all())
        for model, d in found.items()
    }
    verdict, depends = verdict_across(outcomes, "the model")
    texts = [
        f"{min(d.values()):.3g} to {max(d.values()):.3g} W "
        f"({model}, L/W = {min(d):g} to {max(d):g})"
        for model, d in found.items()
    ]
    means = tuple(
        Value(f"mean distance over W, {model}", float(np.mean(list(d.values()))))
        for model, d in found.items()
    )
    return Finding(verdict, means, f"The distance is {', '.join(texts)}.", depends)
