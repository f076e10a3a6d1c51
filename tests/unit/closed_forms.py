"""Closed forms of the nominal stress of Mooney-Rivlin and Saint Venant-Kirchhoff sheets."""

import numpy as np

# T = 2 (lambda - lambda^k) (C10 + C01 lambda^m): (k, m) of each mode
_EXPONENTS = {"uniaxial": (-2.0, -1.0), "biaxial": (-5.0, 2.0), "shear": (-3.0, 0.0)}


def mooney_rivlin_basis(stretch, mode="uniaxial"):
    """Stress per unit of C10 and of C01, shape (..., 2).

    d/dlambda of C10 (I1 - 3) + C01 (I2 - 3), halved for biaxial where two directions work.
    """
    stretch = np.asarray(stretch, dtype=float)
    k, m = _EXPONENTS[mode]
    first = 2.0 * (stretch - stretch**k)
    return np.stack([first, first * stretch**m], axis=-1)


def saint_venant_kirchhoff_stress(stretch, mode, poisson):
    """Stress per unit of Young's modulus: f lambda (lambda^2 - 1) / 2 in plane stress."""
    factor = {"uniaxial": 1.0, "biaxial": 1 / (1 - poisson), "shear": 1 / (1 - poisson**2)}[mode]
    return 0.5 * factor * stretch * (stretch**2 - 1.0)
