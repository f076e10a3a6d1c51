"""Time `stability` over a grid of awkward sheets, each in a process of its own with one thread.

Usage: python benchmarks/bench_stability.py [--quick] [table.csv]
"""

import csv
import itertools
import multiprocessing
import sys
from concurrent.futures import ProcessPoolExecutor
from time import process_time
from typing import NamedTuple

from wrinklestudy.mechanics.bending import BENDING_LAWS
from wrinklestudy.mechanics.laws import (
    Material,
    mooney_rivlin,
    neo_hookean,
    ogden,
    saint_venant_kirchhoff,
    yeoh,
)
from wrinklestudy.sheet import Sheet
from wrinklestudy.vocabulary import PARITIES, Parity

MATERIALS: dict[str, Material] = {
    "mooney-rivlin": mooney_rivlin(6.21e4, 1.58e5),
    "mooney-rivlin 10:1": mooney_rivlin(1.0e5, 1.0e4),
    "neo-hookean": neo_hookean(1.0e5),
    # Fitted to data/treloar1944.csv
    "yeoh": yeoh(184702.0, -1464.56, 40.215),
    "ogden": ogden(4939.63, 4.45149, -1.67034e6, -0.464803),
    **{
        f"svk {poisson:g}": saint_venant_kirchhoff(1e6, poisson)
        for poisson in (0.0, 1e-6, 0.01, 0.1, 0.3, 0.5)
    },
}
ASPECTS = (1.0, 1.2, 1.5, 2.0, 3.0, 5.0, 8.0)
THICKNESSES = (1e-4, 5e-4, 1e-3)
SHOWN = 10


class Timed(NamedTuple):
    """One sheet, what became of it, and the CPU seconds that took."""

    material: str
    bending: str
    parity: str
    aspect: float
    thickness: float
    seconds: float
    evaluations: int
    answer: str


def timed(name: str, bending: str, parity: Parity, aspect: float, thickness: float) -> Timed:
    """Return how long the limits of one sheet take, and what they are."""
    calls: list[float] = []
    start = process_time()
    sheet = Sheet(aspect, thickness, MATERIALS[name], bending, parity)
    try:
        limits = sheet.stability(lambda strain, _: calls.append(strain))
        ranges = " and ".join(
            f"{birth:.5f} to {'the end' if decay is None else f'{decay:.5f}'}"
            for birth, decay in limits.ranges
        )
        answer = f"{ranges or 'never'}; {limits.max_critical_thickness:.4e} at "
        answer += f"{limits.strain_at_max:.4f}; {limits.reason or 'to strain 1'}"
    except ArithmeticError as error:
        answer = str(error)
    seconds = process_time() - start
    return Timed(name, bending, parity, aspect, thickness, seconds, len(calls), answer)


def main(arguments: list[str]) -> None:
    """Time all sheets, or the longest and thinnest alone, and print the slowest."""
    quick = "--quick" in arguments
    outputs = [argument for argument in arguments if not argument.startswith("--")]
    aspects, thicknesses = (ASPECTS[-1:], THICKNESSES[:1]) if quick else (ASPECTS, THICKNESSES)
    sheets = itertools.product(MATERIALS, BENDING_LAWS, PARITIES, aspects, thicknesses)
    rows = []
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, context, max_tasks_per_child=1) as pool:
        for row in pool.map(timed, *zip(*sheets, strict=True)):
            rows.append(row)
            print(*row, sep="  ", file=sys.stderr, flush=True)
    for output in outputs:
        with open(output, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([Timed._fields, *rows])
    rows.sort(key=lambda row: -row.seconds)
    print(f"{len(rows)} sheets, CPU seconds of the {SHOWN} slowest:")
    for row in rows[:SHOWN]:
        print(*row, sep="  ")


if __name__ == "__main__":
    main(sys.argv[1:])
