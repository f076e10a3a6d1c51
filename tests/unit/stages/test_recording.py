"""The record of a job: what is in it, and that none is left of a job that did not end."""

import pytest

from wrinklestudy.files.origin import embedded
from wrinklestudy.files.records import file_digest, read_record
from wrinklestudy.files.storage import write_h5
from wrinklestudy.stages.recording import program, recorded


def job(folder, output, record, **params):
    source = folder / "source.json"
    source.write_text("{}")
    values = {"code": "0123", "strain": 0.1, "caption": {"mesh": "4 x 4 cells"}} | params
    return recorded(
        program(),
        "wrinkle",
        values,
        {"planar": str(source), "none": []},
        [str(output)],
        [str(record)],
    )


def test_a_record_says_what_a_file_was_made_from(tmp_path):
    output, record = tmp_path / "a.h5", tmp_path / "record" / "a.h5.json"
    with job(tmp_path, output, record):
        write_h5(output, {}, {"strain": 0.1})
    found = read_record(record)
    assert found.made["stage"] == "wrinkle"
    assert found.made["code"] == "0123"
    assert found.made["config"] == {"strain": 0.1}
    assert found.made["shown"] == {"mesh": "4 x 4 cells"}
    assert found.made["program"].startswith("wrinklestudy ")
    assert {"python", "numpy", "scipy"} <= found.made["versions"].keys()
    assert found.inputs == {str(tmp_path / "source.json"): file_digest(tmp_path / "source.json")}
    assert found.made["inputs"] == {"planar": file_digest(tmp_path / "source.json")}
    assert found.sha256 == file_digest(output)
    assert embedded(output) == found.made
    assert str(tmp_path) not in str(found.made)


def test_a_job_that_fails_leaves_no_record_of_the_file_before(tmp_path):
    output, record = tmp_path / "a.h5", tmp_path / "record" / "a.h5.json"
    with job(tmp_path, output, record):
        write_h5(output, {}, {"strain": 0.1})
    with pytest.raises(ArithmeticError), job(tmp_path, output, record):
        raise ArithmeticError
    assert not record.exists()
