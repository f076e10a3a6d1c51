"""Statements of others on made-up studies: each verdict comes out both ways, memory has none."""

import re
from dataclasses import replace

import numpy as np
import pytest
from made_up_study import NEVER, STRAIN, sheet, world

from wrinklestudy.equilibrium.islands import Ridge
from wrinklestudy.mechanics.laws import mooney_rivlin, neo_hookean, saint_venant_kirchhoff
from wrinklestudy.results.maps import MapRow
from wrinklestudy.results.tables import write_map
from wrinklestudy.studies.beyond import tips
from wrinklestudy.studies.literature import CATALOGUE, published_mode, sources
from wrinklestudy.studies.literature.claims import codes
from wrinklestudy.studies.literature.islands import HELD
from wrinklestudy.studies.literature.sources import Source
from wrinklestudy.studies.literature.statement import Published, Statement, statement
from wrinklestudy.studies.literature.tables import sources as source_table
from wrinklestudy.studies.literature.tables.statements import table
from wrinklestudy.studies.literature.unread import OPEN_STATEMENTS
from wrinklestudy.study.claims.discovery import load_claims
from wrinklestudy.study.claims.finding import VERDICTS

CLAIMS = {claim.key: claim for claim in load_claims("literature")}
LONG = {"aspect": 2.5, "birth": 0.034, "peak": 0.1, "scale": 0.57 / 0.8}
NH, SVK = {"law": "neo-hookean"}, {"law": "svk"}
ENVELOPE = {
    "envelope_length_over_width": 1.5,
    "deformed_envelope_length_over_width": 1.6,
    "sheet_amplitude_over_thickness": 3.0,
    "nominal_stress_pa": 1e5 * STRAIN,
}


def growing(exponent=0.25, end=np.inf):
    """A/t of a membrane that is flat below its birth and grows with a power of the strain."""
    return np.where((STRAIN > 0.025) & (end > STRAIN), 9.0 * STRAIN**exponent, 0.0)


LONG |= {"excess": 0.0, **ENVELOPE}

SHEETS = {
    "nayyar": {**LONG, **NH, "decay": 0.29},
    "nayyar-fixed": {**LONG, **NH, "decay": 0.25, "bending": "fixed-thickness"},
    "nayyar-fvk": {**LONG, **NH, "decay": 0.292, "bending": "fvk"},
    "nayyar*": {**LONG, **NH, "birth": 0.012, "decay": 0.5, "thickness": 5e-4},
    "mr-010": {"decay": 0.286, **ENVELOPE},
    "mr-010-fixed": {"decay": 0.25, "bending": "fixed-thickness"},
    "mr-010-fvk": {"decay": 0.2956, "bending": "fvk"},
    "mr-010-symmetric": {"decay": 0.286, "parity": "symmetric", **ENVELOPE},
    "gismo-mr": {},
    "gismo-mr-fixed": {"bending": "fixed-thickness"},
    "gismo-mr-fvk": {"bending": "fvk"},
    "nayyar-fvk*": {**NH, "decay": 0.265, "bending": "fvk"},
    "svk-50-fvk": {**SVK, "decay": 0.12, "bending": "fvk"},
    "membrane-fvk": {
        "law": "foppl-von-karman",
        "bending": "fvk",
        "limits": (0.025, np.nan),
        "decay": 9.0,
        "amplitude_over_thickness": growing(),
    },
}
GIVEN = {
    "gismo-mr": mooney_rivlin(6.21485502e4, 15.8114570e4),
    "mr-010": mooney_rivlin(1e5, 1e4),
    "nayyar": neo_hookean(3e6),
    "svk-50": saint_venant_kirchhoff(1e6, 0.5),
    "svk-00": saint_venant_kirchhoff(1e6, 0.0),
}
STRAINS = np.array([0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5])
LENGTHS = (1.0, 1.2, 1.6, 2.0, 2.6, 3.0, 3.5, 4.0, 5.0)
FIRST, LAST = 1.5, 2.6  # at t/L = 5e-4


def ridge(aspect, last=LAST):
    """The largest tau_1/W: with it (tau_1/L)^2 has the roots FIRST and last of t/L = 5e-4."""
    excess = 0.8 * (aspect - FIRST) * (last - aspect)
    return HELD["t/L"] * aspect / np.sqrt(1.0 - min(excess, 0.9))


def map_rows(model, law, highest, ends=0.45, small=None, place=lambda a: 0.3 if a > 3.4 else 0.0):
    """A map: tau_1^2 a parabola over strain up to its end, of a given value at strain 0.01."""
    for aspect in LENGTHS:
        for strain in STRAINS:
            tau = highest(aspect) * np.sqrt(max(4 * strain * (ends - strain) / ends**2, 0.0))
            if small is not None and strain == STRAINS[0]:
                tau = small(aspect)
            seen = {"half_waves": 8, "largest_at": place(aspect), "quartic": 0.05}
            yield MapRow(
                **(seen if tau else dict.fromkeys(seen)),
                **{"material": model, "law": law, "bending": "fvk", "parity": "antisymmetric"},
                **{"aspect": aspect, "strain": float(strain), "reason": ""},
                status="unstable" if tau else "stable",
                critical_thickness=float(tau),
                **{"corner_thickness": None, "cells_along": 18, "cells_across": 36},
            )


def like_theirs(aspect):
    """tau_1/W at strain 0.01 for the load factors of the other code."""
    return 1e-3 / np.sqrt(codes.LOAD_FACTORS.get(aspect, 10.0))


MAPS = {
    "mr-010-fvk": {"law": "mooney-rivlin", "highest": ridge},
    "nayyar-fvk": {"law": "neo-hookean", "highest": ridge},
    "svk-50-fvk": {"law": "svk", "highest": ridge, "ends": 0.45},
    "svk-00": {"law": "svk", "highest": lambda _: 0.0},
}


@pytest.fixture
def study(tmp_path, monkeypatch):
    """Return a function that makes a study with changes of sheets and maps; None leaves one out."""

    def made(sheets=(), maps=(), solved=ridge):
        sheets, maps = dict(sheets), dict(maps)

        class Solved:
            def __init__(self, *_):
                pass

            def __call__(self, aspect, expected):
                return Ridge(solved(aspect), expected)

        monkeypatch.setattr(tips, "RidgeOfLaw", Solved)
        tips.tips.cache_clear()
        paths = []
        for name, own in MAPS.items():
            if maps.get(name, {}) is not None:
                paths.append(tmp_path / f"{name}.csv")
                write_map(list(map_rows(name, **own | maps.get(name, {}))), paths[-1])
        kept = tuple(
            sheet(material=name.rstrip("*"), **own | sheets.get(name, {}))
            for name, own in SHEETS.items()
            if sheets.get(name, {}) is not None
        )
        base = world()
        return replace(
            base,
            sheets=(*base.sheets, *kept),
            given=GIVEN,
            analyses={"map": {"table": paths}} if paths else {},
        )

    return made


def powers(power):
    """tau_1/W at strain 0.01 of sheets whose birth strain goes as a power of L/W."""
    return {"svk-50-fvk": {"small": lambda aspect: 5e-4 * aspect ** (-0.5 * power)}}


def each(names, **changes):
    return dict.fromkeys(names, changes)


NAYYAR = ("nayyar", "nayyar-fixed", "nayyar-fvk")
TEN = ("mr-010", "mr-010-fixed", "mr-010-fvk")

# statement, changes of sheets, changes of maps, verdict
CASES = [
    ("decay-of-ten-to-one", {}, {}, "depends on"),  # fixed thickness is at 0.25
    ("decay-of-ten-to-one", {"mr-010-fixed": {"decay": 0.28}}, {}, "agree"),
    ("decay-of-ten-to-one", each(TEN, decay=0.4), {}, "disagree"),
    ("rise-and-fall", {}, {}, "agree"),
    ("rise-and-fall", each(NAYYAR, limits=(0.034, np.nan)), {}, "disagree"),
    ("rise-and-fall", {"nayyar": {"limits": (0.034, np.nan)}}, {}, "depends on"),
    ("sensitive-to-thickness", {}, {}, "agree"),
    ("sensitive-to-thickness", {"nayyar*": {"birth": 0.03}}, {}, "disagree"),
    ("highest-at-a-tenth", {}, {}, "agree"),
    ("highest-at-a-tenth", each(NAYYAR, peak=0.2), {}, "disagree"),
    ("polyethylene-stays-wrinkled", {}, {}, "disagree"),
    ("polyethylene-stays-wrinkled", each(NAYYAR, limits=(0.034, np.nan)), {}, "agree"),
    ("soft-films", {}, {}, "depends on"),  # not the paper's rubber
    ("soft-films", {"nayyar": {"decay": 0.4}, "mr-010": {"decay": 0.5}}, {}, "disagree"),
    ("decay-with-finite-strain", {}, {}, "agree"),
    ("decay-with-finite-strain", {"svk-50-fvk": {"limits": (0.025, np.nan)}}, {}, "disagree"),
    ("decay-with-every-law", {}, {}, "agree"),
    ("decay-with-every-law", {"nayyar-fvk*": {"limits": (0.02, np.nan)}}, {}, "depends on"),
    ("growth-without-end", {}, {}, "agree"),
    ("growth-without-end", {"membrane-fvk": {"limits": (0.025, 0.4)}}, {}, "disagree"),
    (
        "growth-without-end",
        {"membrane-fvk": {"amplitude_over_thickness": growing(-0.1)}},
        {},
        "disagree",
    ),
    ("growth-without-end", {"mr-010-fvk": {"limits": (0.025, np.nan)}}, {}, "disagree"),
    ("amplitude-as-the-fourth-root", {}, {}, "depends on"),  # only with small strain
    (
        "amplitude-as-the-fourth-root",
        {
            name: {"amplitude_over_thickness": growing(), "decay": 9.0}
            for name in ("membrane-fvk", "svk-50-fvk", "nayyar-fvk*", "mr-010-fvk")
        },
        {},
        "agree",
    ),
    (
        "amplitude-as-the-fourth-root",
        {"membrane-fvk": {"amplitude_over_thickness": growing(0.5)}},
        {},
        "disagree",
    ),
    ("contradiction-at-three", {}, {}, "disagree"),
    ("contradiction-at-three", {}, each(MAPS, highest=lambda _: 2e-3), "agree"),
    ("contradiction-at-three", {}, {"mr-010-fvk": {"highest": lambda _: 9e-4}}, "depends on"),
    ("no-wrinkles-at-some-lengths", {}, {}, "agree"),
    ("no-wrinkles-at-some-lengths", {}, each(["svk-50-fvk"], highest=lambda _: 1e-2), "disagree"),
    ("finite-decay-at-any-length", {}, {}, "agree"),
    ("finite-decay-at-any-length", {}, {"svk-50-fvk": {"ends": 0.6}}, "disagree"),
    ("zones-of-long-sheets", {}, {}, "agree"),
    ("zones-of-long-sheets", {}, {"svk-50-fvk": {"place": lambda _: 0.0}}, "disagree"),
    ("threshold-of-stretch", {}, {}, "agree"),
    ("threshold-of-stretch", {"membrane-fvk": {"limits": (0.03, np.nan)}}, {}, "agree"),
    ("threshold-of-stretch", {"membrane-fvk": {"limits": (0.07, np.nan)}}, {}, "disagree"),
    ("threshold-of-stretch", {"membrane-fvk": {"limits": (0.001, np.nan)}}, {}, "not computed"),
    ("critical-stretch-of-long-sheets", {}, powers(4.0), "agree"),
    ("critical-stretch-of-long-sheets", {}, powers(1.0), "disagree"),
    ("critical-stretch-of-wide-sheets", {}, powers(2.0), "agree"),
    ("critical-stretch-of-wide-sheets", {}, powers(1.0), "disagree"),
    (
        "critical-stretch-of-wide-sheets",
        {},
        {"svk-50-fvk": {"small": lambda a: 0.0 if a < 1.5 else 1e-4}},
        "disagree",
    ),
    ("wavelength-over-strain", {}, {}, "depends on"),  # -1/4 on the deformed sheet alone
    ("wavelength-over-strain", {"nayyar": {"projected_width_over_width": 1.0}}, {}, "agree"),
    ("wavelength-over-strain", {"nayyar": {"wavelength_over_width": 0.1}}, {}, "disagree"),
    ("wavelength-over-thickness", {}, {}, "agree"),
    ("wavelength-over-thickness", {"nayyar*": {"scale": 1.2}}, {}, "disagree"),
    ("wavelength-of-the-formula", {}, {}, "disagree"),
    ("wavelength-of-the-formula", each(NAYYAR, scale=1.25), {}, "agree"),
    ("wavelength-of-the-formula", {"nayyar": {"scale": 1.25}}, {}, "depends on"),
    ("parities-are-duplicates", {}, {}, "agree"),
    ("parities-are-duplicates", {"mr-010-symmetric": {"decay": 0.287}}, {}, "disagree"),
    ("poisson-contraction-compresses", {}, {}, "agree"),
    ("poisson-contraction-compresses", {}, {"svk-00": {"highest": ridge}}, "disagree"),
    ("benchmark-is-the-sheet", {}, {}, "agree"),
    ("benchmark-is-the-sheet", each(["gismo-mr"], decay=0.39), {}, "depends on"),
    (
        "benchmark-is-the-sheet",
        each(["gismo-mr", "gismo-mr-fixed", "gismo-mr-fvk"], decay=0.39),
        {},
        "disagree",
    ),
    ("example-wrinkles", {}, {}, "agree"),
    ("example-wrinkles", each(NAYYAR, **NEVER), {}, "disagree"),
    ("load-factors-of-comsol", {}, {}, "disagree"),
    ("load-factors-of-comsol", {}, {"nayyar-fvk": {"small": like_theirs}}, "agree"),
]


@pytest.mark.parametrize(("key", "sheets", "maps", "verdict"), CASES)
def test_a_verdict_follows_from_the_numbers(study, key, sheets, maps, verdict):
    finding = CLAIMS[key].finding(study(sheets, maps))
    assert finding.verdict == verdict, finding
    assert finding.explanation
    assert not re.search(r"\b(nan|inf)\b", finding.explanation)


@pytest.mark.parametrize(
    ("last", "verdict"), [(2.6, "agree"), (2.63, "agree"), (2.7, "disagree"), (2.5, "disagree")]
)
def test_the_last_length_is_compared_with_the_published_one(study, last, verdict):
    def solved(aspect):
        return ridge(aspect, last)

    finding = CLAIMS[LAST_LENGTH].finding(study((), each(MAPS, highest=solved), solved))
    assert finding.verdict == verdict, finding
    values = {value.name: value.number for value in finding.values}
    assert values["last L/W, t/L held, fvk"] == pytest.approx(last, rel=5e-3)
    # what is inferred: the t/L that would end at the published length
    assert values["t/L that ends at 2.6, fvk"] == pytest.approx(solved(2.6) / 2.6)


@pytest.mark.parametrize(
    ("peaks", "verdict"), [((0.0459, 0.1396), "agree"), ((0.05, 0.14), "disagree")]
)
def test_the_nine_numbers_are_those_of_the_mode(study, monkeypatch, peaks, verdict):
    monkeypatch.setattr(published_mode, "PEAKS", (*peaks, *published_mode.PEAKS[2:]))
    assert CLAIMS[MODE].finding(study()).verdict == verdict


LAST_LENGTH, MODE = "last-length-that-wrinkles", "shape-of-the-mode"


@pytest.mark.parametrize("key", sorted(CLAIMS.keys() - {LAST_LENGTH, MODE}))
def test_every_statement_can_come_out_either_way(key):
    verdicts = {verdict for name, *_, verdict in CASES if name == key} - {"not computed"}
    assert len(verdicts) > 1


@pytest.mark.parametrize("key", CLAIMS)
def test_without_its_sheets_a_statement_is_not_computed_and_says_so(key):
    finding = CLAIMS[key].finding(world())
    assert finding.verdict == "not computed"
    assert finding.explanation.startswith("Not in the study: ")


def test_there_are_enough_statements_and_each_is_told_apart():
    assert len(CLAIMS) >= 20
    assert all(isinstance(claim, Statement) for claim in CLAIMS.values())
    assert {claim.order[0] for claim in CLAIMS.values()} <= {s.number for s in CATALOGUE.sections}
    assert len({claim.order for claim in CLAIMS.values()}) == len(CLAIMS)
    for name in ("figures", "tables"):
        shown = [each for section in CATALOGUE.sections for each in getattr(section, name)]
        assert sorted(shown) == sorted(entry.name for entry in getattr(CATALOGUE, name))


REMEMBERED = Published(source=sources.LI_2016, where="the paper", reliability="M", said="2.6")


def test_what_is_only_remembered_cannot_be_judged():
    with pytest.raises(ValueError, match="from memory only, so it has no verdict"):
        statement(REMEMBERED, order=(1, 0, 1), says="it is.", tolerance="none")(lambda _: None)
    with pytest.raises(ValueError, match="reliability = 'D': must be one of A, B, C, M"):
        replace(REMEMBERED, reliability="D")


def test_the_table_has_every_statement_and_leaves_memory_open(study):
    found = table(study())
    columns = dict(zip(found.columns, zip(*found.rows, strict=True), strict=True))
    assert len(found.rows) == len(CLAIMS) + len(OPEN_STATEMENTS)
    assert columns["key"][: len(CLAIMS)] == tuple(CLAIMS)
    for reliability, verdict in zip(columns["reliability"], columns["verdict"], strict=True):
        assert verdict in (*VERDICTS, "open")
        assert verdict == "open" or reliability != "M"
    assert set(columns["verdict"][len(CLAIMS) :]) == {"open"}
    by_key = dict(zip(columns["key"], found.rows, strict=True))
    own = dict(zip(found.columns, by_key["decay-of-ten-to-one"], strict=True))
    assert own["computed_fvk"] == "birth strain: 0.025; decay strain: 0.296"
    assert own["computed_fixed_thickness"] == "birth strain: 0.025; decay strain: 0.25"
    assert own["computed"] == ""
    assert len(found.head) == len(found.cells[0])


def test_every_source_is_listed_and_used():
    every = {source.name for source in vars(sources).values() if isinstance(source, Source)}
    published = [claim.published for claim in CLAIMS.values()]
    published += [one.published for one in OPEN_STATEMENTS]
    assert {each.source.name for each in published} == every
    assert {row[0] for row in source_table.table(world()).rows} == every
