"""The tension field beside thin sheets: what the figures pick and what they compute."""

import numpy as np
import pytest

from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.results.cases import StudySheet
from wrinklestudy.results.tension import FieldLines
from wrinklestudy.studies.beyond.figures import side_by_side
from wrinklestudy.studies.beyond.figures.field_curves import hidden
from wrinklestudy.studies.beyond.selections import thinnest
from wrinklestudy.study.figures.inputs import Inputs, StateFile

SLOPE = 0.1


def state(strain=0.1, aspect=2.0):
    """Return a flat sheet that is tilted across by a slope: z = SLOPE Y."""
    grid = Grid(np.linspace(0.0, 1.0, 3), np.linspace(0.0, 0.5, 4))
    nodes = np.zeros((3, 4, 3, 4))
    nodes[0, 0], nodes[0, 1] = grid.x[:, None], 1.0
    nodes[1, 0], nodes[1, 2] = grid.y[None, :], 1.0
    nodes[2, 0], nodes[2, 2] = SLOPE * grid.y[None, :], SLOPE
    sheet = DeformedSheet(grid, nodes, Symmetry.mirrored("antisymmetric"))
    return StateFile(strain, aspect, 1e-4, "svk", "wrinkled", "antisymmetric", sheet)


def test_a_tilted_sheet_hides_the_same_part_of_its_width_on_every_line():
    x, phi_squared = hidden(state())
    assert (x[0], x[-1]) == (0.0, 1.0)
    assert phi_squared == pytest.approx(np.sqrt(1.0 + SLOPE**2) - 1.0, rel=1e-10)


def test_the_field_of_the_nearest_strain_and_of_the_same_length_is_shown(monkeypatch):
    line = np.zeros(2)
    fields = [
        FieldLines("m", aspect, strain, line, line, line, np.zeros((2, 2)), line, np.zeros((2, 2)))
        for aspect, strain in ((2.0, 0.02), (2.0, 0.12), (3.0, 0.1))
    ]
    monkeypatch.setattr(side_by_side, "read_lines", lambda _: fields)
    inputs = Inputs(analyses={"tension": {"fields": ["aspect2.h5"]}})
    assert side_by_side.nearest_field(inputs, state()) is fields[1]


def test_the_thinnest_sheet_is_of_the_rubber_and_length_of_the_figure_sheet():
    class Config:
        figure_sheet = StudySheet("latex", 2.0, 1e-3)
        all_sheets = (
            figure_sheet,
            StudySheet("latex", 2.0, 2e-4),
            StudySheet("latex", 3.0, 1e-4),
            StudySheet("other", 2.0, 1e-4),
        )

    assert thinnest(Config()) == (StudySheet("latex", 2.0, 2e-4),)
