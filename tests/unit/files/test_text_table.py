"""Tables as people and machines write them: one reading, or one line that says why not."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.files.text_table import read_text_table

ROWS = (("0.01", "12.5"), ("0.02", "25"), ("0.04", "-3.5e2"))


def read(tmp_path, text, encoding="utf-8"):
    path = tmp_path / "table.csv"
    path.write_bytes(text.encode(encoding))
    return read_text_table(path)


def cells(table):
    return tuple(row.cells for row in table.rows)


@pytest.mark.parametrize("separator", [",", ";", "\t", " ", "  "])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_every_separator_gives_the_same_cells(tmp_path, separator, end):
    lines = [separator.join(row) for row in (("strain", "force_n"), *ROWS)]
    table = read(tmp_path, end.join(lines) + end)
    assert table.names.cells == ("strain", "force_n")
    assert cells(table) == ROWS
    assert [row.line for row in table.rows] == [2, 3, 4]


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
def test_a_byte_order_mark_tells_the_encoding(tmp_path, encoding):
    assert cells(read(tmp_path, "a,b\n1,2\n", encoding)) == (("1", "2"),)


@pytest.mark.parametrize(
    "text",
    [
        "strain;force_n\n0,01;12,5\n0,02;25\n0,04;-3,5e2\n",
        "strain\tforce_n\n0,01\t12,5\n0,02\t25\n0,04\t-3,5e2\n",
        'strain, force_n\n"0,01", "12,5"\n"0,02", "25"\n"0,04", "-3,5e2"\n',
    ],
)
def test_a_decimal_comma_is_read_where_it_cannot_be_a_separator(tmp_path, text):
    assert cells(read(tmp_path, text)) == ROWS


def test_units_in_brackets_join_the_names(tmp_path):
    beside = read(tmp_path, "Extension (mm),Load [N],Strain (%)\n1,2,3\n")
    below = read(tmp_path, '\nExtension,Load,Strain\n(mm),[N],(%)\n"1","2","3"\n')
    assert beside.names.cells == below.names.cells == ("extension_mm", "load_n", "strain_percent")
    assert cells(beside) == cells(below) == (("1", "2", "3"),)


def test_the_counter_of_pandas_and_empty_columns_are_left_out(tmp_path):
    table = read(tmp_path, ",strain,force_n,\n0,0.1,5,\n1,0.2,6,\n")
    assert table.names.cells == ("strain", "force_n")
    assert cells(table) == (("0.1", "5"), ("0.2", "6"))


def test_separators_at_the_end_of_a_row_do_not_count(tmp_path):
    assert cells(read(tmp_path, "a,b\n1,2,\n3,4,,\n")) == (("1", "2"), ("3", "4"))


def test_notes_keep_their_lines(tmp_path):
    table = read(tmp_path, "# width: 140\n\na,b\n1,2\n# second\n3,4\n")
    assert table.notes == ((1, "width: 140"), (5, "second"))
    assert [row.line for row in table.rows] == [4, 6]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", r"table.csv: is empty; a line of column names"),
        ("# only notes\n", "is empty"),
        ("a,b\n", "has column names but no data"),
        (
            "a,b\n0,01,12,5\n",
            r"line 2: 4 cells where 2 columns are named \(a, b\); a comma is both",
        ),
        ("a,b\n1,2\n1.5\n", r"line 3: 1 cells where 2 columns"),
        ("a,b\n1,2\na,b\n3,4\n", "line 3: the column names stand again"),
        ("a,b,a\n1,2,3\n", "line 1: column 'a' stands twice"),
        (",b\n7,2\n9,4\n", "line 1: column 1 has no name"),
        ('a;b\n"1,234";2\n', "line 2: '1,234': the comma may be a decimal sign or separate thous"),
        ("a;b\n0,5;2.5\n", "line 2: '0,5': the comma may be"),
        ('a,b\n"1,2\n', "line 2: is not a row of cells"),
    ],
)
def test_what_has_no_single_reading_is_refused_with_its_line(tmp_path, text, message):
    with pytest.raises(ValueError, match=message) as caught:
        read(tmp_path, text)
    assert "\n" not in str(caught.value)


def test_bytes_that_are_not_text_are_refused(tmp_path):
    path = tmp_path / "table.csv"
    path.write_bytes(b"a,b\n1,2\n\xff\xfe3,4\n")
    with pytest.raises(ValueError, match="line 3: is not UTF-8 text"):
        read_text_table(path)
    path.write_bytes(b"a,b\n1,\0002\n")
    with pytest.raises(ValueError, match="is not a text file"):
        read_text_table(path)
    with pytest.raises(ValueError, match=r"absent.csv: cannot be read \(No such file"):
        read_text_table(tmp_path / "absent.csv")


@given(
    values=st.lists(st.tuples(*[st.decimals(-1000, 1000, places=2)] * 2), min_size=1, max_size=6),
    separator=st.sampled_from([";", "\t"]),
)
def test_points_and_commas_are_the_same_numbers(tmp_path_factory, values, separator):
    folder = tmp_path_factory.mktemp("tables")
    text = f"a{separator}b\n" + "".join(f"{a}{separator}{b}\n" for a, b in values)
    assert cells(read(folder, text.replace(".", ","))) == cells(read(folder, text))
