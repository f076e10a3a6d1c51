"""Error against time of the mesh: cells along, cells across and grading, one at a time.

Usage: ``python benchmarks/bench_mesh.py RUN.json``, by `make bench`. The cases stand for the whole
study: each sheet at its smallest and largest wrinkled strain and near its peak. The error is that
of A, in parts of the largest A of the sheet (near decay A itself vanishes), and of tau_1 against a
mesh with 5/3 of the default cells in each direction, the time CPU seconds of all cases on one
thread.
"""

import os
import sys
import time
from typing import Any, NamedTuple

for _name in ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ[_name] = "1"

from wrinklestudy.equilibrium.planar import PlanarSettings  # noqa: E402
from wrinklestudy.equilibrium.planar import solve as solve_planar  # noqa: E402
from wrinklestudy.equilibrium.wrinkled import solve  # noqa: E402
from wrinklestudy.fem.grid import MeshSettings, make_grid  # noqa: E402
from wrinklestudy.fem.space import Space  # noqa: E402
from wrinklestudy.files.storage import write_json  # noqa: E402
from wrinklestudy.mechanics.laws import Material, mooney_rivlin, neo_hookean, saint_venant_kirchhoff  # noqa: E402
from wrinklestudy.metrics.interpolant import DeformedSheet  # noqa: E402
from wrinklestudy.metrics.measure import measure_sheet  # noqa: E402

LATEX = mooney_rivlin(6.21e4, 1.58e5)
NEO_HOOKEAN, SVK = neo_hookean(2.2e5), saint_venant_kirchhoff(1.0e6)


class Sheet(NamedTuple):
    """A sheet of the study with some of its strains."""

    material: Material
    aspect: float
    thickness: float
    strains: tuple[float, ...]
    settings: PlanarSettings = PlanarSettings()


SHEETS = {
    "latex": Sheet(LATEX, 2.0, 1.0e-3, (0.04, 0.12, 0.3, 0.38)),
    "L/W 1.8": Sheet(LATEX, 1.8, 1.0e-3, (0.04, 0.4)),
    "L/W 2.5": Sheet(LATEX, 2.5, 1.0e-3, (0.04, 0.1, 0.28)),
    "L/W 3": Sheet(LATEX, 3.0, 1.0e-3, (0.08, 0.12, 0.18)),
    "t/W 5e-4": Sheet(LATEX, 2.0, 5.0e-4, (0.02, 0.12, 0.5)),
    "t/W 1.4e-3": Sheet(LATEX, 2.0, 1.4e-3, (0.08, 0.2)),
    "neo-Hookean": Sheet(NEO_HOOKEAN, 2.0, 1.0e-3, (0.04, 0.1, 0.26)),
    "SVK": Sheet(SVK, 2.0, 1.0e-3, (0.03, 0.06, 0.12)),
    "fvk": Sheet(LATEX, 2.0, 1.0e-3, (0.12, 0.5), PlanarSettings(bending="fvk")),
}
DEFAULT = MeshSettings()
FINEST = MeshSettings(40, 60, DEFAULT.grading)
MESHES = {
    "cells along": [MeshSettings(n, 36, 1.5) for n in (12, 16, 20, 24, 30)],
    "cells across": [MeshSettings(24, n, 1.5) for n in (24, 28, 32, 36, 42)],
    "grading": [MeshSettings(24, 36, p) for p in (1.0, 1.25, 1.5, 1.75, 2.0)],
    "both": [MeshSettings(16, 32, 1.5), MeshSettings(16, 36, 1.75), MeshSettings(20, 32, 1.5)],
}


def amplitudes(mesh: MeshSettings) -> dict[str, tuple[float, float]]:
    """Return A/t and tau_1/W of all cases on one mesh."""
    values = {}
    for name, sheet in SHEETS.items():
        space = Space(make_grid(sheet.aspect, sheet.thickness, mesh))
        for strain in sheet.strains:
            planar = solve_planar(space, sheet.material, strain, sheet.settings)
            state = solve(planar, sheet.thickness)
            if state.status != "wrinkled" or state.position is None or planar.modes is None:
                raise ArithmeticError(f"{name}, strain {strain:g}: {state.status} {state.reason}")
            nodes = space.nodes_from_field(state.position)
            profile = measure_sheet(DeformedSheet(space.grid, nodes, sheet.settings.symmetry))
            tau = planar.modes.critical_thickness
            values[f"{name} at {strain:g}"] = profile.amplitude / sheet.thickness, tau
    return values


def run() -> list[dict[str, Any]]:
    """Return one row for each mesh with its largest errors and its time."""
    reference = amplitudes(FINEST)
    known: dict[MeshSettings, dict[str, Any]] = {}
    rows = []
    for part, meshes in MESHES.items():
        for mesh in meshes:
            if mesh not in known:
                known[mesh] = errors(mesh, reference)
            rows.append({"part": part, **known[mesh]})
            print(rows[-1], flush=True)
    return rows


def errors(mesh: MeshSettings, reference: dict[str, tuple[float, float]]) -> dict[str, Any]:
    """Return the largest errors of a mesh in parts of the reference, where, and the CPU time."""
    start = time.process_time()
    values = amplitudes(mesh)
    seconds = time.process_time() - start
    peaks: dict[str, float] = {}
    for name, (amplitude, _) in reference.items():
        sheet = name.split(" at ")[0]
        peaks[sheet] = max(peaks.get(sheet, 0.0), amplitude)
    of_a = {n: abs(a - reference[n][0]) / peaks[n.split(" at ")[0]] for n, (a, _) in values.items()}
    of_tau = {n: abs(tau / reference[n][1] - 1.0) for n, (_, tau) in values.items()}
    return {
        "along": mesh.cells_along,
        "across": mesh.cells_across,
        "grading": mesh.grading,
        "seconds": seconds,
        "error_amplitude": max(of_a.values()),
        "error_amplitude_at": max(of_a, key=of_a.__getitem__),
        "error_tau": max(of_tau.values()),
        "error_tau_at": max(of_tau, key=of_tau.__getitem__),
    }


if __name__ == "__main__":
    cases = sum(len(sheet.strains) for sheet in SHEETS.values())
    write_json(sys.argv[1], {"finest": vars(FINEST), "cases": cases, "rows": run()})
