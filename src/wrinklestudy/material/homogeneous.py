"""Nominal stress of homogeneous deformations: what a material test measures.

Three modes of a thin sheet, lambda being the stretch along the pull (both pulls when biaxial):

* ``uniaxial``: strip in simple tension, free to contract across and through the thickness;
* ``biaxial``: equal stretch in both in-plane directions;
* ``shear``: pure shear (planar tension), a wide strip whose width is held.

Nominal stress is force per undeformed area, the T of Panaitescu et al. (2019), section II.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from wrinklestudy.mechanics.laws import Law, Material
from wrinklestudy.typing import Array

MODES = ("uniaxial", "biaxial", "shear")

Deformations = str | Sequence[str] | NDArray[np.str_]


def _across(law: Law, stretch: Array, mode: Deformations) -> Array:
    """Return the stretch across the pull at each point, of the shape of ``stretch``."""
    modes = np.broadcast_to(np.asarray(mode, dtype=np.str_), stretch.shape)
    widths = {
        "uniaxial": law.natural_width(stretch),
        "biaxial": stretch,
        "shear": np.ones_like(stretch),
    }
    unknown = sorted(set(modes.ravel().tolist()) - set(widths))
    if unknown:
        raise ValueError(f"mode {unknown[0]!r} is unknown: allowed are {', '.join(MODES)}")
    return np.select([modes == name for name in widths], list(widths.values()))


def dimensionless_stress(law: Law, stretch: ArrayLike, mode: Deformations = "uniaxial") -> Array:
    """Return the nominal stress of a law in units of its initial shear modulus.

    T = dg11/dlambda dW/dg11 at the metric diag(lambda^2, width^2): derivative of the energy with
    respect to lambda at a held width, which in simple tension is the one that makes it least.

    Parameters
    ----------
    law : Law
        Dimensionless law.
    stretch : array_like
        Stretch lambda > 0, any shape ``(...)``.
    mode : str or sequence of str
        One of `MODES`, for all points or for each.

    Returns
    -------
    ndarray, shape ``(...)``
        NaN in simple tension where the law leaves no width.

    Raises
    ------
    ValueError
        If a mode is unknown.
    """
    along = np.asarray(stretch, dtype=np.float64)
    across = _across(law, along, mode)
    metric, slope = law.stretched(along, across)
    return slope * law.derivatives(metric)[0][0]


def nominal_stress(
    material: Material, stretch: ArrayLike, mode: Deformations = "uniaxial"
) -> Array:
    """Return the nominal stress in Pa of a material in a homogeneous deformation.

    See `dimensionless_stress` for the parameters and errors.
    """
    return material.shear_modulus * dimensionless_stress(material.law, stretch, mode)
