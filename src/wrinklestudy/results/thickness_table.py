"""Measured thicknesses of a sheet, read from a file."""

from os import fspath

import numpy as np

from wrinklestudy.fem.thickness import ThicknessTable
from wrinklestudy.files.number_table import NumberColumn, read_number_table
from wrinklestudy.typing import AnyPath
from wrinklestudy.vocabulary import Limits

_PLACE = Limits(-50.0, 50.0, unit="from the centre, over W")
_THICKNESS = Limits(0.0, above_lowest=True)
_COLUMNS = (
    NumberColumn("x", {"x": 1.0}, _PLACE),
    NumberColumn("y", {"y": 1.0}, _PLACE),
    NumberColumn("thickness", {"thickness": 1.0}, _THICKNESS),
)


def read_thickness_table(path: AnyPath) -> ThicknessTable:
    """Return the thicknesses of a CSV file with the columns x, y and thickness.

    The rows are all combinations of some x and some y, in any order. The unit of the thickness does
    not matter.

    Raises
    ------
    ValueError
        If the file is no such table; one line that names it.
    """
    table = read_number_table(path, _COLUMNS)
    x, y = (np.unique(table.numbers[name]) for name in ("x", "y"))
    values = np.full((len(x), len(y)), np.nan)
    place = (
        np.searchsorted(x, table.numbers["x"]),
        np.searchsorted(y, table.numbers["y"]),
    )
    values[place] = table.numbers["thickness"]
    count = len(table.numbers["x"])
    if count != values.size or np.isnan(values).any():
        raise ValueError(
            f"{fspath(path)}: {count} rows for {len(x)} x and {len(y)} y; needs each of the "
            f"{values.size} combinations once"
        )
    try:
        return ThicknessTable(tuple(x), tuple(y), tuple(map(tuple, values)))
    except ValueError as error:
        raise ValueError(f"{fspath(path)}: {error}") from None
