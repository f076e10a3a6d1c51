"""The tables of a study: no row is lost, and peaks are those of the curve, not of its samples."""

import csv
import json
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from wrinklestudy.results.table import CASE, COLUMNS, STABILITY_COLUMNS, read_states, write_table

from wrinklestudy.results.peaks import PEAK_COLUMNS, peak_row
from wrinklestudy.stages import summary

TEXTS = ("latex", "mooney-rivlin", "thinning", "antisymmetric")
MODEL = dict(zip(CASE, (*TEXTS, 2.0, 1e-3), strict=True))
BIRTH, DECAY = 0.02, 0.42


def limit(birth=BIRTH, decay=DECAY, **other):
    numbers = {"birth_strain": birth, "decay_strain": decay}
    return MODEL | numbers | {"max_critical_thickness": 2e-3, "strain_at_max": 0.1} | other


def state(strain, amplitude=0.0, status="wrinkled", **other):
    numbers = dict.fromkeys(COLUMNS, 0.5) | dict.fromkeys(("cells_along", "cells_across"), 12)
    numbers |= {"reason": "", "status": status, "strain": strain}
    numbers |= {"amplitude_over_thickness": amplitude, "phi_squared": 1e-4 * amplitude**2}
    numbers |= {"wavelength_over_width": 0.2 - 0.1 * strain if status == "wrinkled" else math.nan}
    return numbers | MODEL | other


def pitchfork(strain):
    """(A/t)^2 = 900 (eps - birth)(decay - eps): supercritical at both ends, 6 at 0.22."""
    return math.sqrt(900.0 * max((strain - BIRTH) * (DECAY - strain), 0.0))


@given(st.lists(st.floats(0.03, 0.41), min_size=1, max_size=8, unique=True))
def test_the_peak_of_a_pitchfork_is_exact_wherever_its_samples_are(strains):
    strains = sorted({round(strain, 3) for strain in strains})
    row = peak_row(limit(), [state(strain, pitchfork(strain)) for strain in strains])
    assert row["max_amplitude_over_thickness"] == pytest.approx(6.0, rel=1e-9)
    assert row["strain_at_max_amplitude"] == pytest.approx(0.22, abs=1e-9)
    assert row["max_phi_squared"] == pytest.approx(1e-4 * 36.0, rel=1e-9)
    assert row["strain_at_max_phi_squared"] == pytest.approx(0.22, abs=1e-9)


def test_wavelengths_are_those_of_the_wrinkled_states_only():
    states = [state(e, pitchfork(e)) for e in (0.1, 0.2, 0.3)]
    states += [state(0.01, 0.0, "flat"), state(0.4, math.nan, "not-converged")]
    row = peak_row(limit(), states)
    assert row["wavelength_over_width_at_max_amplitude"] == pytest.approx(0.2 - 0.1 * 0.22)
    assert row["min_wavelength_over_width"] == pytest.approx(0.17)
    assert row["max_wavelength_over_width"] == pytest.approx(0.19)
    assert (row["wrinkled"], row["flat"], row["not_converged"]) == (3, 1, 1)
    assert (row["cells_along"], row["cells_across"]) == (12, 12)


def test_a_sheet_that_never_wrinkles_has_a_peak_of_zero_and_no_place_for_it():
    row = peak_row(limit(None, None), [state(e, 0.0, "flat") for e in (0.1, 0.2)])
    assert row["max_amplitude_over_thickness"] == row["max_phi_squared"] == 0.0
    assert math.isnan(row["strain_at_max_amplitude"])
    assert math.isnan(row["wavelength_over_width_at_max_amplitude"])


def test_wrinkles_between_two_strains_have_an_unknown_peak_and_not_a_flat_one():
    row = peak_row(limit(0.11, 0.13), [state(e, 0.0, "flat") for e in (0.1, 0.2)])
    assert math.isnan(row["max_amplitude_over_thickness"])
    assert math.isnan(row["max_phi_squared"])


@pytest.mark.parametrize(("hole", "known"), [(0.05, True), (0.2, False), (0.25, False)])
def test_a_state_that_did_not_converge_beside_the_peak_leaves_it_unknown(hole, known):
    """The peak is at 0.22, between two of the samples."""
    states = [state(e, pitchfork(e)) for e in (0.05, 0.15, 0.2, 0.25, 0.3) if e != hole]
    row = peak_row(limit(), [*states, state(hole, math.nan, "not-converged")])
    assert math.isfinite(row["max_amplitude_over_thickness"]) == known
    assert math.isfinite(row["strain_at_max_phi_squared"]) == known


def test_a_curve_that_still_rises_at_its_last_state_has_its_peak_there():
    row = peak_row(limit(BIRTH, None), [state(e, pitchfork(e)) for e in (0.05, 0.1, 0.15)])
    assert row["strain_at_max_amplitude"] == 0.15
    assert row["max_amplitude_over_thickness"] == pytest.approx(pitchfork(0.15))


finite = st.floats(allow_nan=False, allow_infinity=False)
numbers = finite | st.integers(-(10**6), 10**6) | st.just(math.nan)


@given(st.dictionaries(st.sampled_from(list(COLUMNS)), numbers), st.text(max_size=20))
def test_a_table_gives_back_what_was_written(tmp_path_factory, values, reason):
    path = tmp_path_factory.mktemp("table") / "t.csv"
    texts = {"law", "bending", "parity", "material", "status", "reason"}
    reason = reason.replace("\r", " ").replace("\0", " ")
    row = state(0.1, 2.0) | {k: v for k, v in values.items() if k not in texts} | {"reason": reason}
    write_table([row], COLUMNS, CASE, path)
    (back,) = read_states(path)
    assert back.keys() == COLUMNS.keys()
    for name, value in row.items():
        assert back[name] == value or (math.isnan(value) and math.isnan(back[name]))
        assert isinstance(back[name], int) == isinstance(value, int)


def write_sheet(folder, name, aspect, strains):
    """Write what the stages before this one leave of a sheet."""
    own = {"material": name, "aspect": aspect}
    table, content = folder / f"{name}{aspect}.csv", folder / f"{name}{aspect}.json"
    states = [state(strain, pitchfork(strain), **own) for strain in strains]
    write_table(states, COLUMNS, (*CASE, "strain"), table)
    content.write_text(json.dumps(limit(**own) | {"critical_thickness": []}))
    return table, content


@pytest.fixture
def study(tmp_path):
    sheets = [write_sheet(tmp_path, "latex", a, (0.1, 0.2, 0.3)) for a in (2.5, 1.5)]
    sheets.append(write_sheet(tmp_path, "fixed", 2.0, (0.1 + 0.2 - 0.1,)))
    names = ("states", "stability", "peaks")
    return sheets, {name: tmp_path / "out" / f"{name}.csv" for name in names}


def run(study):
    sheets, output = study
    summary.run([table for table, _ in sheets], [content for _, content in sheets], output)
    tables = {}
    for name, path in output.items():
        with open(path, newline="") as file:
            tables[name] = list(csv.DictReader(file))
    return tables


def test_every_state_and_every_sheet_has_its_row(study):
    tables = run(study)
    assert [len(rows) for rows in tables.values()] == [7, 3, 3]
    columns = (COLUMNS, STABILITY_COLUMNS, PEAK_COLUMNS)
    for rows, known in zip(tables.values(), columns, strict=True):
        assert list(rows[0]) == list(known)
    cases = [(row["material"], float(row["aspect"])) for row in tables["peaks"]]
    assert cases == [("fixed", 2.0), ("latex", 1.5), ("latex", 2.5)]
    assert float(tables["states"][0]["strain"]) == 0.1 + 0.2 - 0.1


def test_rows_are_those_of_the_sheets_to_the_byte(study):
    run(study)
    sheets, output = study
    rows = [line for table, _ in sheets for line in table.read_text().splitlines()[1:]]
    assert sorted(output["states"].read_text().splitlines()[1:]) == sorted(rows)


def test_the_order_of_the_sheets_does_not_matter(study):
    sheets, output = study
    run(study)
    first = [path.read_bytes() for path in output.values()]
    run((sheets[::-1], output))
    assert [path.read_bytes() for path in output.values()] == first


@pytest.mark.parametrize(
    ("change", "line"),
    [
        (lambda s: s[0][1].write_text("[1, 2]"), r"latex2.5.json: 'material' is missing"),
        (lambda s: s.append(s[0]), r"latex2.5.csv: holds the same case as .*latex2.5.csv"),
        (lambda s: s[0][0].write_text("a,b\n"), r"latex2.5.csv: column 'material' is missing"),
        (
            lambda s: s[0][0].write_text(s[0][0].read_text().replace("2.5", "long", 1)),
            r"latex2.5.csv: aspect = 'long': must be a number",
        ),
        (
            lambda s: s[0][1].write_text(json.dumps(limit(aspect=7.0))),
            r"sheet latex, .*, 2.5, 0.001: has no stability file",
        ),
    ],
)
def test_a_wrong_file_gets_one_line_and_nothing_is_written(study, change, line):
    sheets, output = study
    change(sheets)
    with pytest.raises(ValueError, match=line) as caught:
        run(study)
    assert "\n" not in str(caught.value)
    assert not output["states"].parent.exists()


def test_the_mesh_of_a_sheet_is_in_its_row(study):
    row = run(study)["peaks"][0]
    assert (row["cells_along"], row["cells_across"]) == ("12", "12")


def test_samples_of_numpy_are_numbers_like_any_other():
    states = [state(np.float64(e), np.float64(pitchfork(e))) for e in (0.1, 0.2, 0.3)]
    assert peak_row(limit(), states)["max_amplitude_over_thickness"] == pytest.approx(6.0)
