"""What follows from the row types: the keys of `solve --json`, the data dictionary."""

from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from made_up_rows import limits_row, state_row

from wrinklestudy.equilibrium.wrinkled import WrinkleSettings
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.results import dictionary
from wrinklestudy.results.fields import read_wrinkle, write_wrinkle
from wrinklestudy.results.rows import SheetRow, StabilityRow, StateRow, columns, refuse_twins
from wrinklestudy.sheet import Sheet
from wrinklestudy.vocabulary import FEWEST_CELLS

DOCS = Path(__file__).parents[3] / "docs"
# What `solve --json` gives; scripts of users rely on it.
SHOWN = [
    "strain",
    "status",
    "amplitude_over_thickness",
    "wavelength_over_width",
    "cells_per_wavelength",
    "arc_width_over_width",
    "projected_width_over_width",
    "phi_squared",
    "phi_squared_central",
    "shape_constant",
    "shape_constant_central",
    "nominal_stress_pa",
    "unstable_directions",
    "newton_iterations",
    "residual",
    "reason",
    "seconds",
]


@pytest.fixture(scope="module")
def sheet():
    return Sheet(2.0, 1e-3, mooney_rivlin(62100.0, 158000.0), mesh=MeshSettings(6, 12))


@pytest.fixture(scope="module")
def state(sheet):
    return sheet.solve(0.1)


def test_a_state_shows_the_documented_numbers_in_their_order(state):
    assert list(state.as_dict()) == SHOWN
    page = (DOCS / "columns.md").read_text().partition("\n## Stability\n")[0]
    marked = [line.split("`")[1] for line in page.splitlines() if ", json |" in line]
    measured = [line.split("`")[1] for line in page.splitlines() if "| json |" in line]
    assert sorted([*marked, *measured, "seconds"]) == sorted(SHOWN)


def test_the_cells_of_a_wavelength_are_those_between_two_crests(state):
    """They contract with the sheet, and half as many again are half as many again."""
    row = state.row()
    contracted = row.projected_width_over_width / 24  # the width of one of 2 x 12 cells
    cells = row.wavelength_over_width / contracted
    assert row.cells_per_wavelength == pytest.approx(cells)
    assert cells < FEWEST_CELLS
    finer = Sheet(2.0, 1e-3, mooney_rivlin(62100.0, 158000.0), mesh=MeshSettings(6, 18)).solve(0.1)
    assert finer.row().cells_per_wavelength == pytest.approx(1.5 * cells, rel=0.03)


def test_a_state_that_did_not_converge_shows_no_measures(sheet):
    state = sheet.solve(0.1, WrinkleSettings(max_iterations=1))
    shown = state.as_dict()
    assert state.status == shown["status"] == "not-converged"
    assert list(shown) == SHOWN
    empty = [name for name, value in shown.items() if value is None]
    assert empty == SHOWN[2:13]
    assert shown["reason"]


def test_the_file_of_a_state_has_its_row(state, tmp_path):
    write_wrinkle(state.equilibrium, tmp_path / "state.h5")
    row, datasets = read_wrinkle(tmp_path / "state.h5")
    shown = state.as_dict()
    for name, column in columns(StateRow).items():
        if column.measured:
            assert getattr(row, name) is None
        elif column.shown:
            assert getattr(row, name) == shown[name]
    assert datasets["position"].shape[0] == 3


def test_the_data_dictionary_is_that_of_the_rows():
    assert (DOCS / "columns.md").read_text(encoding="utf-8") == dictionary.page(), (
        "run: python -m wrinklestudy.results.dictionary docs/columns.md"
    )


@pytest.mark.parametrize("kind", [StateRow, StabilityRow, SheetRow])
def test_every_column_is_described_and_has_its_unit(kind):
    for name, column in columns(kind).items():
        assert column.description
        assert (column.unit == "Pa") == name.endswith("_pa")
        assert not (column.identifies and column.optional)
    assert list(columns(kind)) == [one.name for one in fields(kind)]


def test_rows_are_told_apart_by_sheet_and_strain():
    rows = [state_row(0.1), state_row(0.2), state_row(0.1, aspect=3.0)]
    refuse_twins(rows, ["a", "b", "c"])
    with pytest.raises(ValueError, match="d: holds the same case as b"):
        refuse_twins([*rows, state_row(0.2, status="flat")], ["a", "b", "c", "d"])
    with pytest.raises(ValueError, match="b: holds the same case as a"):
        refuse_twins([limits_row(), limits_row(birth=np.nan)], ["a", "b"])
