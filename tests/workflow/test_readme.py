"""What the README shows works as it stands there."""

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

README = (Path(__file__).parents[2] / "README.md").read_text()
COMMANDS = re.findall(r"^ +\.venv/bin/snakemake (.*?)(?: +#.*)?$", README, flags=re.MULTILINE)
WORKFLOW = pytest.mark.workflow


def test_the_library_example_prints_a_wrinkled_state():
    (example,) = re.findall(r"```python\n(.*?)```", README, flags=re.DOTALL)
    run = subprocess.run(
        [sys.executable, "-c", example], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    status, amplitude = run.stdout.split()
    assert status == "wrinkled"
    assert 1 < float(amplitude) < 10


@pytest.fixture(scope="module")
def project(finished_quick, tmp_path_factory):
    """A copy of the project with the config that the README shows."""
    (example,) = re.findall(r"```yaml\n# (\S+)\n(.*?)```", README, flags=re.DOTALL)
    name, text = example
    study = finished_quick.copied_to(tmp_path_factory.mktemp("readme") / "project")
    (study.folder / name).write_text(text)
    return study, yaml.safe_load(text)


@WORKFLOW
@pytest.mark.parametrize("command", COMMANDS)
def test_the_commands_of_a_study_are_understood(project, command):
    study, _ = project
    words = shlex.split(command.split(">")[0])
    draws = any(word.startswith("--rulegraph") or word.startswith("--dag") for word in words)
    run = study.snakemake(*words, *([] if draws else ["--dry-run"]), config=None)
    assert run.returncode == 0, run.stdout + run.stderr
    if draws:
        assert "flowchart" in run.stdout or "digraph" in run.stdout


@WORKFLOW
def test_the_study_of_another_material_keeps_to_its_own_folders(project):
    study, raw = project
    jobs = study.planned(config="my.yaml")
    folders = tuple(f"{folder}/" for folder in raw["folders"].values())
    assert all(output.startswith(folders) for job in jobs for output in job.outputs)
    (material,) = {entry["material"] for entry in raw["sheets"]}
    planar = {path.split("/")[-3] for job in jobs if job.rule == "planar" for path in job.outputs}
    assert planar == {material}


def test_the_commands_that_people_use_most_are_there():
    assert any("figures/fig05_amplitude.pdf" in command for command in COMMANDS)
    assert any("/wrinkle/" in command for command in COMMANDS)
    assert any("--configfile" in command for command in COMMANDS)
    assert any(command.startswith("-n") for command in COMMANDS)
    assert any("graph" in command or "--dag" in command for command in COMMANDS)
