"""Claims about maps, on made-up maps whose islands, parities, zones and signs are known."""

from dataclasses import replace

import numpy as np
import pytest
from made_up_study import STRAIN, sheet, world

from wrinklestudy.equilibrium.islands import Ridge
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.results.maps import MapRow
from wrinklestudy.results.tables import write_map
from wrinklestudy.studies.beyond import tips
from wrinklestudy.studies.beyond.tables.tips import table
from wrinklestudy.study.claims.discovery import load_claims

CLAIMS = {c.key: c for c in load_claims("beyond") if c.order[0] in (4, 8)}
STRAINS, ASPECTS = np.linspace(0.02, 0.5, 13), np.round(np.arange(1.2, 6.01, 0.2), 12)
FIRST, LAST = 1.545, 2.592  # at t/L = 5e-4


def ridge(aspect, first=FIRST, last=LAST):
    """The largest tau_1/W: with it (tau_1/L)^2 has the roots first and last of t/L = 5e-4."""
    excess = 0.8 * (aspect - first) * (last - aspect)
    return 5e-4 * aspect / np.sqrt(1.0 - excess)


def rows(highest, apart, quartic, place, material="mr-010-fvk", bending="fvk"):
    """Maps with tau_1^2 a parabola over strain that ends at 0.4."""
    for aspect in ASPECTS:
        for strain in STRAINS:
            tau = float(highest(aspect) * np.sqrt(max(25.0 * strain * (0.4 - strain), 0.0)))
            for parity, factor in (("antisymmetric", 1.0), ("symmetric", 1.0 + apart)):
                seen = {"half_waves": 8, "largest_at": place(aspect), "quartic": quartic(strain)}
                yield MapRow(
                    **(seen if tau else dict.fromkeys(seen)),
                    **{"material": material, "law": "mooney-rivlin", "bending": bending},
                    **{"parity": parity, "aspect": float(aspect), "strain": float(strain)},
                    status="unstable" if tau else "stable",
                    critical_thickness=tau * factor,
                    **{"corner_thickness": None, "cells_along": 18, "cells_across": 36},
                    reason="",
                )


def late(aspect):
    """The place of the largest wrinkle: from L/W = 3.5 on at a distance W from the clamp."""
    return max(0.5 - 1.0 / aspect, 0.0) if aspect > 3.5 else 0.0


@pytest.fixture
def study(tmp_path, monkeypatch):
    """A study with one map, and direct solutions that give its ridge."""

    def made(highest=ridge, apart=0.0, quartic=lambda _: 0.05, place=late, name="mr-010-fvk"):
        class Solved:
            def __init__(self, law, settings):
                assert settings.bending == "fvk"
                assert law == mooney_rivlin(1e5, 1e4).law

            def __call__(self, aspect, expected):
                return Ridge(highest(aspect), expected)

        monkeypatch.setattr(tips, "RidgeOfLaw", Solved)
        path = tmp_path / "map.csv"
        write_map(list(rows(highest, apart, quartic, place, material=name)), path)
        given = {"mr-010": mooney_rivlin(1e5, 1e4), "latex": mooney_rivlin(1e5, 1e4)}
        return replace(world(), given=given, analyses={"map": {"table": [path]}})

    return made


def sudden(strain):
    """Subcritical at decay only."""
    return 0.05 if strain < 0.2 else -0.05


CASES = [
    ("one-island", {}, "agree"),
    ("one-island", {"highest": lambda a: ridge(a) * (1.2 + np.cos(6.0 * a))}, "disagree"),
    ("tips-as-of-single-sheets", {}, "agree"),
    ("tips-as-of-single-sheets", {"highest": lambda a: ridge(a, first=1.56)}, "disagree"),
    ("tips-between-lengths", {}, "agree"),
    ("parities-agree", {}, "agree"),
    ("parities-agree", {"apart": 2e-3}, "disagree"),
    ("two-zones", {}, "agree"),
    ("two-zones", {"place": lambda a: 0.2 if a > 2.5 else 0.0}, "disagree"),
    ("two-zones", {"place": lambda _: 0.0}, "not computed"),
    ("zones-at-one-distance", {}, "agree"),
    ("zones-at-one-distance", {"place": lambda _: 0.3}, "disagree"),
    ("birth-is-gradual", {}, "agree"),
    ("birth-is-gradual", {"quartic": lambda _: -0.01}, "disagree"),
    ("birth-is-gradual", {"quartic": sudden}, "agree"),
    ("decay-is-gradual", {"quartic": sudden}, "disagree"),
    ("decay-is-gradual", {}, "agree"),
    ("island-separates-the-paper", {}, "not computed"),
    ("height-from-quartic", {}, "not computed"),
]


@pytest.mark.parametrize(("key", "changes", "verdict"), CASES)
def test_a_verdict_follows_from_the_map(study, key, changes, verdict):
    finding = CLAIMS[key].finding(study(**changes))
    assert finding.verdict == verdict, finding.explanation
    assert finding.explanation


@pytest.mark.parametrize(("last", "verdict"), [(3.2, "agree"), (2.9, "disagree")])
def test_the_papers_lengths_are_told_apart(study, last, verdict):
    """An island in t/W from 1.6."""

    def highest(aspect):
        return 1e-3 * np.sqrt(max(1.0 + 0.3 * (aspect - 1.6) * (last - aspect), 0.0))

    made = study(highest=highest, name="latex")
    assert CLAIMS["island-separates-the-paper"].finding(made).verdict == verdict


def test_the_table_has_the_roots_of_the_ridge(study):
    """In t/W the roots of (L/2W)^2 = 1 - 0.8 (a - first) (last - a)."""
    found = table(study())
    by_end = {(row[2], row[4]): row[5] for row in found.rows}
    assert by_end["t/L", "first"] == pytest.approx(FIRST, rel=1e-3)
    assert by_end["t/L", "last"] == pytest.approx(LAST, rel=1e-3)
    a = np.linspace(1.2, 5.0, 100001)
    excess = (a / 2.0) ** 2 - 1.0 + 0.8 * (a - FIRST) * (LAST - a)
    roots = a[:-1][np.diff(np.sign(excess)) != 0.0]
    assert [by_end["t/W", "first"], by_end["t/W", "last"]] == pytest.approx(roots, rel=1e-3)


@pytest.mark.parametrize(("factor", "verdict"), [(1.0, "agree"), (1.03, "disagree")])
def test_low_wrinkles_have_the_height_of_the_quartic_coefficient(study, factor, verdict):
    """tau_1^2 of the map at L/W = 2.4, g = 0.05: (A/t)^2 = 10 (tau_1^2/t^2 - 1)."""
    made, thickness = study(name="mr-010"), 1.2e-3
    squared = ridge(2.4) ** 2 * np.maximum(25.0 * STRAIN * (0.4 - STRAIN), 0.0)
    height = np.sqrt(np.maximum(squared / thickness**2 - 1.0, 0.0) * 10.0)
    columns = {"critical_thickness": np.sqrt(squared), "birth": 0.05, "decay": 0.35}
    columns["sheet_amplitude_over_thickness"] = factor * height
    low = sheet(material="mr-010", bending="fvk", aspect=2.4, thickness=thickness, **columns)
    found = CLAIMS["height-from-quartic"].finding(replace(made, sheets=(*made.sheets, low)))
    assert found.verdict == verdict, found.explanation


def test_a_study_without_maps_has_no_tips():
    assert table(world()).rows == ()
    assert {c.finding(world()).verdict for c in CLAIMS.values()} == {"not computed"}
