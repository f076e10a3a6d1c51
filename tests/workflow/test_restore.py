"""A lost file comes back as it was, and nothing else is touched."""

import os

import pytest

pytestmark = pytest.mark.workflow

SHEET = "latex/aspect2_thickness0.001"
LOST = [
    "results/quick/material/latex.json",
    "results/quick/mesh/aspect2_resolves0.001.vtu",
    "results/quick/planar/latex/aspect2_resolves0.001/strain0.1.h5",
    f"results/quick/stability/{SHEET}.json",
    f"results/quick/wrinkle/{SHEET}/strain0.2.h5",
    f"results/quick/metrics/{SHEET}.csv",
    "results/quick/summary/peaks.csv",
    "results/quick/claims/claims.html",
    "figures/quick/fig03_surface.png",
    "results/quick/gate/gate.json",
    "results/quick/tension/latex/aspect2.csv",
]
# one job makes these together
TOGETHER = [
    {"results/quick/summary/states.csv", "results/quick/summary/stability.csv", LOST[6]},
    {f"results/quick/claims/{name}" for name in ("claims.csv", "claims.html", "claims.md")}
    | {"results/quick/claims/table1.csv"},
    {f"results/quick/tension/latex/aspect2.{suffix}" for suffix in ("csv", "h5")},
    {f"figures/quick/fig03_surface.{suffix}" for suffix in ("png", "pdf", "csv")},
]
ABOUT_RUNS = (
    "results/quick/log/",
    "results/quick/benchmark/",
    "results/quick/.record/.running",
)


def files(study):
    """Return time and content of every result."""
    found = {}
    for name in ("results", "figures"):
        for path in (study.folder / name).rglob("*"):
            key = path.relative_to(study.folder).as_posix()
            if path.is_file() and not key.startswith(ABOUT_RUNS):
                found[key] = (os.stat(path).st_mtime_ns, path.read_bytes())
    return found


def test_every_stage_is_tried(finished_quick):
    results = finished_quick.folder / "results" / "quick"
    stages = {path.name for path in results.iterdir()} - {"log", "benchmark", ".record"}
    assert {name.split("/")[2] for name in LOST if name.startswith("results")} == stages


@pytest.fixture(scope="module")
def worn(finished_quick, tmp_path_factory):
    """One copy that loses file after file."""
    return finished_quick.copied_to(tmp_path_factory.mktemp("worn") / "study")


@pytest.mark.parametrize("lost", LOST)
def test_a_lost_file_comes_back_bit_for_bit_and_moves_nothing_else(worn, lost):
    before = files(worn)
    (worn.folder / lost).unlink()
    run = worn.snakemake()
    assert run.returncode == 0, run.stderr
    after = files(worn)
    assert {name: content for name, (_, content) in after.items()} == {
        name: content for name, (_, content) in before.items()
    }
    moved = {name for name, (time, _) in after.items() if time != before[name][0]}
    moved = {name for name in moved if "/.record/" not in name}  # each file has a record
    assert moved in ({lost}, *TOGETHER)
    assert lost in moved


def test_a_whole_folder_comes_back_in_one_run(worn):
    before = files(worn)
    lost = {name for name in before if name.startswith("results/quick/planar/")}
    for name in lost:
        (worn.folder / name).unlink()
    assert worn.snakemake().returncode == 0
    after = files(worn)
    assert after.keys() == before.keys()
    moved = {name for name in after if after[name] != before[name]}
    assert {name for name in moved if "/.record/" not in name} == lost
    assert all(after[name][1] == before[name][1] for name in lost)
    assert worn.planned() == []


def test_a_lost_file_does_not_hide_that_there_is_more_to_do(study):
    (study.folder / LOST[2]).unlink()
    study.edit("config.yaml", "max_iterations: 200", "max_iterations: 50")
    ran = {job.rule for job in study.planned()}
    assert ran >= {"planar", "wrinkle", "metrics", "summary", "claims", "figures", "gate"}


def test_one_lost_file_can_be_asked_for_by_name(study):
    lost = study.folder / LOST[4]
    content = lost.read_bytes()
    lost.unlink()
    assert [job.rule for job in study.planned(LOST[4])] == ["wrinkle"]
    assert study.snakemake(LOST[4]).returncode == 0
    assert lost.read_bytes() == content
