"""How sheets come to the tension field, on numbers that are known."""

from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
from made_up_study import STRAIN, sheet, world

from wrinklestudy.studies.beyond.thin_limit import Approach, approaches
from wrinklestudy.study.claims.discovery import load_claims

CLAIMS = {claim.key: claim for claim in load_claims("beyond")}
FIELD = 4e-3

THICKNESS = np.array([1e-4, 2e-4, 5e-4])


def test_a_deficit_at_first_order_has_exponent_one_and_is_extrapolated_to_the_field():
    field = 4e-3
    approach = Approach(0.1, THICKNESS, field * (1.0 - 800.0 * THICKNESS), field, 1e-6)
    assert approach.law.exponents["thickness"].value == pytest.approx(1.0, abs=1e-10)
    assert approach.extrapolated == pytest.approx(1.0, abs=1e-10)


def test_a_field_has_an_approach_where_three_sheets_of_its_rubber_and_length_are_wrinkled():
    sheets = [sheet(thickness=float(t)) for t in THICKNESS]
    like = sheets[0]
    rows = pd.DataFrame(
        {
            "material": like.material,
            "aspect": like.aspect,
            "strain": [STRAIN[1], 0.5 * (STRAIN[1] + STRAIN[2])],
            "status": "wrinkled",
            "phi_squared": 4e-3,
            "phi_squared_error": 1e-6,
        }
    )
    (approach,) = approaches(sheets, rows, like)
    assert approach.strain == STRAIN[1]
    assert list(approach.thickness) == list(THICKNESS)
    assert approaches(sheets[:2], rows, like) == []
    assert approaches(sheets, rows.assign(aspect=like.aspect + 1.0), like) == []


def judged(key, tmp_path, thicknesses=THICKNESS, **columns):
    """Judge a claim on sheets whose deficit is proportional to t, and a made-up tension field."""
    study = world()
    paper = study.sheet
    table = {
        "material": paper.material,
        "aspect": paper.aspect,
        "strain": [STRAIN[1]],
        "status": "wrinkled",
        "phi_squared": FIELD,
        "phi_squared_error": 1e-6,
        "remainder": 0.0,
    }
    path = tmp_path / "tension.csv"
    pd.DataFrame(table | columns).to_csv(path, index=False)
    states = list(paper.columns["strain"])
    sheets = tuple(
        sheet(thickness=t, phi_squared=np.full(len(states), FIELD * (1.0 - 800.0 * t)))
        for t in thicknesses.tolist()
    )
    study = replace(study, sheets=(paper, *sheets), analyses={"tension": {"table": [path]}})
    return CLAIMS[key].finding(study).verdict


@pytest.mark.parametrize(
    ("key", "columns", "verdict"),
    [
        ("field-is-solved", {}, "agree"),
        ("field-is-solved", {"phi_squared_error": 1e-4}, "disagree"),
        ("field-is-solved", {"remainder": 1e-3}, "disagree"),
        ("field-is-solved", {"aspect": 7.0}, "not computed"),
        ("first-order-in-thickness", {}, "agree"),
        ("first-order-in-thickness", {"phi_squared": 1e-3}, "disagree"),  # sheets above the field
        ("first-order-in-thickness", {"phi_squared": 2.0 * FIELD}, "disagree"),  # another limit
        ("first-order-in-thickness", {"aspect": 7.0}, "not computed"),
    ],
)
def test_a_claim_follows_its_numbers(key, columns, verdict, tmp_path):
    assert judged(key, tmp_path, **columns) == verdict


@pytest.mark.parametrize(
    ("thinnest", "columns", "verdict"),
    [
        ([1e-5, 2e-5, 5e-5], {}, "agree"),
        ([1e-5, 2e-5, 5e-5], {"phi_squared": 0.97 * FIELD}, "disagree"),  # sheets above the field
        ([1e-5, 2e-5, 5e-5], {"phi_squared": 1.004 * FIELD}, "disagree"),  # of another limit
        ([1e-4, 2e-4, 5e-4], {}, "not computed"),
    ],
)
def test_the_thinnest_sheets_are_near_the_field_if_they_are(thinnest, columns, verdict, tmp_path):
    assert judged("thinnest-are-near", tmp_path, np.array(thinnest), **columns) == verdict
