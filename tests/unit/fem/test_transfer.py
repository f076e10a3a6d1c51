"""Fields from one grid to another: exact where the functions of the source hold them."""

import numpy as np

from wrinklestudy.fem.grid import Grid, MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.transfer import coarsened, transferred

SOURCE = Space(make_grid(2.0, settings=MeshSettings(5, 4)))
FIELD = np.random.default_rng(1).normal(size=(2, SOURCE.size))


def halved(lines):
    return np.sort(np.append(lines, 0.5 * (lines[1:] + lines[:-1])))


def test_a_finer_grid_with_the_same_lines_holds_the_same_function():
    """The integral of the square of each derivative is that of the source."""
    target = Space(Grid(halved(SOURCE.grid.x), halved(SOURCE.grid.y)), order=8)
    moved = transferred(FIELD, SOURCE, target)
    source = Space(SOURCE.grid, order=8)
    expected = (source.derivatives(FIELD) ** 2 * source.measure).sum(axis=(2, 3))
    found = (target.derivatives(moved) ** 2 * target.measure).sum(axis=(2, 3))
    assert np.allclose(found, expected, rtol=1e-12)


def test_there_and_back_is_the_same_field():
    target = Space(Grid(halved(SOURCE.grid.x), halved(SOURCE.grid.y)))
    back = transferred(transferred(FIELD, SOURCE, target), target, SOURCE)
    assert np.allclose(back, FIELD, atol=1e-11)


def test_a_coarser_grid_keeps_the_edges_and_the_grading():
    grid = make_grid(8.0, 1e-4)
    coarse = coarsened(grid, 32, 24)
    assert coarse.cells == (32, 24)
    assert np.allclose(coarse.x, make_grid(8.0, settings=MeshSettings(8, 24)).x, atol=1e-12)
    assert coarse.y[-1] == grid.y[-1]
    assert coarsened(grid, 500, 500).cells == grid.cells
