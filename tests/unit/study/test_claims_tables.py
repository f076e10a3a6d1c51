"""What the claims are told of a study: numbers of a sheet, series of sheets, Table I."""

from dataclasses import replace

import numpy as np
import pytest
from made_up_study import MATERIALS, STRAIN, field_table, material, sheet, world

from wrinklestudy.studies.panaitescu2019 import table1
from wrinklestudy.studies.panaitescu2019.claims import confinement
from wrinklestudy.study.claims.finding import Finding, verdict_across


def test_a_model_of_other_rubber_is_left_alone():
    """A sheet of another material with the same law must not enter a series of this one."""
    other = sheet("treloar", aspect=2.2, modulus=1.2e6)
    twin = sheet("treloar", law="neo-hookean", decay=0.1, modulus=1.1e6)
    materials = (
        *MATERIALS,
        material("treloar", constants={"c10": 1e5, "c01": 1e5}, source="treloar.csv"),
    )
    study = replace(world(materials), sheets=(other, twin, *world().sheets))
    assert 2.2 not in study.sheets_by("aspect")
    assert study.sheet_with(law="neo-hookean").material == "nh"


def test_a_variant_belongs_to_its_material_by_law_and_modulus():
    study = world()
    assert set(study.sheets_by("bending")) == {"thinning", "fixed-thickness", "fvk"}
    softer = world(fixed={"modulus": 1.001e6})
    assert set(softer.sheets_by("bending")) == {"thinning", "fvk"}


def test_a_verdict_that_depends_names_what_on_and_a_disagreement_is_explained():
    assert verdict_across({"a": True, "b": False}, "x") == (
        "depends on",
        "x (holds for a; not for b)",
    )
    with pytest.raises(ValueError, match="needs an explanation"):
        Finding("disagree")
    with pytest.raises(ValueError, match="depends_on"):
        Finding("depends on", explanation="because")


def test_table_1_has_both_widths_and_the_largest_deviations():
    rows = table1.rows(world())
    assert {row.quantity for row in rows} == {"W_act", "W_proj"}
    first = rows[0]
    assert first.current_value == pytest.approx(1.0 - 0.5 * first.strain)
    assert first.deviation_from_original == pytest.approx(first.computed - 1.0)
    largest = next(row for row in rows if "current" in row.note)
    arc = 0.4 * (0.38 - 0.1) ** 2  # how far the synthetic width bends away
    assert largest.deviation_from_current == pytest.approx(arc)
    projected = next(row for row in rows if row.quantity == "W_proj")
    assert projected.current == table1.TENSION_FIELD
    assert np.isnan(projected.current_value)
    assert table1.rows(world(base=None)) == []


def test_table_1_takes_the_widths_of_the_tension_field_where_it_was_solved(tmp_path):
    path = tmp_path / "tension.csv"
    field = field_table(factor=2.0)
    field[field["strain"] != 0.1].to_csv(path, index=False)
    study = replace(world(), analyses={"tension": {"table": [path]}})
    projected = {row.strain: row for row in table1.rows(study) if row.quantity == "W_proj"}
    assert np.isnan(projected[0.1].current_value)
    phi = projected[0.2].planar / projected[0.2].computed - 1.0
    assert projected[0.2].current_value == pytest.approx(projected[0.2].planar / (1.0 + 2.0 * phi))
    note = f"{table1.LARGEST} from current version"
    (largest,) = [
        row for row in table1.rows(study) if row.quantity == "W_proj" and row.note == note
    ]
    assert largest.strain == 0.06  # where the made-up sheet hides most
    instead = [row for row in table1.rows(study) if table1.TENSION_FIELD in row.note]
    assert {row.quantity for row in instead} == {"W_act"}
    assert abs(instead[-1].deviation_from_current) < 1e-12
    assert f"{len(STRAIN) - 1} strains" in table1.table(study).note


def test_table_1_on_the_page_has_the_numbers_of_the_file():
    table = table1.table(world())
    assert len(table.cells) == len(table.rows) > 0
    assert {len(row) for row in table.cells} == {len(table.head)}
    for row, cells in zip(table.rows, table.cells, strict=True):
        values = dict(zip(table.columns, row, strict=True))
        assert cells[0] == values["quantity"]
        assert float(cells[2]) == pytest.approx(values["computed"], abs=5e-6)
        assert float(cells[7]) == pytest.approx(values["deviation_from_original"], abs=5e-6)
    empty = table1.table(world(base=None))
    assert (empty.columns, empty.rows, empty.head) == (table.columns, (), ())
    assert "lacks wrinkled states" in empty.note


def test_both_averages_of_phi_are_used():
    assert set(confinement.AVERAGES.values()) == {"phi_squared", "phi_squared_central"}
