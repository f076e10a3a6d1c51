"""The quick study through a real Slurm: make test-slurm."""

import os
import subprocess
import sys
import threading
import time

import one_node
import pytest

pytestmark = [
    pytest.mark.workflow,
    pytest.mark.skipif("WRINKLESTUDY_SLURM" not in os.environ, reason="only in make test-slurm"),
    pytest.mark.skipif(bool(one_node.hindrance()), reason=one_node.hindrance()),
]
TABLES = ("summary/states.csv", "summary/stability.csv", "summary/peaks.csv", "claims/claims.csv")
# squeue, because this cluster keeps no accounts; checked often, because its jobs are short
OPTIONS = (
    *("--profile", "profiles/slurm", "--configfile", "config/quick.yaml"),
    *("--jobs", "4", "--cores", "2", "--latency-wait", "5", "--slurm-no-account"),
    *("--slurm-status-command", "squeue", "--slurm-init-seconds-before-status-checks", "5"),
)
HANGS_FOR = 240  # seconds until the time of a stopped job must be over


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    with one_node.running(tmp_path_factory.mktemp("cluster")) as started:
        yield started


def run(study, cluster, *options):
    """Start snakemake on the cluster."""
    return subprocess.Popen(
        [sys.executable, "-m", "snakemake", *OPTIONS, *options],
        cwd=study.folder,
        env={**cluster.environment, "PYTHONPATH": str(study.folder / "src")},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def wait_for(condition, seconds):
    """Return what a condition gives as soon as it gives something."""
    for _ in range(4 * seconds):
        if value := condition():
            return value
        time.sleep(0.25)
    raise AssertionError(f"not within {seconds} s: {condition}")


def state_of(cluster, number):
    return next((state for job, _, state in cluster.jobs() if job == number), "")


def same_tables(study, local):
    results = [folder / "results" / "quick" for folder in (study.folder, local.folder)]
    for name in TABLES:
        ours, theirs = ((folder / name).read_bytes() for folder in results)
        assert ours == theirs, name


def drain_and_resume(cluster, seen):
    """Take the node out of service once jobs have run, and back a little later."""
    wait_for(lambda: sum(state == "COMPLETED" for *_, state in cluster.jobs()) >= 2, 300)
    cluster.drain(True)
    seen.append(len(cluster.jobs()))
    time.sleep(20)
    cluster.drain(False)


def test_a_drained_node_changes_nothing(project, finished_quick, cluster, tmp_path):
    """The tables are byte for byte those of a run without a cluster."""
    study, seen = project(tmp_path), []
    draining = threading.Thread(target=drain_and_resume, args=(cluster, seen))
    process = run(study, cluster)
    draining.start()
    text, _ = process.communicate()
    draining.join()
    assert process.returncode == 0, text[-5000:]
    assert seen
    assert {state for *_, state in cluster.jobs()} == {"COMPLETED"}
    # six states, six fields in the plane and all figures are a submission each
    assert len(cluster.jobs()) < 30
    same_tables(study, finished_quick)


def test_a_job_that_is_killed_for_its_time_is_tried_again(finished_quick, cluster, tmp_path):
    """A job that hangs is ended by Slurm at its limit and runs whole the second time."""
    study = finished_quick.copied_to(tmp_path / "study")
    wrinkle = study.folder / "results" / "quick" / "wrinkle"
    lost = sorted(wrinkle.rglob("*.h5"))[0]
    lost.unlink()
    before = {number for number, *_ in cluster.jobs()}
    target = str(lost.relative_to(study.folder))
    process = run(study, cluster, "--set-resources", "wrinkle:runtime=1", "--", target)

    def started():
        return [job for job, _, state in cluster.jobs() if job not in before and state == "RUNNING"]

    (number,) = wait_for(started, 120)
    group = cluster.command("scontrol", "listpids", number).split()
    for word in group:
        if word.isdigit() and int(word) > 1 and word != number:
            subprocess.run(["kill", "-STOP", word], check=False)
    wait_for(lambda: state_of(cluster, number) == "TIMEOUT", HANGS_FOR)
    text, _ = process.communicate()
    assert process.returncode == 0, text[-5000:]
    assert lost.exists()
    same_tables(study, finished_quick)
