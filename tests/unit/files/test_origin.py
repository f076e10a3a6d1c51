"""A file says where it comes from, and stays what it is to everyone else."""

import io

import numpy as np
import pandas as pd
import pytest
from matplotlib.figure import Figure

from wrinklestudy.fem.grid import Grid
from wrinklestudy.files.origin import current, embedded, stated
from wrinklestudy.files.storage import read_h5, write_h5
from wrinklestudy.results.grids import read_grid, write_grid
from wrinklestudy.study.figures.shown_numbers import write_numbers
from wrinklestudy.study.figures.style import applied, save

MADE = {
    "program": "wrinklestudy 0.1.0",
    "stage": "figures",
    # all that could end a text early in one of the formats
    "shown": r'(a) \ ) "b" -- --> <c> & é </dc:description> #' + "\n",
}


def figure():
    drawn = Figure()
    drawn.add_subplot().plot([0.0, 1.0], [2.0, 3.0])
    return drawn


def save_figure(path):
    with applied():
        save(figure(), path)


def write_state(path):
    write_h5(path, {"grid/x": np.linspace(0.0, 1.0, 3)}, {"strain": 0.1})


WRITERS = {
    ".pdf": save_figure,
    ".png": save_figure,
    ".svg": save_figure,
    ".csv": lambda path: write_numbers(figure(), path),
    ".h5": write_state,
    ".vtu": lambda path: write_grid(Grid(np.arange(3.0), np.arange(2.0)), path),
}


@pytest.mark.parametrize("suffix", WRITERS)
def test_every_format_keeps_its_origin_to_the_letter(tmp_path, suffix):
    path = tmp_path / f"file{suffix}"
    with stated(MADE):
        WRITERS[suffix](path)
    assert current() == ""
    assert embedded(path) == MADE


@pytest.mark.parametrize("suffix", WRITERS)
def test_the_same_origin_gives_the_same_bytes_and_none_is_none(tmp_path, suffix):
    first, second, bare = (tmp_path / f"{name}{suffix}" for name in ("first", "second", "bare"))
    for path in (first, second):
        with stated(MADE):
            WRITERS[suffix](path)
    WRITERS[suffix](bare)
    assert first.read_bytes() == second.read_bytes()
    assert embedded(bare) is None


def test_numbers_meshes_and_states_are_read_as_without_an_origin(tmp_path):
    paths = {suffix: tmp_path / f"file{suffix}" for suffix in (".csv", ".h5", ".vtu")}
    with stated(MADE):
        for suffix, path in paths.items():
            WRITERS[suffix](path)
    table = pd.read_csv(io.StringIO(paths[".csv"].read_text()), comment="#")
    assert list(table.y) == [2.0, 3.0]
    assert read_h5(paths[".h5"])[1] == {"strain": 0.1}
    assert list(read_grid(paths[".vtu"]).x) == [0.0, 1.0, 2.0]


def test_a_damaged_picture_is_not_believed(tmp_path):
    path = tmp_path / "file.png"
    with stated(MADE):
        save(figure(), path)
    content = path.read_bytes()
    path.write_bytes(content.replace(b"wrinklestudy 0.1.0", b"wrinklestudy 0.1.1"))
    with pytest.raises(ValueError, match="damaged"):
        embedded(path)
