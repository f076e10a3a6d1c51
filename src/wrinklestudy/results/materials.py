"""The files of the material stage: a law with constants, fitted to data or given."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from wrinklestudy.files.storage import read_json
from wrinklestudy.material.branches import Loop
from wrinklestudy.material.preload import Offset
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import Material, law_of


def given_material(law: str, constants: Mapping[str, float]) -> dict[str, Any]:
    """Return the content of the file of a material whose constants are given.

    The keys are those of a fit (`Fit.as_dict`), without all that follows from data.

    Parameters
    ----------
    law : str
        A name in `LAWS`.
    constants : mapping
        By name, in Pa or pure numbers; those that are left out have their defaults.

    Raises
    ------
    ValueError
        If the law or a constant is unknown, missing or outside its bounds.
    """
    kind = law_of(law)
    material = kind.material(**constants)
    values = material.law.physical(material.shear_modulus)
    units = {constant.name: constant.unit for constant in kind.constants}
    return {
        "law": law,
        "constants": values,
        "units": units,
        "constants_pa": {name: values[name] for name, unit in units.items() if unit == "Pa"},
        "shear_modulus_pa": material.shear_modulus,
        "young_modulus_pa": material.young_modulus,
        "poisson": material.law.poisson,
    }


def is_fit(path: str | Path) -> bool:
    """Return whether the constants of a file of the material stage were fitted to data.

    Raises
    ------
    ValueError
        If the file cannot be read or is no file of the material stage.
    """
    return "covariance" in _content(path)


def load_fit(path: str | Path) -> Fit:
    """Read the file of a material that was fitted to data.

    Raises
    ------
    ValueError
        If the file cannot be read or a key is missing or wrong; one line naming file and key.
    """
    content = _content(path)
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
    """Return the material of a file of the material stage, fitted or given.

    Raises
    ------
    ValueError
        As `load_fit`.
    """
    content = _content(path)
    try:
        constants = {name: float(value) for name, value in content["constants"].items()}
        return law_of(content["law"]).material(**constants)
    except KeyError as error:
        raise ValueError(f"{path}: key {error} is missing; not a material file") from error
    except (AttributeError, TypeError, ValueError) as error:
        raise ValueError(f"{path}: not a material file ({error})") from error


def _content(path: str | Path) -> dict[str, Any]:
    try:
        content = read_json(path)
    except OSError as error:
        raise ValueError(f"{path}: cannot be read ({error.strerror})") from error
    if not isinstance(content, dict):
        raise ValueError(f"{path}: not a material file")
    return content
