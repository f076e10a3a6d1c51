"""The tables of a study: no row is lost, and the same files give the same bytes."""

import csv
import json

import pytest
from made_up_rows import limits_row, state_row

from wrinklestudy.results.tables import (
    PEAK_COLUMNS,
    STABILITY_COLUMNS,
    STATE_COLUMNS,
    write_states,
)
from wrinklestudy.stages import summary


def write_sheet(folder, name, aspect, strains):
    """Write what the stages before this one leave of a sheet."""
    own = {"material": name, "aspect": aspect}
    table, content = folder / f"{name}{aspect}.csv", folder / f"{name}{aspect}.json"
    write_states([state_row(strain, **own) for strain in strains], table)
    content.write_text(json.dumps(vars(limits_row(**own)) | {"critical_thickness": []}))
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
    columns = (STATE_COLUMNS, STABILITY_COLUMNS, PEAK_COLUMNS)
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
            r"latex2.5.csv, line 2: aspect = 'long': must be a number",
        ),
        (
            lambda s: s[0][1].write_text(json.dumps(vars(limits_row(aspect=7.0)))),
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
    assert (row["cells_along"], row["cells_across"]) == ("6", "12")
