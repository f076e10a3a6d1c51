"""Runs of a small study that are killed at random moments, in a folder of their own."""

import contextlib
import os
import random
import shutil
import signal
import subprocess
import sys
import time

import psutil

CONFIG = "kill.yaml"
SMALL = """\
folders: {results: results/kill, figures: figures/kill}
sheets:
  - {material: latex, aspect: [2.0], thickness: [1.0e-3], strain: [0.1, 0.2]}
tension:
  - {material: latex, aspect: [2.0], strain: [0.1]}
mesh: {cells_across: 12, cells_along: 8}
figures: {compare: [latex], names: [fig02_sheet, fig05_amplitude]}
"""
LONGEST = 10.0  # s; the study takes about as long
PATIENCE = 300.0  # s, for a run that must end by itself
ABOUT_RUNS = ("results/kill/log/", "results/kill/benchmark/", "results/kill/.record/.running")


def files(study):
    """Return the content of every file that a run leaves, hidden ones too."""
    found = {}
    for name in ("results", "figures"):
        for path in (study.folder / name).rglob("*"):
            key = path.relative_to(study.folder).as_posix()
            if path.is_file() and not key.startswith(ABOUT_RUNS):
                found[key] = path.read_bytes()
    return found


def assert_same(study, untouched):
    """Compare all files with those of a run that was never touched."""
    here = files(study)
    assert here.keys() == untouched.keys()
    assert [name for name in here if here[name] != untouched[name]] == []


def start(study):
    """Start the run; its output goes to a file."""
    with open(study.folder / "said.txt", "w") as said:
        return subprocess.Popen(
            [sys.executable, "-m", "snakemake", "--cores", "2", "--configfile", CONFIG],
            cwd=study.folder,
            env={**os.environ, "PYTHONPATH": str(study.folder / "src")},
            stdout=said,
            stderr=said,
            start_new_session=True,
        )


def jobs_of(run):
    """Return the processes of the jobs of a run."""
    found = []
    with contextlib.suppress(psutil.Error):
        for process in psutil.Process(run.pid).children(recursive=True):
            with contextlib.suppress(psutil.Error):
                if any(word.endswith(".stage.py") for word in process.cmdline()[1:2]):
                    found.append(process)
    return found


def kill(run, what):
    """Kill one job of a run, snakemake itself or all of it."""
    jobs = jobs_of(run)
    if what == "job" and jobs:
        with contextlib.suppress(psutil.Error):
            jobs[0].kill()
        run.wait(PATIENCE)  # it ends by itself, or does not notice if the job was over
    elif what == "group":
        os.killpg(run.pid, signal.SIGKILL)
    else:
        os.kill(run.pid, signal.SIGKILL)  # its jobs live on
    run.wait(PATIENCE)


def kill_at_random(study, untouched, count, seed):
    """Kill a run that many times, with the same command again after each; then let it finish.

    A run that finishes before it is killed must have all files of an untouched one; all is then
    removed and begins anew.
    """
    rng = random.Random(seed)
    kills = 0
    while kills < count:
        run = start(study)
        end = time.monotonic() + rng.uniform(0.0, LONGEST)
        while run.poll() is None and time.monotonic() < end:
            time.sleep(0.02)
        if run.poll() is None:
            kill(run, rng.choice(("job", "snakemake", "group")))
            kills += 1
            continue
        assert run.returncode == 0, (study.folder / "said.txt").read_text()
        assert_same(study, untouched)
        for name in ("results", "figures", ".snakemake"):
            shutil.rmtree(study.folder / name)
    run = start(study)
    assert run.wait(PATIENCE) == 0, (study.folder / "said.txt").read_text()
    assert_same(study, untouched)
