"""Reading the files of the material stage."""

import math
from pathlib import Path

import numpy as np

from wrinklestudy.files.storage import read_json
from wrinklestudy.material.branches import Loop
from wrinklestudy.material.preload import Offset
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import Material, law_of


def load_fit(path: str | Path) -> Fit:
    """Read a file of the material stage.

    Raises
    ------
    ValueError
        If the file cannot be read or a key is missing or wrong; one line naming file and key.
    """
    try:
        content = read_json(path)
    except OSError as error:
        raise ValueError(f"{path}: cannot be read ({error.strerror})") from error
    try:
        law = content["law"]
        kind = law_of(law)
        names = [constant.name for constant in kind.constants if constant.fitted]
        constants = {name: float(content["constants"][name]) for name in names}
        kind.material(**constants)
        low, high = content["stretch_range"]
        return Fit(
            law=law,
            constants=constants,
            covariance=np.array(content["covariance"], dtype=np.float64),
            at_bound=tuple(content["at_bound"]),
            rms_pa=float(content["rms_pa"]),
            count=int(content["count"]),
            stretch_range=(float(low), float(high)),
            modes=tuple(content["modes"]),
            condition_number=float(content["condition_number"]),
            source=str(content["source"]),
            largest_stress_pa=float(content["largest_stress_pa"]),
            aicc=_number(content["aicc"]),
            branch=content["branch"],
            cycle=int(content["cycle"]),
            preload=content["preload"],
            offsets={mode: Offset(**one) for mode, one in content["stress_at_rest"].items()},
            loops={
                mode: Loop(**{**one, "hysteresis": _number(one["hysteresis"])})
                for mode, one in content["loops"].items()
            },
            warnings=tuple(content["warnings"]),
        )
    except KeyError as error:
        raise ValueError(f"{path}: key {error} is missing; not a material file") from error
    except (TypeError, ValueError) as error:
        raise ValueError(f"{path}: not a material file ({error})") from error


def _number(value: float | None) -> float:
    return math.nan if value is None else float(value)


def load_material(path: str | Path) -> Material:
    """Return the material of a file of the material stage.

    Raises
    ------
    ValueError
        As `load_fit`.
    """
    return load_fit(path).material()
