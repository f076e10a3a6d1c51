"""The page of the benchmarks: medians, ratios, growth, the whole study, the mesh, thin sheets.

Usage: ``python benchmarks/report.py FOLDER PAGE.md`` writes the page from the JSON files of the
benchmarks in a folder.
"""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.results.files import atomic_path

TEXT = """# Speed

Made by `make bench`; do not edit. Only ratios mean something on another machine ({machine},
{cores} cores).

## Parts of the solver

Medians in milliseconds on one thread at L/W = 2, t/W = 1e-3, strain 0.12, in brackets the ratio to
the numeric factorisation of the tangent on the same mesh, and the exponent of the growth with the
number of cells. The tangent of Newton's method takes its stresses from the last step
(`problem.py`). The branch has 20 strains from 0.02 to 0.40, flat states and modes included.

"""

STUDY = """## The whole study

`config.yaml` from nothing: {wall:.0f} s on {cores} cores, {cpu:.0f} s of CPU time, of which
{solving:.0f} s solve (flat states, eigenproblems, wrinkled states); **{overhead:.0%} of the CPU
time is overhead**: {jobs} starts of Python with the imports of numpy, scipy and scikit-fem, files,
tables, figures, snakemake. The largest job takes {peak_mb_of_a_job:.0f} MB.

"""

STARTS = """What a process costs that imports what a job of a wrinkled state needs, and then ends
(medians, measured after the study):

"""

SHARE = """
The jobs of flat and of wrinkled states, {jobs} of them, start for {seconds:.0f} s. Without any
other job, without files and without snakemake that alone is {share:.0%} of the CPU time beside the
{solving:.0f} s of solving. Only processes that serve several cases could get below it.

"""

MESH = """## The default mesh

Error against time, one number of the mesh changed at a time; {cases} cases that stand for the whole
study. The error of A is in parts of the largest A of the sheet (A itself vanishes at decay), both
errors against {finest} cells; the time is CPU seconds of all cases on one thread. Allowed are
{allowed_a:.1%} in A and {allowed_tau:.1%} in tau_1.

"""

THIN = """## Thin sheets

One wrinkled state each at L/W = 2 and strain {strain:g}, from the flat state alone (no path through
thicker sheets), CPU seconds on one thread.

"""

ALLOWED = 5e-3, 1e-3  # error of A/t and of tau_1 that the default mesh must hold


def markdown(rows: list[list[str]]) -> str:
    """Return rows as a Markdown table, the first with the headings."""
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    lines.insert(1, "|---" * len(rows[0]) + "|")
    return "\n".join(lines) + "\n\n"


def parts(runs: list[dict[str, Any]]) -> list[list[str]]:
    """Return the table of the solver's parts."""
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


def solver(content: dict[str, Any]) -> str:
    """Return the section on the solver."""
    text = markdown(parts(content["benchmarks"]))
    for run in content["benchmarks"]:
        count = run["extra_info"].get("newton_iterations")
        if count is not None:
            name = run["name"].removeprefix("test_").replace("_", " ")
            text += f"- Newton iterations, {name}: {count}\n"
    return text + "\n"


def study(content: dict[str, Any]) -> str:
    """Return the section on the whole study."""
    jobs = sum(stage["jobs"] for stage in content["stages"].values())
    text = STUDY.format(**content | {"jobs": round(jobs)})
    rows = [["stage", "jobs", "CPU seconds", "solving"]]
    for name, stage in content["stages"].items():
        rows.append([name, f"{stage['jobs']:.0f}", f"{stage['job']:.1f}", f"{stage['solve']:.1f}"])
    return text + markdown(rows) + starts(content)


def starts(content: dict[str, Any]) -> str:
    """Say what the start of a job costs, and what share of the study such starts are."""
    rows, last = [["start of a job", "CPU seconds"]], 0.0
    for part in content["starts"]:
        name = f"+ {part['imports']}" if last else part["imports"]
        rows.append([name, f"{part['seconds'] - last:.3f}"])
        last = part["seconds"]
    rows.append(["together", f"{last:.3f}"])
    jobs = sum(content["stages"][stage]["jobs"] for stage in ("planar", "wrinkle"))
    seconds, solving = jobs * last, content["solving"]
    share = seconds / (seconds + solving)
    text = SHARE.format(jobs=round(jobs), seconds=seconds, share=share, solving=solving)
    return STARTS + markdown(rows).rstrip() + "\n" + text


def mesh(content: dict[str, Any]) -> str:
    """Return the section on the default mesh."""
    finest, rows = content["finest"], content["rows"]
    text = MESH.format(
        cases=content["cases"],
        finest=f"{finest['cells_along']} x {finest['cells_across']}",
        allowed_a=ALLOWED[0],
        allowed_tau=ALLOWED[1],
    )
    table = [["varied", "cells", "grading", "seconds", "error of A", "error of tau_1", "holds"]]
    for row in rows:
        table.append(
            [
                row["part"],
                f"{row['along']} x {row['across']}",
                f"{row['grading']:g}",
                f"{row['seconds']:.1f}",
                f"{row['error_amplitude']:.2%} ({row['error_amplitude_at']})",
                f"{row['error_tau']:.3%} ({row['error_tau_at']})",
                "yes" if _holds(row) else "no",
            ]
        )
    return text + markdown(table) + _choice(rows)


def _holds(row: dict[str, Any]) -> bool:
    return bool(row["error_amplitude"] <= ALLOWED[0] and row["error_tau"] <= ALLOWED[1])


def _choice(rows: list[dict[str, Any]]) -> str:
    """Say how the default mesh compares with the cheapest that holds."""
    default = MeshSettings()
    numbers = (default.cells_along, default.cells_across, default.grading)
    own = next(r for r in rows if (r["along"], r["across"], r["grading"]) == numbers)
    cheapest = min(filter(_holds, rows), key=lambda row: row["seconds"])
    return (
        f"Default: {own['along']} x {own['across']}, grading {own['grading']:g}; the cheapest here "
        f"that holds: {cheapest['along']} x {cheapest['across']}, grading "
        f"{cheapest['grading']:g}, at {cheapest['seconds'] / own['seconds']:.2f} of the time.\n\n"
    )


def thin(content: dict[str, Any]) -> str:
    """Return the section on thin sheets."""
    rows = [
        [
            "t/W", "cells", "unknowns", "status", "A/t", "lambda/W", "cells per wavelength",
            "Newton iterations", "planar state", "wrinkled state", "peak memory",
        ]
    ]  # fmt: skip
    for sheet in content["sheets"]:
        along, across = sheet["cells"]
        rows.append(
            [
                f"{sheet['thickness']:g}",
                f"{along} x {across}",
                str(sheet["unknowns"]),
                sheet["status"],
                f"{sheet['amplitude_over_thickness']:.2f}",
                f"{sheet['wavelength']:.4f}",
                f"{sheet['cells_per_wavelength']:.1f}",
                str(sheet["newton_iterations"]),
                f"{sheet['planar_seconds']:.1f} s",
                f"{sheet['wrinkle_seconds']:.1f} s",
                f"{sheet['peak_mb']:.0f} MB",
            ]
        )
    return THIN.format(strain=content["strain"]) + markdown(rows)


def main(folder: Path, output: Path) -> None:
    """Write the page and print it."""
    found = {name: json.loads((folder / f"{name}.json").read_text()) for name in SECTIONS}
    machine = found["solver"]["machine_info"]["cpu"].get("brand_raw", "unknown processor")
    text = TEXT.format(machine=machine, cores=found["study"]["cores"])
    text += "".join(section(found[name]) for name, section in SECTIONS.items())
    with atomic_path(output) as path:
        path.write_text(text.rstrip() + "\n")
    print(text)


SECTIONS = {"solver": solver, "study": study, "mesh": mesh, "thin": thin}

if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
