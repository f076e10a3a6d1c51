"""A file is what its record says, or it is not read."""

import json

import pytest

from wrinklestudy.files.records import (
    FOLDER,
    DamagedFileError,
    Record,
    check,
    damage,
    file_digest,
    read_record,
    record_of,
)


@pytest.fixture
def stored(tmp_path):
    """A file of a study with its record."""
    file = tmp_path / "results" / "metrics" / "latex" / "aspect2.csv"
    file.parent.mkdir(parents=True)
    file.write_text("strain,width\n0.1,0.95\n")
    made = {"stage": "metrics", "config": {"tolerance": 1e-22, "strains": (0.1, 0.2)}}
    record = Record(made, {"a.h5": "0" * 64}, file.stat().st_size, file_digest(file))
    path = tmp_path / "results" / FOLDER / "metrics" / "latex" / "aspect2.csv.json"
    path.parent.mkdir(parents=True)
    path.write_text(record.text())
    return file, path


def test_a_record_is_found_from_its_file_and_read_back(stored):
    file, path = stored
    assert record_of(file) == path
    record = read_record(path)
    assert record.inputs == {"a.h5": "0" * 64}
    assert record.made["config"]["tolerance"] == 1e-22
    assert damage(file, record) is None
    check(file)


def test_a_file_without_a_record_is_read_as_it_is(tmp_path):
    file = tmp_path / "mine.csv"
    file.write_text("x\n")
    assert record_of(file) is None
    check(file)


@pytest.mark.parametrize(
    ("content", "fault"),
    [
        ("strain,width\n0.1,0.9", "has 20 bytes of 22"),
        ("", "has 0 bytes of 22"),
        ("strain,width\n0.1,0.93\n", "its bytes are not those that were written"),
    ],
)
def test_every_damage_is_said_in_one_line(stored, content, fault):
    file, _ = stored
    file.write_text(content)
    with pytest.raises(DamagedFileError) as refused:
        check(file)
    assert str(refused.value) == (
        f"{file}: damaged, {fault}; run the study again, it is then made anew"
    )


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("1e-22", "1E-22"),  # the same number
        ('"metrics"', '"tension"'),
        ("{", ""),
        ('"size": 22', '"size": 23'),
    ],
)
def test_a_record_must_be_as_it_was_written_to_the_byte(stored, old, new):
    file, path = stored
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    with pytest.raises(DamagedFileError, match="damaged record"):
        check(file)


@pytest.mark.parametrize("content", ["[]", "{}", "null", "1", '"text"', "[" * 100_000, "\xff"])
def test_what_is_no_record_at_all_is_a_damaged_one(stored, content):
    _, path = stored
    path.write_bytes(content.encode("latin-1"))
    with pytest.raises(DamagedFileError):
        read_record(path)


def test_a_record_has_neither_time_nor_name_of_the_machine(stored):
    content = json.loads(stored[1].read_text())
    assert content.keys() == {"made", "inputs", "size", "sha256", "checksum"}
