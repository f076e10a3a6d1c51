"""`wrinklestudy provenance` on files that are no result of a finished study."""

import json
from pathlib import Path

import pytest

from wrinklestudy.cli import main
from wrinklestudy.files.records import FOLDER, file_digest
from wrinklestudy.files.storage import write_h5
from wrinklestudy.stages.recording import program, recorded


@pytest.fixture
def state(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    record = f"results/{FOLDER}/wrinkle/a.h5.json"
    params = {"code": "0123", "thickness": 1e-3, "settings": {"seeds": 2, "cycle": None}}
    with recorded(program(), "wrinkle", params, {}, ["results/wrinkle/a.h5"], [record]):
        write_h5("results/wrinkle/a.h5", {"grid/x": range(5), "grid/y": range(4)}, {})
    return tmp_path / "results" / "wrinkle" / "a.h5"


def test_it_names_program_code_config_and_mesh(state, capsys):
    assert main(["provenance", str(state.relative_to(Path.cwd()))]) == 0
    text = capsys.readouterr().out
    assert "stage wrinkle, code 0123" in text
    assert "config: settings.seeds = 2, thickness = 0.001\n" in text
    assert "mesh: 4 x 3 cells on the quarter sheet\n" in text
    assert "checksum: as written\n" in text


def test_a_file_says_the_same_where_it_was_copied(state, tmp_path, capsys):
    copy = tmp_path / "copy.h5"
    copy.write_bytes(state.read_bytes())
    assert main(["provenance", "--json", str(state), str(copy)]) == 0
    first, second = json.loads(capsys.readouterr().out)
    assert first["made"] == second["made"]
    assert (first["checked"], second["checked"]) == (True, False)


def test_a_damaged_file_is_told_and_the_status_is_one(state, capsys):
    state.write_bytes(state.read_bytes()[:-7])
    assert main(["provenance", str(state)]) == 1
    said = capsys.readouterr()
    assert "checksum: damaged" in said.out
    assert said.err.count("\n") == 1
    assert f"{state}: damaged, has " in said.err


@pytest.mark.parametrize("suffix", [".csv", ".h5", ".vtu", ".pdf", ".png", ".svg", ".txt", ".json"])
def test_a_file_of_other_origin_is_refused_in_one_line(tmp_path, capsys, suffix):
    path = tmp_path / f"mine{suffix}"
    for content in (b"", b"strain,width\n0.1,0.9\n", b"\x89PNG\r\n\x1a\n\xff\xff\xff\xfftEXt"):
        path.write_bytes(content)
        assert main(["provenance", str(path)]) == 2
        assert capsys.readouterr().err.count("\n") == 1


def test_a_missing_file_is_named(capsys):
    assert main(["provenance", "nowhere.csv"]) == 2
    assert capsys.readouterr().err == "wrinklestudy provenance: nowhere.csv: no such file\n"


COARSE = ["--cells-along", "6", "--cells-across", "8"]
SHEET = ["--aspect", "2", "--thickness", "1e-3", "--c10", "1e5", "--c01", "0", *COARSE]


def made_by(path, capsys):
    capsys.readouterr()
    assert main(["provenance", "--json", str(path)]) == 0
    (answer,) = json.loads(capsys.readouterr().out)
    return answer["made"]


def test_files_of_a_command_say_how_they_were_made(tmp_path, capsys):
    """From this process and from others; paths are in them by their names alone."""
    files = ["--vtu", str(tmp_path / "s.vtu"), "--picture", str(tmp_path / "s.png")]
    strains = ["--strain", "0.01:0.02:0.01", "--jobs", "2"]
    assert main(["solve", *SHEET, *strains, *files]) == 0
    made = [made_by(path, capsys) for path in sorted(tmp_path.iterdir())]
    assert len(made) == 4
    assert all(one == made[0] for one in made)
    assert made[0]["command"] == "solve"
    config = made[0]["config"]
    assert (config["c10"], config["c01"], config["strain"]) == (1e5, 0.0, ["0.01:0.02:0.01"])
    assert str(tmp_path) not in json.dumps(made)
    assert main(["provenance", str(tmp_path / "s_strain0.01.vtu")]) == 0
    assert ", command solve, code " in capsys.readouterr().out


def test_a_picture_of_a_fit_names_its_data_by_checksum(tmp_path, capsys):
    data = tmp_path / "curve.csv"
    data.write_text("strain,stress_pa\n0,0\n0.1,5e4\n0.2,9e4\n0.3,1.2e5\n0.5,1.7e5\n")
    assert main(["fit", str(data), "--plot", str(tmp_path / "fit.pdf")]) == 0
    made = made_by(tmp_path / "fit.pdf", capsys)
    assert made["inputs"] == {"data": file_digest(data)}
    assert made["config"]["data"] == "curve.csv"
