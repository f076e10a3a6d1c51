"""One's own sheet as a page and as a film: strains, files, refusals."""

import json
import re

import pytest
from PIL import Image

from wrinklestudy.cli import explore_command, main
from wrinklestudy.cli.shaped_states import default_strains
from wrinklestudy.equilibrium.ranges import Stability
from wrinklestudy.sheet import Sheet

LATEX = ["--c10", "0.1e6", "--c01", "0.2e6"]
COARSE = ["--cells-along", "6", "--cells-across", "12"]
SHEET = ["--aspect", "2", "--thickness", "1e-3", *LATEX, *COARSE]


def numbers_of(path):
    found = re.search(r'id="numbers">(.*?)</script>', path.read_text(encoding="utf-8"))
    return json.loads(found[1])


@pytest.fixture
def few(monkeypatch):
    """A small map and few tension fields."""
    monkeypatch.setattr(explore_command, "_LENGTHS", (0.75, 1.0))
    monkeypatch.setattr(explore_command, "_MAP_STRAINS", (0.4, 1.0))
    monkeypatch.setattr(explore_command, "_TENSION_STRAINS", (0.4, 1.0))


@pytest.mark.usefixtures("few")
def test_the_page_of_a_sheet_has_what_solve_and_stability_say(tmp_path, capsys):
    path = tmp_path / "own.html"
    words = [*SHEET, "--strain", "0.1", "--strain", "0.3"]
    assert main(["explore", *words, "--output", str(path)]) == 0
    capsys.readouterr()
    numbers = numbers_of(path)
    assert main(["solve", *words, "--json"]) == 0
    solved = json.loads(capsys.readouterr().out)
    (shown,) = numbers["sheets"]
    for name in ("strain", "amplitude_over_thickness", "nominal_stress_pa", "status"):
        assert shown["states"][name] == [
            state[name] if isinstance(state[name], str) else pytest.approx(state[name], rel=1e-9)
            for state in solved
        ]
    assert main(["stability", *SHEET, "--json"]) == 0
    limits = json.loads(capsys.readouterr().out)
    assert shown["birth"] == pytest.approx(limits["birth_strain"], rel=1e-9)
    (model,) = numbers["maps"]
    assert numbers["maps"][model]["aspects"] == [1.5, 2.0]
    assert numbers["maps"][model]["strains"] == [0.12, 0.3]
    fields = numbers["tension"][shown["material"]]
    assert [field["strain"] for field in fields] == [0.12, 0.3]
    assert (
        fields[0]["phi_squared"] > shown["states"]["phi_squared"][0]
    )  # more hides without bending


@pytest.mark.usefixtures("few")
def test_several_processes_write_the_page_of_one(tmp_path):
    pages = [tmp_path / "one.html", tmp_path / "two.html"]
    for jobs, path in zip("12", pages, strict=True):
        words = ["--strain", "0.1", "--strain", "0.3", "--jobs", jobs, "--output", str(path)]
        assert main(["explore", *SHEET, *words]) == 0
    assert pages[0].read_bytes() == pages[1].read_bytes()


def test_a_film_has_a_frame_for_each_strain(tmp_path, capsys):
    path = tmp_path / "film.gif"
    assert main(["film", *SHEET, "--frames", "3", "--output", str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["frames"] == 3
    assert Image.open(path).n_frames == 3
    assert main(["film", *SHEET, "--output", str(path)]) == 2
    assert "exists already; --overwrite replaces it" in capsys.readouterr().err


def limits(birth, decay, largest=0.5):
    ranges = () if birth is None else ((birth, decay),)
    return Stability(1e-3, birth, decay, ranges, 2e-3, 0.1, largest, "", ())


@pytest.mark.parametrize(
    ("found", "first", "last"),
    [
        (limits(0.02, 0.4), 0.012, 0.424),
        (limits(0.02, None, 1.0), 0.012, 1.0),
        (limits(0.02, 0.99), 0.012, 1.0),
        (limits(None, None), 0.02, 0.4),
    ],
)
def test_strains_reach_from_before_birth_to_after_decay(found, first, last):
    strains = default_strains(found, 20)
    assert (strains[0], strains[-1], len(strains)) == (first, last, 20)
    assert strains == sorted(set(strains))


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["explore", *SHEET], "--output: missing"),
        (["explore", *SHEET, "--output", "page.pdf"], "--output page.pdf: must end in .html"),
        (["explore", "--config", "c.yaml", "--aspect", "2", "--output", "p.html"], "--aspect"),
        (["explore", "--config", "none.yaml", "--output", "p.html"], "none.yaml: cannot be read"),
        (["explore", *LATEX, "--output", "p.html"], "--aspect and --thickness: missing"),
        (["explore", *SHEET, "--strain", "2", "--output", "p.html"], "--strain = 2: must be"),
        (["film", *SHEET], "--output: missing"),
        (["film", *SHEET, "--output", "f.avi"], "--output f.avi: must end in .gif or .mp4"),
        (["film", *SHEET, "--frames", "1", "--output", "f.gif"], "--frames = 1: must be >= 2"),
        (
            ["film", *SHEET, "--frames", "9", "--strain", "0.1", "--output", "f.gif"],
            "--strain, --frames: give strains or how many",
        ),
    ],
)
def test_what_is_wrong_is_said_in_one_line(capsys, tmp_path, monkeypatch, words, message):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(Sheet, "solve", lambda *_: pytest.fail("was computed"))
    assert main(words) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert message in err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.usefixtures("few")
def test_a_law_without_a_tension_field_has_a_page_without_one(tmp_path):
    path = tmp_path / "membrane.html"
    law = ["--law", "foppl-von-karman", "--young", "1e6", "--bending", "fvk"]
    size = ["--aspect", "2", "--thickness", "1e-3", *COARSE]
    assert main(["explore", *size, *law, "--strain", "0.1", "--output", str(path)]) == 0
    numbers = numbers_of(path)
    assert numbers["tension"] == {}
    assert numbers["sheets"][0]["states"]["status"] == ["wrinkled"]
