"""Hyperelastic laws of a plane-stress sheet and their fit to measurements.

`run` is the stage; `load` gives the material that it wrote. The function that fits is
`wrinklestudy.material.fit.fit`.
"""

from wrinklestudy.material.fit import run
from wrinklestudy.material.laws import (
    Material,
    mooney_rivlin,
    neo_hookean,
    saint_venant_kirchhoff,
)
from wrinklestudy.material.result import Fit, load, load_fit

__all__ = [
    "Fit",
    "Material",
    "load",
    "load_fit",
    "mooney_rivlin",
    "neo_hookean",
    "run",
    "saint_venant_kirchhoff",
]
