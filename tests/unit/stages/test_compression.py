"""The compression stage: its table is what the library says of the centre."""

import pytest

from wrinklestudy.equilibrium.compression import STRAINS, central_states
from wrinklestudy.equilibrium.critical_map import map_grid
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.files.storage import write_json
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.results.analyses import joined_table
from wrinklestudy.results.materials import given_material
from wrinklestudy.stages import compression

MESH = {"cells_along": 8, "cells_across": 12, "grading": 1.5}


@pytest.fixture
def rubber(tmp_path):
    path = tmp_path / "mr.json"
    write_json(path, given_material("mooney-rivlin", {"c10": 1e5, "c01": 1e4}))
    return path


def test_a_row_for_each_strain_up_to_three(rubber, tmp_path):
    output = tmp_path / "aspect2.csv"
    compression.run(rubber, 2.0, MESH, output, "mr-010")
    table = joined_table([output])
    assert list(table["strain"]) == list(STRAINS)
    assert STRAINS[-1] == 3.0
    assert set(table["material"]) == {"mr-010"}
    grid = map_grid(2.0, MeshSettings(**MESH))
    states = central_states(grid, mooney_rivlin(1e5, 1e4).law, STRAINS)
    assert list(table["central_excess"]) == [state.excess for state in states]
    assert list(table["coarse_central_excess"]) == [state.coarse_excess for state in states]
    first = output.read_bytes()
    compression.run(rubber, 2.0, MESH, output, "mr-010")
    assert output.read_bytes() == first
