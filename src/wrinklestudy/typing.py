"""Names for the types that many modules use."""

from os import PathLike

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]
AnyPath = str | PathLike[str]
Cell = str | int | float | None
