"""How long Snakemake plans studies of ever more states, and what it needs: docs/planning.md.

Usage: ``python benchmarks/bench_plan.py PAGE.md``, by `make bench-plan`. Each study is a dry run of
its own; nothing is computed. The largest is planned whole and in batches.
"""

import os
import pstats
import re
import resource
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from wrinklestudy.files.storage import atomic_path
from wrinklestudy.study.pages import render

TEMPLATES = Path(__file__).parent / "templates"
# L/W, t/W and strains of each study
SIZES = ((5, 4, 10), (10, 5, 20), (20, 10, 20), (25, 16, 25), (50, 20, 50))
DRY_RUN = ("snakemake", "--dry-run", "--cores", "2", "--quiet", "rules")
PROFILED = SIZES[1]
_OWN = ("src/wrinklestudy", "workflow/rules", "/Snakefile")
BATCHES = 20  # into which the largest study is cut
SECONDS, MEGABYTES = 60.0, 1000.0  # that planning may take


@dataclass(frozen=True)
class Plan:
    """One dry run."""

    states: int
    jobs: int
    seconds: float
    megabytes: float


def config(folder: Path, size: tuple[int, int, int]) -> Path:
    """Write the config of a study of many sheets."""
    lengths, thicknesses, strains = (
        ", ".join(f"{value:.6g}" for value in np.linspace(low, high, count))
        for (low, high), count in zip(((1.5, 6.0), (5e-4, 2e-3), (0.01, 0.5)), size, strict=True)
    )
    path = folder / "many.yaml"
    path.write_text(
        f"folders: {{results: {folder}/results, figures: {folder}/figures}}\n"
        f"sheets:\n  - {{material: latex, aspect: [{lengths}], thickness: [{thicknesses}], "
        f"strain: [{strains}]}}\n"
        "figures: {compare: [latex], names: [fig05_amplitude], "
        "sheet: {material: latex, aspect: 1.5, thickness: 5.0e-4}}\n"
    )
    return path


def plan(size: tuple[int, int, int], *options: str) -> Plan:
    """Plan a study in a process of its own and say what that took.

    Raises
    ------
    subprocess.CalledProcessError
        If Snakemake refuses the study.
    """
    with tempfile.TemporaryDirectory() as name:
        path = config(Path(name), size)
        command = [sys.executable, "-m", *DRY_RUN, *options, "--configfile", str(path)]
        run = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        assert run.stdout is not None
        text = run.stdout.read()
        _, status, usage = os.wait4(run.pid, 0)
    if status:
        raise subprocess.CalledProcessError(status, command, text[-2000:])
    jobs = int(re.findall(r"^total +(\d+)$", text, flags=re.MULTILINE)[0])
    states = dict(re.findall(r"^(\w+) +(\d+)$", text, flags=re.MULTILINE))["wrinkle"]
    return Plan(int(states), jobs, usage.ru_utime + usage.ru_stime, _megabytes(usage))


def _megabytes(usage: resource.struct_rusage) -> float:
    return usage.ru_maxrss / 1024.0


def own_share(size: tuple[int, int, int]) -> float:
    """Return the part of the time of planning a study that is spent in code of this project."""
    with tempfile.TemporaryDirectory() as name:
        record = Path(name) / "profile"
        command = [sys.executable, "-m", "cProfile", "-o", str(record), "-m", *DRY_RUN]
        path = config(Path(name), size)
        subprocess.run([*command, "--configfile", str(path)], check=True, capture_output=True)
        times = pstats.Stats(str(record)).stats.items()  # type: ignore[attr-defined]
    ours = sum(value[2] for (file, *_), value in times if any(part in file for part in _OWN))
    return float(ours / sum(value[2] for _, value in times))


def page(plans: list[Plan], batch: Plan, own: float) -> str:
    """Return the page; the same numbers give the same text."""
    jobs, seconds = (np.array([getattr(p, name) for p in plans]) for name in ("jobs", "seconds"))
    exponent = float(np.polyfit(np.log(jobs[1:]), np.log(seconds[1:]), 1)[0])
    largest = plans[-1]
    rows = [
        [f"{p.states}", f"{p.jobs}", f"{p.seconds:.1f}", f"{1e3 * p.seconds / p.jobs:.2f}",
         f"{p.megabytes:.0f}"]
        for p in plans
    ]  # fmt: skip
    return render(
        "planning.md.j2",
        TEMPLATES,
        plans=(("states", "jobs", "CPU seconds", "ms a job", "peak MB"), rows),
        exponent=exponent,
        largest=largest,
        batch=batch,
        batches=BATCHES,
        own=own,
        profiled=int(np.prod(PROFILED)),
        allowed=(SECONDS, MEGABYTES),
        whole_holds=largest.seconds <= SECONDS and largest.megabytes <= MEGABYTES,
        batch_holds=batch.seconds <= SECONDS and batch.megabytes <= MEGABYTES,
    )


def main(output: Path) -> None:
    """Plan all studies and write the page."""
    plans = []
    for size in SIZES:
        plans.append(plan(size))
        print(plans[-1], flush=True)
    batch = plan(SIZES[-1], "--batch", f"summary=1/{BATCHES}")
    with atomic_path(output) as path:
        path.write_text(page(plans, batch, own_share(PROFILED)), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
