"""`wrinklestudy fit` for a person: text, table, picture, block of a config; and its recipe."""

import json
import re
from pathlib import Path

import pytest
import yaml
from rubber_files import FORMATS, STRETCH, lines, stress

from wrinklestudy.cli import main
from wrinklestudy.material.fit import fit
from wrinklestudy.mechanics.laws import LAWS
from wrinklestudy.study.config.blocks import MaterialBlock

RECIPE = Path(__file__).parents[3] / "docs" / "recipes" / "own_rubber.md"


@pytest.fixture
def preloaded(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("My rubber, 2.csv").write_text(lines("stretch,stress_pa", STRETCH, stress() + 1.5e4))
    return "My rubber, 2.csv"


def test_the_report_has_what_decides_whether_to_believe_it(preloaded, capsys):
    assert main(["fit", preloaded, "--remove-preload"]) == 0
    out, err = capsys.readouterr()
    for word in ("c10", "c01", "standard error", "correlation c10, c01", "condition number"):
        assert word in out
    assert re.search(r"c10 +48000 ", out)
    assert re.search(r"initial Young's modulus +1\.074e\+06 Pa", out)
    assert re.search(r"initial shear modulus +358000 Pa", out)
    assert re.search(r"stable +yes: stress rises with stretch in all modes from 1 to 1.6", out)
    assert re.search(r"misfit .* % of the largest stress", out)
    assert "warning" not in out
    assert err == ""


def test_warnings_are_in_the_text_in_the_json_and_on_stderr(preloaded, capsys):
    assert main(["fit", preloaded]) == 0
    out, err = capsys.readouterr()
    assert "warning: preload: the uniaxial stress at stretch 1 is 1.5e+04" in out
    assert err.startswith("wrinklestudy fit: warning: preload")
    assert main(["fit", preloaded, "--json"]) == 0
    out, again = capsys.readouterr()
    assert again == err
    warnings = json.loads(out)["warnings"]
    assert err.splitlines() == [f"wrinklestudy fit: warning: {text}" for text in warnings]


def test_all_laws_stand_side_by_side(preloaded, capsys):
    assert main(["fit", preloaded, "--law", "all", "--remove-preload"]) == 0
    out, _ = capsys.readouterr()
    table = [line.split() for line in out.splitlines()[3:8]]
    assert {row[0] for row in table} <= set(LAWS)
    assert table[0][0] in ("mooney-rivlin", "ogden")
    assert "svk: fitted to the initial slope" in out
    assert main(["fit", preloaded, "--law", "all", "--remove-preload", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert {one["law"] for one in found} == set(LAWS)
    for one in found:
        assert {"rms_pa", "aicc", "constants"} <= set(one) or "reason" in one


def test_a_warning_of_all_laws_is_printed_once(preloaded, capsys):
    assert main(["fit", preloaded, "--law", "all"]) == 0
    assert capsys.readouterr().err.count("preload: the uniaxial stress") == 1


@pytest.mark.parametrize(
    ("suffix", "start"), [("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<?")]
)
def test_a_picture_is_drawn_and_never_drawn_over(preloaded, capsys, suffix, start):
    picture = Path(f"fit.{suffix}")
    command = ["fit", preloaded, "--law", "all", "--plot", str(picture)]
    assert main(command) == 0
    assert picture.read_bytes().startswith(start)
    picture.write_text("mine")
    capsys.readouterr()
    assert main(command) == 2
    out, err = capsys.readouterr()
    assert (out, err) == (
        "",
        f"wrinklestudy fit: --plot {picture}: exists already; --overwrite replaces it\n",
    )
    assert picture.read_text() == "mine"
    assert main([*command, "--overwrite"]) == 0
    assert picture.read_bytes().startswith(start)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--plot", "fit.jpg"], "--plot fit.jpg: must end in .pdf or .png or .svg"),
        (["--yaml", "--json"], "--yaml and --json exclude each other"),
        (["--yaml", "--law", "all"], "--yaml: needs one law"),
        (["--cycle", "0"], "cycle = 0: must be >= 1"),
        (["--cycle", "2"], "has no loading in cycle 2 of the uniaxial test"),
        (["--branch", "unloading"], "has no unloading in cycle 1"),
        (["--mode", "shear"], "has no shear data"),
    ],
)
def test_options_that_do_not_fit_are_refused_in_one_line(preloaded, capsys, options, message):
    assert main(["fit", preloaded, *options]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert message in err


def test_the_block_makes_the_same_material(preloaded, capsys):
    options = ["--remove-preload", "--stretch", "1", "1.5", "--mode", "uniaxial"]
    assert main(["fit", preloaded, "--law", "yeoh", *options, "--yaml"]) == 0
    block = yaml.safe_load(capsys.readouterr().out)["materials"]
    assert list(block) == ["my-rubber-2"]
    material = MaterialBlock(**block["my-rubber-2"])
    assert main(["fit", preloaded, "--law", "yeoh", *options, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    same = fit(
        material.data,
        material.law,
        stretch=material.stretch,
        modes=material.modes,
        branch=material.branch,
        cycle=material.cycle,
        preload=material.preload,
    )
    assert same.constants == found["constants"]


@pytest.mark.parametrize(
    ("name", "material"), [("no.csv", "rubber-no"), ("2.csv", "rubber-2"), ("ä__B.csv", "b")]
)
def test_the_name_of_the_material_is_one_in_yaml(tmp_path, monkeypatch, capsys, name, material):
    monkeypatch.chdir(tmp_path)
    Path(name).write_text(FORMATS["pascals"])
    assert main(["fit", name, "--yaml"]) == 0
    assert list(yaml.safe_load(capsys.readouterr().out)["materials"]) == [material]


def test_the_recipe_is_followed_to_the_letter(tmp_path, monkeypatch, capsys):
    text = RECIPE.read_text(encoding="utf-8")
    ((name, table),) = re.findall(r"```csv (\S+)\n(.*?)```", text, re.DOTALL)
    (block,) = re.findall(r"```yaml\n(.*?)```", text, re.DOTALL)
    commands = re.findall(r"^    wrinklestudy (fit [^#\n]*)", text, re.MULTILINE)
    assert len(commands) == 5
    monkeypatch.chdir(tmp_path)
    Path(name).write_text(table)
    for command in commands:
        assert main(command.split()) == 0, command
        out, err = capsys.readouterr()
        if "--yaml" in command:
            assert out == block
        assert ("warning: preload" in err) == ("--remove-preload" not in command)
        assert "(16 loading, 6 unloading)" in err
    assert Path("fit.png").stat().st_size > 10_000
