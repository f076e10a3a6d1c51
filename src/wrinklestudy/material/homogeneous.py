"""Nominal stress of homogeneous deformations: what a material test measures.

Three modes of a thin sheet, lambda being the stretch along the pull (both pulls when biaxial):

* ``uniaxial``: strip in simple tension, free to contract across and through the thickness;
* ``biaxial``: equal stretch in both in-plane directions;
* ``shear``: pure shear (planar tension), a wide strip whose width is held.

Nominal stress is force per undeformed area, the T of Panaitescu et al. (2019), section II.
"""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from wrinklestudy.mechanics.laws import Material, MooneyRivlin, SaintVenantKirchhoff
from wrinklestudy.typing import Array

MODES = ("uniaxial", "biaxial", "shear")

Deformations = str | Sequence[str] | NDArray[np.str_]

# T = 2 (lambda - lambda^k) (C10 + C01 lambda^m): (k, m) of each mode
_EXPONENTS = {"uniaxial": (-2.0, -1.0), "biaxial": (-5.0, 2.0), "shear": (-3.0, 0.0)}


def _per_point(table: Mapping[str, tuple[float, ...]], mode: Deformations, stretch: Array) -> Array:
    """Look up one row of ``table`` per stretch, shape ``(..., columns)``."""
    modes = np.broadcast_to(np.asarray(mode, dtype=np.str_), stretch.shape)
    unknown = sorted(set(modes.ravel().tolist()) - set(table))
    if unknown:
        raise ValueError(f"mode {unknown[0]!r} is unknown: allowed are {', '.join(MODES)}")
    rows = [table[name] for name in modes.ravel().tolist()]
    width = len(next(iter(table.values())))
    return np.array(rows, dtype=np.float64).reshape(*stretch.shape, width)


def mooney_rivlin_basis(stretch: ArrayLike, mode: Deformations = "uniaxial") -> Array:
    """Return the two columns whose combination with (C10, C01) is the nominal stress.

    T = C10 B0 + C01 B1 with B0 = 2 (lambda - lambda^k), B1 = B0 lambda^m and (k, m) = (-2, -1)
    uniaxial, (-5, 2) biaxial, (-3, 0) shear: d/dlambda of C10 (I1 - 3) + C01 (I2 - 3), halved for
    biaxial where two directions work. Uniaxial: the curve of Fig. 1 of Panaitescu et al. (2019).

    Parameters
    ----------
    stretch : array_like
        Stretch lambda > 0, any shape ``(...)``.
    mode : str or sequence of str
        One of `MODES`, for all points or for each.

    Returns
    -------
    ndarray, shape ``(..., 2)``
        Stress per unit of C10 and of C01. The columns coincide in shear, which therefore tells
        nothing but the sum of the constants.

    Raises
    ------
    ValueError
        If a mode is unknown.
    """
    lam = np.asarray(stretch, dtype=np.float64)
    exponents = _per_point(_EXPONENTS, mode, lam)
    first = 2.0 * (lam - lam ** exponents[..., 0])
    return np.stack([first, first * lam ** exponents[..., 1]], axis=-1)


def saint_venant_kirchhoff_basis(
    stretch: ArrayLike, mode: Deformations = "uniaxial", poisson: float = 0.5
) -> Array:
    """Return the nominal stress of a Saint Venant-Kirchhoff sheet per unit of Young's modulus.

    T / Y = f lambda (lambda^2 - 1) / 2 in plane stress, f = 1 uniaxial (whatever nu),
    1 / (1 - nu) biaxial, 1 / (1 - nu^2) shear. With nu = 1/2 the sheet has lost all its thickness
    at E11 = 1 uniaxial, 1/4 biaxial, 1/2 shear; the formula means nothing beyond.

    Parameters
    ----------
    stretch : array_like
        Stretch lambda > 0, any shape ``(...)``.
    mode : str or sequence of str
        One of `MODES`, for all points or for each.
    poisson : float
        Poisson's ratio nu, 0 <= nu <= 1/2.

    Returns
    -------
    ndarray, shape ``(...)``

    Raises
    ------
    ValueError
        If a mode is unknown.
    """
    lam = np.asarray(stretch, dtype=np.float64)
    table = {
        "uniaxial": (1.0,),
        "biaxial": (1.0 / (1.0 - poisson),),
        "shear": (1.0 / (1.0 - poisson**2),),
    }
    factor = _per_point(table, mode, lam)[..., 0]
    return 0.5 * factor * lam * (lam**2 - 1.0)


def nominal_stress(
    material: Material, stretch: ArrayLike, mode: Deformations = "uniaxial"
) -> Array:
    """Return the nominal stress in Pa of a material in a homogeneous deformation.

    Parameters
    ----------
    material : Material
        Mooney-Rivlin, neo-Hookean or Saint Venant-Kirchhoff material.
    stretch : array_like
        Stretch lambda > 0, any shape ``(...)``.
    mode : str or sequence of str
        One of `MODES`, for all points or for each.

    Returns
    -------
    ndarray, shape ``(...)``

    Raises
    ------
    ValueError
        If a mode is unknown.
    TypeError
        If the law of the material has no closed form here.
    """
    law = material.law
    if isinstance(law, MooneyRivlin):
        constants = np.array([law.c10, law.c01]) * material.shear_modulus
        return mooney_rivlin_basis(stretch, mode) @ constants
    if isinstance(law, SaintVenantKirchhoff):
        basis = saint_venant_kirchhoff_basis(stretch, mode, law.poisson)
        return material.young_modulus * basis
    raise TypeError(f"no closed-form stress for the law {type(law).__name__}")
