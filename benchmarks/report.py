"""The page of the benchmarks: medians, ratios, growth, the whole study, the mesh, thin sheets.

Usage: ``python benchmarks/report.py FOLDER PAGE.md`` writes the page from the JSON files of the
benchmarks in a folder.
"""

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.study.pages import number, render

TEMPLATES = Path(__file__).parent / "templates"
FILES = ("solver", "study", "mesh", "thin")
ALLOWED = 5e-3, 1e-3  # error of A/t and of tau_1 that the default mesh must hold

# Headings and rows of a table
PageTable = tuple[Sequence[str], Sequence[Sequence[str]]]


def page(contents: dict[str, dict[str, Any]]) -> str:
    """Return the page from the content of `FILES`; the same content gives the same text."""
    solver, study, mesh, thin = (contents[name] for name in FILES)
    jobs = sum(stage["jobs"] for stage in study["stages"].values())
    return render(
        "performance.md.j2",
        TEMPLATES,
        machine=solver["machine_info"]["cpu"].get("brand_raw", "unknown processor"),
        solver={"parts": parts(solver["benchmarks"]), "iterations": iterations(solver)},
        study=study | {"jobs": round(jobs), "stages": stages(study["stages"])},
        starts=starts(study),
        mesh={
            "cases": mesh["cases"],
            "finest": "{cells_along} x {cells_across}".format(**mesh["finest"]),
            "allowed": ALLOWED,
            "table": meshes(mesh["rows"]),
            "choice": choice(mesh["rows"]),
        },
        thin={"strain": thin["strain"], "table": thin_sheets(thin["sheets"])},
    )


def parts(runs: Sequence[dict[str, Any]]) -> PageTable:
    """Return the table of the solver's parts."""
    cells = sorted({run["extra_info"]["cells"] for run in runs})
    medians: dict[str, dict[int, float]] = {}
    for run in runs:
        name = _name(run).split("[")[0]
        medians.setdefault(name, {})[run["extra_info"]["cells"]] = run["stats"]["median"]
    unit = medians["factorisation"]
    rows = []
    for name, times in medians.items():
        shown = [
            f"{1e3 * times[n]:.1f} ({times[n] / unit[n]:.2f})" if n in times else "" for n in cells
        ]
        growth = ""
        if len(times) > 1:
            sizes = np.log(sorted(times))
            exponent = np.polyfit(sizes, np.log([times[n] for n in sorted(times)]), 1)[0]
            growth = f"cells^{exponent:.2f}"
        rows.append([name, *shown, growth])
    return ["part", *(f"{n} cells" for n in cells), "growth"], rows


def iterations(content: dict[str, Any]) -> list[tuple[str, Any]]:
    """Return the Newton iterations of the benchmarks that count them, by name."""
    return [
        (_name(run), run["extra_info"]["newton_iterations"])
        for run in content["benchmarks"]
        if run["extra_info"].get("newton_iterations") is not None
    ]


def _name(run: dict[str, Any]) -> str:
    return str(run["name"]).removeprefix("test_").replace("_", " ")


def stages(content: dict[str, dict[str, float]]) -> PageTable:
    """Return the table of the study's stages."""
    rows = [
        [name, f"{stage['jobs']:.0f}", f"{stage['job']:.1f}", f"{stage['solve']:.1f}"]
        for name, stage in content.items()
    ]
    return ("stage", "jobs", "CPU seconds", "solving"), rows


def starts(content: dict[str, Any]) -> dict[str, Any]:
    """Return what the start of a job costs, and what share of the study such starts are."""
    rows, last = [], 0.0
    for part in content["starts"]:
        name = f"+ {part['imports']}" if last else part["imports"]
        rows.append([name, f"{part['seconds'] - last:.3f}"])
        last = part["seconds"]
    rows.append(["together", f"{last:.3f}"])
    jobs = sum(content["stages"][stage]["jobs"] for stage in ("planar", "wrinkle"))
    seconds = jobs * last
    return {
        "parts": (("start of a job", "CPU seconds"), rows),
        "jobs": round(jobs),
        "seconds": seconds,
        "share": seconds / (seconds + content["solving"]),
    }


def meshes(rows: Sequence[dict[str, Any]]) -> PageTable:
    """Return the table of the meshes that were tried."""
    columns = ("varied", "cells", "grading", "seconds", "error of A", "error of tau_1", "holds")
    return columns, [
        [
            row["part"],
            _mesh(row),
            f"{row['grading']:g}",
            f"{row['seconds']:.1f}",
            f"{row['error_amplitude']:.2%} ({row['error_amplitude_at']})",
            f"{row['error_tau']:.3%} ({row['error_tau_at']})",
            "yes" if _holds(row) else "no",
        ]
        for row in rows
    ]


def _mesh(row: dict[str, Any]) -> str:
    return f"{row['along']} x {row['across']}"


def _holds(row: dict[str, Any]) -> bool:
    return bool(row["error_amplitude"] <= ALLOWED[0] and row["error_tau"] <= ALLOWED[1])


def choice(rows: Sequence[dict[str, Any]]) -> str:
    """Say whether the default mesh holds the errors, and how it compares with the cheapest."""
    default = MeshSettings()
    numbers = (default.cells_along, default.cells_across, default.grading)
    own = next(r for r in rows if (r["along"], r["across"], r["grading"]) == numbers)
    holds = "holds both" if _holds(own) else "does not hold them"
    text = f"Default: {_mesh(own)}, grading {own['grading']:g}, which {holds}; "
    holding = [row for row in rows if _holds(row)]
    if not holding:
        return f"{text}no mesh that was tried holds both."
    cheapest = min(holding, key=lambda row: row["seconds"])
    return (
        f"{text}the cheapest here that holds: {_mesh(cheapest)}, grading "
        f"{cheapest['grading']:g}, at {cheapest['seconds'] / own['seconds']:.2f} of the time."
    )


def thin_sheets(sheets: Sequence[dict[str, Any]]) -> PageTable:
    """Return the table of thin sheets."""
    columns = (
        "t/W", "cells", "unknowns", "status", "A/t", "lambda/W", "cells per wavelength",
        "Newton iterations", "planar state", "wrinkled state", "peak memory",
    )  # fmt: skip
    return columns, [
        [
            f"{sheet['thickness']:g}",
            " x ".join(map(str, sheet["cells"])),
            str(sheet["unknowns"]),
            sheet["status"],
            number(sheet["amplitude_over_thickness"], ".2f"),
            number(sheet["wavelength"], ".4f"),
            number(sheet["cells_per_wavelength"], ".1f"),
            str(sheet["newton_iterations"]),
            f"{sheet['planar_seconds']:.1f} s",
            f"{sheet['wrinkle_seconds']:.1f} s",
            f"{sheet['peak_mb']:.0f} MB",
        ]
        for sheet in sheets
    ]


def main(folder: Path, output: Path) -> None:
    """Write the page and print it."""
    text = page({name: json.loads((folder / f"{name}.json").read_text()) for name in FILES})
    with atomic_path(output) as path:
        path.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
