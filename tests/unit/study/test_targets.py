"""A file that is asked for by name is one of a study, or gets one line that says why not."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.results.cases import Case, StudySheet
from wrinklestudy.results.paths import STAGES, Paths
from wrinklestudy.study.config import parse_config
from wrinklestudy.study.plan import files_of, files_on_the_way, wanted_files
from wrinklestudy.study.targets import refusal

RAW = {
    "folders": {"results": "out", "figures": "pictures"},
    "materials": {
        "rubber": {"data": "a.csv", "law": "svk"},
        "other": {"data": "b.csv", "law": "svk"},
    },
    "variants": {"thick": {"material": "rubber", "bending": "fvk"}},
    "sheets": [
        {"material": "rubber", "aspect": [2, 3], "thickness": [1e-3, 2e-3], "strain": [0.1, 0.2]},
        {"material": "thick", "aspect": [2], "thickness": [5e-4], "strain": [0.1]},
    ],
    "maps": [{"material": "thick", "aspect": [2, 3], "strain": [0.1, 0.2]}],
    "tension": [{"material": "rubber", "aspect": [2], "strain": [0.1, 0.2]}],
    "compression": [{"material": "rubber", "aspect": [2, 3]}],
    "imperfections": [
        {
            "material": "thick",
            "aspect": [2],
            "thickness": [1e-3],
            "strain": [0.1, 0.2],
            "shear": [0.01, -0.02],
        }
    ],
    "figures": {
        "names": ["fig07_width"],
        "sheet": {"material": "rubber", "aspect": 2, "thickness": 1e-3},
    },
}
STUDY = parse_config(RAW, "test")
PATHS = Paths("out", "pictures")


def refused(target):
    return refusal(target, STUDY, PATHS)


def test_the_files_of_a_study_follow_from_its_cases():
    """Two sheets of one L/W and class of thickness share mesh and flat states."""
    count = {stage: len(files_of(STUDY, PATHS, stage)) for stage in STAGES}
    assert count == {
        "material": 2,
        "mesh": 3,
        "planar": 5,
        "stability": 5,
        "map": 2,
        "tension": 2,  # the table and the fields of one job
        "compression": 2,
        "imperfection": 2,
        "wrinkle": 9,
        "metrics": 5,
        "summary": 3,
        "figures": 3,  # two formats and the numbers
        "claims": 4,
        "gate": 1,
    }


def test_wanted_files_those_on_the_way_and_the_gate_are_all_that_there_is():
    every = [file for stage in STAGES for file in files_of(STUDY, PATHS, stage)]
    split = [*wanted_files(STUDY, PATHS), *files_on_the_way(STUDY, PATHS), "out/gate/gate.json"]
    assert sorted(split) == sorted(every)
    assert len(set(every)) == len(every)


def test_no_file_of_the_study_is_refused():
    for stage in STAGES:
        files = files_of(STUDY, PATHS, stage)
        assert files
        assert not any(map(refused, files))


@given(st.floats(0.5, 20), st.floats(1e-6, 0.05), st.floats(1e-6, 1))
def test_a_case_within_the_limits_need_not_stand_in_the_config(aspect, thickness, strain):
    case = Case(StudySheet("thick", aspect, thickness), strain)
    for stage in ("mesh", "planar", "stability", "wrinkle"):
        assert refused(PATHS.of_case(stage, case)) is None


@pytest.mark.parametrize("path", ["all", "out/wrinkle/notes.txt", "README.md", "--dry-run", "gate"])
def test_what_is_no_result_is_left_to_snakemake(path):
    assert refused(path) is None


@pytest.mark.parametrize(
    ("target", "fault"),
    [
        (
            "out/wrinkle/rubber/aspect0.4_thickness0.06/strain1.1.h5",
            "aspect = 0.4: must be a number >= 0.5 and <= 20 (L/W); "
            "thickness = 0.06: must be a number >= 1e-6 and <= 0.05 (t/W); "
            "strain = 1.1: must be a number >= 1e-7 and <= 1",
        ),
        (
            "out//wrinkle/rubber/aspect2.0_thickness.001/strain+1e-1.h5",
            "numbers have one spelling; "
            "write out/wrinkle/rubber/aspect2_thickness0.001/strain0.1.h5",
        ),
        (
            "out/stability/rubber/aspect2_thicknessthin.json",
            "thickness = thin: must be a number >= 1e-6 and <= 0.05 (t/W)",
        ),
        (
            "out/metrics/ruber/aspect2_thickness0.001.csv",
            "material 'ruber' is unknown; did you mean rubber? allowed: rubber, other, thick",
        ),
        (
            "out/metrics/rubber/aspect4_thickness0.001.csv",
            "the config has no strains for this sheet (sheets)",
        ),
        (
            "out/imperfection/thick/aspect2_thickness0.001/shear-0.02.csv",
            "the config has no strains for this imperfect sheet (imperfections)",
        ),
        (
            "out/material/thick.json",
            "material 'thick' is unknown; allowed: rubber, other",
        ),
        (
            "out/mesh/aspect2_resolves0.0007.vtu",
            "resolved = 0.0007: must be 0.001, or 0.001 halved any number of times; write 0.0005",
        ),
        (
            "pictures/fig1_stress.pdf",
            "figure 'fig1_stress' is unknown; did you mean fig01_stress? "
            f"allowed: {', '.join(STUDY.catalogue.figure_names)}",
        ),
    ],
)
def test_what_cannot_be_made_gets_one_line(target, fault):
    assert refused(target) == f"{target}: {fault}"
