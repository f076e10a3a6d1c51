"""Runs killed at random moments go on by the same command and end as an untouched one.

`make test-kill` kills a hundred times, with a seed of the day; `make test` ten times.
"""

import os

import kills
import pytest

pytestmark = pytest.mark.workflow

COUNT = int(os.environ.get("KILLS", "10"))
SEED = int(os.environ.get("KILL_SEED", "15"))


def test_killed_runs_end_as_an_untouched_one(project, tmp_path):
    untouched = project(tmp_path / "untouched")
    (untouched.folder / kills.CONFIG).write_text(kills.SMALL)
    run = untouched.snakemake(config=kills.CONFIG)
    assert run.returncode == 0, run.stderr
    files = kills.files(untouched)
    assert len(files) > 40

    killed = project(tmp_path / "killed")
    (killed.folder / kills.CONFIG).write_text(kills.SMALL)
    kills.kill_at_random(killed, files, COUNT, SEED)
