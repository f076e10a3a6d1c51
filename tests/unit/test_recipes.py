"""The recipes of the docs are followed to the letter: their blocks of Python are executed."""

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from wrinklestudy import MeshSettings, Sheet, mooney_rivlin, neo_hookean
from wrinklestudy.cli import main
from wrinklestudy.material.fit import fit
from wrinklestudy.mechanics import plate
from wrinklestudy.mechanics.bending import BENDING_LAWS
from wrinklestudy.mechanics.laws import LAWS, describe, from_description, law_of
from wrinklestudy.mechanics.section import Section
from wrinklestudy.results.materials import load_fit
from wrinklestudy.stages import material as material_stage
from wrinklestudy.study.config.blocks import MaterialBlock, PlateBlock
from wrinklestudy.study.figures import style
from wrinklestudy.study.scan_file import read_scan_file

ROOT = Path(__file__).parents[2]
TRELOAR = ROOT / "data" / "treloar1944.csv"
COARSE = ["--cells-along", "10", "--cells-across", "16"]
SHEET = ["--aspect", "2", "--thickness", "1e-3", *COARSE]


def block(recipe):
    """The Python block of a recipe."""
    text = (ROOT / "docs" / "recipes" / f"{recipe}.md").read_text(encoding="utf-8")
    (found,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    return found


@pytest.fixture
def gent():
    """Follow the recipe of a law, and forget the law afterwards."""
    assert "gent" not in LAWS
    exec(compile(block("law"), "law.md", "exec"), {"__name__": "recipe"})
    yield law_of("gent")
    del LAWS["gent"]


@pytest.fixture
def constant():
    """Follow the recipe of a bending law, and forget it afterwards."""
    exec(compile(block("bending_law"), "bending_law.md", "exec"), {"__name__": "recipe"})
    yield BENDING_LAWS["constant"]
    del BENDING_LAWS["constant"]


@pytest.mark.usefixtures("gent")
def test_a_law_is_solved_from_the_command_line(capsys):
    command = ["solve", *SHEET, "--law", "gent", "--mu", "3.9e5", "--strain", "0.1", "--json"]
    assert main([*command, "--jm", "80"]) == 0
    (state,) = json.loads(capsys.readouterr().out)
    assert state["status"] == "wrinkled"
    # without a limit the law is neo-Hookean
    assert main([*command, "--jm", "1e9"]) == 0
    (limit,) = json.loads(capsys.readouterr().out)
    rubber = Sheet(2, 1e-3, neo_hookean(1.95e5), mesh=MeshSettings(10, 16)).solve(0.1).as_dict()
    for name in ("amplitude_over_thickness", "nominal_stress_pa"):
        assert limit[name] == pytest.approx(rubber[name], rel=1e-6)
    assert state["nominal_stress_pa"] > limit["nominal_stress_pa"]
    assert main([*command, "--jm", "-8e1"]) == 2
    assert "jm = -80: must be > 0" in capsys.readouterr().err


@pytest.mark.usefixtures("gent")
def test_a_law_is_fitted_and_comes_back_from_its_file(tmp_path):
    result = fit(TRELOAR, "gent")
    assert result.units == {"mu": "Pa", "jm": ""}
    # chains cannot be longer than at the last stretch that was measured
    assert result.constants["jm"] > 7.6**2 + 2 / 7.6 - 3
    assert result.rms_pa < 0.25 * fit(TRELOAR, "mooney-rivlin").rms_pa
    material = result.material()
    assert describe(material) == {
        "law": "gent",
        "mu_pa": pytest.approx(result.constants["mu"]),
        "jm": result.constants["jm"],
    }
    assert from_description(describe(material)).law == material.law
    material_stage.run("gent", "rubber", tmp_path / "rubber.json", csv=TRELOAR)
    assert load_fit(tmp_path / "rubber.json").as_dict() == result.as_dict()


def test_a_law_is_shown_and_allowed_in_the_config(gent):
    assert style.law_label("gent") == "Gent"
    assert style.looks(["gent", "svk"])[0] != style.looks(["svk"])[0]
    assert MaterialBlock(data="a.csv", law="gent").law == gent.name


def test_a_law_that_was_forgotten_is_unknown():
    with pytest.raises(ValueError, match="law 'gent' is unknown"):
        law_of("gent")


def test_the_tangent_of_the_law_of_the_recipe_is_that_of_its_energy(gent):
    law, step = gent.material(mu=1.0, jm=5.0).law, 1e-6
    metric = np.array([1.6, 0.9, 0.2])
    steps = [step * axis for axis in np.eye(3)]
    slope = [law.energy(metric + 1j * 1e-24 * s).imag / 1e-30 for s in steps]
    np.testing.assert_allclose(law.derivatives(metric)[0], slope, rtol=1e-12)
    bend = [law.derivatives(metric + s)[0] - law.derivatives(metric - s)[0] for s in steps]
    np.testing.assert_allclose(law.derivatives(metric)[1], np.array(bend) / (2 * step), rtol=1e-7)


def test_a_bending_law_is_solved_and_allowed_in_the_config(constant, capsys):
    constants = ["--c10", "1.95e5", "--c01", "0"]
    command = ["solve", *SHEET, *constants, "--strain", "0.1", "--json", "--bending"]
    assert main([*command, "constant"]) == 0
    (state,) = json.loads(capsys.readouterr().out)
    assert main([*command, "fvk"]) == 0
    (fvk,) = json.loads(capsys.readouterr().out)
    assert state["status"] == "wrinkled"
    # both have the initial stiffness; they differ in what they take for the curvature
    ratio = state["amplitude_over_thickness"] / fvk["amplitude_over_thickness"]
    assert ratio == pytest.approx(1.0, abs=0.1)
    assert ratio != 1.0
    assert PlateBlock(bending="constant").bending == constant.name


@pytest.mark.usefixtures("constant")
def test_the_bending_law_of_the_recipe_is_objective_and_exact():
    law, rng = mooney_rivlin(6.21e4, 1.58e5).law, np.random.default_rng(2)
    section = Section(law, 0.05, "constant")
    values = 0.1 * rng.standard_normal((5, 3, 1))
    values[0, 0] += 1.2
    values[1, 1] += 0.9
    slope = plate.gradient(*plate.respond(section, values))
    step = 1e-5 * rng.standard_normal(values.shape)
    ends = [plate.energy(section, values + sign * step)[0] for sign in (1, -1)]
    assert ends[0] - ends[1] == pytest.approx(2.0 * float((slope * step).sum()), rel=1e-7)
    turn = np.linalg.qr(rng.standard_normal((3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    turned = np.einsum("ij,ajp->aip", turn, values)
    assert plate.energy(section, turned) == pytest.approx(plate.energy(section, values), rel=1e-13)


@pytest.mark.parametrize("recipe", ["law", "bending_law", "own_scan"])
def test_the_block_of_a_recipe_stands_alone(recipe):
    subprocess.run([sys.executable, "-c", block(recipe)], check=True)


def test_the_scan_of_the_recipe_is_measured_within_its_errors(capsys):
    names = {"__name__": "recipe"}
    exec(compile(block("own_scan"), "own_scan.md", "exec"), names)
    scan = names["scan"]
    # the middle peak of a symmetric packet has the height of the packet
    assert abs(scan.measures.amplitude - names["true_height"]) < 3.0 * scan.amplitude_error
    # an envelope that falls moves the side peaks inwards, by a few percent
    assert scan.measures.wavelength == pytest.approx(names["true_wavelength"], rel=0.05)
    assert scan.left_out == 5
    assert "5 points left out" in capsys.readouterr().out


def test_the_table_of_the_recipe_is_read(tmp_path):
    text = (ROOT / "docs" / "recipes" / "own_scan.md").read_text(encoding="utf-8")
    (table,) = re.findall(r"```csv scan.csv\n(.*?)```", text, re.DOTALL)
    path = tmp_path / "scan.csv"
    path.write_text(table, encoding="utf-8")
    file = read_scan_file(path)
    assert (file.unit, len(file.y), np.isnan(file.z).sum()) == ("mm", 3, 1)
