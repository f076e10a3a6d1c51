"""The study of what others published runs from constants to its page."""

import csv
import re

import pytest

pytestmark = pytest.mark.workflow

CONFIGS = ("--configfile", "config/literature.yaml", "config/literature_quick.yaml")


@pytest.fixture(scope="module")
def finished_literature(project, tmp_path_factory):
    study = project(tmp_path_factory.mktemp("literature"))
    run = study.snakemake(*CONFIGS, config=None)
    assert run.returncode == 0, run.stdout + run.stderr
    return study


def test_the_page_shows_every_figure(finished_literature):
    claims = finished_literature.folder / "results/literature_quick/claims"
    page = (claims / "claims.md").read_text()
    figures = finished_literature.folder / "figures" / "literature_quick"
    shown = re.findall(r"\]\(literature/(\w+\.png)\)", page)
    assert sorted(shown) == sorted(path.name for path in figures.glob("*.png"))


def test_statements_are_judged_but_for_those_from_memory(finished_literature):
    path = finished_literature.folder / "results/literature_quick/claims/statements.csv"
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    verdicts = {row["verdict"] for row in rows if row["reliability"] != "M"}
    assert {"agree", "disagree", "depends on", "open"} <= verdicts
    assert {row["verdict"] for row in rows if row["reliability"] == "M"} == {"open"}
    by_key = {row["key"]: row["verdict"] for row in rows}
    assert by_key["growth-without-end"] == "agree"
    assert by_key["shape-of-the-mode"] == "agree"
