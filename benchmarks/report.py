"""Medians of a benchmark run, ratios to the factorisation and growth with the mesh.

Usage: ``python benchmarks/report.py RUN.json [PAGE.md]`` prints the table and writes it as a page.
"""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

from wrinklestudy.store import atomic_path

TEXT = """# Speed

Made by `make bench`; do not edit. Medians in milliseconds on one thread, in brackets the ratio to
the numeric factorisation of the tangent on the same mesh, and the exponent of the growth with the
number of cells. Only the ratios mean something on another machine ({machine}).

"""


def table(runs: list[dict[str, Any]]) -> list[list[str]]:
    """Return the rows of the table, the first with the headings."""
    cells = sorted({run["extra_info"]["cells"] for run in runs})
    medians: dict[str, dict[int, float]] = {}
    for run in runs:
        name = run["name"].split("[")[0].removeprefix("test_").replace("_", " ")
        medians.setdefault(name, {})[run["extra_info"]["cells"]] = run["stats"]["median"]
    unit = medians["factorisation"]
    rows = [["part", *(f"{n} cells" for n in cells), "growth"]]
    for name, times in medians.items():
        row = [name]
        row += [
            f"{1e3 * times[n]:.1f} ({times[n] / unit[n]:.2f})" if n in times else "" for n in cells
        ]
        growth = ""
        if len(times) > 1:
            sizes = np.log(sorted(times))
            exponent = np.polyfit(sizes, np.log([times[n] for n in sorted(times)]), 1)[0]
            growth = f"cells^{exponent:.2f}"
        rows.append([*row, growth])
    return rows


def page(content: dict[str, Any]) -> str:
    """Return the page as Markdown."""
    rows = table(content["benchmarks"])
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    lines.insert(1, "|---" * len(rows[0]) + "|")
    machine = content["machine_info"]["cpu"].get("brand_raw", "unknown processor")
    text = TEXT.format(machine=machine) + "\n".join(lines) + "\n\n"
    for run in content["benchmarks"]:
        count = run["extra_info"].get("newton_iterations")
        if count is not None:
            name = run["name"].removeprefix("test_").replace("_", " ")
            text += f"- Newton iterations, {name}: {count}\n"
    return text


def main(source: Path, output: Path | None = None) -> None:
    """Print the page and write it."""
    text = page(json.loads(source.read_text()))
    print(text)
    if output is not None:
        with atomic_path(output) as path:
            path.write_text(text)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
