"""Print medians of a benchmark run, ratios to the factorisation and growth with the mesh.

python benchmarks/report.py results/bench/solver.json
"""

import json
import sys
from pathlib import Path

import numpy as np


def main(path: Path) -> None:
    """Print one line for each part: milliseconds and ratio for each mesh, and the exponent."""
    runs = json.loads(path.read_text())["benchmarks"]
    cells = sorted({run["extra_info"]["cells"] for run in runs})
    table: dict[str, dict[int, float]] = {}
    for run in runs:
        name = run["name"].split("[")[0].removeprefix("test_")
        table.setdefault(name, {})[run["extra_info"]["cells"]] = run["stats"]["median"]
    unit = table["factorisation"]
    print(f"{'median ms (ratio)':24}" + "".join(f"{n:>9} cells    " for n in cells) + "   exponent")
    for name, medians in table.items():
        row = f"{name:24}"
        for n in cells:
            if n in medians:
                row += f"{1e3 * medians[n]:10.1f} ({medians[n] / unit[n]:6.2f})"
            else:
                row += " " * 19
        if len(medians) > 1:
            sizes = np.log([n for n in cells if n in medians])
            times = np.log([medians[n] for n in cells if n in medians])
            row += f"  cells^{np.polyfit(sizes, times, 1)[0]:.2f}"
        print(row)
    for run in runs:
        if "newton_iterations" in run["extra_info"]:
            print(f"{run['name']}: Newton iterations {run['extra_info']['newton_iterations']}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
