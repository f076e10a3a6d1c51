"""Configs that someone broke, and paths that are asked for: a plan within its folders, or lines."""

import os
from pathlib import Path

import pytest
import yaml
from fuzzing import JUNK, ODD, broken, fuzzed, in_time, tree
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.results.paths import Paths
from wrinklestudy.study.config import ConfigError, load_config
from wrinklestudy.study.config.reading import read_study
from wrinklestudy.study.plan import files_on_the_way, wanted_files
from wrinklestudy.study.targets import refusal
from wrinklestudy.vocabulary import one_line

ROOT = Path(__file__).parents[2]
# All blocks, but small: reading YAML is most of the time.
WHOLE = """\
study: panaitescu2019
folders: {results: results, figures: figures, experiment: data/experiment}
materials:
  latex:
    data: data/latex_panaitescu2019.csv
    law: mooney-rivlin
    stretch: [1.0, 1.65]
  given: {law: neo-hookean, constants: {c10: 1.0e+5}}
variants:
  latex-fvk: {material: latex, bending: fvk}
sheets:
  - material: latex # the paper's
    aspect: [2.0, 2.5]
    thickness: [1.0e-3]
    strain: {start: 0.1, stop: 0.3, step: 0.1}
  - {material: latex-fvk, aspect: [2.0], thickness: [1.0e-3], strain: [0.12]}
tension:
  - {material: latex, aspect: [2.0], strain: [0.1]}
imperfections:
  - {material: latex, aspect: [2.0], thickness: [1.0e-3], strain: [0.12], shear: [0.003, 0.01]}
  - material: latex
    aspect: [2.0]
    thickness: [1.0e-3]
    strain: [0.12]
    thickness_ripple: {amplitude: [0.01], wavelength: 0.5}
mesh: {cells_across: 36, cells_along: 24, grading: 1.5}
plate: {bending: thinning, parity: antisymmetric}
solver: {modes: 8, tolerance: 1.0e-22, max_iterations: 200, seeds: 1}
gate: {allow_not_converged: 0}
figures:
  sheet: {material: latex, aspect: 2.0, thickness: 1.0e-3}
  compare: [latex, latex-fvk]
"""
PART = """\
folders:
  results: results/quick
sheets:
  - material: latex
    aspect: [2.0]
    thickness: [1.0e-3]
    strain: [0.1, 0.2, 0.32]
"""
STUDY = load_config(yaml.safe_load(WHOLE), [])
PATHS = Paths(STUDY.folders.results, STUDY.folders.figures)
FILES = [*wanted_files(STUDY, PATHS), *files_on_the_way(STUDY, PATHS)]


@pytest.fixture
def project(tmp_path, monkeypatch):
    """The config and the data of the project, as the working folder."""
    (tmp_path / "data").symlink_to(ROOT / "data")
    (tmp_path / "config.yaml").write_text(WHOLE)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def assert_planned_inside(study):
    """Every file of the plan is in the folders of results and figures."""
    folders = study.folders
    paths = Paths(folders.results, folders.figures)
    for file in (*wanted_files(study, paths), *files_on_the_way(study, paths)):
        place = Path(os.path.normpath(file))
        inside = [os.path.normpath(folder) for folder in (folders.results, folders.figures)]
        assert any(place.is_relative_to(folder) for folder in inside), file
        assert refusal(file, study, paths) is None, file


def assert_lines(error, name="my.yaml"):
    """Every line names the config, and nothing in it moves the cursor of a terminal."""
    lines = str(error).splitlines()
    assert lines
    for line in lines:
        assert name in line, line
        assert line.isprintable(), line


@fuzzed()
@given(broken(WHOLE, PART))
def test_configs(project, content):
    Path("my.yaml").write_bytes(content)
    with in_time():
        try:
            study = read_study("my.yaml")
        except ConfigError as error:
            assert_lines(error)
        else:
            assert_planned_inside(study)
    assert {name for name in tree(project) if "/" not in name} == {"config.yaml", "data", "my.yaml"}


NAMES = ODD.filter(lambda text: text.strip()) | st.text(min_size=1, max_size=8)


@fuzzed()
@given(NAMES, st.sampled_from(["material", "variant", "results", "figures", "data", "study"]))
def test_names_that_reach_paths_and_pages(project, name, place):
    """A material, a folder or a file may have any name that is safe, and no other."""
    del project
    raw = yaml.safe_load(WHOLE)
    if place == "material":
        raw["materials"][name] = {"law": "svk"}
        raw["sheets"].append(raw["sheets"][0] | {"material": name})
    elif place == "variant":
        raw["variants"][name] = {"material": "latex", "bending": "fvk"}
        raw["sheets"].append(raw["sheets"][0] | {"material": name})
    elif place == "data":
        raw["materials"]["latex"]["data"] = name
    elif place == "study":
        raw["study"] = name
    else:
        raw["folders"][place] = name
    with in_time():
        try:
            study = load_config(raw, ["config.yaml"])
        except ConfigError as error:
            refused = error
        else:
            refused = None
    if refused is not None:
        assert_lines(refused, "config.yaml")
        return
    assert_planned_inside(study)
    if place in ("material", "variant"):
        assert name.replace("-", "").replace("_", "").isalnum()
        assert name.isascii()


def edited_paths():
    """Return paths of the study, and such paths with junk in the place of some characters."""
    place = st.floats(0.0, 1.0, exclude_max=True)

    def edit(path, place, length, junk):
        at = int(place * len(path))
        return path[:at] + junk + path[at + length :]

    return st.builds(edit, st.sampled_from(FILES), place, st.integers(0, 12), JUNK)


@fuzzed()
@given(edited_paths() | JUNK)
def test_paths_that_are_asked_for(path):
    with in_time():
        said = refusal(path, STUDY, PATHS)
    assert said is None or (said.startswith(one_line(path)) and said.isprintable())
