"""Where compression ends, from excesses that are known."""

from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
from made_up_study import material, world

from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.studies.beyond.compression import crossings, endings, turns
from wrinklestudy.study.claims.discovery import load_claims

CLAIM = next(c for c in load_claims("beyond") if c.key == "compression-ends-or-lasts")
STRAIN = np.round(np.arange(0.05, 3.01, 0.05), 12)
RUBBERS = {"r0": 0.0, "r1": 0.1, "r3": 0.3}


def rubber(name):
    return mooney_rivlin(1e5, RUBBERS[name] * 1e5)


def rows(name, end, aspect=2.0, coarse_end=None):
    """Return a sheet whose excess changes sign at one strain."""
    return pd.DataFrame(
        {
            "material": name,
            "aspect": aspect,
            "strain": STRAIN,
            "central_excess": STRAIN * (end - STRAIN),
            "coarse_central_excess": STRAIN * ((coarse_end or end) - STRAIN),
        }
    )


def test_a_sign_change_is_found_between_the_strains_and_its_return_too():
    ends, returns = crossings(STRAIN, (STRAIN - 0.83) * (STRAIN - 2.17))
    assert ends == pytest.approx(0.83, abs=1e-3)
    assert returns == pytest.approx(2.17, abs=1e-3)
    ends, returns = crossings(STRAIN, STRAIN)
    assert np.isinf(ends)
    assert np.isnan(returns)


def test_the_error_holds_the_mesh_and_the_strains_between():
    (ending,) = endings(rows("r1", 0.83, coarse_end=0.85), rubber)
    assert ending.ratio == pytest.approx(0.1)
    assert ending.strain == pytest.approx(0.83, abs=1e-3)
    assert 0.02 - 1e-3 < ending.error < 0.02 + 5e-3
    assert ending.least == pytest.approx(3.0 * (0.83 - 3.0))


def test_the_turn_lies_between_the_last_ratio_that_ends_and_the_first_that_lasts():
    table = pd.concat([rows("r3", 9.0), rows("r0", 0.6), rows("r1", 0.9), rows("r1", 0.5, 3.0)])
    by_aspect = turns(endings(table, rubber))
    assert by_aspect[2.0].last_ending == pytest.approx(0.1)
    assert by_aspect[2.0].first_lasting == pytest.approx(0.3)
    assert by_aspect[2.0].rises
    assert np.isinf(by_aspect[3.0].first_lasting)
    falls = turns(endings(pd.concat([rows("r0", 0.9), rows("r1", 0.6)]), rubber))
    assert not falls[2.0].rises


def test_strains_without_a_flat_state_are_left_out():
    table = rows("r1", 0.83)
    table.loc[table["strain"] > 2.0, ["central_excess", "coarse_central_excess"]] = np.nan
    (ending,) = endings(table, rubber)
    assert ending.last == 2.0
    assert ending.strain == pytest.approx(0.83, abs=1e-3)


@pytest.mark.parametrize(
    ("ends", "verdict"),
    [
        ((0.6, 0.9, 9.0), "agree"),
        ((0.9, 0.6, 9.0), "disagree"),  # falls with the ratio
        ((9.0, 9.0, 9.0), "disagree"),  # lasts for a neo-Hookean rubber
        ((0.6, 0.9, 1.5), "disagree"),  # ends for every ratio
        ((0.6, 9.0, 1.5), "disagree"),  # ends again beyond
        ((0.6,), "not computed"),
    ],
)
def test_the_claim_follows_the_numbers(ends, verdict, tmp_path):
    path = tmp_path / "compression.csv"
    tables = [rows(name, end) for name, end in zip(RUBBERS, ends, strict=False)]
    pd.concat(tables).to_csv(path, index=False)
    study = replace(
        world((material(constants={"c10": 1e5, "c01": 2.5e5}),)),
        given={name: rubber(name) for name in RUBBERS},
        analyses={"compression": {"table": [path]}},
    )
    finding = CLAIM.finding(study)
    assert finding.verdict == verdict, finding
    assert finding.explanation
