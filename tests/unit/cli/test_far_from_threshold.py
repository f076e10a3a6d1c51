"""`solve --far-from-threshold`: a prediction that says that it is one."""

import json

import pytest

from wrinklestudy.cli import main

SHEET = [
    "--aspect",
    "2",
    "--c10",
    "6.21e4",
    "--c01",
    "1.58e5",
    "--cells-along",
    "12",
    "--cells-across",
    "20",
]


def answer(capsys, *options):
    assert main(["solve", *SHEET, "--far-from-threshold", *options]) == 0
    return capsys.readouterr().out


def test_predicts_thin_sheets_as_such(capsys):
    (state,) = json.loads(answer(capsys, "--thickness", "1e-6", "--strain", "0.1", "--json"))
    assert state["method"] == "far-from-threshold"
    assert state["status"] == "wrinkled"
    # a wave that hides the width of the tension field: (2 pi A/lambda)^2/4 is Phi^2 where it is
    slope = 2 * 3.14159 * state["amplitude_over_thickness"] * 1e-6 / state["wavelength_over_width"]
    assert state["phi_squared"] < slope**2 / 4 < 3 * state["phi_squared"]
    assert "not solved" in answer(capsys, "--thickness", "1e-6", "--strain", "0.1")


def test_draws_no_surface_that_was_not_solved(capsys, tmp_path):
    options = ["--thickness", "1e-4", "--strain", "0.1", "--picture", str(tmp_path / "a.png")]
    assert main(["solve", *SHEET, "--far-from-threshold", *options]) == 2
    assert "--picture: not with --far-from-threshold" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("strain", ["1e-6", "0.001"])
def test_says_that_a_thick_sheet_is_flat(capsys, strain):
    (state,) = json.loads(answer(capsys, "--thickness", "0.05", "--strain", strain, "--json"))
    assert (state["status"], state["wavelength_over_width"]) == ("flat", None)
