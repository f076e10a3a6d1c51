"""One run at a time: a live one is not disturbed, a dead one holds nothing."""

import os
import shutil
import signal
import subprocess
import sys
import time

import pytest

pytestmark = pytest.mark.workflow

RESULTS = "results/quick"
PLANAR = f"{RESULTS}/planar/latex/aspect2_resolves0.001"
QUICK = "config/quick.yaml"
TARGET = f"{RESULTS}/metrics/latex/aspect2_thickness0.001.csv"


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


def test_the_same_command_waits_for_a_live_run_and_takes_over_from_a_dead_one(
    started, finished_quick
):
    study, run = started
    second = study.snakemake(TARGET)
    assert second.returncode == 1
    assert second.stderr.splitlines()[-1].startswith(
        f"{RESULTS}: a run works here already (process {run.pid} on "
    )
    assert "Traceback" not in second.stderr

    os.killpg(run.pid, signal.SIGKILL)
    run.wait()
    assert list((study.folder / ".snakemake" / "locks").iterdir())
    again = study.snakemake(TARGET)
    assert again.returncode == 0, again.stderr
    assert f"{RESULTS}: the last run was killed; this one goes on\n" in again.stderr
    made = [path for path in (study.folder / "results").rglob("*.[hc]*") if path.is_file()]
    names = [path.relative_to(study.folder).as_posix() for path in made]
    assert TARGET in names
    assert len([name for name in names if name.startswith(PLANAR)]) > 1
    for name in names:
        whole = (finished_quick.folder / name).read_bytes()
        assert (study.folder / name).read_bytes() == whole, name


def test_another_study_in_the_same_place_is_not_disturbed(started):
    """Its results are in another folder, below the first one's."""
    study, run = started
    others = study.snakemake("results/material/treloar.json", config=None)
    assert others.returncode == 0, others.stderr
    assert run.poll() is None or run.returncode == 0


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can make a small disk")
@pytest.mark.skipif(shutil.which("mount") is None, reason="no mount here")
def test_a_full_disk_is_said_in_a_line_and_the_run_goes_on_once_there_is_room(
    fresh, finished_quick, tmp_path
):
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=400k", "tmpfs", str(disk)]
    if subprocess.run(mount, capture_output=True, check=False).returncode != 0:
        pytest.skip("no small disk can be mounted here")
    try:
        (fresh.folder / "results").symlink_to(disk)
        full = fresh.snakemake(TARGET)
        assert full.returncode != 0
        lines = full.stderr.splitlines()
        assert [line for line in lines if "cannot be written (No space left on device)" in line]
        assert [line for line in lines if f"{RESULTS}: stopped, its disk is full" in line]
        assert "Traceback" not in full.stderr
        hidden = [path for path in disk.rglob(".*-*-*") if path.is_file()]
        assert hidden == []

        subprocess.run(["mount", "-o", "remount,size=20m", str(disk)], check=True)
        subprocess.run(["mount", "-o", "remount,ro", str(disk)], check=True)
        closed = fresh.snakemake(TARGET)
        assert closed.returncode == 1
        wanted = f"{RESULTS}: cannot be written (Read-only file system)"
        assert closed.stderr.splitlines()[-1] == wanted

        subprocess.run(["mount", "-o", "remount,rw", str(disk)], check=True)
        again = fresh.snakemake(TARGET)
        assert again.returncode == 0, again.stderr
        whole = (finished_quick.folder / TARGET).read_bytes()
        assert (fresh.folder / TARGET).read_bytes() == whole
    finally:
        subprocess.run(["umount", "-l", str(disk)], check=True)
