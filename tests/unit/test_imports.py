"""Imports point one way, and a job imports no more than it needs."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import wrinklestudy

ROOT = Path(wrinklestudy.__file__).parent

# From the bottom up: a room may import from the rooms before its own, and from itself.
ROOMS = [
    "typing",
    "vocabulary",
    "files",
    "mechanics",
    "fem",
    "equilibrium",
    "material",
    "metrics",
    "results",
    "study",
    "stages",
    "studies",
    "explorer",
    "sheet",
    "cli",
    "__init__",
]


def modules():
    for path in sorted(ROOT.rglob("*.py")):
        relative = path.relative_to(ROOT).with_suffix("")
        yield relative.parts[0], path


def imported(path):
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module:
            yield node.module, [alias.name for alias in node.names]
        elif isinstance(node, ast.Import):
            for alias in node.names:
                yield alias.name, []


def test_imports_point_down():
    level = {name: k for k, name in enumerate(ROOMS)}
    wrong = []
    for name, path in modules():
        assert name in level, f"{path}: not in the rooms of the architecture"
        for module, names in imported(path):
            parts = module.split(".")
            if parts[0] != "wrinklestudy":
                continue
            targets = [parts[1]] if len(parts) > 1 else names
            wrong += [f"{path.name} imports {t}" for t in targets if level[t] > level[name]]
    assert not wrong


def test_a_study_is_loaded_by_its_name_and_imported_by_none():
    for room, path in modules():
        names = [] if room == "studies" else [module for module, _ in imported(path)]
        assert not [name for name in names if name.startswith("wrinklestudy.studies")], path


def test_the_library_never_imports_snakemake():
    for _, path in modules():
        assert not [m for m, _ in imported(path) if m.split(".")[0] == "snakemake"], path


@pytest.mark.parametrize("module", ["planar", "stability", "wrinkle"])
def test_solver_jobs_do_not_import_heavy_packages(module):
    code = (
        f"import sys, wrinklestudy.stages.{module};"
        "print([m for m in ('pandas', 'matplotlib', 'pydantic', 'meshio') if m in sys.modules])"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


def test_figures_of_computed_points_do_without_splines():
    code = (
        "import sys; from wrinklestudy.studies.panaitescu2019.figures import fig05_amplitude;"
        "print('scipy.interpolate' in sys.modules)"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "False"


def test_a_solve_and_its_measures_do_without_splines_and_optimisers():
    """They would add a sixth to the time of a solve."""
    code = (
        "import sys; from wrinklestudy import MeshSettings, Sheet, mooney_rivlin;"
        "sheet = Sheet(2.0, 1e-3, mooney_rivlin(6.21e4, 1.58e5), mesh=MeshSettings(8, 16));"
        "assert sheet.solve(0.12).measures is not None;"
        "print([m for m in ('scipy.interpolate', 'scipy.optimize', 'scipy.stats')"
        " if m in sys.modules])"
    )
    solve = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert solve.stdout.strip() == "[]"
