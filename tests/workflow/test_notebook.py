"""The notebook runs on a fresh kernel, and what it shows is what the library gives."""

import re
from pathlib import Path

import pytest

from wrinklestudy import MeshSettings, Sheet, fit

nbformat = pytest.importorskip("nbformat", reason="the extra docs is not installed")
nbclient = pytest.importorskip("nbclient", reason="the extra docs is not installed")
pytest.importorskip("ipykernel", reason="the extra docs is not installed")

pytestmark = pytest.mark.workflow

ROOT = Path(__file__).parents[2]
NOTEBOOK = ROOT / "docs" / "notebooks" / "from_fit_to_map.ipynb"
LARGEST = 400_000  # bytes


def printed(notebook):
    """What the cells print, without pictures."""
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", ())]
    return "".join(output.text for output in outputs if output.output_type == "stream")


def numbers(text):
    return [float(number) for number in re.findall(r"\d+(?:\.\d+)?(?:e-?\d+)?", text)]


@pytest.fixture(scope="module")
def kept():
    return nbformat.read(NOTEBOOK, as_version=4)


@pytest.fixture(scope="module")
def executed(kept):
    """The notebook as a fresh kernel executes it."""
    fresh = nbformat.from_dict(kept)
    for cell in fresh.cells:
        cell.get("outputs", []).clear()
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", str(ROOT / "src"))
        client = nbclient.NotebookClient(
            fresh, timeout=300, resources={"metadata": {"path": str(NOTEBOOK.parent)}}
        )
        return client.execute()


def test_it_prints_what_is_kept(kept, executed):
    """To three digits: the last ones differ between processors."""
    assert len(numbers(printed(kept))) > 20
    assert numbers(printed(executed)) == pytest.approx(numbers(printed(kept)), rel=1e-3, abs=1e-3)
    pictures = [
        [
            output
            for cell in notebook.cells
            for output in cell.get("outputs", ())
            if "data" in output
        ]
        for notebook in (kept, executed)
    ]
    assert len(pictures[0]) == len(pictures[1]) >= 5


def test_its_numbers_are_those_of_the_library(executed):
    text = printed(executed)
    rubber = fit(
        ROOT / "data/treloar1944.csv", "mooney-rivlin", stretch=(1.0, 1.65), modes=["uniaxial"]
    )
    sheet = Sheet(2.0, 1e-3, rubber.material(), mesh=MeshSettings(12, 20))
    for name, value in rubber.constants.items():
        assert float(re.search(rf"{name} = (\d+)", text)[1]) == pytest.approx(value, abs=0.51)
    birth, decay = map(float, re.search(r"from ([\d.]+) to ([\d.]+)", text).groups())
    limits = sheet.stability()
    assert birth == pytest.approx(limits.birth_strain, abs=6e-5)
    assert decay == pytest.approx(limits.decay_strain, abs=6e-4)
    amplitude = sheet.solve(0.15).as_dict()["amplitude_over_thickness"]
    assert float(re.search(r"0\.15 wrinkled +A/t = ([\d.]+)", text)[1]) == pytest.approx(
        amplitude, abs=6e-4
    )


def test_it_is_kept_small_and_without_lines_that_were_written_over(kept):
    assert NOTEBOOK.stat().st_size < LARGEST
    assert "\x1b" not in NOTEBOOK.read_text(encoding="utf-8")
    assert "\r" not in printed(kept)
    assert printed(kept).count("\n") < 30
