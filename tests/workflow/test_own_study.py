"""A study outside the package, as docs/recipes/study.md shows it, runs as the one within does."""

import csv

import pytest

pytestmark = pytest.mark.workflow

CONFIG = "my.yaml"


def planned(study):
    return sorted(job.rule for job in study.planned(config=CONFIG))


def test_its_figure_is_drawn_in_both_formats_and_no_other(finished_recipe):
    figures = finished_recipe.folder / "figures" / "mine"
    drawn = {path.name for path in figures.glob("[!.]*")}
    assert drawn == {"height.pdf", "height.png", "height.csv"}
    assert (figures / "height.pdf").read_bytes().startswith(b"%PDF")
    assert (figures / "height.png").read_bytes().startswith(b"\x89PNG")


def test_its_claim_is_judged_by_the_computed_numbers(finished_recipe):
    results = finished_recipe.folder / "results" / "mine"
    with open(results / "summary" / "states.csv", newline="") as file:
        heights = [float(row["amplitude_over_thickness"]) for row in csv.DictReader(file)]
    with open(results / "claims" / "claims.csv", newline="") as file:
        (claim,) = csv.DictReader(file)
    assert claim["key"] == "higher-than-thick"
    assert claim["verdict"] == ("agree" if max(heights) > 1.0 else "disagree")
    assert f"A/t reaches {max(heights):.3g}" in claim["explanation"]
    assert not (results / "claims" / "table1.csv").exists()
    page = (results / "claims" / "claims.html").read_text()
    assert "How high the wrinkles are" in page
    assert claim["statement"] in page
    assert "Panaitescu" not in page


def test_the_second_run_has_nothing_to_do(finished_recipe):
    assert finished_recipe.planned(config=CONFIG) == []


def test_an_edit_of_its_figure_redraws_it(recipe):
    recipe.edit("my_study/height.py", '"$A/t$"', '"$A$ over $t$"')
    assert planned(recipe) == ["figures", "gate"]


def test_an_edit_of_its_claim_judges_again(recipe):
    recipe.edit("my_study/claims.py", "HIGH = 1.0", "HIGH = 100.0")
    assert planned(recipe) == ["claims", "gate"]


def test_an_edit_of_a_comment_in_it_reruns_nothing(recipe):
    recipe.edit("my_study/claims.py", "HIGH = 1.0  # t", "HIGH = 1.0  # in thicknesses")
    assert planned(recipe) == []


def test_a_mistake_in_it_stops_with_its_line_before_any_job(recipe):
    recipe.edit("my_study/__init__.py", "sheets=figure_sheet", "sheet=figure_sheet")
    run = recipe.snakemake(config=CONFIG)
    assert run.returncode != 0
    line = run.stderr.splitlines()[-1]
    assert line.startswith(
        "my.yaml over config.yaml: study = 'my_study': my_study/__init__.py, line "
    )
    assert "Traceback" not in run.stderr
    assert "Job stats" not in run.stderr + run.stdout
