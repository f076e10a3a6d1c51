"""The row of a wrinkle file: every state has one, and what is measured is that of its shape."""

import math

import numpy as np
import pandas as pd
import pytest
from made_up_rows import SHEET

from wrinklestudy.files.storage import write_h5
from wrinklestudy.results.rows import StateRow, columns
from wrinklestudy.results.states import measure_state
from wrinklestudy.stages import metrics

GRID_X, GRID_Y = np.linspace(0.0, 1.0, 9), np.linspace(0.0, 0.5, 25)


def position(amplitude, wavelength=0.13):
    """z = A sin(2 pi Y / lambda) cos^2(pi X / 2) on a sheet that is otherwise undeformed."""
    k = 2.0 * np.pi / wavelength
    f, df = np.cos(0.5 * np.pi * GRID_X) ** 2, -0.5 * np.pi * np.sin(np.pi * GRID_X)
    g, dg = np.sin(k * GRID_Y), k * np.cos(k * GRID_Y)
    field = np.zeros((3, 4, 9, 25))
    field[0, 0], field[0, 1] = GRID_X[:, None], 1.0
    field[1, 0], field[1, 2] = GRID_Y, 1.0
    field[2] = amplitude * np.stack([np.outer(a, b) for b in (g, dg) for a in (f, df)])
    return field


def attributes(strain, status, **other):
    """Return the attributes of a wrinkle file, all numbers 0.1 + 0.2 that are not given."""
    kinds = {
        column.name: column.kind for column in columns(StateRow).values() if not column.measured
    }
    values = {name: 7 if kind is int else 0.1 + 0.2 for name, kind in kinds.items()}
    own = {"strain": strain, "status": status, "reason": "", "unstable_directions": 0}
    return values | SHEET | own | {"planar_width_over_width": 0.95} | other


def write_state(path, strain, status="wrinkled", amplitude=3e-3, **other):
    datasets = {"grid/x": GRID_X, "grid/y": GRID_Y, "position": position(amplitude)}
    if status == "not-converged":
        datasets = {"history": np.ones((3, 2))}
    write_h5(path, datasets, attributes(strain, status, **other))
    return path


@pytest.fixture
def sheet(tmp_path):
    states = [
        write_state(tmp_path / "c.h5", 0.3, "not-converged", reason="60 iterations, no, decrease"),
        write_state(tmp_path / "a.h5", 0.02, "flat", amplitude=1e-8),
        write_state(tmp_path / "b.h5", 0.1 + 0.2 - 0.1),
    ]
    return states, tmp_path / "out" / "metrics.csv"


def table(sheet):
    metrics.run(*sheet)
    return pd.read_csv(sheet[1])


def test_every_state_has_a_row_and_a_hole_has_no_measures(sheet):
    found = table(sheet)
    assert list(found["status"]) == ["flat", "wrinkled", "not-converged"]
    flat, wrinkled, hole = (row for _, row in found.iterrows())
    assert flat["amplitude_over_thickness"] == flat["phi_squared"] == 0.0
    assert flat["arc_width_over_width"] == pytest.approx(1.0)
    assert np.isnan([flat["wavelength_over_width"], flat["shape_constant"]]).all()
    assert wrinkled["amplitude_over_thickness"] == pytest.approx(3.0, rel=3e-3)
    assert wrinkled["wavelength_over_width"] == pytest.approx(0.13, rel=3e-3)
    assert wrinkled["sheet_amplitude_x_over_length"] == 0.0
    measured = ["amplitude_over_thickness", "phi_squared", "energy", "unstable_directions"]
    assert hole[measured].isna().all()
    assert hole["reason"] == "60 iterations, no, decrease"
    assert hole["newton_iterations"] == 7


def test_numbers_keep_all_their_digits(sheet):
    found = table(sheet)
    assert found["strain"][1] == 0.1 + 0.2 - 0.1
    assert found["residual"][0] == 0.1 + 0.2
    assert found["cells_along"].dtype == np.int64
    assert "0.30000000000000004" in sheet[1].read_text()


def test_the_order_of_the_files_does_not_matter(sheet):
    states, output = sheet
    table(sheet)
    first = output.read_bytes()
    metrics.run(states[::-1], output)
    assert output.read_bytes() == first


def test_one_case_twice_is_refused_before_anything_is_written(sheet, tmp_path):
    states, output = sheet
    twin = write_state(tmp_path / "twin.h5", 0.02)
    with pytest.raises(ValueError, match=r"twin.h5: holds the same case as .*a.h5"):
        metrics.run([*states, twin], output)
    assert not output.parent.exists()


def test_a_file_of_another_kind_gets_one_line_that_names_it(tmp_path):
    path = tmp_path / "planar.h5"
    write_h5(path, {}, {"strain": 0.1, "status": "flat"})
    with pytest.raises(ValueError, match=r"planar.h5: 'material' is missing, not a wrinkle file"):
        measure_state(path)
    write_h5(path, {}, attributes(0.1, "done"))
    with pytest.raises(ValueError, match=r"planar.h5: status = 'done': must be one of wrinkled, f"):
        measure_state(path)
    write_h5(path, {}, attributes(0.1, "flat", cells_along="many"))
    with pytest.raises(ValueError, match=r"cells_along = 'many': must be a whole number"):
        measure_state(path)
    write_h5(path, {"grid/x": GRID_X}, attributes(0.1, "wrinkled"))
    with pytest.raises(ValueError, match=r"planar.h5: dataset 'grid/y' is missing"):
        measure_state(path)


def test_an_attribute_that_is_not_a_number_stands_for_none(tmp_path):
    path = write_state(tmp_path / "a.h5", 0.1, residual=math.nan)
    assert measure_state(path).residual is None
    write_state(path, 0.1, young_modulus_pa=math.nan)
    with pytest.raises(ValueError, match=r"a.h5: young_modulus_pa is empty: must be a number"):
        measure_state(path)
