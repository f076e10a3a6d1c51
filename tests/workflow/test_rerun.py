"""What runs again after which change: no more and no less than the change needs."""

from collections import Counter

import pytest

pytestmark = pytest.mark.workflow

TABLE_FIGURES = {
    "fig05a_amplitude",
    "fig05b_wavelength",
    "fig07a_width",
    "fig07b_confinement",
    "fig07c_slaving",
}
STRAINS = "strain: [0.1, 0.2, 0.32]"
THICKNESS = "thickness: [1.0e-3]"


def rules(jobs):
    return Counter(job.rule for job in jobs)


def figures(jobs):
    files = [output for job in jobs if job.rule == "figures" for output in job.outputs]
    return {file.split("/")[-1].split(".")[0] for file in files}


def test_the_second_run_has_nothing_to_do(finished_quick):
    assert finished_quick.planned() == []


def test_the_full_study_has_nothing_of_the_quick_one(finished_quick):
    jobs = finished_quick.planned(config=None)
    assert rules(jobs) == {
        "material": 3,
        "mesh": 1,
        "planar": 25,
        "stability": 1,
        "wrinkle": 25,
        "metrics": 1,
        "figures": 9,
        "gate": 1,
    }
    assert not any("quick" in output for job in jobs for output in job.outputs)


def test_one_more_strain_runs_only_what_it_needs(study):
    study.edit("config/quick.yaml", STRAINS, "strain: [0.1, 0.2, 0.25, 0.32]")
    jobs = study.planned()
    for stage in ("planar", "wrinkle"):
        outputs = [job.outputs for job in jobs if job.rule == stage]
        assert [files[0].split("/")[-1] for files in outputs] == ["strain0.25.h5"]
    assert figures(jobs) == TABLE_FIGURES | {"fig04b_profiles"}
    assert rules(jobs).keys() == {"planar", "stability", "wrinkle", "metrics", "figures", "gate"}
    assert rules(jobs)["stability"] == 1


def test_one_more_thickness_uses_the_flat_states_that_there_are(study):
    study.edit("config/quick.yaml", THICKNESS, "thickness: [1.0e-3, 1.2e-3]")
    jobs = study.planned()
    assert figures(jobs) == TABLE_FIGURES
    new = [job.outputs[0] for job in jobs if job.rule in ("stability", "wrinkle")]
    assert len(new) == 4
    assert all("aspect2_thickness0.0012" in output for output in new)
    assert rules(jobs).keys() == {"stability", "wrinkle", "metrics", "figures", "gate"}


def test_a_finer_spelling_of_the_same_number_runs_nothing(study):
    study.edit("config/quick.yaml", STRAINS, "strain: [1.0e-1, 0.20, 0.32]")
    assert study.planned() == []


@pytest.mark.parametrize(
    ("old", "new", "first"),
    [
        ("max_iterations: 60", "max_iterations: 50", {"wrinkle"}),
        ("modes: 8", "modes: 7", {"planar", "stability"}),
        ("grading: 1.5", "grading: 1.4", {"mesh"}),
        ("allow_not_converged: 0", "allow_not_converged: 1", {"gate"}),
    ],
)
def test_a_setting_reruns_the_stages_that_take_it_and_none_before(study, old, new, first):
    study.edit("config.yaml", old, new)
    order = ("material", "mesh", "planar", "stability", "wrinkle", "metrics", "figures", "gate")
    ran = rules(study.planned())
    assert first <= ran.keys()
    start = min(order.index(stage) for stage in first)
    assert not ran.keys() & set(order[:start])


def test_an_edit_of_the_plate_reruns_the_states_and_not_the_fit(study):
    path = study.folder / "src/wrinklestudy/plate.py"
    path.write_text(path.read_text() + "\n\ndef unused() -> int:\n    return 1\n")
    ran = rules(study.planned())
    assert ran["planar"] == ran["wrinkle"] == 3
    assert ran["stability"] == 1
    assert "material" not in ran
    assert "mesh" not in ran


def test_an_edit_of_one_figure_redraws_that_figure(study):
    path = study.folder / "src/wrinklestudy/figures/fig02_sheet.py"
    path.write_text(path.read_text() + "\n\nUNUSED = 1\n")
    jobs = study.planned()
    assert figures(jobs) == {"fig02_sheet"}
    assert rules(jobs).keys() == {"figures", "gate"}


@pytest.mark.parametrize("name", ["src/wrinklestudy/plate.py", "workflow/scripts/planar.py"])
def test_an_edit_of_a_comment_reruns_nothing(study, name):
    path = study.folder / name
    path.write_text(f"# A remark.\n{path.read_text()}\n# Another one.\n")
    assert study.planned() == []


def test_an_edit_of_a_script_reruns_its_stage(study):
    path = study.folder / "workflow/scripts/metrics.py"
    path.write_text(path.read_text() + "\nUNUSED = 1\n")
    assert rules(study.planned()) == {"metrics": 1, "figures": 5, "gate": 1}


def test_a_wrong_config_stops_with_its_line_before_any_job(study):
    study.edit("config/quick.yaml", STRAINS, "strain: [0.1, 5]")
    run = study.snakemake()
    assert run.returncode != 0
    line = "sheets[0].strain[1] = 5: must be a number > 0 and <= 1"
    assert f"config/quick.yaml over config.yaml: {line}" == run.stderr.splitlines()[-1]
    assert "Traceback" not in run.stderr
    assert "Job stats" not in run.stderr + run.stdout


def test_a_spelling_that_is_no_case_is_refused(finished_quick):
    folder = "results/quick/wrinkle/latex/aspect2_thickness0.001"
    run = finished_quick.snakemake("--dry-run", f"{folder}/strain0.20.h5")
    assert run.returncode != 0
    assert "MissingRuleException" in run.stderr + run.stdout
