"""The wrinkle stage: the wrinkled equilibrium of one sheet at one strain."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from wrinklestudy.equilibrium.wrinkled import WrinkleSettings, solve
from wrinklestudy.results.fields import read_planar, write_wrinkle
from wrinklestudy.stages.log import log_cpu


def run(
    planar: Path | str, thickness: float, settings: Mapping[str, Any], output: Path | str
) -> None:
    """Solve one sheet at one strain from its planar file and write the state.

    Parameters
    ----------
    planar : path
        HDF5 file of the planar stage.
    thickness : float
        t/W.
    settings : mapping
        Keys of `WrinkleSettings`.
    output : path
        HDF5 file to write.
    """
    flat = read_planar(planar)
    with log_cpu("solve"):
        state = solve(flat, thickness, WrinkleSettings(**settings))
    write_wrinkle(state, output)
