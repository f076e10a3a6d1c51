"""The quick study runs from measured curve to figures, and what it leaves can be trusted."""

import csv
import json

import pytest

from wrinklestudy.study.loading import load_catalogue

pytestmark = pytest.mark.workflow


@pytest.mark.parametrize("name", load_catalogue("panaitescu2019").figure_names)
def test_each_figure_is_there_in_both_formats(finished_quick, name):
    figures = finished_quick.folder / "figures" / "quick"
    pdf, png = ((figures / f"{name}{suffix}").read_bytes() for suffix in (".pdf", ".png"))
    assert pdf.startswith(b"%PDF")
    assert b"%%EOF" in pdf[-20:]
    assert png.startswith(b"\x89PNG")
    assert png.endswith(b"IEND\xaeB`\x82")
    assert min(len(pdf), len(png)) > 5_000


def test_the_table_has_one_row_for_each_case_and_no_hole(finished_quick):
    results = finished_quick.folder / "results" / "quick"
    with open(results / "summary" / "states.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    cases = {"latex": [0.1, 0.2, 0.32], "latex-fixed": [0.06, 0.12, 0.18]}
    wanted = [(name, strain) for name, strains in cases.items() for strain in strains]
    assert sorted((row["material"], float(row["strain"])) for row in rows) == wanted
    # the sheet of the paper is wrinkled between 0.025 and 0.4, at any mesh worth the name
    assert [row["status"] for row in rows] == ["wrinkled"] * 6
    assert json.loads((results / "gate" / "gate.json").read_text())["cases"] == 6


def test_a_variant_has_the_material_of_its_base_and_its_own_bending(finished_quick):
    results = finished_quick.folder / "results" / "quick"
    with open(results / "summary" / "stability.csv", newline="") as file:
        base, fixed = sorted(csv.DictReader(file), key=lambda row: row["material"])
    assert (base["bending"], fixed["bending"]) == ("thinning", "fixed-thickness")
    assert base["law"] == fixed["law"] == "mooney-rivlin"
    # a sheet that keeps its thickness is stiffer at large strain: its wrinkles go earlier
    assert float(fixed["decay_strain"]) < float(base["decay_strain"]) - 0.03
    assert not (results / "material" / "latex-fixed.json").exists()


def test_claims_and_table_one_are_there_and_complete(finished_quick):
    claims = finished_quick.folder / "results" / "quick" / "claims"
    with open(claims / "claims.csv", newline="") as file:
        verdicts = {row["verdict"] for row in csv.DictReader(file)}
    assert verdicts <= {"agree", "disagree", "depends on", "not computed"}
    assert "agree" in verdicts
    assert (claims / "claims.html").read_text().rstrip().endswith("</html>")
    assert len((claims / "table1.csv").read_text().splitlines()) > 1


def test_nothing_is_written_outside_the_folders_of_the_quick_study(finished_quick):
    for name in ("results", "figures"):
        assert [path.name for path in (finished_quick.folder / name).iterdir()] == ["quick"]


def test_no_temporary_file_is_left(finished_quick):
    results = finished_quick.folder / "results"
    kept = {".snakemake_timestamp", ".record", ".running"}  # records, and the lock of a run
    assert [path for path in results.rglob(".*") if path.name not in kept] == []


def test_a_job_that_fails_says_why_in_one_line_and_the_log_has_the_rest(study):
    study.edit("data/treloar1944.csv", "stretch,", "strech,")
    run = study.snakemake("results/quick/material/treloar.json")
    assert run.returncode != 0
    lines = [line for line in run.stderr.splitlines() if "treloar1944.csv" in line]
    assert any("column 'strech' is unknown" in line for line in lines), run.stderr
    assert "Traceback" not in run.stderr
    log = study.folder / "results/quick/log/material/treloar.log"
    assert "Traceback" in log.read_text()


def statuses(study):
    table = study.folder / "results" / "quick" / "summary" / "states.csv"
    with open(table, newline="") as file:
        return [(row["status"], int(row["newton_iterations"])) for row in csv.DictReader(file)]


def test_the_gate_fails_the_run_when_a_case_has_not_converged(study):
    needed = max(iterations for _, iterations in statuses(study))
    study.edit("config.yaml", "max_iterations: 200", f"max_iterations: {needed - 1}")
    study.edit("config/quick.yaml", "figures:\n  comp", "figures:\n  names: [fig07_width]\n  comp")
    run = study.snakemake("--quiet", "all")
    failed = sum(status == "not-converged" for status, _ in statuses(study))
    assert 0 < failed < 6
    assert run.returncode != 0
    line = f"{failed} of 6 cases have not converged (gate.allow_not_converged = 0)"
    assert line in run.stderr

    study.edit("config.yaml", "allow_not_converged: 0", f"allow_not_converged: {failed}")
    assert [job.rule for job in study.planned()] == ["gate"]
    assert study.snakemake("--quiet", "all").returncode == 0
