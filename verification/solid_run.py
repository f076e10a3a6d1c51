"""Compute the tables of the solid anew: `make verify-solid` (some ten minutes on one core)."""

import csv
import datetime
from importlib.metadata import version

import pandas as pd

from verification.groups.solid import SHEETS, estimate
from verification.tools.solid_table import (
    ENDS,
    MATERIALS,
    STATES,
    STRAINS,
    append,
    end_cases,
    solve_ends,
    solve_state,
    state_cases,
)
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.studies.panaitescu2019.solid import COLUMNS, FILE
from wrinklestudy.typing import AnyPath

_PACKAGES = ("felupe", "numpy", "scipy")


def write_best(ends: pd.DataFrame, path: AnyPath) -> None:
    """Write birth and decay of the paper's sheet, extrapolated, where the study reads them."""
    material, thickness = SHEETS[0]
    law = MATERIALS[material].law.physical(MATERIALS[material].shear_modulus)
    newest = ends.sort_values("date").iloc[-1]
    with (
        atomic_path(path) as target,
        open(target, "w", newline="", encoding="utf-8") as file,
    ):
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for end in ("birth", "decay"):
            best = estimate(ends, end, SHEETS[0])
            numbers = (best.strain, best.bar, 2.0, thickness, law["c10"], law["c01"])
            texts = (f"{number:.6g}" for number in numbers)
            writer.writerow((end, *texts, newest["date"], newest["felupe"]))


def main() -> None:
    """Write both tables, a row as soon as it is known, then the file of the study."""
    today = datetime.datetime.now(tz=datetime.UTC).date().isoformat()
    stamp = {"date": today, **{name: version(name) for name in _PACKAGES}}
    ENDS.unlink(missing_ok=True)
    for case in end_cases():
        birth, decay = solve_ends(case)
        values = {"birth": birth.strain, "decay": decay.strain}
        values |= {f"birth_{name}": getattr(birth, name) for name in ("before", "after", "corner")}
        values |= {f"decay_{name}": getattr(decay, name) for name in ("before", "after", "corner")}
        append(ENDS, case, values, stamp)
        print(f"{case}: birth {birth.strain:.5f}, decay {decay.strain:.5f}", flush=True)
    write_best(pd.read_csv(ENDS), FILE)
    STATES.unlink(missing_ok=True)
    plates = {strain: state_cases()[0].plate().solve(strain) for strain in STRAINS}
    for case in state_cases():
        sheet = case.sheet()
        for strain, plate in plates.items():
            values = {"strain": strain} | solve_state(sheet, plate)
            append(STATES, case, values, stamp)
            print(f"{case}: strain {strain:g}, {values}", flush=True)


if __name__ == "__main__":
    main()
