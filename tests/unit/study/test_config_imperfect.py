"""The block of imperfect sheets: all combinations, and one line for what is wrong."""

import pytest

from wrinklestudy.results.paths import Paths
from wrinklestudy.study.config import ConfigError, load_config, parse_config
from wrinklestudy.study.plan import files_of

SHEET = {"material": "rubber", "aspect": [2], "thickness": [1e-3], "strain": [0.12, 0.3]}


def raw(*entries):
    return {
        "materials": {"rubber": {"law": "svk", "constants": {"young": 1e6, "poisson": 0.5}}},
        "sheets": [SHEET],
        "tension": [],
        "imperfections": [{**SHEET, **entry} for entry in entries],
        "figures": {"sheet": {"material": "rubber", "aspect": 2, "thickness": 1e-3}},
    }


def names(*entries):
    return [sheet.name for sheet in parse_config(raw(*entries), "c").imperfect_sheets]


def test_an_entry_means_all_combinations():
    assert names({}) == ["perfect"]
    assert names({"shear": [0.01, 0.03], "twist": [0.1]}) == [
        "shear-0.01_twist-0.1",
        "shear-0.03_twist-0.1",
    ]
    ripple = {"amplitude": [0.01, 0.02], "wavelength": 0.06, "angle": 0}
    assert names({"thickness_ripple": ripple}) == [
        "thickness-ripple-0.01x0.06x0x0",
        "thickness-ripple-0.02x0.06x0x0",
    ]


def test_entries_for_one_sheet_join_their_strains_and_each_sheet_is_a_job():
    study = parse_config(
        raw({"shear": [0.01]}, {"shear": [0.01, 0.02], "strain": [0.2]}, {"symmetry": "half"}), "c"
    )
    strains = {sheet.name: own for sheet, own in study.imperfect_sheets.items()}
    assert strains == {
        "perfect_half": (0.12, 0.3),
        "shear-0.01": (0.12, 0.2, 0.3),
        "shear-0.02": (0.2,),
    }
    folder = "results/imperfection/rubber/aspect2_thickness0.001"
    assert files_of(study, Paths(), "imperfection") == [f"{folder}/{name}.csv" for name in strains]
    assert study.analyses("imperfection") == {("rubber", 2.0): (0.12, 0.2, 0.3)}


@pytest.mark.parametrize(
    ("entry", "fault"),
    [
        ({"shear": [0.6]}, "imperfections[0].shear[0] = 0.6: must be a number >= -0.5 and <= 0.5"),
        ({"shear": []}, "imperfections[0].shear = []"),
        ({"sheer": [0.1]}, "imperfections[0].sheer: unknown key; did you mean shear?"),
        ({"density": [950]}, "imperfections[0]: density and width_mm must be given together"),
        ({"gravity": 1.6}, "imperfections[0].gravity: needs density and width_mm"),
        ({"shear": [0.01], "symmetry": "half"}, "imperfections[0]: symmetry = 'half'"),
        ({"material": "rubbr"}, "imperfections[0].material = 'rubbr': is not in materials"),
        ({"symmetry": "third"}, "imperfections[0].symmetry = 'third': must be 'quarter', 'half'"),
        (
            {"thickness_along": [0.5], "thickness_across": [0.5],
             "thickness_ripple": {"amplitude": [0.5], "wavelength": 0.5}},
            "imperfections[0]: thickness over its mean",
        ),
    ],
)  # fmt: skip
def test_what_is_wrong_gets_one_line(entry, fault):
    with pytest.raises(ConfigError) as refused:
        parse_config(raw(entry), "c")
    assert fault in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_table_that_is_not_there_is_refused_with_its_key(tmp_path):
    config = tmp_path / "c.yaml"
    config.write_text("a: 1\n")
    with pytest.raises(ConfigError, match=r"thickness_table = 'no\.csv': must be a CSV file"):
        load_config(raw({"thickness_table": "no.csv"}), [config])
