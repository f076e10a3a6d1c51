"""Time of tangent plus residual against the factorisation of the same matrix, on one thread.

    python benchmarks/assembly.py [--repeats 15] [--refine 1]

Prints medians in milliseconds and the ratio to the numeric factorisation.
"""

import argparse
import os
from statistics import median
from time import perf_counter

for name in ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ[name] = "1"

from wrinklestudy import planar, wrinkle  # noqa: E402 (after the number of threads is set)
from wrinklestudy.fem.linear import make_solver  # noqa: E402
from wrinklestudy.fem.space import Space  # noqa: E402
from wrinklestudy.material.laws import mooney_rivlin  # noqa: E402
from wrinklestudy.mesh import MeshSettings, make_grid  # noqa: E402


def main() -> None:
    """Time the parts in turn, so that a change of the machine's speed falls on all of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeats", type=int, default=15)
    parser.add_argument("--refine", type=int, default=1, help="factor on the cells each way")
    arguments = parser.parse_args()
    settings = MeshSettings(24 * arguments.refine, 36 * arguments.refine)
    space = Space(make_grid(2.0, settings=settings))
    flat = planar.solve(space, mooney_rivlin(6.21e4, 1.58e5), 0.12)
    state = wrinkle.solve(flat, 1e-3)
    problem = wrinkle.PlateProblem(flat.flat, flat.modes, 1e-3)
    unknowns = state.position[problem.assembler.free]
    solver = make_solver()
    _, residual, tangent = problem.derivatives(unknowns)
    solver.factorise(tangent)  # the symbolic part is done once for all Newton iterations
    times: dict[str, list[float]] = {"assembly": [], "factorisation": [], "solve": []}
    for _ in range(arguments.repeats):
        start = perf_counter()
        _, residual, tangent = problem.derivatives(unknowns)
        assembled = perf_counter()
        solver.factorise(tangent)
        factorised = perf_counter()
        solver.solve(residual)
        times["assembly"].append(assembled - start)
        times["factorisation"].append(factorised - assembled)
        times["solve"].append(perf_counter() - factorised)
    unit = median(times["factorisation"])
    print(f"{type(solver).__name__}, {residual.size} unknowns, {arguments.repeats} repeats")
    for part, seconds in times.items():
        print(f"{part:14} {1e3 * median(seconds):8.1f} ms  {median(seconds) / unit:6.2f}")


if __name__ == "__main__":
    main()
