"""Every claim can come out either way, and does so for the physical reason that it names."""

import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_up_rows import SHEET, state_row
from made_up_study import (
    MATERIALS,
    NEVER,
    STRAIN,
    all_bending,
    field_table,
    lengths,
    material,
    world,
)

from wrinklestudy.studies.panaitescu2019.claims import persistence
from wrinklestudy.studies.panaitescu2019.solid import solid_ends
from wrinklestudy.study.claims.discovery import load_claims
from wrinklestudy.study.claims.finding import VERDICTS

CLAIMS = load_claims("panaitescu2019")

# The claims in the order of the paper, each with its verdict on a study that is made to agree with
# the paper where it can.
AS_THE_PAPER = {
    "young-modulus": "agree",
    "nonlinear-stress": "agree",
    "central-region": "agree",
    "incompressible": "agree",
    "law-fits-data": "agree",
    "svk-deviates": "agree",
    "appear-at-finite-strain": "agree",
    "disappear-at-large-strain": "agree",
    "beyond-earlier-range": "agree",
    "strain-definition": "disagree",  # the strain of Sec. II fills the bar, not that of the caption
    "colour-bar": "agree",
    "colour-bar-in-thicknesses": "disagree",  # 3.5 t at this thickness
    "rise-and-decay": "agree",
    "flat-at-greatest-strain": "agree",
    "antisymmetric": "agree",
    "neo-hookean-smaller": "agree",
    "neo-hookean-shorter": "agree",
    "around-three-tenths": "agree",
    "material-nonlinearity": "agree",
    "svk-much-lower": "agree",
    "none-when-short": "agree",
    "wrinkles-when-long": "agree",
    "at-variance-with-earlier-island": "disagree",  # with t/L held the sheet is 1.5e-3 W thick
    "island-of-lengths": "agree",
    "thin-enough": "agree",
    "threshold-vanishes": "agree",
    "small-slope": "agree",
    "sinusoid": "agree",
    "scaled-wavelength": "agree",
    "discrepancy-near-threshold": "agree",
    "wavelength-interval": "agree",
    "length-exponent": "agree",
    "amplitude-decreases": "agree",
    "planar-width-retained": "agree",
    "linear-width": "agree",
    "nonlinear-width": "agree",
    "zero-outside": "agree",
    "non-monotonic": "agree",
    "order-of-magnitude": "agree",
    "tension-field": "agree",
    "hookean-maximum": "agree",
    "single-constant": "agree",
    "constant-is-one": "depends on",  # 1/pi for the central crest, a sinusoid
    "collapse": "agree",
    "weak-dependence": "agree",
    "caption-ranges": "agree",
    "mooney-rivlin-highest": "agree",
    "persist-to-two-fifths": "agree",
}

STEEP = {"constants": (0.2, 3.0), "central": (0.1, 1.5)}

# The paper's constants, of which the solid is known: it decays at 0.3988
OF_THE_SOLID = world(
    (material(constants={"c10": 6.21e4, "c01": 1.58e5}), *MATERIALS[1:]),
    base={"decay": 0.3984, "modulus": 6.0 * (6.21e4 + 1.58e5)},
    fixed={"decay": 0.32, "modulus": 6.0 * (6.21e4 + 1.58e5)},
    fvk={"decay": 0.59, "modulus": 6.0 * (6.21e4 + 1.58e5)},
)

# claim, study, verdict: each with the physics changed so that the claim comes out another way
CASES = [
    ("young-modulus", world((material(constants={"c10": 6e4, "c01": 1.6e5}),)), "disagree"),
    ("nonlinear-stress", world((material(constants={"c10": 1.6e5, "c01": 0.0}),)), "disagree"),
    ("central-region", world(base={"sheet_amplitude_x_over_length": 0.45}), "disagree"),
    ("central-region", world(base={"sheet_amplitude_y_over_width": -0.5}), "disagree"),
    ("incompressible", world((material(law="svk"),)), "disagree"),
    ("law-fits-data", world((material(rms=1e5),)), "disagree"),
    ("law-fits-data", world((material(note="Latex.\nNOT MEASURED: rebuilt"),)), "not computed"),
    ("svk-deviates", world((material(law="svk"),)), "disagree"),
    ("appear-at-finite-strain", world(base={"birth": 5e-4}), "disagree"),
    ("appear-at-finite-strain", world(base={"limits": (0.05, 0.4)}), "disagree"),
    ("appear-at-finite-strain", world(base=NEVER), "disagree"),
    ("disappear-at-large-strain", world(base={"limits": (0.025, np.nan)}), "disagree"),
    ("disappear-at-large-strain", world(base={"limits": (0.025, 0.3)}), "disagree"),
    ("disappear-at-large-strain", world(base=NEVER), "not computed"),
    ("beyond-earlier-range", all_bending(decay=0.25), "disagree"),
    ("beyond-earlier-range", world(fixed={"decay": 0.25}), "depends on"),
    ("beyond-earlier-range", world(fixed=None, fvk=None), "agree"),
    ("strain-definition", world(base={"phi_max": 7.8e-4}), "agree"),
    ("strain-definition", world(base={"phi_max": 8.5e-4, "peak": 0.11}), "depends on"),
    ("colour-bar", world(base={"phi_max": 4e-4}), "disagree"),
    ("colour-bar", world(base={"phi_max": 4e-3}), "disagree"),
    (
        "colour-bar-in-thicknesses",
        world(wanted=("latex", 2.0, 1.4e-3)),
        "agree",
    ),
    ("rise-and-decay", world(base={"peak": 0.3}), "disagree"),
    ("rise-and-decay", world(base={"limits": (0.025, np.nan)}), "not computed"),
    ("flat-at-greatest-strain", all_bending(decay=0.48), "disagree"),
    ("flat-at-greatest-strain", world(fvk={"decay": 0.6}), "depends on"),
    ("antisymmetric", world(even={"energy": -1.1}), "disagree"),
    ("antisymmetric", world(even={"energy": -1.0001}), "depends on"),
    ("antisymmetric", world(even={"energy": -4 * STRAIN / 0.36}), "depends on"),
    ("antisymmetric", world(even=None), "not computed"),
    ("antisymmetric", world(even=NEVER), "not computed"),
    ("neo-hookean-smaller", world(nh={"phi_max": 2e-3}), "disagree"),
    ("neo-hookean-shorter", world(nh={"decay": 0.39}), "disagree"),
    ("neo-hookean-shorter", world(nh=None), "not computed"),
    ("around-three-tenths", world(nh={"decay": 0.39}), "disagree"),
    ("around-three-tenths", world(fixed={"decay": 0.32}), "depends on"),
    ("around-three-tenths", world(fixed=None, fvk=None), "not computed"),
    ("around-three-tenths", OF_THE_SOLID, "agree"),  # fixed thickness is not what the solid does
    ("material-nonlinearity", world(nh={"decay": 0.39}, svk={"decay": 0.37}), "disagree"),
    ("material-nonlinearity", world(nh=None, svk=None), "not computed"),
    ("svk-much-lower", world(svk={"decay": 0.3}), "disagree"),
    ("svk-much-lower", world(svk=NEVER), "disagree"),
    ("svk-much-lower", world(svk=None), "not computed"),
    ("none-when-short", world(short={"birth": 0.1, "decay": 0.2, "peak": 0.15}), "disagree"),
    ("none-when-short", world(short=None), "not computed"),
    ("wrinkles-when-long", world(a30=NEVER), "disagree"),
    ("wrinkles-when-long", world(a30=None), "not computed"),
    ("at-variance-with-earlier-island", world(a30={"critical": 1.6e-3}), "agree"),
    ("at-variance-with-earlier-island", world(a30=None), "not computed"),
    ("island-of-lengths", world(a35={"birth": 0.1, "decay": 0.2, "peak": 0.15}), "disagree"),
    ("island-of-lengths", world(short={"birth": 0.1, "decay": 0.2, "peak": 0.15}), "disagree"),
    ("island-of-lengths", world(a25=NEVER), "disagree"),
    ("island-of-lengths", world(a35=None), "not computed"),
    (
        "thin-enough",
        world(thick=NEVER, thickest={"birth": 0.1, "decay": 0.2, "peak": 0.15}),
        "disagree",
    ),
    ("thin-enough", world(thick=None, thickest=None), "not computed"),
    ("threshold-vanishes", world(thin={"birth": 0.03}), "disagree"),
    ("threshold-vanishes", world(thin=None, thick=None), "not computed"),
    ("small-slope", world(base={"phi_max": 0.1}), "disagree"),
    ("sinusoid", world(base={"central": (0.5, 0.0)}), "disagree"),
    ("scaled-wavelength", world(base={"scale": 1.25}), "disagree"),
    ("discrepancy-near-threshold", world(base={"scale": 1.03, "excess": 0.0}), "disagree"),
    ("discrepancy-near-threshold", world(base={"limits": (0.005, 0.4)}), "not computed"),
    ("wavelength-interval", world(base={"scale": 1.5}), "disagree"),
    ("wavelength-interval", world(base={"scale": 0.7}), "disagree"),
    (
        "length-exponent",
        world(
            a18={"scale": 1.8**-0.5}, a25={"scale": 2.5**-0.5}, base={"scale": 2.0**-0.5}, a30=None
        ),
        "disagree",
    ),
    ("length-exponent", world(a25={"scale": 1.3}), "disagree"),
    ("length-exponent", world(a18=None, a30=None), "not computed"),
    ("amplitude-decreases", world(base={"peak": 0.3}), "disagree"),
    ("planar-width-retained", world(base={"arc_width_over_width": 1.0}), "disagree"),
    ("planar-width-retained", world(base={"planar_width_over_width": np.nan}), "not computed"),
    ("linear-width", world(base={"arc_width_over_width": 1.0}), "disagree"),
    ("nonlinear-width", world(base={"arc_width_over_width": 1.0 - 0.5 * STRAIN}), "disagree"),
    ("zero-outside", world(base={"limits": (0.05, 0.4)}), "disagree"),
    ("zero-outside", world(base={"limits": (0.025, 0.45)}), "disagree"),
    ("non-monotonic", world(base={"phi_squared": STRAIN / 100.0}), "disagree"),
    ("non-monotonic", world(base={"phi_squared": np.cos(40 * STRAIN) ** 2}), "disagree"),
    ("order-of-magnitude", world(base={"phi_max": 1e-6}), "disagree"),
    ("order-of-magnitude", world(base={"phi_max": 8e-4}), "depends on"),
    ("hookean-maximum", world(base={"peak": 0.2}), "disagree"),
    ("single-constant", world(base=STEEP), "disagree"),
    ("single-constant", world(base={"constants": STEEP["constants"]}), "depends on"),
    ("constant-is-one", world(base={"central": (0.8, 0.0)}), "agree"),
    ("constant-is-one", world(base={"constants": (0.3, 0.0)}), "disagree"),
    ("collapse", world(a25={"constants": (1.0, 0.0), "central": (0.5, 0.0)}), "disagree"),
    ("collapse", world(a25={"constants": (1.0, 0.0)}), "depends on"),
    ("collapse", world(a18=None, a25=None, a30=None), "not computed"),
    ("weak-dependence", world(base={"constants": (0.8, 0.0), "central": (0.33, 0.0)}), "disagree"),
    ("weak-dependence", world(base=STEEP), "disagree"),
    ("caption-ranges", lengths(**STEEP), "disagree"),
    ("mooney-rivlin-highest", world(nh={"decay": 0.45}, svk={"decay": 0.45}), "disagree"),
    ("mooney-rivlin-highest", world(nh={"decay": 0.45}), "depends on"),
    ("mooney-rivlin-highest", world(svk=None), "not computed"),
    ("persist-to-two-fifths", all_bending(decay=0.3), "disagree"),
    ("persist-to-two-fifths", world(fixed={"decay": 0.32}, fvk={"decay": 0.59}), "depends on"),
]

# claim, Phi^2 of the tension field over that of the sheet, other columns of its table, verdict
FIELDS = [
    ("tension-field", 1.19, {}, "agree"),
    ("tension-field", 3.0, {}, "disagree"),
    ("tension-field", 0.5, {}, "disagree"),
    ("tension-field", 1.0, {"aspect": 3.0}, "not computed"),
    ("tension-field", 1.0, {"remainder": 0.1}, "not computed"),
    ("tension-field", 1.0, {"status": "not-converged"}, "not computed"),
    ("tension-field", 1.0, {"strain": STRAIN + 0.003}, "not computed"),
]

BY_KEY = {claim.key: claim for claim in CLAIMS}


@pytest.fixture
def with_field(tmp_path):
    """Return a function that adds a tension field to a study, by default that of its sheet."""

    def add(study, factor=1.0, **columns):
        path = tmp_path / "tension.csv"
        field_table(factor, **columns).to_csv(path, index=False)
        return replace(study, analyses={"tension": {"table": [path]}})

    return add


@pytest.mark.parametrize(("key", "verdict"), AS_THE_PAPER.items())
def test_a_study_as_the_paper_has_it_agrees(key, verdict, with_field):
    finding = BY_KEY[key].finding(with_field(world()))
    assert finding.verdict == verdict, finding


@pytest.mark.parametrize(("key", "study", "verdict"), CASES)
def test_other_physics_gives_another_verdict(key, study, verdict):
    finding = BY_KEY[key].finding(study)
    assert finding.verdict == verdict, finding
    assert finding.explanation
    assert not re.search(r"\b(nan|inf)\b", finding.explanation)


def test_the_verdict_on_three_tenths_names_the_solid(monkeypatch):
    finding = BY_KEY["around-three-tenths"].finding(OF_THE_SOLID)
    solid = {value.name: value.number for value in finding.values}["decay strain of the solid"]
    assert solid == solid_ends()["decay"].strain
    assert "with thinning, not with fixed-thickness or fvk" in finding.explanation
    # a solid that decayed where the plate of fixed thickness does would leave both reasons open
    other = {"decay": replace(solid_ends()["decay"], strain=0.32)}
    monkeypatch.setattr(persistence, "solid_ends", lambda: other)
    assert BY_KEY["around-three-tenths"].finding(OF_THE_SOLID).verdict == "depends on"


@pytest.mark.parametrize(("key", "factor", "columns", "verdict"), FIELDS)
def test_another_tension_field_gives_another_verdict(key, factor, columns, verdict, with_field):
    finding = BY_KEY[key].finding(with_field(world(), factor, **columns))
    assert finding.verdict == verdict, finding
    assert not re.search(r"\b(nan|inf)\b", finding.explanation)


def test_a_study_without_tension_fields_says_so():
    finding = BY_KEY["tension-field"].finding(world())
    assert finding.verdict == "not computed"
    assert "tension fields of latex, L/W = 2" in finding.explanation


@pytest.mark.parametrize("key", BY_KEY)
def test_every_claim_can_come_out_either_way(key):
    verdicts = {verdict for name, *_, verdict in [*CASES, *FIELDS] if name == key}
    verdicts -= {"not computed"}
    assert verdicts - {AS_THE_PAPER[key]}


@pytest.mark.parametrize("key", BY_KEY)
def test_without_the_sheet_of_the_text_a_claim_is_not_computed_and_says_so(key):
    finding = BY_KEY[key].finding(world(base=None))
    assert finding.verdict == "not computed"
    assert "sheet latex, L/W = 2, t/W = 0.001" in finding.explanation


def test_no_claim_is_lost_and_none_stands_twice():
    assert list(BY_KEY) == list(AS_THE_PAPER)
    assert len({claim.order for claim in CLAIMS}) == len(CLAIMS)
    assert len({claim.statement for claim in CLAIMS}) == len(CLAIMS)


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.key)
def test_a_claim_stands_where_its_place_says(claim):
    """The order begins with a section that the place names; captions lie elsewhere."""
    section, part, _ = claim.order
    own = ("", "I", "II", "III", "IV", "V")[section] + (f".{'ABCD'[part - 1]}" if part else "")
    sections = re.findall(r"\b[IV]+(?:\.[A-D])?\b", claim.place)
    assert own in sections or "aption" in claim.place


HOLES = st.lists(st.booleans(), min_size=len(STRAIN), max_size=len(STRAIN))


def lost_state(row):
    """Return the state of the same case that did not converge: nothing but the case is known."""
    return state_row(row.strain, "not-converged", **dict(zip(SHEET, row.sheet_key, strict=True)))


@given(st.lists(HOLES, min_size=3, max_size=3))
@settings(max_examples=25, deadline=None)
@pytest.mark.filterwarnings("error")
def test_holes_anywhere_never_stop_a_claim(holes):
    study = world()
    sheets = []
    for k, sheet in enumerate(study.sheets):
        lost = holes[k % len(holes)]
        states = [
            lost_state(row) if hole else row for hole, row in zip(lost, sheet.states, strict=True)
        ]
        sheets.append(replace(sheet, states=tuple(states)))
    for claim in CLAIMS:
        assert claim.finding(replace(study, sheets=tuple(sheets))).verdict in VERDICTS
