"""The study of imperfections runs to its page, and an entry more computes that entry alone."""

import re

import pytest

pytestmark = pytest.mark.workflow

QUICK = "config/imperfections_quick.yaml"
CONFIGS = ("--configfile", "config/imperfections.yaml", QUICK)
SHEETS = "results/imperfections_quick/imperfection/latex/aspect2_thickness0.001"


@pytest.fixture(scope="module")
def finished(project, tmp_path_factory):
    study = project(tmp_path_factory.mktemp("imperfections"))
    run = study.snakemake(*CONFIGS, config=None)
    assert run.returncode == 0, run.stdout + run.stderr
    return study


def test_the_page_shows_every_figure_and_every_state_converged(finished):
    page = (finished.folder / "results/imperfections_quick/claims/claims.md").read_text()
    figures = finished.folder / "figures" / "imperfections_quick"
    shown = re.findall(r"\]\(imperfections/(\w+\.png)\)", page)
    assert sorted(shown) == sorted(path.name for path in figures.glob("*.png"))
    assert "seed of its own.** *agree.*" in page


def test_a_lost_table_comes_back_and_moves_nothing_else(finished, tmp_path):
    study = finished.copied_to(tmp_path / "study")
    assert study.planned(*CONFIGS, config=None) == []
    lost = f"{SHEETS}/shear-0.01.csv"
    before = (study.folder / lost).read_bytes()
    (study.folder / lost).unlink()
    (job,) = study.planned(*CONFIGS, config=None)
    assert (job.rule, job.outputs[0]) == ("imperfection", lost)
    assert study.snakemake(*CONFIGS, config=None).returncode == 0
    assert (study.folder / lost).read_bytes() == before


def test_one_more_size_is_the_only_sheet_that_is_computed(finished, tmp_path):
    study = finished.copied_to(tmp_path / "study")
    study.edit(QUICK, "shear: [0.01, 0.03]", "shear: [0.01, 0.02, 0.03]")
    jobs = study.planned(*CONFIGS, config=None)
    assert {job.outputs[0] for job in jobs if job.rule == "imperfection"} == {
        f"{SHEETS}/shear-0.02.csv"
    }
    assert {job.rule for job in jobs} == {"imperfection", "figures", "claims", "gate"}
