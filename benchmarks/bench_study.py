"""Time of the whole study from nothing, and how much of its CPU time is spent on solving.

Usage: ``python benchmarks/bench_study.py RUN.json [snakemake options]``, by `make bench`. All
cores are used; results and figures go to a folder of their own that is removed at the end. Solving
is what the jobs log as such: flat states, eigenproblems and wrinkled states. The rest is overhead:
Python's start and imports, files, tables, figures and snakemake itself. What the start of a job
costs is measured part by part in processes that do nothing else.
"""

import json
import os
import re
import resource
import subprocess
import sys
import time
from collections import defaultdict
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

from wrinklestudy.files.storage import write_json

# What a job of a wrinkled state imports, each on top of those before
IMPORTS = {
    "Python": "gc",
    "snakemake's objects": "snakemake.iocontainers",
    "numpy": "numpy",
    "h5py": "h5py",
    "scipy.sparse": "scipy.sparse.linalg",
    "scikit-fem": "skfem",
    "wrinklestudy": "wrinklestudy.stages.wrinkle",
}
ROUNDS = 15

LINE = re.compile(r"(solve|job): ([0-9.]+) s of CPU")


def run(options: list[str]) -> dict[str, Any]:
    """Run the study in a new folder and return its times in seconds."""
    with TemporaryDirectory(dir=".", prefix="results-") as path:
        folder = Path(path).name
        folders = json.dumps({"results": f"{folder}/results", "figures": f"{folder}/figures"})
        command = [sys.executable, "-m", "snakemake", "--cores", "all", "--quiet", "all"]
        start = time.perf_counter()
        before = children()
        subprocess.run([*command, *options, "--config", f"folders={folders}"], check=True)
        wall, total = time.perf_counter() - start, children() - before
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        stages = logged(Path(folder, "results", "log"))
    solving = sum(stage["solve"] for stage in stages.values())
    return {
        "cores": os.cpu_count(),
        "wall": wall,
        "cpu": total,
        "solving": solving,
        "overhead": 1.0 - solving / total,
        "peak_mb_of_a_job": peak / 1024,
        "stages": stages,
        "starts": starts(),
    }


def starts() -> list[dict[str, Any]]:
    """Return the median CPU seconds of a process that imports one thing more and ends, in order.

    As in the study all cores have such a process at the same time.
    """
    names, cores = list(IMPORTS), os.cpu_count() or 1
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    times: dict[str, list[float]] = {name: [] for name in names}
    for _ in range(ROUNDS):
        for number, name in enumerate(names, start=1):
            wanted = ", ".join(IMPORTS[n] for n in names[:number])
            # as in stages/memory.py
            code = f"import gc; gc.disable(); import {wanted}; gc.freeze()"
            before = children()
            command = [sys.executable, "-c", code]
            jobs = [subprocess.Popen(command, env=environment) for _ in range(cores)]
            if any(job.wait() for job in jobs):
                raise RuntimeError(f"importing {wanted}: failed")
            times[name].append((children() - before) / cores)
    return [{"imports": name, "seconds": median(times[name])} for name in names]


def children() -> float:
    """Return the CPU seconds of the child processes that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def logged(folder: Path) -> dict[str, dict[str, float]]:
    """Sum up what the jobs of each stage logged."""
    stages: dict[str, dict[str, float]] = defaultdict(lambda: {"jobs": 0, "solve": 0.0, "job": 0.0})
    for path in sorted(folder.rglob("*.log")):
        stage = stages[path.relative_to(folder).parts[0].removesuffix(".log")]
        stage["jobs"] += 1
        for part, seconds in LINE.findall(path.read_text()):
            stage[part] += float(seconds)
    return dict(stages)


if __name__ == "__main__":
    times = run(sys.argv[2:])
    write_json(sys.argv[1], times)
    print(json.dumps(times, indent=1))
