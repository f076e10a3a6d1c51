"""The data dictionary: what each column holds, as a page of the docs.

``python -m wrinklestudy.results.dictionary docs/columns.md`` writes it from the row types.
"""

import sys
from collections.abc import Iterable, Mapping, Sequence

from wrinklestudy.files.storage import atomic_path
from wrinklestudy.results.rows import Column, columns
from wrinklestudy.results.tables import (
    COMPRESSION_COLUMNS,
    IMPERFECTION_COLUMNS,
    MAP_COLUMNS,
    PEAK_COLUMNS,
    STABILITY_COLUMNS,
    STATE_COLUMNS,
    TENSION_COLUMNS,
)
from wrinklestudy.results.whole import WholeRow

_KINDS = {str: "text", int: "whole number", float: "number"}

_HEAD = """# Columns of the tables

Written by `python -m wrinklestudy.results.dictionary docs/columns.md` from the row types in
`wrinklestudy/results/rows.py`; a test keeps it in step. Lengths are in units of the width W, with L
the length and t the thickness of the undeformed sheet; mu is the initial shear modulus. x runs
along the pull, y across, both from the centre: x = 0 is the line half-way between the clamps.

The tables are CSV files with one header line, sorted by the columns marked *key*. Numbers have all
their digits. An empty cell means that there is no such number: a flat state has no wavelength, a
state that did not converge has no measures, a sheet that never wrinkles has no birth strain.
"""

_STATES = """
## States

`results/metrics/{material}/aspect{aspect}_thickness{thickness}.csv` (one sheet) and
`results/summary/states.csv` (all), one row per state. Columns marked *file* are also
attributes of the wrinkle file of the state, with NaN where there is no number; for a state that did
not converge these are the numbers of the last iterate. Columns marked *json* are what
`wrinklestudy solve --json` and `State.as_dict()` give, together with `seconds`, the wall time of
the solve.
"""

_WHOLE = """
## Sheets without mirrors

What `wrinklestudy solve --json` prints of a sheet with imperfections or with another `--symmetry`
than a quarter, for each strain.
"""

_STABILITY = """
## Stability

`results/summary/stability.csv`, one row per sheet. The JSON files of the stability stage have the
same keys, among others.
"""

_PEAKS = """
## Peaks

`results/summary/peaks.csv`, one row per sheet. A maximum is taken from a smooth curve through
the states, birth and decay, so that it may lie between them; it is unknown if a state beside it did
not converge.
"""

_MAP = """
## Map

`results/map/{material}/aspect{aspect}.csv`, one row per strain and parity. In units of L the
critical thickness is tau_1/W divided by L/W. Columns marked *json* are what
`wrinklestudy map --json` gives.
"""

_TENSION = """
## Tension

`results/tension/{material}/aspect{aspect}.csv`, one row per strain. Columns marked *json* are what
`wrinklestudy tension-field --json` gives.
"""

_COMPRESSION = """
## Compression

`results/compression/{material}/aspect{aspect}.csv`, one row per strain.
"""

_IMPERFECTION = """
## Imperfection

`results/imperfection/{material}/aspect{aspect}_thickness{thickness}/{imperfection}.csv`, one row
per strain; birth, decay and windows are those of the sheet.
"""


def page() -> str:
    """Return the data dictionary as Markdown."""
    files = {name for name, column in STATE_COLUMNS.items() if not column.measured}
    blocks = [
        _HEAD,
        _STATES,
        *_table(STATE_COLUMNS, files),
        _STABILITY,
        *_table(STABILITY_COLUMNS),
        _PEAKS,
        *_table(PEAK_COLUMNS),
        _MAP,
        *_table(MAP_COLUMNS),
        _TENSION,
        *_table(TENSION_COLUMNS),
        _COMPRESSION,
        *_table(COMPRESSION_COLUMNS),
        _IMPERFECTION,
        *_table(IMPERFECTION_COLUMNS),
        _WHOLE,
        *_table(columns(WholeRow)),
    ]
    return "".join(blocks)


def _table(columns: Mapping[str, Column], files: Iterable[str] = ()) -> list[str]:
    lines = ["\n| column | is | unit | | what |\n", "|---|---|---|---|---|\n"]
    for name, column in columns.items():
        marks = {"key": column.identifies, "file": name in files, "json": column.shown}
        kind = f"{_KINDS[column.kind]}{' or empty' if column.optional else ''}"
        text = column.description.replace("|", "\\|")
        which = ", ".join(mark for mark, holds in marks.items() if holds)
        lines.append(f"| `{name}` | {kind} | {column.unit} | {which} | {text} |\n")
    return lines


def main(arguments: Sequence[str]) -> None:
    """Write the data dictionary to the path given."""
    (output,) = arguments
    with atomic_path(output) as path:
        path.write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
