"""Columns with units and bounds: what is wrong is said with file, line and column."""

import math

import pytest

from wrinklestudy.files.number_table import (
    NumberColumn,
    NumberNote,
    WordColumn,
    read_number_table,
)
from wrinklestudy.vocabulary import Limits

STRAIN = NumberColumn(
    "strain",
    {"strain": 1.0, "strain_percent": 0.01},
    Limits(-1.0, 10.0, above_lowest=True),
    hint="0.12 is 12%",
)
STRESS = NumberColumn("stress", {"stress_pa": 1.0, "stress_kpa": 1e3})
ERROR = NumberColumn("error", {"error_pa": 1.0}, Limits(0.0), needed=False, gaps=True)
MODE = WordColumn("mode", ("uniaxial", "shear"), "uniaxial")
WIDTH = NumberNote("width", Limits(0.0, above_lowest=True), {"mm": 1.0, "m": 1e3})


def read(tmp_path, text, **options):
    path = tmp_path / "curve.csv"
    path.write_text(text)
    return read_number_table(path, (STRAIN, STRESS, ERROR), (MODE,), (WIDTH,), **options)


def test_units_of_the_names_are_taken_into_account(tmp_path):
    table = read(tmp_path, "strain_percent,stress_kpa,time_s\n12,1.5,0\n24,3,1\n")
    assert table.numbers["strain"] == pytest.approx([0.12, 0.24], rel=1e-15)
    assert table.numbers["stress"] == pytest.approx([1500.0, 3000.0], rel=1e-15)
    assert table.spelled == {"strain": "strain_percent", "stress": "stress_kpa"}
    assert table.words["mode"] == ("uniaxial", "uniaxial")
    assert "error" not in table.numbers


def test_gaps_are_allowed_only_where_they_are(tmp_path):
    table = read(tmp_path, "strain,stress_pa,error_pa,mode\n0,1,,shear\n1,2,NaN,uniaxial\n")
    assert [math.isnan(value) for value in table.numbers["error"]] == [True, True]
    assert table.words["mode"] == ("shear", "uniaxial")
    with pytest.raises(ValueError, match="line 2, column stress_pa: '' is not a number"):
        read(tmp_path, "strain,stress_pa\n0,\n")


@pytest.mark.parametrize(
    ("text", "width"),
    [
        *(("140", 140.0), ("140 mm", 140.0), ("0.14m", 140.0), ("1.4e2 mm", 140.0)),
        *(("140,5 mm", 140.5), ("0,1405 m", 140.5)),
    ],
)
def test_a_note_may_have_a_unit(tmp_path, text, width):
    table = read(tmp_path, f"# Width:  {text}\n# by: me\nstrain,stress_pa\n0,1\n")
    assert table.notes["width"] == pytest.approx(width, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("strain,stress_pa\n0,1_000\n", "line 2, column stress_pa: '1_000' is not a number"),
        ("strain,stress_pa\n0,inf\n", "'inf' is not a number"),
        ("strain,stress_pa\n0,1e999\n", "1e999 must be a finite number"),
        ("strain,stress_pa\n0,3 kPa\n", "write the number without the unit 'kPa'"),
        ("strain,stress_pa\n12,1\n", r"column strain: 12 must be > -1 and <= 10 \(0.12 is 12%\)"),
        ("strain_percent,stress_pa\n-100,1\n", r"column strain_percent: -100 must be > -100"),
        ("strain,strain_percent,stress_pa\n0,0,1\n", "strain and strain_percent exclude each"),
        ("strain\n0\n", r"line 1: a column stress_pa or stress_kpa is missing \(has strain\)"),
        ("strain,stress_pa,sterss\n0,1,2\n", "column 'sterss' is unknown; allowed are strain,"),
        ("strain,stress_pa,mode\n0,1,tension\n", "column mode: 'tension'; allowed are uniaxial"),
        ("# width: 140 furlong\nstrain,stress_pa\n0,1\n", "without the unit 'furlong'; units may"),
        ("# width: 1,405 m\nstrain,stress_pa\n0,1\n", "line 1, width: '1,405 m' is not a number"),
        ("strain,stress\n0,1\n", "'stress' is unknown; write it with its unit: stress_pa or"),
        ("# width: -1\nstrain,stress_pa\n0,1\n", "line 1, width: -1 must be > 0"),
        ("# width: 1\n# width: 2\nstrain,stress_pa\n0,1\n", "line 2: '# width:' is given twice"),
    ],
)
def test_one_line_names_what_is_wrong(tmp_path, text, message):
    with pytest.raises(ValueError, match=message) as caught:
        read(tmp_path, text)
    assert "\n" not in str(caught.value)
    assert "curve.csv" in str(caught.value)


def test_other_columns_are_left_alone_on_request(tmp_path):
    table = read(tmp_path, "strain,stress_pa,x\n0,1,?\n", others=True)
    assert set(table.numbers) == {"strain", "stress"}


def test_a_table_has_exactly_one_of_the_columns_that_mean_the_same(tmp_path):
    path = tmp_path / "curve.csv"
    columns = [NumberColumn(name, {name: 1.0}, needed=False) for name in ("stretch", "strain")]
    either = (("stretch", "strain"),)
    path.write_text("strain\n0\n")
    assert list(read_number_table(path, columns, either=either).numbers) == ["strain"]
    path.write_text("strain,stretch\n0,1\n")
    with pytest.raises(ValueError, match="line 1: columns stretch and strain exclude each other"):
        read_number_table(path, columns, either=either)
    path.write_text("time\n0\n")
    with pytest.raises(ValueError, match=r"a column stretch or strain is missing \(has time\)"):
        read_number_table(path, columns, either=either)


@pytest.mark.parametrize(
    "line", ["# gauge length: 80", "# Gauge_length = 80 mm", "#gauge  length:80"]
)
def test_a_note_may_be_spelled_as_people_do(tmp_path, line):
    path = tmp_path / "curve.csv"
    path.write_text(f"# E = 2 (a + b)\n{line}\nstrain\n0\n")
    column = NumberColumn("strain", {"strain": 1.0})
    note = NumberNote("gauge length", units={"mm": 1.0})
    assert read_number_table(path, [column], notes=[note]).notes == {"gauge length": 80.0}


def test_words_may_be_capitalised(tmp_path):
    table = read(tmp_path, "strain,stress_pa,mode\n0,1,Shear\n")
    assert table.words["mode"] == ("shear",)
