"""The tutorial works as it stands: its commands are run one by one, its numbers are right."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pandas as pd
import pytest

pytestmark = pytest.mark.workflow

ROOT = Path(__file__).parents[2]
TUTORIAL = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")
COMMANDS = [
    line
    for block in re.findall(r"```sh\n(.*?)```", TUTORIAL, flags=re.DOTALL)
    for line in block.splitlines()
]


def run(study, command, *more):
    program, *arguments = shlex.split(command)
    module = {"wrinklestudy": "wrinklestudy.cli", "snakemake": "snakemake"}[program]
    return subprocess.run(
        [sys.executable, "-m", module, *arguments, *more],
        cwd=study.folder,
        env={**os.environ, "PYTHONPATH": str(study.folder / "src"), "OMP_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture(scope="module")
def followed(project, tmp_path_factory):
    """The folder in which every command of the tutorial was run, and what each printed."""
    study = project(tmp_path_factory.mktemp("tutorial"))
    (config,) = re.findall(r"```yaml\n(# tutorial\.yaml\n.*?)```", TUTORIAL, flags=re.DOTALL)
    (study.folder / "tutorial.yaml").write_text(config)
    return study, [run(study, command) for command in COMMANDS]


def test_every_command_succeeds(followed):
    _, runs = followed
    assert len(runs) >= 6
    failed = [done.args[2:] for done in runs if done.returncode]
    assert failed == [], [done.stderr for done in runs if done.returncode]


@pytest.mark.parametrize(
    "picture",
    [
        "fit.png",
        "sheet.png",
        "scan.png",
        "figures/tutorial/fig04_profiles.png",
        "figures/tutorial/fig05_amplitude.png",
    ],
)
def test_every_picture_that_it_names_is_there(followed, picture):
    assert (followed[0].folder / picture).read_bytes().startswith(b"\x89PNG")


def test_the_fit_finds_the_constants_that_the_data_were_made_with(followed):
    study, (fit, *_) = followed
    constants = dict(re.findall(r"^(c10|c01)\s+(\S+)", fit.stdout, flags=re.MULTILINE))
    assert float(constants["c10"]) == pytest.approx(0.08e6, rel=0.01)
    assert float(constants["c01"]) == pytest.approx(0.12e6, rel=0.01)
    assert study.folder.is_dir()


def test_computed_and_scanned_amplitude_agree(followed):
    """The scan is one of a computed sheet: the study of its rubber must find it within 2%."""
    study, _ = followed
    table = study.folder / "results/tutorial/metrics/my-rubber/aspect2_thickness0.001.csv"
    states = pd.read_csv(table).set_index("strain")
    measured = run(study, "wrinklestudy measure data/tutorial/experiment/profiles --json").stdout
    amplitude = float(re.search(r'"amplitude": ([\d.e-]+)', measured)[1]) / 0.14
    assert states.loc[0.12, "amplitude_over_thickness"] == pytest.approx(amplitude, rel=0.02)


def test_the_files_are_those_that_their_script_makes(project, tmp_path_factory, tmp_path):
    study = project(tmp_path_factory.mktemp("samples"))
    command = [sys.executable, "data/tutorial/make.py", str(tmp_path)]
    environment = {**os.environ, "PYTHONPATH": str(study.folder / "src")}
    subprocess.run(command, cwd=study.folder, env=environment, check=True)
    for name in ("tensile.csv", "experiment/profiles/strain0.12.csv"):
        made = [line for line in (tmp_path / name).read_text().splitlines() if line[:1] != "#"]
        kept = (study.folder / "data/tutorial" / name).read_text().splitlines()
        kept = [line for line in kept if line[:1] != "#"]
        assert len(made) == len(kept)
        for one, other in zip(made[2:], kept[2:], strict=True):
            pairs = zip(one.split(","), other.split(","), strict=True)
            assert all(float(a) == pytest.approx(float(b), abs=2e-3) for a, b in pairs)
