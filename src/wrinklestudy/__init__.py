"""Wrinkles in stretched hyperelastic sheets.

The names below are loaded when they are first used, so that a job that needs one stage imports
only that.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from wrinklestudy.fem.clamps import Clamps
    from wrinklestudy.fem.grid import MeshSettings
    from wrinklestudy.fem.thickness import Ripple, ThicknessField, ThicknessTable
    from wrinklestudy.material.fit import fit
    from wrinklestudy.mechanics.laws import (
        foppl_von_karman,
        mooney_rivlin,
        neo_hookean,
        ogden,
        saint_venant_kirchhoff,
        yeoh,
    )
    from wrinklestudy.results.solved import State, TensionState
    from wrinklestudy.results.whole import WholeState
    from wrinklestudy.sheet import Sheet

_HOMES = {
    "Clamps": "wrinklestudy.fem.clamps",
    "MeshSettings": "wrinklestudy.fem.grid",
    "Ripple": "wrinklestudy.fem.thickness",
    "Sheet": "wrinklestudy.sheet",
    "State": "wrinklestudy.results.solved",
    "TensionState": "wrinklestudy.results.solved",
    "ThicknessField": "wrinklestudy.fem.thickness",
    "ThicknessTable": "wrinklestudy.fem.thickness",
    "WholeState": "wrinklestudy.results.whole",
    "fit": "wrinklestudy.material.fit",
    "foppl_von_karman": "wrinklestudy.mechanics.laws",
    "mooney_rivlin": "wrinklestudy.mechanics.laws",
    "neo_hookean": "wrinklestudy.mechanics.laws",
    "ogden": "wrinklestudy.mechanics.laws",
    "saint_venant_kirchhoff": "wrinklestudy.mechanics.laws",
    "yeoh": "wrinklestudy.mechanics.laws",
}

__all__ = [
    "Clamps",
    "MeshSettings",
    "Ripple",
    "Sheet",
    "State",
    "TensionState",
    "ThicknessField",
    "ThicknessTable",
    "WholeState",
    "fit",
    "foppl_von_karman",
    "mooney_rivlin",
    "neo_hookean",
    "ogden",
    "saint_venant_kirchhoff",
    "yeoh",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
