"""Command line and library example: keys, exit status, one line for bad input."""

import json
import math
import subprocess
import sys

import pytest

from wrinklestudy.cli import main
from wrinklestudy.mechanics.laws import LAWS

COARSE = ["--cells-along", "10", "--cells-across", "16"]
SHEET = ["--aspect", "2", "--thickness", "1e-3", "--c10", "6.21e4", "--c01", "1.58e5", *COARSE]
KEYS = {
    "strain",
    "status",
    "amplitude_over_thickness",
    "wavelength_over_width",
    "arc_width_over_width",
    "projected_width_over_width",
    "phi_squared",
    "shape_constant",
    "nominal_stress_pa",
    "unstable_directions",
    "newton_iterations",
    "seconds",
}


def test_solve_prints_a_list_with_one_object_per_strain(capsys):
    assert main(["solve", *SHEET, "--strain", "0.01", "--strain", "0.1", "--json"]) == 0
    out, err = capsys.readouterr()
    flat, wrinkled = json.loads(out)
    assert set(flat) >= KEYS
    assert set(wrinkled) == set(flat)
    assert (flat["status"], wrinkled["status"]) == ("flat", "wrinkled")
    assert flat["amplitude_over_thickness"] == 0
    assert flat["wavelength_over_width"] is None
    assert wrinkled["amplitude_over_thickness"] > 1
    assert "strain 0.1" in err


def test_stability_prints_birth_decay_and_table(capsys):
    assert main(["stability", *SHEET, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert 0.02 < found["birth_strain"] < 0.03
    assert 0.35 < found["decay_strain"] < 0.45
    strains = [row[0] for row in found["critical_thickness"]]
    assert strains == sorted(strains)


def test_a_thick_sheet_has_null_for_birth_and_decay(capsys):
    thick = [*SHEET]
    thick[3] = "3e-3"
    assert main(["stability", *thick, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["birth_strain"] is None
    assert found["decay_strain"] is None


def test_svk_needs_no_constants(capsys):
    arguments = ["--aspect", "2", "--thickness", "1e-3", "--law", "svk", *COARSE]
    assert main(["solve", *arguments, "--strain", "0.05", "--json"]) == 0
    (state,) = json.loads(capsys.readouterr().out)
    slope = state["nominal_stress_pa"] / 0.05
    assert slope == pytest.approx(1e6, rel=0.15)  # the clamps stiffen the sheet a little


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (["--strain", "5"], "--strain = 5: must be >= 1e-7 and <= 1"),
        (["--strain", "0.1", "--thickness", "-1"], "thickness = -1: must be >= 1e-6"),
        (["--strain", "0.1", "--aspect", "0"], "aspect = 0: must be"),
        (["--strain", "0.1", "--young", "1e6"], "--young: not a constant of mooney-rivlin"),
        (["--strain", "0.1", "--c10", "-1"], "c10 = -1: must be >= 0 Pa"),
        (["--strain", "0.1", "--c01", "-3.1e4"], "c01 = -31000: must be >= 0 Pa"),
        (["--strain", "-1e-1"], "--strain = -0.1: must be >= 1e-7 and <= 1"),
        (["--strain", "0.1", "--thickness", "-1e-3"], "thickness = -0.001: must be >= 1e-6"),
        (["--strain", "0.1", "--aspect", "-2E+0"], "aspect = -2: must be"),
        (["--strain", "0.1", "--cells-across", "-1e1"], "--cells-across = -10: must be >= 2"),
        (
            ["--strain", "0.1", "--law", "ogden"],
            "--c10: not a constant of ogden, which takes --mu1",
        ),
        (["--strain", "0.1", "--cells-along", "1"], "--cells-along = 1: must be >= 2"),
        (["--strain", "0.1", "--law", "neo-hookean"], "--c01: not a constant of neo-hookean"),
    ],
)
def test_bad_input_is_one_line_and_status_2(capsys, change, message):
    assert main(["solve", *SHEET, *change]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert message in err


def material_options(**constants):
    return [text for name, value in constants.items() for text in (f"--{name}", str(value))]


def test_ogden_with_exponents_two_and_minus_two_is_mooney_rivlin(capsys):
    options = ["solve", *SHEET[:4], *COARSE, "--strain", "0.1", "--json"]
    pairs = material_options(mu1=1.242e5, alpha1=2, mu2="-3.16e5", alpha2="-2e0")
    assert main([*options, "--law", "ogden", *pairs]) == 0
    (state,) = json.loads(capsys.readouterr().out)
    assert main([*options, *material_options(c10=6.21e4, c01=1.58e5)]) == 0
    (expected,) = json.loads(capsys.readouterr().out)
    assert state["status"] == expected["status"] == "wrinkled"
    for name in ("amplitude_over_thickness", "phi_squared", "nominal_stress_pa"):
        assert state[name] == pytest.approx(expected[name], rel=1e-9)


def test_yeoh_with_its_first_constant_alone_is_neo_hookean(capsys):
    options = ["stability", *SHEET[:4], *COARSE, "--json"]
    pairs = material_options(c10=1e5, c20=0, c30=0)
    assert main([*options, "--law", "yeoh", *pairs]) == 0
    found = json.loads(capsys.readouterr().out)
    assert main([*options, "--law", "neo-hookean", "--c10", "1e5"]) == 0
    expected = json.loads(capsys.readouterr().out)
    for name in ("birth_strain", "decay_strain"):
        assert found[name] == pytest.approx(expected[name], rel=1e-9)


def test_a_term_of_the_wrong_sign_is_refused(capsys):
    pairs = material_options(mu1=1e5, alpha1=2, mu2="-3e5", alpha2=2)
    assert main(["solve", *SHEET[:4], "--strain", "0.1", "--law", "ogden", *pairs]) == 2
    assert "mu2 = -300000: must be >= 0 Pa with alpha2 = 2" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["-3.1e4.5", "--3e5", "-x"])
def test_what_is_no_number_is_still_refused(capsys, text):
    with pytest.raises(SystemExit) as stop:
        main(["solve", *SHEET, "--strain", text])
    assert stop.value.code == 2
    assert capsys.readouterr().out == ""


def test_a_stretch_window_takes_negative_numbers_as_values(capsys):
    assert main(["fit", "data/none.csv", "--stretch", "-1e0", "2"]) == 2
    assert "none.csv" in capsys.readouterr().err


def test_help_names_every_constant_of_every_law(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["solve", "--help"])
    assert stop.value.code == 0
    text = capsys.readouterr().out
    for law in LAWS.values():
        assert law.name in text
        for constant in law.constants:
            assert f"--{constant.name} " in text


def test_help_needs_no_numpy():
    code = (
        "import sys\nfrom wrinklestudy.cli import main\ntry:\n    main(['--help'])\n"
        "finally:\n    print('numpy' in sys.modules)"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "stability" in found.stdout
    assert found.stdout.endswith("False\n")


def test_a_missing_constant_is_named(capsys):
    arguments = ["--aspect", "2", "--thickness", "1e-3", "--c10", "1", "--strain", "0.1"]
    assert main(["solve", *arguments]) == 2
    assert "--c01: mooney-rivlin needs it" in capsys.readouterr().err


def test_a_word_instead_of_a_number_is_refused(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["solve", *SHEET, "--strain", "much"])
    assert stop.value.code == 2
    assert "'much' is not a finite number" in capsys.readouterr().err


def test_fit_recovers_constants_from_a_csv(tmp_path, capsys):
    rows = ["strain,stress_pa"]
    for k in range(1, 30):
        stretch = 1 + k / 50
        stress = 2 * (stretch - stretch**-2) * (3e4 + 1e5 / stretch)
        rows.append(f"{stretch - 1!r},{stress!r}")
    file = tmp_path / "data.csv"
    file.write_text("\n".join(rows) + "\n")
    assert main(["fit", str(file), "--law", "mooney-rivlin", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["constants_pa"]
    assert found["c10"] == pytest.approx(3e4, rel=1e-6)
    assert found["c01"] == pytest.approx(1e5, rel=1e-6)


def test_fit_names_a_missing_file(tmp_path, capsys):
    assert main(["fit", str(tmp_path / "none.csv")]) == 2
    assert "none.csv" in capsys.readouterr().err


def test_text_output_has_no_nan(capsys):
    assert main(["solve", *SHEET, "--strain", "0.01"]) == 0
    out = capsys.readouterr().out
    assert "flat" in out
    assert "nan" not in out


def test_library_example_solves_a_sheet():
    from wrinklestudy import MeshSettings, Sheet, mooney_rivlin

    latex = mooney_rivlin(c10=6.21e4, c01=1.58e5)
    sheet = Sheet(aspect=2, thickness=1e-3, material=latex, mesh=MeshSettings(10, 16))
    state = sheet.solve(strain=0.1)
    assert state.status == "wrinkled"
    assert math.isfinite(state.measures.amplitude)
