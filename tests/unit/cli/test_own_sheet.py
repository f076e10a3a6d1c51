"""One sheet from the command line: sizes, strains, files, sentences, ends."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import meshio
import numpy as np
import pytest

from wrinklestudy.cli import main
from wrinklestudy.material.fit import fit
from wrinklestudy.stages import material as material_stage

ROOT = Path(__file__).parents[3]
LATEX_CSV = ROOT / "data" / "latex_panaitescu2019.csv"
COARSE = ["--cells-along", "8", "--cells-across", "14"]
LATEX = ["--c10", "6.21e4", "--c01", "1.58e5"]
RATIOS = ["--aspect", "2", "--thickness", "1e-3", *LATEX, *COARSE]
MM = ["--length-mm", "280", "--width-mm", "140", "--thickness-mm", "0.14", *LATEX, *COARSE]
THREADS = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


@pytest.fixture
def solved(capsys):
    """Return a function that runs a command and returns what its JSON says."""

    def run(*words, status=0):
        assert main([*words, "--json"]) == status
        return json.loads(capsys.readouterr().out)

    return run


def numbers(state):
    """All of a state but the time that it took."""
    return {name: value for name, value in state.items() if name != "seconds"}


def refused(capsys, *words, status=2):
    """Return the one line that a command is refused with."""
    assert main([*words]) == status
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    return err


def test_lengths_and_ratios_of_a_sheet_give_the_same_numbers(solved):
    """The problem has no length of its own: mm are ratios times W."""
    (ratios,) = solved("solve", *RATIOS, "--strain", "0.12")
    (mm,) = solved("solve", *MM, "--clamp-mm", "313.6")
    assert numbers(mm).items() >= numbers(ratios).items()
    assert mm["amplitude_mm"] == pytest.approx(0.14 * ratios["amplitude_over_thickness"])
    assert mm["wavelength_mm"] == pytest.approx(140 * ratios["wavelength_over_width"])
    assert mm["force_n"] == pytest.approx(ratios["nominal_stress_pa"] * 0.14 * 0.14e-3)
    assert mm["clamps_mm"] == pytest.approx(313.6)


def test_lengths_and_ratios_give_the_same_birth_and_decay(solved):
    ratios, mm = solved("stability", *RATIOS), solved("stability", *MM)
    assert mm.items() >= ratios.items()
    assert mm["birth_clamps_mm"] == pytest.approx(280 * (1 + ratios["birth_strain"]))


def test_several_processes_give_the_numbers_of_one_in_their_order(solved):
    words = ["solve", *RATIOS, "--strain", "0.3", "--strain", "0.06:0.18:0.06"]
    alone, together = solved(*words), solved(*words, "--jobs", "2")
    assert [state["strain"] for state in alone] == [0.3, 0.06, 0.12, 0.18]
    assert [numbers(state) for state in together] == [numbers(state) for state in alone]


def test_a_material_of_a_config_is_its_fit_and_so_is_the_file_of_a_fit(
    solved, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    Path("mine.yaml").write_text(
        f"materials:\n  mine: {{data: {LATEX_CSV}, law: neo-hookean, stretch: [1.0, 1.5]}}\n"
    )
    constants = fit(LATEX_CSV, "neo-hookean", stretch=(1.0, 1.5)).constants
    material_stage.run("neo-hookean", "mine", "mine.json", csv=LATEX_CSV, stretch=(1.0, 1.5))
    words = ["solve", "--aspect", "2", "--thickness", "1e-3", *COARSE, "--strain", "0.12"]
    (direct,) = solved(*words, "--law", "neo-hookean", "--c10", repr(constants["c10"]))
    for choice in (["--material", "mine", "--config", "mine.yaml"], ["--material", "mine.json"]):
        (state,) = solved(*words, *choice)
        assert numbers(state) == numbers(direct)


VARIANT = f"""
materials:
  mine: {{data: {LATEX_CSV}, law: neo-hookean, stretch: [1.0, 1.5]}}
variants:
  mine-even: {{material: mine, bending: fvk, parity: symmetric}}
  mine-lost: {{material: yours, bending: fvk}}
  mine-wrong: {{material: mine, bending: stiff}}
"""


def test_a_variant_of_a_config_has_its_bending_law_and_parity(solved, capsys, tmp_path):
    config = tmp_path / "mine.yaml"
    config.write_text(VARIANT)
    words = ["solve", "--aspect", "2", "--thickness", "1e-3", *COARSE, "--strain", "0.12"]
    words += ["--config", str(config), "--material"]
    (direct,) = solved(*words, "mine", "--bending", "fvk", "--parity", "symmetric")
    (variant,) = solved(*words, "mine-even")
    assert numbers(variant) == numbers(direct)
    for choice, message in (
        (["mine-even", "--bending", "fvk"], "is a variant with bending = fvk; --bending cannot go"),
        (["mine-even", "--parity", "symmetric"], "--parity cannot go with it"),
        (["mine-lost"], "materials has no 'yours'"),
        (["mine-wrong"], "variants.mine-wrong.bending = 'stiff': must be"),
        (["mine-evn"], "did you mean mine-even?"),
    ):
        assert message in refused(capsys, *words, *choice)


SIZELESS = [*LATEX, *COARSE, "--strain", "0.1"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([*RATIOS, "--strain", "0.1", "--width-mm", "140"], "give ratios or lengths, not both"),
        (["--length-mm", "2", "--width-mm", "1", *SIZELESS], "--thickness-mm: missing"),
        (["--aspect", "2", *SIZELESS], "--thickness: missing"),
        (
            ["--length-mm", "2", "--width-mm", "0", "--thickness-mm", "1", *SIZELESS],
            "--width-mm = 0: must be > 0 mm",
        ),
        (
            ["--length-mm", "140", "--width-mm", "280", "--thickness-mm", "140", *SIZELESS],
            "--thickness-mm over --width-mm = 0.5: must be >= 1e-6 and <= 0.05",
        ),
        ([*MM, "--clamp-mm", "270"], "--clamp-mm = 270: strain -0.0357 of a length of 280 mm"),
        ([*MM, "--clamp-mm", "290:330:30"], "nearest: 320 or 350"),
        ([*RATIOS, "--clamp-mm", "300"], "--clamp-mm: needs --length-mm"),
        ([*RATIOS], "--strain: missing"),
        ([*MM, "--clamp-mm", "300", "--strain", "0.1"], "give strains or distances, not both"),
        ([*RATIOS, "--strain", "0.02:0.31:0.02"], "nearest: 0.3 or 0.32"),
        ([*RATIOS, "--strain", "-0.1:0.3:0.1"], "--strain = -0.1: must be >= 1e-7"),
        ([*RATIOS, "--strain", "1e-12"], "--strain = 1e-12: must be >= 1e-7 and <= 1"),
        ([*RATIOS, "--strain", "0.1", "--jobs", "0"], "--jobs = 0: must be >= 1"),
        ([*RATIOS, "--strain", "0.1", "--material", "a"], "--c10 cannot go with it"),
        ([*RATIOS, "--strain", "0.1", "--config", "a"], "--config: goes with --material"),
        ([*RATIOS, "--strain", "0.1", "--vtu", "a.vtk"], "--vtu a.vtk: must end in .vtu"),
        ([*RATIOS, "--strain", "0.1", "--picture", "a.jpg"], "must end in .pdf or .png or .svg"),
    ],
)
def test_options_that_do_not_go_together_are_one_line(capsys, words, message):
    assert message in refused(capsys, "solve", *words)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("materials: {b: {data: x.csv, law: svk}}", "materials has no 'a'; allowed: b"),
        ("materials: {a: {data: x.csv, law: sv}}", "materials.a.law = 'sv': must be"),
        ("materials: {a: {data: x.csv, law: svk}}", "x.csv: cannot be read"),
        ("materials:\n  a: {}\n  a: {}\n", "line 3: materials.a stands twice"),
        ("materials: [", "is not YAML"),
        ("sheets: []", "materials: must be a block"),
    ],
)
def test_a_material_that_a_config_lacks_is_one_line(capsys, tmp_path, text, message):
    config = tmp_path / "a.yaml"
    config.write_text(text)
    size = ["--aspect", "2", "--thickness", "1e-3", "--strain", "0.1"]
    line = refused(capsys, "solve", *size, "--material", "a", "--config", str(config))
    assert message in line


@pytest.mark.parametrize(
    "words", [["--strain", "1_0e-2"], ["--strain", "0.1:0.2"], ["--cell", "3"]]
)
def test_what_the_parser_refuses_is_one_line(capsys, words):
    with pytest.raises(SystemExit) as stop:
        main(["solve", *RATIOS, *words])
    assert stop.value.code == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_sentences_and_table_say_the_numbers_of_the_json(solved, capsys):
    words = ["solve", *MM, "--clamp-mm", "313.6"]
    (state,) = solved(*words)
    assert main(words) == 0
    sentence, table = capsys.readouterr().out.split("\n\n")
    for name in ("amplitude_mm", "amplitude_over_thickness", "wavelength_mm"):
        assert f"{state[name]:.4g} " in sentence.replace("\n", " ")
    assert f"{state['crests_and_troughs']} crests and troughs" in sentence.replace("\n", " ")
    shown = dict(zip(*(re.split(r"  +", line.strip()) for line in table.splitlines()), strict=True))
    assert shown["A mm"] == f"{state['amplitude_mm']:.4g}"
    assert shown["Phi^2"] == f"{state['phi_squared']:.4g}"
    assert max(map(len, f"{sentence}\n{table}".splitlines())) <= 80


def test_the_sentence_of_stability_says_birth_and_decay(solved, capsys):
    found = solved("stability", *MM)
    assert main(["stability", *MM]) == 0
    text = capsys.readouterr().out
    words = " ".join(text.split())
    for name in ("birth", "decay"):
        assert f"strain {found[f'{name}_strain']:.4g}" in words
        assert f"{found[f'{name}_clamps_mm']:.6g} mm" in words
    assert max(map(len, text.splitlines())) <= 80


def test_a_sheet_that_never_wrinkles_is_told_so(capsys):
    thick = ["--aspect", "2", "--thickness", "3e-3", *LATEX, *COARSE]
    assert main(["stability", *thick]) == 0
    assert "never wrinkles" in capsys.readouterr().out
    assert main(["solve", *thick, "--strain", "0.1", "--strain", "0.2"]) == 0
    assert "flat at 2 of 2 strains" in capsys.readouterr().out


# Saint Venant-Kirchhoff has no thickness left where it is stretched by a half.
BEYOND = ["--aspect", "2", "--thickness", "1e-3", "--law", "svk", *COARSE, "--strain"]


def test_what_does_not_converge_says_why_and_the_exit_status_is_1(solved, capsys, tmp_path):
    vtu = tmp_path / "a.vtu"
    good, bad = solved("solve", *BEYOND, "0.05:0.85:0.8", "--vtu", str(vtu), status=1)
    assert (good["status"], bad["status"]) == ("wrinkled", "not-converged")
    assert [path.name for path in tmp_path.iterdir()] == ["a_strain0.05.vtu"]
    assert main(["solve", *BEYOND, "0.85"]) == 1
    out, err = capsys.readouterr()
    assert bad["reason"] in " ".join(out.split())
    assert bad["reason"] in err


def test_surface_and_pictures_are_written_and_not_replaced(capsys, tmp_path):
    vtu, picture = tmp_path / "new" / "a.vtu", tmp_path / "new" / "a.png"
    words = ["solve", *MM, "--strain", "0.12", "--vtu", str(vtu), "--picture", str(picture)]
    assert main(words) == 0
    capsys.readouterr()
    first = vtu.read_bytes(), picture.read_bytes()
    assert "a.vtu: exists already; --overwrite replaces it" in refused(capsys, *words)
    assert main([*words, "--overwrite"]) == 0
    assert (vtu.read_bytes(), picture.read_bytes()) == first
    assert sorted(path.name for path in vtu.parent.iterdir()) == ["a.png", "a.vtu"]


def test_the_surface_has_the_numbers_of_the_solve(solved, tmp_path):
    """The force through the middle of the sheet is that at the clamp; z reaches the amplitude."""
    vtu = tmp_path / "a.vtu"
    (state,) = solved("solve", *MM, "--clamp-mm", "313.6", "--vtu", str(vtu))
    mesh = meshio.read(vtu)
    rest = mesh.point_data["reference_position_mm"]
    middle = np.abs(rest[:, 0]) < 1e-9
    width = mesh.points[middle, 1]
    order = np.argsort(width)
    arc = np.linalg.norm(np.diff(mesh.points[middle][order][:, 1:], axis=0), axis=1)
    through = 0.14 * (mesh.point_data["cauchy_xx_pa"] * mesh.point_data["stretch_thickness"])
    through = through[middle][order]
    force = 1e-6 * float((0.5 * (through[1:] + through[:-1]) * arc).sum())
    assert force == pytest.approx(state["force_n"], rel=2e-3)  # 8 x 14 cells
    height = np.abs(mesh.points[middle, 2]).max()  # a peak may lie half a sample away
    assert height == pytest.approx(state["amplitude_mm"], rel=5e-3)
    assert np.ptp(width) == pytest.approx(state["projected_width_mm"], rel=1e-6)
    np.testing.assert_allclose(mesh.point_data["displacement_mm"], mesh.points - rest)


def test_the_plot_of_stability_is_written(capsys, tmp_path):
    plot = tmp_path / "s.pdf"
    assert main(["stability", *MM, "--plot", str(plot)]) == 0
    assert plot.read_bytes().startswith(b"%PDF")
    capsys.readouterr()
    assert "exists already" in refused(capsys, "stability", *MM, "--plot", str(plot))


def test_sheets_too_thin_for_the_mesh_or_the_memory_are_refused_at_once(capsys, monkeypatch):
    start = time.monotonic()
    size = ["--aspect", "2", *LATEX, "--strain", "0.1", "--thickness"]
    line = refused(capsys, "solve", *size, "1e-9")
    assert "must be >= 1e-6" in line
    assert "10,800,300 unknowns" in line  # 3 x 4 x 25 x 36001
    monkeypatch.setattr("wrinklestudy.fem.size.available_memory", lambda: 1e9)
    line = refused(capsys, "solve", *size, "1e-5", status=1)
    assert "t/W = 1e-05 needs 24 x 408 cells, 122,700 unknowns" in line
    assert "1 GB are available" in line
    assert time.monotonic() - start < 5.0


def test_large_problems_say_how_large_before_they_start(capsys, monkeypatch):
    monkeypatch.setattr("wrinklestudy.cli.sheet_options._MANY_UNKNOWNS", 1000)
    assert main(["solve", *RATIOS, "--strain", "0.01"]) == 0
    first, *_ = capsys.readouterr().err.splitlines()
    assert first.startswith("t/W = 0.001: 8 x 14 cells, 1,620 unknowns")


@pytest.mark.parametrize("word", ["--version", "--help"])
def test_version_and_help(capsys, word):
    with pytest.raises(SystemExit) as stop:
        main([word])
    assert stop.value.code == 0
    assert "wrinklestudy" in capsys.readouterr().out


def shell(command, **options):
    """Run a command of the shell with the program as $PROGRAM."""
    program = f"{sys.executable} -m wrinklestudy.cli"
    environment = os.environ | THREADS | {"PROGRAM": program}
    return subprocess.run(
        ["bash", "-c", f"{command}; exit ${{PIPESTATUS[0]}}"],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
        **options,
    )


SOLVE = f"$PROGRAM solve {' '.join(RATIOS)} --strain 0.01"


@pytest.mark.parametrize("command", [f"{SOLVE} --json | true", f"{SOLVE} 2>&1 | true"])
def test_nobody_who_reads_on_is_a_quiet_end(command):
    run = shell(command)
    assert run.returncode == 0
    assert run.stderr in ("", "strain 0.01 (1 of 1)\n")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
@pytest.mark.parametrize("words", [SOLVE, f"{SOLVE} --json", "$PROGRAM --help"])
def test_a_full_disk_is_one_line_and_status_1(words):
    run = shell(f"{words} > /dev/full")
    assert run.returncode == 1
    *progress, last = run.stderr.splitlines()
    assert "standard output: cannot be written (No space left on device)" in last
    assert progress in ([], ["strain 0.01 (1 of 1)"])


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_an_interrupt_is_one_line_and_status_130(jobs):
    words = ["solve", "--aspect", "2", "--thickness", "1e-4", *LATEX, "--strain", "0.1:0.5:0.1"]
    process = subprocess.Popen(
        [sys.executable, "-m", "wrinklestudy.cli", *words, "--jobs", jobs],
        env=os.environ | THREADS,
        stderr=subprocess.PIPE,
        text=True,
    )
    first = process.stderr.readline()  # it is at work then, however long it took to begin
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert "strain 0.1 " in first
    assert process.returncode == 130
    assert err.splitlines()[-1] == "wrinklestudy solve: interrupted"
    assert "Traceback" not in err


def test_the_commands_of_the_recipe_run(tmp_path, monkeypatch, capsys):
    text = (ROOT / "docs" / "recipes" / "own_sheet.md").read_text(encoding="utf-8")
    whole_lines = re.sub(r" \\\n +", " ", text)
    commands = re.findall(r"^ +wrinklestudy (.*)$", whole_lines, re.MULTILINE)
    assert len(commands) == 7
    monkeypatch.chdir(tmp_path)
    for name in ("data", "config.yaml"):
        (tmp_path / name).symlink_to(ROOT / name)
    for command in commands:
        coarse = [] if command.startswith("fit") else COARSE
        assert main([*command.split(), *coarse]) == 0
    capsys.readouterr()
    made = {path.name for path in tmp_path.iterdir()}
    assert made == {"data", "config.yaml", "stability.png", "map.png", "sheet.png", "sheet.vtu"}


@pytest.mark.parametrize(("across", "warned"), [("14", True), ("30", False)])
def test_a_mesh_too_coarse_for_the_wrinkles_is_said(capsys, across, warned):
    """At L/W = 2, t/W = 1e-3 and strain 0.1 a wavelength is an eighth of the width."""
    size = ["--aspect", "2", "--thickness", "1e-3", *LATEX, "--cells-along", "8"]
    assert main(["solve", *size, "--cells-across", across, "--strain", "0.1"]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert ("too coarse" in said) == warned
    assert ("cells per wavelength" in said) == warned
