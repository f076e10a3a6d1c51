"""Figures and claims are given the same sheets, whether from single tables or from those of all."""

import json
from dataclasses import replace

import numpy as np
import pytest
from made_up_rows import limits_row, state_row

from wrinklestudy.results.load import load_sheets, load_study
from wrinklestudy.results.tables import write_states
from wrinklestudy.stages import summary

NAMES = ("states", "stability", "peaks")


@pytest.fixture
def files(tmp_path):
    """Tables and stability files of two sheets, given from large to small and from high to low."""
    tables, limits = [], []
    for aspect in (3.0, 2.0):
        states = [
            state_row(strain, aspect=aspect, amplitude_over_thickness=aspect * strain)
            for strain in (0.3, 0.1, 0.2)
        ]
        tables.append(tmp_path / f"{aspect}.csv")
        limits.append(tmp_path / f"{aspect}.json")
        write_states(states, tables[-1])
        limits[-1].write_text(json.dumps(vars(limits_row(aspect=aspect))))
    return tables, limits


def tables_of(files, folder):
    output = {name: folder / f"{name}.csv" for name in NAMES}
    summary.run(*files, output)
    return [output[name] for name in NAMES]


def test_both_ways_lead_to_the_same_sheets(files, tmp_path):
    single = load_sheets(*files)
    assert [sheet.aspect for sheet in single] == [3.0, 2.0]
    whole = load_study(*tables_of(files, tmp_path))
    assert [sheet.aspect for sheet in whole] == [2.0, 3.0]
    for one, other in zip(single[::-1], whole, strict=True):
        assert one.row == other.row
        assert one.states == other.states


def test_states_come_by_strain_and_numbers_as_arrays(files):
    sheet, _ = load_sheets(*files)
    assert list(sheet.column("strain")) == [0.1, 0.2, 0.3]
    assert np.isnan(sheet.column("phi_squared")).all()
    assert sheet.peak["max_amplitude_over_thickness"] == sheet.row.max_amplitude_over_thickness
    assert (sheet.birth, sheet.decay) == (0.02, 0.42)
    assert sheet.size == (3.0, 1e-3)


def test_a_sheet_without_a_stability_file_has_no_ends(files):
    sheets = load_sheets(files[0], [])
    assert len(sheets) == len(files[0])
    for sheet in sheets:
        assert np.isnan([sheet.birth, sheet.decay, sheet.max_critical_thickness]).all()


def test_a_sheet_that_is_not_in_all_tables_is_named(files, tmp_path):
    states, stability, peaks = tables_of(files, tmp_path)
    kept = [replace(row, aspect=7.0) for sheet in load_sheets(*files) for row in sheet.states[:1]]
    write_states([replace(kept[0], aspect=2.0)], states)
    with pytest.raises(
        ValueError, match=r"states.csv: has no state of sheet latex, .*, 3.0, 0.001"
    ):
        load_study(states, stability, peaks)
    write_states([*(replace(kept[0], aspect=aspect) for aspect in (2.0, 3.0)), kept[0]], states)
    with pytest.raises(ValueError, match=r"peaks.csv: has no sheet latex, .*, 7.0, 0.001"):
        load_study(states, stability, peaks)
