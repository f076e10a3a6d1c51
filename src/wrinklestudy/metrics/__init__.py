"""Metrics stage: what is measured on a wrinkled sheet, and the tables of a study.

`profile` and `measure` need no files and also serve laser scans, `sheet` looks at the whole
surface, `table` writes the tables. Importing this package loads numpy and `scipy.interpolate` only.
"""

from wrinklestudy.metrics.measure import Measures, measure, measure_position
from wrinklestudy.metrics.profile import (
    Profile,
    cleaned,
    profile_from_state,
    read_profile_csv,
)
from wrinklestudy.metrics.sheet import SheetPeak, sheet_peak
from wrinklestudy.metrics.table import COLUMNS, STABILITY_COLUMNS, measure_state, run

__all__ = [
    "COLUMNS",
    "STABILITY_COLUMNS",
    "Measures",
    "Profile",
    "SheetPeak",
    "cleaned",
    "measure",
    "measure_position",
    "measure_state",
    "profile_from_state",
    "read_profile_csv",
    "run",
    "sheet_peak",
]
