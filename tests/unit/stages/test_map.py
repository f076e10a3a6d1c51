"""The map stage: what it writes is what the library says, holes included."""

import pytest

from wrinklestudy.equilibrium import flat, modes
from wrinklestudy.equilibrium.critical_map import map_grid
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.files.storage import write_json
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.results.materials import given_material
from wrinklestudy.results.tables import read_map
from wrinklestudy.stages import map as map_stage

MESH = {"cells_along": 8, "cells_across": 14, "grading": 1.5}


@pytest.fixture
def rubber(tmp_path):
    path = tmp_path / "mr-250.json"
    write_json(path, given_material("mooney-rivlin", {"c10": 1e5, "c01": 2.5e5}))
    return path


def test_a_table_has_the_tau_1_of_each_strain_and_parity(rubber, tmp_path):
    map_stage.run(
        rubber, 2.0, (0.1, 0.3), MESH, {"bending": "fvk"}, {"table": tmp_path / "map.csv"}, "mr-fvk"
    )
    rows = read_map(tmp_path / "map.csv")
    assert [(row.parity, row.strain) for row in rows] == [
        (parity, strain) for parity in ("antisymmetric", "symmetric") for strain in (0.1, 0.3)
    ]
    grid = map_grid(2.0, MeshSettings(**MESH))
    for row in rows[:2]:
        assert (row.material, row.law, row.bending) == ("mr-fvk", "mooney-rivlin", "fvk")
        assert (row.cells_along, row.cells_across) == grid.cells
        state = flat.solve(grid, mooney_rivlin(1e5, 2.5e5).law, row.strain)
        assert row.critical_thickness == pytest.approx(modes.critical_thickness(state, "fvk"))


def test_the_same_job_gives_the_same_bytes(rubber, tmp_path):
    paths = [tmp_path / "first.csv", tmp_path / "second.csv"]
    for path in paths:
        map_stage.run(rubber, 2.0, (0.1, 0.3), MESH, {"bending": "thinning"}, path)
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_a_strain_without_a_flat_state_is_a_row_with_a_reason(rubber, tmp_path, monkeypatch):
    from wrinklestudy.equilibrium import critical_map

    def solve(space, law, strain, start=None):
        del space, law, start
        raise flat.NotConvergedError(f"flat state at strain {strain:g}: made up")

    monkeypatch.setattr(critical_map, "solve_flat", solve)
    map_stage.run(rubber, 2.0, (0.1,), MESH, {"bending": "thinning"}, tmp_path / "map.csv")
    for row in read_map(tmp_path / "map.csv"):
        assert (row.status, row.critical_thickness) == ("not-converged", None)
        assert row.reason == "flat state at strain 0.1: made up"
