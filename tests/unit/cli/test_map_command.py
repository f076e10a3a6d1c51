"""Maps from the command line: points, order, parities, files, refusals."""

import json

import pytest

from wrinklestudy.cli import main
from wrinklestudy.equilibrium import flat

LATEX = ["--c10", "6.21e4", "--c01", "1.58e5"]
COARSE = ["--cells-along", "8", "--cells-across", "14"]
MAP = ["map", *LATEX, *COARSE, "--aspect", "2:3:1", "--strain", "0.3", "--strain", "0.1:0.2:0.1"]


@pytest.fixture
def points(capsys):
    """Return a function that runs a map and returns what its JSON says."""

    def run(*words):
        assert main([*MAP, *words, "--json"]) == 0
        return json.loads(capsys.readouterr().out)

    return run


def test_a_map_has_one_point_for_each_length_and_strain_in_their_order(points):
    found = points()
    assert [(p["aspect"], p["strain"]) for p in found] == [
        (aspect, strain) for aspect in (2.0, 3.0) for strain in (0.3, 0.1, 0.2)
    ]
    for point in found:
        assert point["parity"] in ("antisymmetric", "symmetric")
        assert point["half_waves"] % 2 == (point["parity"] == "symmetric")
        assert 0.0 <= point["largest_at"] <= 0.5
        assert (point["status"], point["reason"]) == ("unstable", "")


def test_the_default_is_the_parity_whose_thicker_sheets_wrinkle(points):
    larger, both = points(), points("--parity", "both")
    assert len(both) == 2 * len(larger)
    for k, point in enumerate(larger):
        pair = both[2 * k : 2 * k + 2]
        assert point in pair
        assert point["critical_thickness"] == max(p["critical_thickness"] for p in pair)


def test_one_parity_alone_is_half_of_both(points):
    """What one parity is started from must not change the other."""
    both = [p for p in points("--parity", "both") if p["parity"] == "symmetric"]
    for alone, beside in zip(points("--parity", "symmetric"), both, strict=True):
        assert alone["critical_thickness"] == pytest.approx(beside["critical_thickness"], rel=1e-9)


def test_several_processes_give_the_points_of_one(points):
    assert points("--jobs", "2") == points()


def test_the_map_has_the_critical_thickness_of_stability(capsys):
    """On the same cells across; the mesh along differs."""
    words = ["--aspect", "2", "--thickness", "1e-3", *LATEX, *COARSE, "--json"]
    assert main(["stability", *words]) == 0
    known = json.loads(capsys.readouterr().out)["critical_thickness"]
    nearest = min(known, key=lambda pair: abs(pair[0] - 0.1))
    assert (
        main(["map", *LATEX, *COARSE, "--aspect", "2", "--strain", repr(nearest[0]), "--json"]) == 0
    )
    (point,) = json.loads(capsys.readouterr().out)
    assert point["critical_thickness"] == pytest.approx(nearest[1], rel=5e-3)


def test_people_get_a_sentence_and_a_table(capsys):
    assert main(MAP) == 0
    text = capsys.readouterr().out
    assert "wrinkle, the thickest at L/W = 2 and strain 0.1." in " ".join(text.split())
    assert max(map(len, text.splitlines())) <= 80
    assert text.count("unstable") == 6


def test_a_plot_is_written_and_not_written_over(capsys, tmp_path):
    path = tmp_path / "map.png"
    assert main([*MAP, "--plot", str(path)]) == 0
    assert path.read_bytes().startswith(b"\x89PNG")
    capsys.readouterr()
    assert main([*MAP, "--plot", str(path)]) == 2
    assert "exists already; --overwrite replaces it" in capsys.readouterr().err


def test_a_hole_has_its_reason_in_the_json_and_on_stderr(capsys, monkeypatch):
    from wrinklestudy.equilibrium import critical_map

    def solve(space, law, strain, start=None):
        if strain == 0.2:
            raise flat.NotConvergedError("flat state at strain 0.2: made up")
        return flat.solve(space, law, strain, start=start)

    monkeypatch.setattr(critical_map, "solve_flat", solve)
    assert main([*MAP, "--json"]) == 1
    out, err = capsys.readouterr()
    holes = [point for point in json.loads(out) if point["status"] == "not-converged"]
    assert [(hole["aspect"], hole["strain"]) for hole in holes] == [(2.0, 0.2), (3.0, 0.2)]
    assert {hole["critical_thickness"] for hole in holes} == {None}
    assert err.count("flat state at strain 0.2: made up") == 2


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--strain", "0.1"], "--aspect: missing"),
        (["--aspect", "2"], "--strain: missing"),
        (["--aspect", "0.4:1:0.2", "--strain", "0.1"], "--aspect = 0.4: must be >= 0.5"),
        (["--aspect", "1:2:0.3", "--strain", "0.1"], "--aspect 1:2:0.3: stop = 2"),
        (["--aspect", "2", "--strain", "1.5"], "--strain = 1.5: must be >= 1e-7 and <= 1"),
        (["--aspect", "2", "--strain", "0.1", "--jobs", "0"], "--jobs = 0: must be >= 1"),
        (
            ["--aspect", "2", "--strain", "0.1", "--plot", "map.png"],
            "contours need at least two L/W and two strains",
        ),
        (["--aspect", "2", "--strain", "0.1", "--plot", "map.jpg"], "--plot map.jpg: must end in"),
    ],
)
def test_what_is_wrong_is_said_in_one_line(capsys, words, message):
    assert main(["map", *LATEX, *words]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert message in err
