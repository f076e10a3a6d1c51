"""A run that was killed goes on by itself, and a live one is not disturbed."""

import os
import signal
import subprocess
import sys
import time

import pytest

pytestmark = pytest.mark.workflow

PLANAR = "results/quick/planar/latex/aspect2_resolves0.001"
QUICK = "config/quick.yaml"
TARGET = "results/quick/metrics/latex/aspect2_thickness0.001.csv"


def unlock(study):
    command = [sys.executable, "workflow/unlock.py"]
    return subprocess.run(command, cwd=study.folder, capture_output=True, text=True, check=False)


@pytest.fixture
def started(fresh):
    """A copy of the project in which a run has made its first planar state."""
    study = fresh
    run = subprocess.Popen(
        [sys.executable, "-m", "snakemake", "--cores", "2", TARGET, "--configfile", QUICK],
        cwd=study.folder,
        env={**os.environ, "PYTHONPATH": str(study.folder / "src")},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        end = time.monotonic() + 120.0
        while not any((study.folder / PLANAR).glob("strain*.h5")):
            assert run.poll() is None, "the run ended before it could be killed"
            assert time.monotonic() < end, "no planar state in two minutes"
            time.sleep(0.01)
        yield study, run
    finally:
        if run.poll() is None:
            os.killpg(run.pid, signal.SIGKILL)
            run.wait()


def test_a_killed_run_goes_on_and_ends_as_an_untouched_one(started, finished_quick):
    study, run = started
    live = unlock(study)
    assert live.returncode == 1
    assert live.stderr.count("\n") == 1
    assert f"(process {run.pid})" in live.stderr

    os.killpg(run.pid, signal.SIGKILL)
    run.wait()
    stopped = study.snakemake(TARGET)
    assert stopped.returncode != 0
    assert "lock" in stopped.stderr.lower()

    assert unlock(study).returncode == 0
    again = study.snakemake(TARGET)
    assert again.returncode == 0, again.stderr
    made = [path for path in (study.folder / "results").rglob("[!.]*.[hc]*") if path.is_file()]
    names = [path.relative_to(study.folder).as_posix() for path in made]
    assert TARGET in names
    assert len([name for name in names if name.startswith(PLANAR)]) > 1
    for name in names:
        if not name.startswith(("results/quick/log/", "results/quick/benchmark/")):
            whole = (finished_quick.folder / name).read_bytes()
            assert (study.folder / name).read_bytes() == whole, name


def test_where_nothing_is_locked_nothing_is_said(fresh):
    done = unlock(fresh)
    assert done.returncode == 0
    assert done.stdout + done.stderr == ""
