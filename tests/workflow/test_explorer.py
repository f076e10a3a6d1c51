"""The page of a real study has its states, and the study is finished with it as before."""

import json
import os
import re
import subprocess
import sys

import pytest

from wrinklestudy.results.tables import read_states

pytestmark = pytest.mark.workflow


def test_the_quick_study_becomes_a_page(finished_quick, tmp_path):
    page = tmp_path / "explorer.html"
    options = ["--config", "config/quick.yaml", "--output", str(page), "--json"]
    run = subprocess.run(
        [sys.executable, "-m", "wrinklestudy.cli", "explore", *options],
        cwd=finished_quick.folder,
        env={**os.environ, "PYTHONPATH": str(finished_quick.folder / "src")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    known = read_states(finished_quick.folder / "results/quick/summary/states.csv")
    assert json.loads(run.stdout)["states"] == len(known)
    text = re.search(r'id="numbers">(.*?)</script>', page.read_text(encoding="utf-8"))[1]
    shown = {
        (sheet["model"], sheet["aspect"], sheet["thickness"], strain): amplitude
        for sheet in json.loads(text)["sheets"]
        for strain, amplitude in zip(
            sheet["states"]["strain"], sheet["states"]["amplitude_over_thickness"], strict=True
        )
    }
    assert shown == {
        (row.material, row.aspect, row.thickness, row.strain): row.amplitude_over_thickness
        for row in known
    }
