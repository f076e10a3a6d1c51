"""Progress: silent off a terminal, patient on one; the observer changes no number."""

import io

import numpy as np
import pytest

from wrinklestudy import MeshSettings, Sheet, mooney_rivlin
from wrinklestudy.cli import progress
from wrinklestudy.cli.progress import SolveProgress, StatusLine, duration
from wrinklestudy.fem.size import ProblemSize


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture
def sheet():
    return Sheet(2.0, 1e-3, mooney_rivlin(6.21e4, 1.58e5), mesh=MeshSettings(8, 14))


def test_who_watches_a_solve_changes_no_bit_of_it_and_sees_every_iteration(sheet):
    seen = []
    watched = sheet.solve(0.12, observer=lambda *told: seen.append(told)).equilibrium
    alone = sheet.solve(0.12).equilibrium
    np.testing.assert_array_equal(watched.position, alone.position)
    assert watched.history == alone.history
    stages = [stage for stage, _ in seen]
    assert list(dict.fromkeys(stages)) == ["flat state", "modes", "wrinkled state"]
    fresh = [row for row in watched.history if row.fresh]
    assert [last for stage, last in seen if stage == "wrinkled state"] == fresh


@pytest.mark.parametrize(("kind", "patience"), [(io.StringIO, -1.0), (Terminal, 3600.0)])
def test_nothing_is_shown_off_a_terminal_or_within_two_seconds(sheet, monkeypatch, kind, patience):
    monkeypatch.setattr(progress, "_PATIENCE", patience)
    stream = kind()
    sheet.solve(0.12, observer=SolveProgress("s", sheet.size, 1e-3, StatusLine(stream)))
    assert stream.getvalue() == ""


def test_a_notebook_gets_no_line_that_it_could_not_write_over(sheet, monkeypatch):
    """Commands of a cell have a terminal, but all that they write to it stays in the output."""
    monkeypatch.setattr(progress, "_PATIENCE", -1.0)
    monkeypatch.setenv("JPY_PARENT_PID", "1")
    line = StatusLine(Terminal())
    sheet.solve(0.12, observer=SolveProgress("s", sheet.size, 1e-3, line))
    line.clear()
    assert line.stream.getvalue() == ""


def test_a_terminal_shows_stage_iteration_decrement_and_what_is_left(sheet, monkeypatch):
    monkeypatch.setattr(progress, "_PATIENCE", -1.0)
    monkeypatch.delenv("JPY_PARENT_PID", raising=False)
    monkeypatch.setenv("COLUMNS", "120")
    stream = Terminal()
    sheet.solve(0.12, observer=SolveProgress("strain 0.12", sheet.size, 1e-3, StatusLine(stream)))
    lines = stream.getvalue().split("\r\x1b[2K")[1:]
    assert any(line.startswith("strain 0.12: flat state, iteration 1, about ") for line in lines)
    assert "wrinkled state, iteration 2" in stream.getvalue()
    assert "decrement" in lines[-1]


def test_thinner_sheets_and_finer_meshes_take_longer():
    def left(cells, thickness):
        return SolveProgress("", ProblemSize(*cells), thickness, StatusLine()).seconds_left()

    assert left((24, 36), 1e-3) < left((24, 144), 1e-3) < left((24, 144), 1e-4)


def test_times_in_words():
    assert [duration(t) for t in (0.2, 12.3, 200.0, 9000.0)] == ["1 s", "12 s", "3 min", "2.5 h"]
