"""The study beyond the paper runs from given constants to its page."""

import csv
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


def test_the_page_shows_every_figure(finished_beyond):
    page = (finished_beyond.folder / "results/beyond_quick/claims/claims.md").read_text()
    figures = finished_beyond.folder / "figures" / "beyond_quick"
    shown = re.findall(r"\]\(beyond/(\w+\.png)\)", page)
    assert sorted(shown) == sorted(path.name for path in figures.glob("*.png"))


def test_a_finished_study_has_nothing_left_to_do(finished_beyond):
    run = finished_beyond.snakemake("--dry-run", *CONFIGS, config=None)
    assert "Nothing to be done" in run.stdout + run.stderr


def test_tips_come_out_right_from_a_coarse_map(finished_beyond):
    """Three L/W and four strains lead to the tips of the 10:1 sheet at t/L = 5e-4."""
    table = finished_beyond.folder / "results/beyond_quick/claims/tips.csv"
    with open(table, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["held"] == "t/L"]
    found = {(row["material"], row["end"]): float(row["aspect"]) for row in rows}
    assert found["mr-010-fvk", "first"] == pytest.approx(1.545, rel=5e-3)
    assert found["mr-010-fvk", "last"] == pytest.approx(2.592, rel=5e-3)
