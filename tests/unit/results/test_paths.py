"""Each stage has its files in a place of its own, and a path gives its case back."""

import re
from importlib import import_module
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.results.cases import Case, StudySheet, canonical, parse_value
from wrinklestudy.results.paths import STAGES, Paths

RULES = Path(__file__).parents[3] / "workflow" / "rules"
positive = st.floats(min_value=1e-12, max_value=1e12)


@pytest.mark.parametrize("stage", STAGES)
def test_a_stage_has_one_name_for_entry_module_and_rule(stage):
    assert callable(import_module(f"wrinklestudy.stages.{stage}").run)
    assert f"\nrule {stage}:\n" in "\n" + (RULES / f"{stage}.smk").read_text()


def test_there_is_no_rule_file_without_an_entry():
    assert {path.stem for path in RULES.glob("*.smk")} == {*STAGES, "common"}


def test_no_two_stages_write_the_same_file():
    paths = Paths()
    patterns = [paths.pattern(stage, name) for stage in STAGES for name in STAGES[stage].outputs]
    assert len(set(patterns)) == len(patterns)


def test_results_may_lie_where_the_project_lies():
    assert Paths(".", "figures").pattern("gate") == "gate/gate.json"


def test_sheets_of_one_class_share_the_planar_state_but_not_the_wrinkle():
    thick, thin = (Case(StudySheet("latex", 2.0, t), 0.1) for t in (1.2e-3, 1e-3))
    paths = Paths("results/quick", "figures/quick")
    assert paths.of_case("planar", thick) == paths.of_case("planar", thin)
    assert paths.of_case("wrinkle", thick) != paths.of_case("wrinkle", thin)
    folder = "results/quick/planar/latex/aspect2_resolves0.001"
    assert paths.of_case("planar", thin) == f"{folder}/strain0.1.h5"


@pytest.mark.parametrize("output", ["metrics", "stability"])
def test_a_sheet_has_one_file_of_its_own(output):
    paths = Paths("out")
    sheets = [
        StudySheet(name, a, t) for name in ("a", "b") for a in (1.5, 2.0) for t in (5e-4, 1e-3)
    ]
    files = {paths.of_sheet(output, sheet) for sheet in sheets}
    assert len(files) == len(sheets)
    assert all(file.startswith(f"out/{output}/") for file in files)


@pytest.mark.parametrize("stage", STAGES)
def test_outputs_logs_and_run_times_have_the_same_wildcards_and_different_files(stage):
    paths = Paths("out", "out/figures")
    three = [paths.pattern(stage), paths.log(stage), paths.benchmark(stage)]
    wildcards = [re.findall(r"{(\w+)}", path) for path in three]
    assert wildcards[0] == wildcards[1] == wildcards[2]
    assert len(set(three)) == 3
    assert all(path.startswith("out/") for path in three)


@given(positive, positive, positive)
def test_a_path_gives_its_case_back(aspect, thickness, strain):
    path = Paths().of_case("wrinkle", Case(StudySheet("latex-2", aspect, thickness), strain))
    pattern = re.sub(r"{(\w+)}", r"(?P<\1>[^/_]+)", re.escape(Paths().pattern("wrinkle")))
    pattern = re.sub(r"\\{(\w+)\\}", r"(?P<\1>[^/_]+)", pattern)
    found = re.fullmatch(pattern, path)
    assert found is not None
    assert found["material"] == "latex-2"
    values = [parse_value(found[name]) for name in ("aspect", "thickness", "strain")]
    assert values == [canonical(aspect), canonical(thickness), canonical(strain)]
