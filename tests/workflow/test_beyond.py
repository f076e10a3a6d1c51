"""The study beyond the paper runs from given constants to its page."""

import re

import pytest

pytestmark = pytest.mark.workflow

CONFIGS = ("--configfile", "config/beyond.yaml", "config/beyond_quick.yaml")


@pytest.fixture(scope="module")
def finished_beyond(project, tmp_path_factory):
    study = project(tmp_path_factory.mktemp("beyond"))
    run = study.snakemake(*CONFIGS, config=None)
    assert run.returncode == 0, run.stdout + run.stderr
    return study


def test_the_page_shows_every_figure_of_its_sections_and_judges_what_it_can(finished_beyond):
    page = (finished_beyond.folder / "results/beyond_quick/claims/claims.md").read_text()
    figures = finished_beyond.folder / "figures" / "beyond_quick"
    shown = re.findall(r"\]\(beyond/(\w+\.png)\)", page)
    assert sorted(shown) == sorted(path.name for path in figures.glob("*.png"))


def test_a_finished_study_has_nothing_left_to_do(finished_beyond):
    run = finished_beyond.snakemake("--dry-run", *CONFIGS, config=None)
    assert "Nothing to be done" in run.stdout + run.stderr
