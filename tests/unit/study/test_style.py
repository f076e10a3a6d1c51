"""Figures look the same for everyone: a `matplotlibrc` that someone has changes none of them."""

import os
import subprocess
import sys

import pytest

HOSTILE = """
text.usetex: True
savefig.bbox: tight
savefig.transparent: True
figure.facecolor: black
axes.grid: True
axes.prop_cycle: cycler('color', ['red'])
font.size: 30
lines.linestyle: --
backend: TkAgg
"""
DRAW = """
from wrinklestudy.study.figures import style
with style.applied():
    figure, axes = style.panel()
    axes.plot([0.1, 0.4], [1.0, 2.0], label=r"$A/t$")
    axes.set_xlabel("strain")
    style.legend_above(axes)
    for name in ("drawn.pdf", "drawn.png", "drawn.svg"):
        style.save(figure, name)
"""
DRAWN = ("drawn.pdf", "drawn.png", "drawn.svg")


def drawn(folder, **environment):
    """Draw a figure in a folder by a Python of its own; return the bytes of its files."""
    command = [sys.executable, "-c", DRAW]
    subprocess.run(command, cwd=folder, env=os.environ | environment, check=True)
    return [(folder / name).read_bytes() for name in DRAWN]


@pytest.fixture(scope="module")
def plain(tmp_path_factory):
    folder = tmp_path_factory.mktemp("plain")
    # of an empty file matplotlib takes its defaults, whatever the user of this machine has
    (folder / "matplotlibrc").write_text("")
    return drawn(folder)


def test_a_matplotlibrc_in_the_working_folder_changes_no_figure(plain, tmp_path):
    (tmp_path / "matplotlibrc").write_text(HOSTILE)
    assert drawn(tmp_path) == plain


def test_a_matplotlibrc_that_the_environment_names_changes_no_figure(plain, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (tmp_path / "own").write_text(HOSTILE)
    assert drawn(elsewhere, MATPLOTLIBRC=str(tmp_path / "own")) == plain
