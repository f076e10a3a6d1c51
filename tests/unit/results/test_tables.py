"""Tables give back what was written, and say in one line what is wrong with them."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_up_rows import limits_row, state_row

from wrinklestudy.results.peaks import sheet_row
from wrinklestudy.results.rows import SheetRow, StabilityRow, StateRow, columns, make_row
from wrinklestudy.results.tables import (
    read_sheets,
    read_states,
    write_peaks,
    write_stability,
    write_states,
)

# What pandas takes for numbers, dates or gaps if it is not told otherwise, and what CSV must quote.
TRICKY = [
    "nan",
    "NaN",
    "NA",
    "None",
    "null",
    "true",
    "1e5",
    "007",
    "inf",
    "",
    "-",
    '"',
    " a ",
    "a,b",
]
TRICKY += ["#x", "=1", "\N{GREEK SMALL LETTER LAMDA}/W", "two\nlines", "'", "N/A", "2019-01-01"]

texts = st.sampled_from(TRICKY) | st.text(
    st.characters(codec="utf-8", exclude_characters="\0\r"), max_size=12
)
numbers = st.floats(allow_nan=False, allow_infinity=False)
CELLS = {str: texts, int: st.integers(-(2**63), 2**63 - 1), float: numbers}


def cells(column):
    if column.allowed:
        return st.sampled_from(column.allowed)
    return st.none() | CELLS[column.kind] if column.optional else CELLS[column.kind]


def rows(kind):
    values = {name: cells(column) for name, column in columns(kind).items()}
    return st.fixed_dictionaries(values).map(lambda one: kind(**one))


def several(kind):
    return st.lists(rows(kind), min_size=1, max_size=4, unique_by=lambda row: row.key)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("tables")


@given(written=several(StateRow))
def test_states_come_back_as_they_were_to_the_last_bit(folder, written):
    write_states(written, folder / "states.csv")
    back = read_states(folder / "states.csv")
    # repr, so that 1 is not 1.0 and 0.0 not -0.0
    assert repr(back) == repr(sorted(written, key=lambda row: row.key))


@given(written=several(SheetRow))
def test_sheets_come_back_from_their_two_tables(folder, written):
    write_stability(written, folder / "stability.csv")
    write_peaks(written, folder / "peaks.csv")
    back = read_sheets(folder / "stability.csv", folder / "peaks.csv")
    assert repr(back) == repr(sorted(written, key=lambda row: row.key))


@given(written=several(StateRow), seed=st.randoms())
def test_the_order_of_the_rows_does_not_matter(folder, written, seed):
    write_states(written, folder / "a.csv")
    seed.shuffle(written)
    write_states(written, folder / "b.csv")
    assert (folder / "a.csv").read_bytes() == (folder / "b.csv").read_bytes()


@pytest.mark.parametrize("name", TRICKY)
def test_a_name_that_looks_like_something_else_stays_a_name(tmp_path, name):
    path = tmp_path / "states.csv"
    write_states([state_row(0.1, material=name), state_row(0.2, material=name)], path)
    assert [row.material for row in read_states(path)] == [name, name]


def test_no_number_is_an_empty_cell_and_whole_numbers_have_no_point(tmp_path):
    path = tmp_path / "states.csv"
    write_states(
        [state_row(0.1 + 0.2, phi_squared=0.0), state_row(0.2, phi_squared=math.nan)], path
    )
    head, first, second = (line.split(",") for line in path.read_text().splitlines())
    assert head == list(columns(StateRow))
    place = {name: k for k, name in enumerate(head)}
    assert (first[place["phi_squared"]], second[place["phi_squared"]]) == ("", "0.0")
    assert first[place["newton_iterations"]] == "7"
    assert first[place["unstable_directions"]] == ""
    assert second[place["strain"]] == "0.30000000000000004"
    assert "\r" not in path.read_text()


def test_numbers_of_numpy_are_numbers_like_any_other(tmp_path):
    path = tmp_path / "states.csv"
    values = {"phi_squared": np.float64(0.1), "unstable_directions": np.int64(0)}
    write_states([state_row(np.float64(0.1), **values)], path)
    (back,) = read_states(path)
    assert (type(back.phi_squared), type(back.unstable_directions)) == (float, int)
    assert back == state_row(0.1, phi_squared=0.1, unstable_directions=0)


def test_a_table_without_rows_has_its_columns(tmp_path):
    path = tmp_path / "states.csv"
    write_states([], path)
    assert path.read_text() == ",".join(columns(StateRow)) + "\n"
    assert read_states(path) == []


def test_lines_may_end_as_spreadsheets_end_them(tmp_path):
    path = tmp_path / "states.csv"
    write_states([state_row(0.1), state_row(0.2)], path)
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    assert read_states(path) == [state_row(0.1), state_row(0.2)]


def test_columns_in_another_order_and_others_beside_them_are_read(tmp_path):
    path = tmp_path / "states.csv"
    write_states([state_row(0.1)], path)
    lines = [line.split(",") for line in path.read_text().splitlines()]
    path.write_text("".join(",".join([*line[::-1], "more"]) + "\n" for line in lines))
    assert read_states(path) == [state_row(0.1)]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (("material,", "stuff,"), "column 'material' is missing"),
        (("law,", "strain,"), "column 'law' is missing"),
        (("parity,", "parity,parity,"), "column 'parity' stands twice"),
        ((",reason", ",phi_squared"), "column 'phi_squared' stands twice"),
        ((",0.2,", ",,"), "line 3: strain is empty: must be a number"),
        ((",0.2,", ",nan,"), "line 3: strain is empty: must be a number"),
        ((",0.2,", ",a lot,"), "line 3: strain = 'a lot': must be a number"),
        (("wrinkled", "crumpled"), "line 2: status = 'crumpled': must be one of wrinkled, flat, n"),
        ((",6,12,", ",6,12.5,"), "line 2: cells_across = '12.5': must be a whole number"),
        ((",6,12,", ",6"), "line 2: cells_across is empty: must be a whole number"),
        ((",2.0,", ",,2.0,"), "is not a table (.*line 2"),
        (("latex,", '"latex,'), "is not a table ("),
    ],
)
def test_a_wrong_table_gets_one_line_that_says_where(tmp_path, change, message):
    path = tmp_path / "states.csv"
    write_states([state_row(0.1), state_row(0.2)], path)
    path.write_text(path.read_text().replace(*change, 1))
    with pytest.raises(ValueError, match=r"states\.csv") as caught:
        read_states(path)
    expected, _, more = message.partition(".*")
    assert expected in str(caught.value)
    assert more in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("content", [b"", b"\n", b"\xff\xfe\xfa", b"a,b\n1,2,3\n"])
def test_what_is_no_table_gets_one_line(tmp_path, content):
    path = tmp_path / "states.csv"
    path.write_bytes(content)
    with pytest.raises(ValueError, match=r"states\.csv: is not a table \(.+\)$"):
        read_states(path)


def test_a_sheet_in_one_of_the_two_tables_only_is_named(tmp_path):
    one = sheet_row(limits_row(), [state_row(0.1)])
    both = [one, replace(one, aspect=3.0)]
    stability, peaks = tmp_path / "stability.csv", tmp_path / "peaks.csv"
    for limits, highest, lacking in (([one], both, stability), (both, [one], peaks)):
        write_stability(limits, stability)
        write_peaks(highest, peaks)
        with pytest.raises(
            ValueError, match=rf"{lacking.name}: has no sheet latex, .*, 3.0, 0.001"
        ):
            read_sheets(stability, peaks)


def test_a_row_that_lacks_a_value_is_refused():
    values = vars(limits_row())
    assert make_row(StabilityRow, values | {"more": 1}, "a.json", "stability file") == limits_row()
    del values["decay_strain"]
    with pytest.raises(ValueError, match=r"^a.json: 'decay_strain' is missing, not a stability f"):
        make_row(StabilityRow, values, "a.json", "stability file")


@pytest.mark.parametrize("wrong", ["0.1", True, [0.1]])
def test_what_is_no_number_is_not_taken_for_one(wrong):
    with pytest.raises(ValueError, match=r"birth_strain = .*: must be a number or empty"):
        limits_row(birth=wrong)
