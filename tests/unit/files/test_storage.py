"""Files are whole or absent, the same content gives the same bytes, and reading undoes writing."""

import subprocess
import sys
import time

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.files import storage


def test_a_failed_write_keeps_the_old_file_and_leaves_no_other(tmp_path):
    output = tmp_path / "state.h5"
    output.write_text("old")

    def fail():
        with storage.atomic_path(output) as path:
            path.write_text("half")
            raise RuntimeError("killed")

    with pytest.raises(RuntimeError, match="killed"):
        fail()
    assert output.read_text() == "old"
    assert list(tmp_path.iterdir()) == [output]


WRITING = {
    "h5": "write_h5('{output}', {{'x': np.arange(1e5)}}, {{}})",
    "json": "write_json('{output}', list(range(10**5)))",
    "pdf": "save(figure, '{output}')",
    "png": "save(figure, '{output}')",
}
# A limit on the size of files fails as a full disk does, at any write or close.
ON_A_SMALL_DISK = """
import resource
import numpy as np
from matplotlib.figure import Figure
from wrinklestudy.files.storage import DiskError, write_h5, write_json
from wrinklestudy.study.figures.style import save

figure = Figure()
figure.add_subplot().plot(np.sin(np.arange(1000.0)))
resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))
try:
    {writing}
except DiskError as error:
    print(error)
"""


@pytest.mark.parametrize("suffix", WRITING)
def test_a_disk_that_is_full_is_said_in_a_line_and_nothing_half_is_left(tmp_path, suffix):
    output = tmp_path / f"state.{suffix}"
    code = ON_A_SMALL_DISK.format(writing=WRITING[suffix].format(output=output))
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.stdout == f"{output}: cannot be written (File too large)\n", run.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_one_is_said_in_a_line(tmp_path):
    (tmp_path / "results").write_text("")
    with (
        pytest.raises(storage.DiskError, match=r"cannot be written \(Not a directory\)"),
        storage.atomic_path(tmp_path / "results" / "a" / "b.csv"),
    ):
        pass


def test_the_temporary_file_is_a_hidden_neighbour_with_the_same_suffix(tmp_path):
    output = tmp_path / "new" / "strain0.12.h5"
    with storage.atomic_path(output) as path:
        assert path.parent == output.parent
        assert path.suffix == ".h5"
        assert path.name.startswith(".")
        path.write_text("x")
        assert not output.exists()
    assert [p.name for p in output.parent.iterdir()] == ["strain0.12.h5"]


_KILLED = """
import os, sys
from wrinklestudy.files.storage import atomic_path

with atomic_path(sys.argv[1]) as path:
    path.write_text("half")
    os.kill(os.getpid(), 9)
"""


def test_what_a_killed_process_left_goes_with_the_next_write(tmp_path):
    output = tmp_path / "state.h5"
    for name in ("state.h5", "state-2.h5"):
        subprocess.run([sys.executable, "-c", _KILLED, tmp_path / name], check=False)
    left = sorted(tmp_path.iterdir())
    assert len(left) == 2
    storage.write_h5(output, {"x": np.ones(1)}, {})
    other = next(path for path in left if path.name.startswith(".state-2"))
    assert sorted(tmp_path.iterdir()) == sorted([output, other])


def test_what_a_living_process_or_another_host_writes_stays(tmp_path, monkeypatch):
    output = tmp_path / "state.h5"
    with storage.atomic_path(output) as living:
        living.write_text("half")
        storage.write_h5(output, {"x": np.ones(1)}, {})
        assert living.exists()
    with monkeypatch.context() as elsewhere:
        elsewhere.setattr(storage.platform, "node", lambda: "elsewhere")
        subprocess.run([sys.executable, "-c", _KILLED, output], check=False)
        here = set(tmp_path.iterdir())
        storage.write_h5(output, {"x": np.ones(1)}, {})
    assert set(tmp_path.iterdir()) == here


def test_unwritable_content_writes_nothing(tmp_path):
    with pytest.raises(ValueError, match="JSON"):
        storage.write_json(tmp_path / "a.json", {"x": float("inf")})
    with pytest.raises(TypeError, match="'settings'"):
        storage.write_h5(tmp_path / "a.h5", {"x": np.ones(2)}, {"settings": {"a": 1}})
    assert list(tmp_path.iterdir()) == []


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_infinity=False) | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)


def without_nan(value):
    if isinstance(value, dict):
        return {key: without_nan(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [without_nan(entry) for entry in value]
    return None if value != value else value


@given(json_values)
def test_json_round_trip_with_nan_as_null(tmp_path_factory, value):
    path = tmp_path_factory.mktemp("json") / "value.json"
    storage.write_json(path, value)
    assert storage.read_json(path) == without_nan(value)


def test_json_takes_numpy_and_does_not_depend_on_the_order_of_keys():
    numpy = {"b": np.float64(0.1), "a": np.array([[1.0, np.nan]]), "c": np.int64(3)}
    plain = {"a": [[1.0, None]], "b": 0.1, "c": 3}
    assert storage.format_json(numpy) == storage.format_json(plain)


def test_bad_json_is_named_with_its_line(tmp_path):
    path = tmp_path / "latex.json"
    path.write_text('{"a": 1,\n b}')
    with pytest.raises(ValueError, match=r"latex\.json: line 2 is not JSON"):
        storage.read_json(path)


def test_h5_round_trip(tmp_path):
    datasets = {
        "position": np.arange(12.0).reshape(3, 4),
        "modes/2": np.eye(2),
        "law": "Mooney–Rivlin",
    }
    attrs = {
        "strain": 0.1,
        "status": "wrinkled",
        "iterations": 7,
        "stable": True,
        "decay_strain": None,
        "residuals": np.array([1.0, 1e-9]),
        "versions": ["numpy 2", "scipy 1"],
        "empty": [],
    }
    path = tmp_path / "state.h5"
    storage.write_h5(path, datasets, attrs)
    got, got_attrs = storage.read_h5(path)
    assert got.keys() == datasets.keys()
    assert got["law"] == datasets["law"]
    assert np.array_equal(got["position"], datasets["position"])
    assert np.array_equal(got["modes/2"], datasets["modes/2"])
    assert got_attrs.keys() == attrs.keys()
    for name in ("strain", "status", "iterations", "stable", "decay_strain", "versions"):
        assert got_attrs[name] == attrs[name]
        assert type(got_attrs[name]) is type(attrs[name])
    assert np.array_equal(got_attrs["residuals"], attrs["residuals"])
    assert len(got_attrs["empty"]) == 0
    assert storage.read_h5(path, ())[0] == {}
    assert list(storage.read_h5(path, ("position",))[0]) == ["position"]


def test_h5_has_no_time_stamp_and_no_order_of_writing(tmp_path):
    datasets = {"b/x": np.arange(100.0), "a": np.ones((3, 3)), "note": "text"}
    attrs = {"strain": 0.1, "reason": None, "status": "flat"}
    storage.write_h5(tmp_path / "1.h5", datasets, attrs)
    time.sleep(1.1)  # HDF5 counts whole seconds
    backwards = dict(reversed(datasets.items())), dict(reversed(attrs.items()))
    storage.write_h5(tmp_path / "2.h5", *backwards)
    assert (tmp_path / "1.h5").read_bytes() == (tmp_path / "2.h5").read_bytes()


def test_h5_costs_little_more_than_its_numbers(tmp_path):
    storage.write_h5(tmp_path / "x.h5", {"x": np.ones(10_000)}, {"strain": 0.1})
    assert (tmp_path / "x.h5").stat().st_size < 80_000 + 8_000


def test_a_file_that_is_no_h5_is_named(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"none\.h5: no such file"):
        storage.read_h5(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("hello")
    with pytest.raises(ValueError, match=r"text\.h5: not a complete HDF5 file"):
        storage.read_h5(tmp_path / "text.h5")
    storage.write_h5(tmp_path / "x.h5", {"x": np.ones(1)}, {})
    with pytest.raises(ValueError, match=r"x\.h5: has no dataset 'y'"):
        storage.read_h5(tmp_path / "x.h5", ("y",))
