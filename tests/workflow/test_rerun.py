"""What runs again after which change: no more and no less than the change needs."""

from collections import Counter

import pytest
import yaml

from wrinklestudy.results.paths import STAGES as TABLE
from wrinklestudy.study.config import parse_config

pytestmark = pytest.mark.workflow

# Figures that show tables of the sheet latex, and of its variant
SHEET_FIGURES = {
    "fig05_amplitude",
    "fig05_wavelength",
    "fig06_aspect",
    "fig06_thickness",
    "fig07_width",
    "fig06_labelled",
    "fig07_confinement",
    "fig07_slaving",
    "fig07_collapse",
    "fig05_page",
    "fig06_page",
    "fig07_page",
}
VARIANT_FIGURES = {"fig05_amplitude", "fig05_wavelength", "fig05_page"}
# the paper's study has no map, no end of compression and no imperfect sheets
STAGES = tuple(name for name in TABLE if name not in ("map", "compression", "imperfection"))
STRAINS = "strain: [0.1, 0.2, 0.32]"
LATEX = "  - material: latex\n    aspect: [2.0]\n    thickness: [1.0e-3]\n"
ASPECT, SHEET = "aspect2_resolves0.001", "aspect2_thickness0.001"


def rules(jobs):
    return Counter(job.rule for job in jobs)


def figures(jobs):
    files = [output for job in jobs if job.rule == "figures" for output in job.outputs]
    return {file.split("/")[-1].split(".")[0] for file in files}


def test_the_second_run_has_nothing_to_do(finished_quick):
    assert finished_quick.planned() == []


def outputs(jobs, stage):
    return {output for job in jobs if job.rule == stage for output in job.outputs}


def test_the_full_study_has_nothing_of_the_quick_one(finished_quick):
    jobs = finished_quick.planned(config=None)
    raw = yaml.safe_load((finished_quick.folder / "config.yaml").read_text())
    study = parse_config(raw, "config.yaml")
    flat = {
        (case.sheet.material, case.sheet.aspect, case.sheet.resolved, case.strain)
        for case in study.cases
    }
    assert rules(jobs) == {
        "material": len(study.materials),
        "mesh": len({(one.aspect, one.resolved) for one in study.all_sheets}),
        "planar": len(flat),
        "stability": len(study.all_sheets),
        "tension": len(study.tension),
        "wrinkle": len(study.cases),
        "metrics": len(study.all_sheets),
        "summary": 1,
        "claims": 1,
        "figures": len(study.catalogue.figures),
        "gate": 1,
    }
    assert not any("quick" in output for job in jobs for output in job.outputs)


def test_one_more_strain_runs_only_what_it_needs(study):
    study.edit("config/quick.yaml", STRAINS, "strain: [0.1, 0.2, 0.25, 0.32]")
    jobs = study.planned()
    results = "results/quick"
    assert outputs(jobs, "planar") == {f"{results}/planar/latex/{ASPECT}/strain0.25.h5"}
    assert outputs(jobs, "wrinkle") == {f"{results}/wrinkle/latex/{SHEET}/strain0.25.h5"}
    assert outputs(jobs, "stability") == {f"{results}/stability/latex/{SHEET}.json"}
    assert outputs(jobs, "metrics") == {f"{results}/metrics/latex/{SHEET}.csv"}
    assert figures(jobs) == SHEET_FIGURES | {"fig04_profiles"}
    assert rules(jobs).keys() == set(STAGES) - {"material", "mesh", "tension"}


def test_one_more_strain_of_a_variant_redraws_only_what_compares_it(study):
    study.edit("config/quick.yaml", "[0.06, 0.12, 0.18]", "[0.06, 0.12, 0.15, 0.18]")
    jobs = study.planned()
    for stage in ("planar", "wrinkle", "stability", "metrics"):
        assert all("/latex-fixed/" in output for output in outputs(jobs, stage))
        assert rules(jobs)[stage] == 1
    assert figures(jobs) == VARIANT_FIGURES


def test_one_more_thickness_uses_the_flat_states_that_there_are(study):
    more = LATEX.replace("1.0e-3", "1.0e-3, 1.2e-3")
    study.edit("config/quick.yaml", LATEX, more)
    jobs = study.planned()
    assert figures(jobs) == {"fig06_thickness", "fig06_labelled", "fig06_page"}
    new = [job.outputs[0] for job in jobs if job.rule in ("stability", "wrinkle", "metrics")]
    assert len(new) == 5
    assert all("latex/aspect2_thickness0.0012" in output for output in new)
    assert rules(jobs).keys() == set(STAGES) - {"material", "mesh", "planar", "tension"}


def test_one_more_aspect_leaves_the_other_sheets_alone(study):
    study.edit("config/quick.yaml", LATEX, LATEX.replace("2.0", "2.0, 2.5"))
    jobs = study.planned()
    assert figures(jobs) == {
        "fig06_aspect",
        "fig06_labelled",
        "fig06_page",
        "fig07_collapse",
        "fig07_page",
    }
    for stage in ("mesh", "planar", "stability", "wrinkle", "metrics"):
        assert outputs(jobs, stage)
        assert all("aspect2.5_" in output for output in outputs(jobs, stage))


@pytest.mark.parametrize(
    ("figure", "sheets"),
    [
        ("fig01_stress", set()),
        ("fig02_sheet", {"latex/aspect2_thickness0.001"}),
        (
            "fig05_amplitude",
            {f"{name}/aspect2_thickness0.001" for name in ("latex", "latex-nh", "latex-svk")},
        ),
        ("fig07_width", {"latex/aspect2_thickness0.001"}),
    ],
)
def test_one_figure_runs_only_what_it_shows(finished_quick, figure, sheets):
    """Of the default study, from nothing: no other L/W, t/W or model, no table of the study."""
    jobs = finished_quick.planned(f"figures/{figure}.pdf", config=None)
    assert figures(jobs) == {figure}
    solved = {"/".join(path.split("/")[2:4]) for path in outputs(jobs, "wrinkle")}
    assert solved == sheets
    for stage in ("stability", "metrics"):
        found = {path.split("/", 2)[2].rpartition(".")[0] for path in outputs(jobs, stage)}
        assert found <= sheets
    assert all(f"/{ASPECT}/" in path for path in outputs(jobs, "planar"))
    assert not rules(jobs).keys() & {"summary", "claims", "gate"}


def test_new_measurements_redraw_the_figures_that_show_them(study):
    folder = study.folder / "data" / "experiment"
    folder.mkdir(exist_ok=True)
    (folder / "wavelength.csv").write_text("aspect,thickness,strain,wavelength_over_width\n")
    jobs = study.planned()
    assert figures(jobs) == {"fig05_wavelength", "fig05_page"}
    assert rules(jobs).keys() == {"figures", "gate"}


def test_a_finer_spelling_of_the_same_number_runs_nothing(study):
    study.edit("config/quick.yaml", STRAINS, "strain: [1.0e-1, 0.20, 0.32]")
    assert study.planned() == []


@pytest.mark.parametrize(
    ("old", "new", "first"),
    [
        ("max_iterations: 200", "max_iterations: 50", {"wrinkle"}),
        ("modes: 8", "modes: 7", {"planar", "stability"}),
        ("grading: 1.5", "grading: 1.4", {"mesh"}),
        ("allow_not_converged: 0", "allow_not_converged: 1", {"gate"}),
    ],
)
def test_a_setting_reruns_the_stages_that_take_it_and_none_before(study, old, new, first):
    study.edit("config.yaml", old, new)
    ran = rules(study.planned())
    assert first <= ran.keys()
    start = min(STAGES.index(stage) for stage in first)
    assert not ran.keys() & set(STAGES[:start])


def test_one_more_strain_of_the_tension_field_judges_again_and_draws_nothing(study):
    study.edit("config/quick.yaml", "strain: [0.1, 0.2]\n", "strain: [0.1, 0.2, 0.25]\n")
    assert rules(study.planned()) == {"tension": 1, "claims": 1, "gate": 1}


def test_another_bending_law_reruns_the_sheets_that_do_not_name_their_own(study):
    study.edit("config.yaml", "bending: thinning #", "bending: fvk #")
    jobs = study.planned()
    for stage in ("planar", "stability", "wrinkle", "metrics"):
        assert all("/latex/" in output for output in outputs(jobs, stage))
        assert outputs(jobs, stage)


def test_an_edit_of_the_plate_reruns_the_states_and_not_the_fit(study):
    path = study.folder / "src/wrinklestudy/mechanics/plate.py"
    path.write_text(path.read_text() + "\n\ndef unused() -> int:\n    return 1\n")
    ran = rules(study.planned())
    assert ran["planar"] == ran["wrinkle"] == 6
    assert ran["stability"] == 2
    assert "material" not in ran
    assert "mesh" not in ran


def test_an_edit_of_one_figure_redraws_that_figure(study):
    path = study.folder / "src/wrinklestudy/studies/panaitescu2019/figures/fig02_sheet.py"
    path.write_text(path.read_text() + "\n\nUNUSED = 1\n")
    jobs = study.planned()
    assert figures(jobs) == {"fig02_sheet"}
    assert rules(jobs).keys() == {"figures", "gate"}


def test_an_edit_of_the_claims_judges_again_and_draws_nothing(study):
    path = study.folder / "src/wrinklestudy/studies/panaitescu2019/claims/width.py"
    path.write_text(path.read_text() + "\n\nUNUSED = 1\n")
    assert rules(study.planned()) == {"claims": 1, "gate": 1}


@pytest.mark.parametrize(
    "name",
    [
        "src/wrinklestudy/mechanics/plate.py",
        "src/wrinklestudy/stages/planar.py",
        "workflow/scripts/stage.py",
    ],
)
def test_an_edit_of_a_comment_reruns_nothing(study, name):
    path = study.folder / name
    path.write_text(f"# A remark.\n{path.read_text()}\n# Another one.\n")
    assert study.planned() == []


def test_an_edit_of_a_stage_reruns_that_stage_and_what_follows(study):
    path = study.folder / "src/wrinklestudy/stages/metrics.py"
    path.write_text(path.read_text() + "\nUNUSED = 1\n")
    ran = {"metrics": 2, "summary": 1, "claims": 1, "figures": len(SHEET_FIGURES), "gate": 1}
    assert rules(study.planned()) == ran


def test_an_edit_of_the_adapter_reruns_every_stage(study):
    path = study.folder / "workflow/scripts/stage.py"
    path.write_text(path.read_text() + "\nUNUSED = 1\n")
    assert rules(study.planned()).keys() == set(STAGES)


def test_a_wrong_config_stops_with_its_line_before_any_job(study):
    study.edit("config/quick.yaml", STRAINS, "strain: [0.1, 5]")
    run = study.snakemake()
    assert run.returncode != 0
    line = "sheets[0].strain[1] = 5: must be a number >= 1e-7 and <= 1"
    assert f"config/quick.yaml over config.yaml: {line}" == run.stderr.splitlines()[-1]
    assert "Traceback" not in run.stderr
    assert "Job stats" not in run.stderr + run.stdout


def test_of_two_config_files_the_one_that_wins_is_named_first(study):
    for name, cells in (("one", 1), ("two", 14)):
        (study.folder / f"{name}.yaml").write_text(f"mesh: {{cells_across: {cells}}}\n")
    run = study.snakemake("--dry-run", "--configfile", "two.yaml", "one.yaml", config=None)
    line = "mesh.cells_across = 1: must be a whole number >= 2 and <= 500"
    assert run.stderr.splitlines()[-1] == f"one.yaml over two.yaml over config.yaml: {line}"
    run = study.snakemake("--dry-run", "--configfile", "one.yaml", "two.yaml", config=None)
    assert run.returncode == 0, run.stderr


def test_a_key_that_stands_twice_is_refused_with_its_line(study):
    study.edit(
        "config/quick.yaml", "  cells_across: 18\n", "  cells_across: 18\n  cells_across: 9\n"
    )
    run = study.snakemake("--dry-run")
    lines = (study.folder / "config/quick.yaml").read_text().splitlines()
    second = lines.index("  cells_across: 9") + 1
    wanted = f"config/quick.yaml, line {second}: mesh.cells_across stands twice, first in line"
    assert run.returncode != 0
    assert run.stderr.splitlines()[-1] == f"{wanted} {second - 1}"


def test_a_number_on_the_command_line_counts_as_one_in_the_file(study):
    assert study.planned("--config", "mesh={cells_across: 18}") == []
    run = study.snakemake("--dry-run", "--config", "mesh={cells_across: 1_8}")
    line = "mesh.cells_across = '1_8': must be a whole number >= 2 and <= 500"
    source = "--config over config/quick.yaml over config.yaml"
    assert run.stderr.splitlines()[-1] == f"{source}: {line}"


@pytest.mark.parametrize("spelling", ["results/quick/", "./results/quick", "results//quick"])
def test_another_spelling_of_a_folder_is_the_same_folder(study, spelling):
    study.edit("config/quick.yaml", "results: results/quick", f"results: {spelling}")
    assert study.planned() == []


def test_a_folder_may_lie_at_home(finished_quick, tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    jobs = finished_quick.planned("--config", "folders={results: ~/wrinkles}")
    (gate,) = outputs(jobs, "gate")
    assert gate == f"{tmp_path}/wrinkles/gate/gate.json"


SHEETS = "results/quick/wrinkle/latex/aspect2_thickness"


@pytest.mark.parametrize(
    ("target", "fault"),
    [
        (f"{SHEETS}0.001/strain0.20.h5", f"write {SHEETS}0.001/strain0.2.h5"),
        (f"./{SHEETS}1.5e-3/strain0.2.h5", f"write {SHEETS}0.0015/strain0.2.h5"),
        (f"{SHEETS}0.001/strain20.h5", "strain = 20: must be a number >= 1e-7 and <= 1"),
        ("figures/quick/fig4_profiles.png", "did you mean fig04_profiles?"),
    ],
)
def test_a_file_that_cannot_be_is_refused_in_one_line(finished_quick, target, fault):
    run = finished_quick.snakemake("--dry-run", target)
    assert run.returncode != 0
    last = run.stderr.splitlines()[-1]
    assert last.startswith(f"{target}: ")
    assert fault in last
    assert "Exception" not in run.stderr
    assert "Job stats" not in run.stderr + run.stdout
