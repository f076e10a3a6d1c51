"""Print a profile for a cluster with memory, time and group sizes as a finished run needed them.

Snakemake keeps what each job took in ``results/.../benchmark``. From these records every rule gets
the memory and the time to ask for, and groups of as many jobs as fill a submission:

    .venv/bin/python workflow/cluster_profile.py results > profiles/my-cluster/profile.yaml

Jobs that fail are tried again with twice and three times as much (``attempt``). A rule without
records keeps what the workflow says. The new profile goes over ``profiles/slurm``.
"""

import argparse
import csv
import math
import sys
from dataclasses import dataclass
from pathlib import Path

# Rules whose jobs of different cases do not need each other: many go into one submission.
GROUPED = ("planar", "wrinkle", "metrics", "map", "tension", "compression", "figures")
HEADROOM = 1.5  # over the largest memory on record
STEP = 100  # MB; what is asked for is a multiple
LARGEST_GROUP = 500


@dataclass(frozen=True)
class Records:
    """What the jobs of a rule took: seconds and MB of each."""

    seconds: tuple[float, ...]
    memory: tuple[float, ...]

    @property
    def mem_mb(self) -> int:
        """Memory to ask for."""
        return STEP * math.ceil(HEADROOM * max(self.memory) / STEP)

    @property
    def runtime(self) -> int:
        """Minutes to ask for, twice the longest job on record."""
        return max(1, math.ceil(2.0 * max(self.seconds) / 60.0))

    def group(self, minutes: float) -> int:
        """Return how many jobs one after the other last some minutes."""
        mean = sum(self.seconds) / len(self.seconds)
        return max(1, min(LARGEST_GROUP, int(60.0 * minutes / max(mean, 0.1))))


def read(results: Path) -> dict[str, Records]:
    """Return the records of a results folder by rule.

    Raises
    ------
    ValueError
        If there are none, or a file is not a record.
    """
    rows: dict[str, list[tuple[float, float]]] = {}
    for folder in sorted(results.glob("**/benchmark/*")):
        for path in sorted(folder.rglob("*.tsv")):
            rows.setdefault(folder.name, []).append(_row(path))
    if not rows:
        raise ValueError(f"{results}: no records (benchmark/*/*.tsv); run a small study first")
    return {
        rule: Records(*(tuple(column) for column in zip(*taken, strict=True)))
        for rule, taken in rows.items()
    }


def _row(path: Path) -> tuple[float, float]:
    with open(path, newline="", encoding="utf-8") as file:
        row = next(csv.DictReader(file, delimiter="\t"), {})
    try:
        memory = row["max_rss"]
        # a job that ended before its memory was looked at has none
        return float(row["s"]), 0.0 if memory in ("NA", "-") else float(memory)
    except (KeyError, TypeError, ValueError):
        raise ValueError(f"{path}: not a record of a job: columns s and max_rss") from None


def profile(records: dict[str, Records], minutes: float) -> str:
    """Return the text of a profile.

    Parameters
    ----------
    records : mapping
        What jobs took, by rule.
    minutes : float
        How long a submission should last.
    """
    lines = ["set-resources:"]
    for rule, taken in sorted(records.items()):
        lines += [
            f"  {rule}:  # {len(taken.seconds)} jobs: at most {max(taken.seconds):.1f} s"
            f" and {max(taken.memory):.0f} MB",
            f"    mem_mb: attempt * {max(taken.mem_mb, STEP)}",
            f"    runtime: attempt * {taken.runtime}",
        ]
    grouped = [rule for rule in GROUPED if rule in records]
    if grouped:
        lines.append(f"groups: [{', '.join(f'{rule}={rule}' for rule in grouped)}]")
        sizes = [f"{rule}={records[rule].group(minutes)}" for rule in grouped]
        lines.append(f"group-components: [{', '.join(sizes)}]")
    return "\n".join(lines) + "\n"


def main() -> None:
    """Print the profile for the records of a folder."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=Path, help="folder of the results of a finished run")
    parser.add_argument("--minutes", type=float, default=20.0, help="of a submission (20)")
    options = parser.parse_args()
    if not options.minutes > 0.0:
        parser.error("--minutes: must be greater than 0")
    try:
        print(profile(read(options.results), options.minutes), end="")
    except ValueError as error:
        sys.exit(f"{parser.prog}: {error}")


if __name__ == "__main__":
    main()
