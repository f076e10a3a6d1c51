"""Command lines of all kinds: the right exit status, one line, no file that nobody asked for.

Nothing is solved here: what would be ends with a line, as a sheet does that cannot be solved.
"""

import json
import math
import traceback
from itertools import chain
from pathlib import Path

import pytest
from fuzzing import JUNK, fuzzed, in_time, is_said, tree
from hypothesis import given
from hypothesis import strategies as st

import wrinklestudy.cli as command_line
from wrinklestudy.cli import map_command, solving
from wrinklestudy.cli.parser import COMMANDS
from wrinklestudy.equilibrium import critical_map
from wrinklestudy.mechanics.laws import LAWS
from wrinklestudy.sheet import Sheet

ROOT = Path(__file__).parents[2]
NUMBERS = """
2 1e-3 0.12 1 0.5 140 0.14 6.21e4 1.58e5 -1 0 21 1e-9 nan inf 1e400
0.02:0.1:0.02 0.1:0.02:0.02 1:2 0:1:0 0.1:0.2:1e-9
"""
WORDS = """
latex paper neo-hookean svk ogden fvk thinning symmetric whole all larger both uniaxial loading
curve.csv scan.csv scans fit.json config.yaml missing.csv thickness.csv 0.01:0.5 0.01:0.0625:1.57:0
new.png new.pdf new.vtu new.gif new.html old.png deeper/new.svg old.png/new.png
"""
OPTIONS = """
aspect thickness length-mm width-mm thickness-mm strain clamp-mm jobs c10 c01 mu1 alpha1 young
poisson law material config bending parity cells-along cells-across symmetry shear rotate twist
pitch lift thickness-along thickness-across thickness-ripple thickness-table density gravity
vtu picture plot output frames mode branch cycle stretch
"""
FLAGS = "json overwrite far-from-threshold yaml remove-preload help version"
SHEET = ["--aspect", "2", "--thickness", "1e-3"]
CONSTANTS = ["--c10", "6.21e4", "--c01", "1.58e5"]
# What makes a command complete, so that what is thrown in is not always the second mistake.
COMPLETE = {
    "solve": [*SHEET, *CONSTANTS, "--strain", "0.1"],
    "stability": [*SHEET, *CONSTANTS],
    "map": ["--aspect", "2", "--strain", "0.1", *CONSTANTS],
    "tension-field": ["--aspect", "2", "--strain", "0.1", *CONSTANTS],
    "explore": [*SHEET, *CONSTANTS, "--output", "new.html"],
    "film": [*SHEET, *CONSTANTS, "--output", "new.gif"],
    "fit": ["curve.csv"],
    "measure": ["scan.csv"],
    "provenance": ["old.png"],
}


def _one_of(text):
    return st.sampled_from(text.split())


def words():
    """Return a strategy for command lines, nearly right ones among them."""
    numbers, names, options, flags = map(_one_of, (NUMBERS, WORDS, OPTIONS, FLAGS))
    value = numbers | names | JUNK.filter(lambda text: "\x00" not in text)
    option = st.tuples(options, value).map(lambda pair: [f"--{pair[0]}", pair[1]])
    joined = st.tuples(options, value).map(lambda pair: [f"--{pair[0]}={pair[1]}"])
    flag = flags.map(lambda name: [f"--{name}"])
    more = st.lists(option | joined | flag | value.map(lambda text: [text]), max_size=4)
    begun = st.sampled_from(sorted(COMMANDS)).flatmap(
        lambda name: st.sampled_from([[name], [name, *COMPLETE[name]]])
    )
    anything = st.lists(value, max_size=3)
    return st.tuples(begun | anything, more).map(
        lambda pair: [*pair[0], *chain.from_iterable(pair[1])]
    )


class NotSolvedHereError(ArithmeticError):
    """Stands for a sheet that cannot be solved."""


def _unsolved(*_, **__):
    raise NotSolvedHereError("not solved here")


def _here(work, tasks, _jobs):
    return map(work, tasks)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A working folder with files of all kinds, in which nothing is solved."""
    inside = tmp_path / "inside"
    (inside / "scans").mkdir(parents=True)
    (inside / "config.yaml").symlink_to(ROOT / "config.yaml")
    (inside / "data").symlink_to(ROOT / "data")
    curve = (ROOT / "data" / "latex_panaitescu2019.csv").read_text()
    rows = "".join(f"{y},{0.3 * math.sin(y / 3)}\n" for y in range(-30, 31))
    texts = {
        "curve.csv": curve,
        "scan.csv": f"y_mm,w_mm\n{rows}",
        "fit.json": "{}",
        "old.png": "mine",
        "thickness.csv": "x,y,thickness\n-1,-1,1\n1,-1,1\n-1,1,1\n1,1,1.1\n",
    }
    for name, text in texts.items():
        (inside / name).write_text(text)
    monkeypatch.chdir(inside)
    for name in ("solve", "stability", "tension_field", "far_from_threshold"):
        monkeypatch.setattr(Sheet, name, _unsolved)
    monkeypatch.setattr(critical_map, "critical_states", _unsolved)
    monkeypatch.setattr(map_command, "in_processes", _here)
    monkeypatch.setattr(solving, "in_processes", _here)
    assert set(COMPLETE) == set(COMMANDS)
    assert "mooney-rivlin" in LAWS
    return inside


def run(argv, monkeypatch):
    """Return the exit status, and the error behind it if there is one."""
    errors = []
    inner = command_line._run

    def recorded(name, given):
        try:
            return inner(name, given)
        except Exception as error:
            errors.append(error)
            raise

    with monkeypatch.context() as patch, in_time():
        patch.setattr(command_line, "_run", recorded)
        try:
            status = command_line.main(argv)
        except SystemExit as stop:  # of argparse
            status = stop.code
    return status, errors


def _refuse_constant(name):
    raise AssertionError(f"{name} is no JSON")


@fuzzed()
@given(words())
def test_command_lines(folder, monkeypatch, capsys, argv):
    before = tree(folder.parent)
    mine = (folder / "old.png").read_text()
    capsys.readouterr()
    status, errors = run(argv, monkeypatch)
    out, err = capsys.readouterr()
    assert status in (0, 1, 2), argv
    for error in errors:
        known = is_said(error) or isinstance(error, OSError | NotSolvedHereError)
        assert known, "".join(traceback.format_exception(error))
    if status:
        last = err.splitlines()[-1]
        assert last.startswith("wrinklestudy"), err
        assert len(last) > len("wrinklestudy: ")
    if status == 2:
        assert out == ""
        assert len(err.splitlines()) == 1, err
    if status == 0 and "--json" in argv and not {"--help", "--version"} & {*argv}:
        json.loads(out, parse_constant=_refuse_constant)
    new = tree(folder.parent) - before
    asked = {folder.name + "/" + word.split("=")[-1] for word in argv}
    for name in new:  # files that were asked for and their folders
        assert name in asked or any(file.startswith(f"{name}/") for file in asked), name
        if (folder.parent / name).is_file():
            (folder.parent / name).unlink()
    if "--overwrite" not in argv:
        assert (folder / "old.png").read_text() == mine
    else:
        (folder / "old.png").write_text(mine)
