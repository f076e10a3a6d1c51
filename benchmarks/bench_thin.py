"""Time and peak memory of far thinner sheets than those of the study, each in its own process.

Usage: ``python benchmarks/bench_thin.py RUN.json``, by `make bench`. The mesh has the default
number of cells for each wavelength across the sheet; one thread.
"""

import json
import os
import resource
import subprocess
import sys
import time
from typing import Any

from wrinklestudy.files.storage import write_json

STRAIN = 0.1
THICKNESSES = (1.0e-3, 1.0e-4, 2.0e-5, 1.0e-5)


def solve(thickness: float) -> dict[str, Any]:
    """Solve one sheet and say what it took."""
    from wrinklestudy.equilibrium import newton, planar, wrinkled
    from wrinklestudy.fem.boundary import QUARTER
    from wrinklestudy.fem.grid import make_grid
    from wrinklestudy.fem.space import Space
    from wrinklestudy.mechanics.laws import mooney_rivlin
    from wrinklestudy.metrics.interpolant import DeformedSheet
    from wrinklestudy.metrics.measure import measure_sheet

    start = time.process_time()
    space = Space(make_grid(2.0, thickness))
    flat = planar.solve(space, mooney_rivlin(6.21e4, 1.58e5), STRAIN)
    middle = time.process_time()
    state = wrinkled.solve(flat, thickness)
    end = time.process_time()
    if state.position is None:
        raise ArithmeticError(f"t/W = {thickness:g}: {state.reason}")
    nodes = space.nodes_from_field(state.position)
    profile = measure_sheet(DeformedSheet(space.grid, nodes, QUARTER))
    return {
        "thickness": thickness,
        "cells": space.grid.cells,
        "unknowns": int(QUARTER.free(space).sum()),
        "status": state.status,
        "amplitude_over_thickness": profile.amplitude / thickness,
        "wavelength": profile.wavelength,
        "cells_per_wavelength": 2.0 * space.grid.cells[1] * profile.wavelength,
        "newton_iterations": newton.count(state.history),
        "planar_seconds": middle - start,
        "wrinkle_seconds": end - middle,
        "peak_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    }


def main(target: str) -> None:
    """Write all sheets as JSON; with a number instead of a file name print that one sheet."""
    try:
        thickness = float(target)
    except ValueError:
        sheets = []
        for value in THICKNESSES:
            command = [sys.executable, __file__, str(value)]
            done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
            print(done.stdout, end="", flush=True)
            sheets.append(json.loads(done.stdout))
        write_json(target, {"strain": STRAIN, "sheets": sheets})
    else:
        print(json.dumps(solve(thickness)))


if __name__ == "__main__":
    for name in ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ[name] = "1"
    main(sys.argv[1])
