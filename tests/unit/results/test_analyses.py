"""The files of an analysis reach figures and claims by its name, whatever stages there are."""

from pathlib import Path

import pytest

from wrinklestudy.results.analyses import analysis_files, input_name, joined_table
from wrinklestudy.results.paths import STAGES, Paths, Stage
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.study.catalogue import FigureEntry
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.config import parse_config
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.plan import files_of, files_on_the_way
from wrinklestudy.study.targets import refusal

STUDY = parse_config(
    {
        "materials": {"rubber": {"law": "svk", "constants": {"young": 1e6}}},
        "variants": {"thick": {"material": "rubber", "bending": "fvk"}},
        "sheets": [{"material": "rubber", "aspect": [2], "thickness": [1e-3], "strain": [0.1]}],
        "tension": [
            {"material": "rubber", "aspect": [2, 3], "strain": [0.1]},
            {"material": "rubber", "aspect": [2], "strain": [0.2]},
        ],
        "figures": {"sheet": {"material": "rubber", "aspect": 2, "thickness": 1e-3}},
    },
    "test",
)


@pytest.fixture
def tension(monkeypatch):
    """An analysis with two outputs, before the gate."""
    outputs = {
        "table": "{material}/aspect{aspect}.csv",
        "fields": "{material}/aspect{aspect}.h5",
    }
    last = dict(STAGES)["gate"]
    monkeypatch.delitem(STAGES, "gate")
    monkeypatch.setitem(STAGES, "tension", Stage(outputs, analysis=True))
    monkeypatch.setitem(STAGES, "gate", last)


@pytest.mark.usefixtures("tension")
def test_there_is_a_job_for_each_model_and_length_of_its_block():
    files = files_of(STUDY, Paths(), "tension")
    folder = "results/tension/rubber"
    assert files == [f"{folder}/aspect{a}.{kind}" for kind in ("csv", "h5") for a in (2, 3)]
    assert set(files) <= set(files_on_the_way(STUDY, Paths()))
    assert not any(refusal(file, STUDY, Paths()) for file in files)


@pytest.mark.usefixtures("tension")
@pytest.mark.parametrize(
    ("name", "fault"),
    [
        ("rubber/aspect4", "the config has no strains for this material and L/W (tension)"),
        ("thick/aspect2", "material 'thick' is unknown; allowed: rubber"),
    ],
)
def test_a_file_without_strains_is_refused(name, fault):
    path = f"results/tension/{name}.csv"
    assert refusal(path, STUDY, Paths()) == f"{path}: {fault}"


@pytest.mark.usefixtures("tension")
def test_tables_are_joined_with_every_digit_and_fields_are_paths(tmp_path):
    exact = 0.1 + 0.2
    for name, number in (("a", exact), ("b", 1.0 / 3.0)):
        (tmp_path / f"{name}.csv").write_text(f"material,strain\n{name},{number!r}\n")
    tables = [tmp_path / "a.csv", tmp_path / "b.csv"]
    given = {input_name("tension", "table"): tables, input_name("tension", "fields"): "x.h5"}
    files = analysis_files(given)
    inputs = Inputs(analyses=files)
    assert list(inputs.table("tension")["strain"]) == [exact, 1.0 / 3.0]
    assert list(inputs.table("tension")["material"]) == ["a", "b"]
    assert inputs.fields("tension") == [Path("x.h5")]
    study = StudyTables((), (), ("rubber", 2.0, 1e-3), analyses=files)
    assert study.table("tension").equals(joined_table(tables))


def test_what_a_study_lacks_is_named():
    with pytest.raises(MissingError, match="any tension"):
        StudyTables((), (), ("rubber", 2.0, 1e-3)).table("tension")
    with pytest.raises(ValueError, match="tension: no table given"):
        Inputs().table("tension")
    with pytest.raises(TypeError, match="wrinkle_state"):
        analysis_files({"wrinkle_state": "a.h5"})
    with pytest.raises(ValueError, match="analyses = 'wrinkle': allowed"):
        FigureEntry(name="a", title="a", caption="a", module="a", analyses=("wrinkle",))


def test_a_table_that_is_none_is_named(tmp_path):
    path = tmp_path / "empty.csv"
    path.write_text("")
    with pytest.raises(ValueError, match=r"empty\.csv: is not a table"):
        joined_table([path])
