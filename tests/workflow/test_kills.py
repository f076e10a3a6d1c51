"""Runs killed at random moments go on by the same command and end as an untouched one.

`make test-kill` kills a hundred times, with a seed of the day; `make test` ten times.
"""

import os
import time

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


def test_a_job_that_the_system_kills_is_said_in_one_line(fresh):
    """As it does when memory runs out: by a signal that no process can answer."""
    (fresh.folder / kills.CONFIG).write_text(kills.SMALL)
    run = kills.start(fresh)
    end = time.monotonic() + kills.PATIENCE
    while not (jobs := kills.jobs_of(run)):
        assert run.poll() is None
        assert time.monotonic() < end
        time.sleep(0.02)
    for job in jobs:
        job.kill()
    assert run.wait(kills.PATIENCE) == 1
    said = (fresh.folder / "said.txt").read_text()
    lines = [line for line in said.splitlines() if line.startswith("results/kill: stopped, ")]
    assert len(lines) == 1
    assert "a job was killed" in lines[0]
    assert "Traceback" not in said
