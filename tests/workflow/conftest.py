"""The quick study, run once for real in a copy of the project; tests take copies of that."""

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PARTS = ("Snakefile", "config.yaml", "config", "data", "profiles", "src", "workflow")
QUICK = "config/quick.yaml"


@dataclass(frozen=True)
class Job:
    """One job of a dry run."""

    rule: str
    outputs: tuple[str, ...]


class Study:
    """A copy of the project in a folder of its own."""

    def __init__(self, folder: Path):
        self.folder = folder

    def snakemake(self, *options: str, config: str | None = QUICK) -> subprocess.CompletedProcess:
        """Run snakemake on the code and the config of the copy."""
        command = [sys.executable, "-m", "snakemake", "--cores", "2", *options]
        if config is not None:
            command += ["--configfile", config]
        return subprocess.run(
            command,
            cwd=self.folder,
            env={**os.environ, "PYTHONPATH": str(self.folder / "src")},
            capture_output=True,
            text=True,
            check=False,
        )

    def planned(self, *options: str, config: str | None = QUICK) -> list[Job]:
        """Return the jobs that snakemake would run, without the target rule."""
        run = self.snakemake("--dry-run", *options, config=config)
        text = run.stdout + run.stderr
        assert run.returncode == 0, text
        jobs = []
        for block in text.split("\nrule ")[1:]:
            lines = block.splitlines()
            outputs = [line.split(": ", 1)[1] for line in lines if line.startswith("    output: ")]
            if outputs:
                jobs.append(Job(lines[0].rstrip(":"), tuple(outputs[0].split(", "))))
        assert bool(jobs) != ("Nothing to be done" in text), text
        return jobs

    def copied_to(self, folder: Path) -> "Study":
        """Return a copy to be changed, in a folder that is not there yet."""
        shutil.copytree(self.folder, folder)  # keeps the times of the files
        return Study(folder)

    def edit(self, name: str, old: str, new: str) -> None:
        """Replace a text that stands once in a file."""
        path = self.folder / name
        text = path.read_text()
        assert text.count(old) == 1, f"{old!r} in {name}: {text.count(old)} times"
        path.write_text(text.replace(old, new))


def copy_of_the_project(folder: Path) -> Study:
    """Return a copy of the project as it is, in a folder that is made if need be."""
    folder.mkdir(exist_ok=True)
    for name in PARTS:
        source = ROOT / name
        if source.is_dir():
            ignored = shutil.ignore_patterns("__pycache__", "*.egg-info")
            shutil.copytree(source, folder / name, ignore=ignored)
        else:
            shutil.copy2(source, folder / name)
    return Study(folder)


@pytest.fixture
def fresh(tmp_path):
    """A copy of the project in which nothing has run yet."""
    return copy_of_the_project(tmp_path)


@pytest.fixture(scope="session")
def project():
    """The function that copies the project into a folder."""
    return copy_of_the_project


@pytest.fixture(scope="session")
def finished_quick(tmp_path_factory):
    """The finished quick study; not to be changed."""
    study = copy_of_the_project(tmp_path_factory.mktemp("quick"))
    run = study.snakemake()
    assert run.returncode == 0, run.stdout + run.stderr
    return study


@pytest.fixture(scope="session")
def finished_recipe(tmp_path_factory):
    """The finished study of docs/recipes/study.md; not to be changed."""
    study = copy_of_the_project(tmp_path_factory.mktemp("recipe"))
    for name, text in recipe_files().items():
        path = study.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
    run = study.snakemake(config="my.yaml")
    assert run.returncode == 0, run.stdout + run.stderr
    return study


def recipe_files() -> dict[str, str]:
    """Return the files that the recipe for a study shows, by name."""
    text = (ROOT / "docs" / "recipes" / "study.md").read_text()
    blocks = re.findall(r"```(?:python|yaml)\n# (\S+)\n(.*?)```", text, flags=re.DOTALL)
    return dict(blocks)


@pytest.fixture
def study(finished_quick, tmp_path):
    """A copy of the finished quick study, to be changed."""
    return finished_quick.copied_to(tmp_path / "study")


@pytest.fixture
def recipe(finished_recipe, tmp_path):
    """A copy of the finished study of the recipe, to be changed."""
    return finished_recipe.copied_to(tmp_path / "study")
