"""Compute the tables of the solid anew: `make verify-solid` (some ten minutes on one core)."""

import datetime
from importlib.metadata import version

from verification.tools.solid_table import (
    ENDS,
    STATES,
    STRAINS,
    append,
    end_cases,
    solve_ends,
    solve_state,
    state_cases,
)

_PACKAGES = ("felupe", "numpy", "scipy")


def main() -> None:
    """Write both tables, a row as soon as it is known."""
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
