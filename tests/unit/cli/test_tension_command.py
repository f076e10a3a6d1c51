"""Tension fields from the command line: keys, order, laws, sentences, failures, refusals."""

import json
from dataclasses import replace

import pytest

from wrinklestudy.cli import main
from wrinklestudy.equilibrium import tension_field

LATEX = ["--c10", "6.21e4", "--c01", "1.58e5"]
COARSE = ["--cells-along", "8", "--cells-across", "18"]
COMMAND = ["tension-field", "--aspect", "2", *COARSE]
KEYS = {
    "strain",
    "status",
    "phi_squared",
    "phi_squared_error",
    "phi_squared_central",
    "arc_width_over_width",
    "projected_width_over_width",
    "wrinkled_width_over_width",
    "wrinkled_length_over_length",
    "nominal_stress_pa",
    "remainder",
    "newton_iterations",
    "reason",
    "seconds",
}


@pytest.fixture
def states(capsys):
    """Return a function that runs the command and returns what its JSON says."""

    def run(*words, status=0):
        assert main([*COMMAND, *words, "--json"]) == status
        return json.loads(capsys.readouterr().out)

    return run


def test_each_strain_has_an_object_in_the_order_given(states):
    found = states(*LATEX, "--strain", "0.3", "--strain", "0.1:0.2:0.1", "--strain", "0.1")
    assert [state["strain"] for state in found] == [0.3, 0.1, 0.2]
    for state in found:
        assert state.keys() == KEYS
        assert (state["status"], state["reason"], state["remainder"]) == ("wrinkled", "", 0.0)
        arc, projected = state["arc_width_over_width"], state["projected_width_over_width"]
        assert state["phi_squared"] == pytest.approx((arc - projected) / projected, rel=1e-9)
        assert state["phi_squared"] < state["phi_squared_central"]
        assert state["phi_squared_error"] < 0.05 * state["phi_squared"]


def test_several_processes_give_the_numbers_of_one(states):
    words = [*LATEX, "--strain", "0.1:0.2:0.1"]
    both = [states(*words, "--jobs", jobs) for jobs in "12"]
    for one, other in zip(*both, strict=True):
        assert one | {"seconds": 0.0} == other | {"seconds": 0.0}


@pytest.mark.parametrize(
    "words",
    [
        ["--law", "neo-hookean", "--c10", "2.2e5"],
        ["--law", "svk", "--young", "1.3e6", "--poisson", "0.3"],
        ["--law", "yeoh", "--c10", "2.2e5", "--c20", "-2e3", "--c30", "1e2"],
        ["--law", "ogden", "--mu1", "6.3e5", "--alpha1", "1.3", "--mu2", "-1e4", "--alpha2", "-2"],
    ],
)
def test_every_law_has_a_tension_field(states, words):
    """A clamped sheet hides less than its natural contraction, which is below half the strain."""
    (state,) = states(*words, "--strain", "0.02")
    assert (state["status"], state["remainder"]) == ("wrinkled", 0.0)
    assert 0.0 < state["phi_squared"] < state["phi_squared_central"] < 0.5 * 0.02


def test_the_force_scales_with_the_constants_and_nothing_else_does(states):
    single, triple = (
        states("--c10", str(scale * 6e4), "--c01", str(scale * 1.5e5), "--strain", "0.1")[0]
        for scale in (1, 3)
    )
    assert triple["nominal_stress_pa"] == pytest.approx(3.0 * single["nominal_stress_pa"], rel=1e-9)
    assert triple["phi_squared"] == pytest.approx(single["phi_squared"], rel=1e-9)


def test_people_get_a_sentence_and_a_narrow_table(capsys):
    assert main([*COMMAND, *LATEX, "--strain", "0.1:0.3:0.1"]) == 0
    text = capsys.readouterr().out
    assert "is wrinkled at 3 of 3 strains, from 0.1 to 0.3." in " ".join(text.split())
    assert max(map(len, text.splitlines())) <= 80
    assert len(text.partition("\n\n")[2].splitlines()) == 4


def test_a_taut_sheet_is_flat(capsys):
    words = ["tension-field", "--aspect", "1", *COARSE, *LATEX, "--strain", "0.1"]
    assert main(words) == 0
    assert "is taut on both mid-lines" in " ".join(capsys.readouterr().out.split())
    assert main([*words, "--json"]) == 0
    (state,) = json.loads(capsys.readouterr().out)
    assert (state["status"], state["phi_squared"]) == ("flat", 0.0)
    assert state["arc_width_over_width"] == state["projected_width_over_width"]


def test_what_did_not_converge_has_no_values_and_status_1(capsys, monkeypatch):
    few = replace(tension_field._OPTIONS, max_iterations=1)
    monkeypatch.setattr(tension_field, "_OPTIONS", few)
    assert main([*COMMAND, *LATEX, "--strain", "0.1", "--json"]) == 1
    out, err = capsys.readouterr()
    (state,) = json.loads(out)
    assert state["status"] == "not-converged"
    assert state["reason"] in err
    known = {name for name, value in state.items() if value is not None}
    assert known == {"strain", "status", "remainder", "newton_iterations", "reason", "seconds"}
    assert main([*COMMAND, *LATEX, "--strain", "0.1"]) == 1
    assert "strain 0.1 did not converge: tension field" in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--strain", "0.1"], "--aspect: missing"),
        (["--aspect", "2"], "--strain: missing"),
        (["--aspect", "0", "--strain", "0.1"], "--aspect = 0: must be >= 0.5 and <= 20 (L/W)"),
        (["--aspect", "2", "--strain", "0"], "--strain = 0: must be >= 1e-7 and <= 1"),
        (["--aspect", "2", "--strain", "0.1:0.3:0.15"], "--strain 0.1:0.3:0.15: stop = 0.3"),
        (["--aspect", "2", "--strain", "0.1", "--jobs", "0"], "--jobs = 0: must be >= 1"),
        (
            ["--aspect", "2", "--strain", "0.1", "--cells-across", "1"],
            "--cells-across = 1: must be >= 2",
        ),
        (["--aspect", "2", "--strain", "0.1", "--poisson", "0.3"], "--poisson: not a constant of"),
    ],
)
def test_what_is_wrong_is_said_in_one_line(capsys, words, message):
    assert main(["tension-field", *LATEX, *words]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert message in err


def test_a_law_without_a_tension_field_is_refused(capsys):
    words = ["--aspect", "2", "--strain", "0.1", "--law", "foppl-von-karman", "--young", "1e6"]
    assert main(["tension-field", *words]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err == (
        "wrinklestudy tension-field: law foppl-von-karman: has no tension field, its strain is "
        "linear in the plane\n"
    )


def test_a_thickness_is_refused(capsys):
    words = [*COMMAND, *LATEX, "--strain", "0.1", "--thickness", "1e-3"]
    with pytest.raises(SystemExit, match="2"):
        main(words)
    assert "unrecognized arguments: --thickness" in capsys.readouterr().err


def test_what_the_memory_would_not_hold_is_refused(capsys, monkeypatch):
    monkeypatch.setattr("wrinklestudy.fem.size.available_memory", lambda: 1e6)
    assert main([*COMMAND, *LATEX, "--strain", "0.1"]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("wrinklestudy tension-field: L/W = 2 needs 8 x 12 cells")
