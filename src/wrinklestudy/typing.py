"""Names for the types that many modules use."""

from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]
AnyPath = str | PathLike[str]
Cell = str | int | float | None
# Files of analyses by stage and output, such as {"map": {"table": [...]}}
AnalysisFiles = Mapping[str, Mapping[str, Sequence[Path]]]
