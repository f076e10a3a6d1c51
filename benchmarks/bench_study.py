"""Time of the whole study from nothing, and how much of its CPU time is spent on solving.

Usage: ``python benchmarks/bench_study.py RUN.json [snakemake options]``, by `make bench`. All
cores are used; results and figures go to a folder of their own that is removed at the end. Solving
is what the jobs log as such: flat states, eigenproblems and wrinkled states. The rest is overhead:
Python's start and imports, files, tables, figures and snakemake itself.
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
from tempfile import TemporaryDirectory
from typing import Any

from wrinklestudy.store import write_json

LINE = re.compile(r"(solve|job): ([0-9.]+) s of CPU")


def run(options: list[str]) -> dict[str, Any]:
    """Run the study in a new folder and return its times in seconds."""
    with TemporaryDirectory(dir=".", prefix="results-") as path:
        folder = Path(path).name
        folders = json.dumps({"results": f"{folder}/results", "figures": f"{folder}/figures"})
        command = [sys.executable, "-m", "snakemake", "--cores", "all", "--quiet", "all"]
        start = time.perf_counter()
        subprocess.run([*command, *options, "--config", f"folders={folders}"], check=True)
        wall = time.perf_counter() - start
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        stages = logged(Path(folder, "results", "log"))
    total = usage.ru_utime + usage.ru_stime
    solving = sum(stage["solve"] for stage in stages.values())
    return {
        "cores": os.cpu_count(),
        "wall": wall,
        "cpu": total,
        "solving": solving,
        "overhead": 1.0 - solving / total,
        "peak_mb_of_a_job": usage.ru_maxrss / 1024,
        "stages": stages,
    }


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
    found = run(sys.argv[2:])
    write_json(sys.argv[1], found)
    print(json.dumps(found, indent=1))
