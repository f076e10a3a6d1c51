"""The page of a study: its files, and in one line what is missing of them."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
import yaml

from wrinklestudy.cli import main
from wrinklestudy.explorer.from_study import content_of_study
from wrinklestudy.files.storage import write_json
from wrinklestudy.results.maps import MapRow
from wrinklestudy.results.materials import given_material
from wrinklestudy.results.tables import write_map
from wrinklestudy.study.config.reading import read_study

STRAINS = (0.06, 0.1, 0.2)
CONSTANTS = {"c10": 1e5, "c01": 2e5}
CURVE = [[0.05, 1.2e-3], [0.1, 1.5e-3], [0.3, 1.1e-3]]
CONFIG = {
    "materials": {"rubber": {"law": "mooney-rivlin", "constants": CONSTANTS}},
    "variants": {"rubber-fvk": {"material": "rubber", "bending": "fvk"}},
    "sheets": [
        {"material": name, "aspect": [2.0], "thickness": [1e-3], "strain": [*STRAINS]}
        for name in ("rubber", "rubber-fvk")
    ],
    "figures": {"sheet": {"material": "rubber-fvk", "aspect": 2.0, "thickness": 1e-3}},
}
SIZE = "aspect2_thickness0.001"


@pytest.fixture
def folder(tmp_path, monkeypatch, made_up):
    """A computed study as the working folder."""
    monkeypatch.chdir(tmp_path)
    Path("config.yaml").write_text(yaml.safe_dump(CONFIG))
    results = Path("results")
    write_json(results / "material/rubber.json", given_material("mooney-rivlin", CONSTANTS))
    for name, bending in (("rubber", "thinning"), ("rubber-fvk", "fvk")):
        sheet = made_up(material=name, bending=bending)
        table, limits = sheet.write(tmp_path, STRAINS)
        for kind in ("metrics", "stability", f"wrinkle/_/{SIZE}"):
            (results / kind.replace("_", name, 1)).mkdir(parents=True, exist_ok=True)
        (results / "metrics" / name).mkdir()
        shutil.move(table, results / "metrics" / name / f"{SIZE}.csv")
        known = json.loads(limits.read_text()) | {"critical_thickness": CURVE}
        write_json(results / "stability" / name / f"{SIZE}.json", known)
        for strain in STRAINS:
            file = sheet.write_state(tmp_path, strain)
            shutil.move(file, results / "wrinkle" / name / SIZE / f"strain{strain:g}.h5")
    return tmp_path


@pytest.mark.usefixtures("folder")
def test_a_page_has_the_sheets_with_their_shapes():
    content = content_of_study(read_study("config.yaml"), "config.yaml")
    assert [shown.sheet.bending for shown in content.sheets] == ["thinning", "fvk"]
    assert {shown.material for shown in content.sheets} == {"rubber"}
    assert content.first == 1
    assert content.constants == {"rubber": "Mooney–Rivlin, c10 = 100 kPa, c01 = 200 kPa"}
    first = content.sheets[0]
    assert [row.strain for row in first.sheet.states] == [*STRAINS]
    assert [shape is None for shape in first.shapes] == [False, False, True]  # 0.2 is a hole
    ends = [shape.evaluate(np.ones(1), np.zeros(1))[0, 0, 0] for shape in first.shapes[:2]]
    assert ends == pytest.approx([1.06, 1.1])


@pytest.mark.usefixtures("folder")
def test_without_a_map_it_is_that_of_the_curves_of_the_sheets():
    content = content_of_study(read_study("config.yaml"), "config.yaml")
    shown = content.maps[0]
    assert (shown.model, list(shown.aspects)) == ("rubber", [2.0])
    assert shown.strains[-1] == max(STRAINS)
    assert shown.computed == ((0.05, 2.0), (0.1, 2.0))
    assert shown.values[0, 30] == pytest.approx(1.5e-3)


def test_a_map_of_the_study_is_taken_where_there_is_one(folder):
    config = CONFIG | {"maps": [{"material": "rubber", "aspect": [3.0], "strain": [0.1]}]}
    Path("config.yaml").write_text(yaml.safe_dump(config))
    row = MapRow(
        *("rubber", "mooney-rivlin", "thinning", "symmetric", 3.0, 0.1, "unstable", 7e-4),
        *(7, 0.0, 0.1, None, 4, 4, ""),
    )
    (folder / "results/map/rubber").mkdir(parents=True)
    write_map([row], folder / "results/map/rubber/aspect3.csv")
    shown = content_of_study(read_study("config.yaml"), "config.yaml").maps[0]
    assert (list(shown.aspects), shown.computed) == ([3.0], ())
    np.testing.assert_array_equal(shown.values, [[7e-4]])


@pytest.mark.parametrize("name", ["material/rubber.json", f"wrinkle/rubber/{SIZE}/strain0.1.h5"])
def test_what_is_missing_is_said_in_one_line(folder, name, capsys):
    (folder / "results" / name).unlink()
    assert main(["explore", "--config", "config.yaml", "--output", "page.html"]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert f"results/{name} is missing; run the study first" in err
    assert not Path("page.html").exists()


@pytest.mark.usefixtures("folder")
def test_the_command_writes_the_page_and_may_write_it_again(capsys):
    words = ["explore", "--config", "config.yaml", "--output", "pages/page.html"]
    assert main(words) == 0
    assert "2 sheets, 6 states" in capsys.readouterr().out
    assert main([*words, "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["bytes"] == Path("pages/page.html").stat().st_size < 15_000_000


@pytest.mark.usefixtures("folder")
def test_a_file_that_is_no_such_page_is_not_written_over(capsys):
    Path("mine.html").write_text("<html>mine</html>")
    words = ["explore", "--config", "config.yaml", "--output", "mine.html"]
    assert main(words) == 2
    assert "exists already; --overwrite replaces it" in capsys.readouterr().err
    assert Path("mine.html").read_text() == "<html>mine</html>"
    assert main([*words, "--overwrite"]) == 0
