"""The gate lets a study through that has no more holes than allowed, and names those it has."""

import json

import pytest
from made_up_rows import state_row

from wrinklestudy.results.tables import write_states
from wrinklestudy.stages import gate


@pytest.fixture
def states(tmp_path):
    holes = [state_row(0.1 * k, "not-converged") for k in range(1, 8)]
    write_states([*holes, state_row(0.9), state_row(0.95, "flat")], tmp_path / "states.csv")
    return tmp_path / "states.csv"


def test_counts_are_written_if_there_are_no_more_holes_than_allowed(states, tmp_path):
    gate.run(states, 7, "digest", tmp_path / "gate.json")
    by_status = {"not-converged": 7, "wrinkled": 1, "flat": 1}
    content = json.loads((tmp_path / "gate.json").read_text())
    assert content == {"cases": 9, "by_status": by_status, "study": "digest"}


def test_one_hole_too_many_is_named_in_one_line_and_nothing_is_written(states, tmp_path):
    named = r"7 of 9 cases .*: material=latex aspect=2.0 thickness=0.001 strain=0.1; .*; \.\.\.$"
    with pytest.raises(gate.GateError, match=named) as caught:
        gate.run(states, 6, "digest", tmp_path / "gate.json")
    assert str(caught.value).count("strain=") == 5
    assert not (tmp_path / "gate.json").exists()
