"""The imperfection stage: a row for each strain, also where nothing converges."""

import math

import pytest

from wrinklestudy.files.storage import write_json
from wrinklestudy.results.analyses import joined_table
from wrinklestudy.results.materials import given_material
from wrinklestudy.stages import imperfection

MESH = {"cells_along": 6, "cells_across": 9, "grading": 1.5}
SETTINGS = {
    "bending": "thinning",
    "parity": "antisymmetric",
    "modes": 4,
    "tolerance": 1e-22,
    "max_iterations": 200,
    "seeds": 1,
}


@pytest.fixture
def rubber(tmp_path):
    path = tmp_path / "mr.json"
    write_json(path, given_material("mooney-rivlin", {"c10": 6.21e4, "c01": 1.58e5}))
    return path


def run(rubber, output, **changes):
    options = {
        **{"aspect": 2.0, "thickness": 2e-3, "strains": [0.12], "symmetry": "half"},
        **{"given": [], "mesh": MESH, "settings": SETTINGS},
        **changes,
    }
    imperfection.run(rubber, "rubber", output=output, **options)
    return joined_table([output])


def test_what_is_uneven_is_in_the_rows_and_the_same_job_gives_the_same_bytes(rubber, tmp_path):
    """On the thick end of a sheet that is thicker at one edge there are no wrinkles: they move."""
    output = tmp_path / "x.csv"
    given = [("thickness_across", 0.3)]
    table = run(rubber, output, thickness=1e-3, given=given)
    row = table.iloc[0]
    assert (row["kind"], row["size"], row["status"]) == ("thickness-across", 0.3, "wrinkled")
    assert row["shift_across"] < -1e-3
    assert abs(row["shift_along"]) < 1e-9
    assert row["amplitude_low"] <= row["amplitude_high"] <= row["envelope_amplitude"] * 1.001
    assert row["birth_strain"] < 0.12 < row["decay_strain"]
    first = output.read_bytes()
    run(rubber, output, thickness=1e-3, given=given)
    assert output.read_bytes() == first


def test_a_state_that_does_not_converge_is_a_row_with_its_decrements(rubber, tmp_path):
    few = {**SETTINGS, "max_iterations": 1}
    table = run(rubber, tmp_path / "x.csv", thickness=1e-3, settings=few)
    row = table.iloc[0]
    assert row["status"] == "not-converged"
    assert row["reason"]
    assert math.isnan(row["amplitude_low"])
    assert math.isnan(row["parity_energy"])
    decrements = [float(text) for text in str(row["decrements"]).split()]
    assert decrements
    assert all(map(math.isfinite, decrements))


def test_a_sheet_that_is_too_thick_is_flat(rubber, tmp_path):
    row = run(rubber, tmp_path / "x.csv", thickness=5e-3).iloc[0]
    assert row["status"] == "flat"
    assert math.isnan(row["shift_across"])
    assert math.isnan(row["decay_strain"])
