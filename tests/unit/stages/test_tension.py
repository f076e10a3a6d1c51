"""The tension stage: its table and fields are what the library says of the sheet."""

import numpy as np
import pytest

from wrinklestudy.equilibrium.tension_field import solve, tension_grid
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.files.storage import write_json
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.metrics.confinement import confinement
from wrinklestudy.results.analyses import joined_table
from wrinklestudy.results.materials import given_material
from wrinklestudy.results.tension import read_lines
from wrinklestudy.stages import tension

MESH = {"cells_along": 8, "cells_across": 15, "grading": 1.5}
STRAINS = (0.1, 0.2)


@pytest.fixture
def rubber(tmp_path):
    path = tmp_path / "mr-250.json"
    write_json(path, given_material("mooney-rivlin", {"c10": 1e5, "c01": 2.5e5}))
    return path


def run(rubber, folder):
    outputs = {"table": folder / "aspect2.csv", "fields": folder / "aspect2.h5"}
    tension.run(rubber, 2.0, STRAINS, MESH, outputs, "mr-250")
    return outputs


def test_a_row_for_each_strain_with_what_is_measured_on_the_field(rubber, tmp_path):
    table = joined_table([run(rubber, tmp_path)["table"]])
    field = solve(tension_grid(2.0, MeshSettings(**MESH)), mooney_rivlin(1e5, 2.5e5).law, 0.1)
    assert list(table["strain"]) == list(STRAINS)
    assert set(table["status"]) == {"wrinkled"}
    assert table["phi_squared"][0] == confinement(field).phi_squared
    assert table["nominal_stress_pa"][0] == pytest.approx(field.force * 7e5, rel=1e-12)


def test_the_widths_on_the_mid_line_are_those_of_the_table_and_vanish_at_the_clamp(
    rubber, tmp_path
):
    outputs = run(rubber, tmp_path)
    table = joined_table([outputs["table"]])
    for line, phi_squared in zip(read_lines(outputs["fields"]), table["phi_squared"], strict=True):
        assert line.phi_squared[0] == phi_squared
        assert line.phi_squared[-1] == pytest.approx(0.0, abs=1e-9)
        assert line.projected_width[-1] == pytest.approx(1.0, abs=1e-12)
        assert (np.diff(line.projected_width) > 0.0).all()


def test_the_same_job_gives_the_same_bytes(rubber, tmp_path):
    runs = []
    for name in ("first", "second"):
        (tmp_path / name).mkdir()
        runs.append(run(rubber, tmp_path / name))
    for output in ("table", "fields"):
        assert runs[0][output].read_bytes() == runs[1][output].read_bytes()
