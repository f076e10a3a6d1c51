"""A damaged file is found before it is used, said in a line and made again by the same command."""

import json
import random
import shutil
import subprocess
import sys

import pytest

from wrinklestudy.files.records import DamagedFileError, check
from wrinklestudy.results.fields import read_planar, read_wrinkle
from wrinklestudy.results.grids import read_grid
from wrinklestudy.results.load import read_limits
from wrinklestudy.results.materials import load_material
from wrinklestudy.results.tables import read_states, read_tension
from wrinklestudy.results.tension import read_lines

pytestmark = pytest.mark.workflow

RESULTS = "results/quick"
SHEET = "latex/aspect2_thickness0.001"
# what later stages read, and how
READERS = {
    f"{RESULTS}/material/latex.json": load_material,
    f"{RESULTS}/mesh/aspect2_resolves0.001.vtu": read_grid,
    f"{RESULTS}/planar/latex/aspect2_resolves0.001/strain0.1.h5": read_planar,
    f"{RESULTS}/stability/{SHEET}.json": read_limits,
    f"{RESULTS}/wrinkle/{SHEET}/strain0.2.h5": read_wrinkle,
    f"{RESULTS}/metrics/{SHEET}.csv": read_states,
    f"{RESULTS}/tension/latex/aspect2.csv": read_tension,
    f"{RESULTS}/tension/latex/aspect2.h5": read_lines,
    f"{RESULTS}/summary/states.csv": read_states,
}
OTHERS = [
    f"{RESULTS}/summary/peaks.csv",
    f"{RESULTS}/claims/claims.csv",
    f"{RESULTS}/gate/gate.json",
    "figures/quick/fig03_surface.png",
    "figures/quick/fig02_sheet.csv",
    f"{RESULTS}/.record/wrinkle/{SHEET}/strain0.1.h5.json",
]
PLACES = 20


def flipped(content, place, bit):
    changed = bytearray(content)
    changed[place] ^= 1 << bit
    return bytes(changed)


def damaged(content, rng):
    """Yield contents with one wrong bit, with the end missing, and with nothing left."""
    for _ in range(PLACES):
        yield flipped(content, rng.randrange(len(content)), rng.randrange(8))
        yield content[: rng.randrange(len(content))]
    yield b""


def contents(study):
    return {
        path.relative_to(study.folder).as_posix(): path.read_bytes()
        for name in ("results", "figures")
        for path in (study.folder / name).rglob("*")
        if path.is_file() and not {"log", "benchmark"} & set(path.parts) and path.suffix
    }


@pytest.fixture(scope="module")
def worn(finished_quick, tmp_path_factory):
    """One copy whose files are damaged and mended."""
    return finished_quick.copied_to(tmp_path_factory.mktemp("damaged") / "study")


@pytest.mark.parametrize("name", READERS)
def test_no_number_is_read_from_a_damaged_file(worn, name):
    path = worn.folder / name
    whole = path.read_bytes()
    READERS[name](path)
    try:
        for content in damaged(whole, random.Random(name)):
            path.write_bytes(content)
            with pytest.raises(DamagedFileError) as refused:
                READERS[name](path)
            assert str(refused.value).startswith(f"{path}: damaged, ")
            assert "\n" not in str(refused.value)
    finally:
        path.write_bytes(whole)


@pytest.mark.parametrize("name", READERS)
def test_a_damaged_record_vouches_for_nothing(worn, name):
    folder, _, below = name.partition("/quick/")
    record = worn.folder / folder / "quick" / ".record" / f"{below}.json"
    whole = record.read_bytes()
    try:
        for content in damaged(whole, random.Random(name)):
            # a blank more or less at the end of the file is no damage
            if content.strip() != whole.strip():
                record.write_bytes(content)
                with pytest.raises(DamagedFileError, match="damaged record"):
                    check(worn.folder / name)
    finally:
        record.write_bytes(whole)


def test_files_of_every_stage_are_made_again_by_the_same_command(worn):
    before = contents(worn)
    rng = random.Random(2)
    names = [*READERS, *OTHERS]
    for name in names:
        path = worn.folder / name
        path.write_bytes(rng.choice(list(damaged(path.read_bytes(), rng))))
    asked = worn.snakemake("--dry-run")
    assert asked.stderr.count("; a run removes it\n") == len(names)
    assert all((worn.folder / name).exists() for name in names)
    run = worn.snakemake()
    assert run.returncode == 0, run.stderr
    assert run.stderr.count("; removed, to be made again\n") == len(names)
    assert contents(worn) == before
    assert worn.planned() == []


def test_results_of_another_version_without_their_history_are_made_again(study):
    """As after the results, and nothing else, were copied from an older checkout."""
    before = contents(study)
    shutil.rmtree(study.folder / ".snakemake")
    path = study.folder / "src/wrinklestudy/stages/metrics.py"
    path.write_text(path.read_text() + "\nUNUSED = 1\n")
    (study.folder / f"{RESULTS}/.record/material/treloar.json.json").unlink()
    run = study.snakemake()
    assert run.returncode == 0, run.stderr
    said = [
        line for line in run.stderr.splitlines() if line.endswith("; removed, to be made again")
    ]
    assert len(said) == 2
    assert f"{RESULTS}/material/treloar.json: no record says how it was made" in said[0] + said[1]
    outdated = f"{RESULTS}/metrics/"
    assert any(line.startswith(outdated) and "made by wrinklestudy 0." in line for line in said)
    after = contents(study)
    tables = [name for name in before if "/.record/" not in name and name.endswith(".csv")]
    assert [
        name for name in tables if name.startswith("results") and before[name] != after[name]
    ] == []
    assert study.planned() == []


def test_provenance_leads_from_a_figure_to_the_measured_curve(finished_quick):
    command = [sys.executable, "-m", "wrinklestudy.cli", "provenance", "--json"]
    name = "figures/quick/fig05_amplitude.png"
    run = subprocess.run(
        [*command, name], cwd=finished_quick.folder, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    (found,) = json.loads(run.stdout)
    assert found["made"]["stage"] == "figures"
    assert "12 x 18 cells" in found["made"]["shown"]["mesh"]
    stages = {source["made"]["stage"] for source in found["sources"].values() if source["made"]}
    assert stages == {"metrics", "stability", "wrinkle", "planar", "mesh", "material"}
    assert found["sources"]["data/latex_panaitescu2019.csv"]["unchanged"] is True
