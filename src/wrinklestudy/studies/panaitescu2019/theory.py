"""Closed forms with which the study compares, after Panaitescu et al. (2019).

A. Panaitescu, M. Xin, B. Davidovitch, J. Chopin, A. Kudrolli, Phys. Rev. E 100, 053003 (2019),
called "the paper" here; its equations are named by the labels of its LaTeX source. Strain is
eps = (L' - L)/L, lengths are in units of the width W, stresses in the unit of the constants given.
"""

import math

import numpy as np
from numpy.typing import ArrayLike

from wrinklestudy.typing import Array

# Young's modulus in Pa that the paper states (caption of Fig. 1) and normalises by. It is not the
# initial slope 6 (C10 + C01) = 1.32 MPa of the constants that the paper gives.
STATED_YOUNG_MODULUS = 1.0e6

# Factor that the paper applies to the Cerda-Mahadevan wavelength in its Fig. 5b.
WAVELENGTH_FACTOR = 0.8

# C of A = C lambda Phi for a sinusoidal profile (below eq. amp-geo).
SINUSOID_CONSTANT = 1.0 / math.pi


def _stretch(strain: ArrayLike) -> Array:
    stretch = 1.0 + np.asarray(strain, dtype=np.float64)
    if not np.all(stretch > 0.0):
        raise ValueError("strain: must be > -1")
    return stretch


def _tensile(strain: ArrayLike) -> Array:
    values = np.asarray(strain, dtype=np.float64)
    if not np.all(values > 0.0):
        raise ValueError("strain: must be > 0")
    return values


def uniaxial_svk(strain: ArrayLike, young: float = 1.0) -> Array:
    """Return the nominal stress T = Y lambda (lambda^2 - 1) / 2 of Saint Venant-Kirchhoff.

    The second Piola stress is Y E11; Poisson's ratio does not enter in simple tension.

    Parameters
    ----------
    strain : array_like
        Strain eps > -1, any shape.
    young : float
        Young's modulus Y; its unit is that of the result.

    Returns
    -------
    ndarray
        Same shape as `strain`.

    Raises
    ------
    ValueError
        If a strain is not above -1.
    """
    stretch = _stretch(strain)
    return young * (0.5 * stretch * (stretch**2 - 1.0))


def uniaxial_hookean(strain: ArrayLike, young: float = 1.0) -> Array:
    """Return the nominal stress T = Y eps / (1 + eps) of an incompressible Hookean material.

    Hooke's law between true stress and strain, sigma = Y eps; the cross-section of an
    incompressible strip shrinks by 1 / (1 + eps), so that the force per undeformed area is
    sigma / (1 + eps). The paper's section II names such a material beside SVK without an equation.
    This form is used because incompressibility must enter, which in T = Y eps it would not.

    Parameters
    ----------
    strain : array_like
        Strain eps > -1, any shape.
    young : float
        Young's modulus Y; its unit is that of the result.

    Returns
    -------
    ndarray
        Same shape as `strain`.

    Raises
    ------
    ValueError
        If a strain is not above -1.
    """
    stretch = _stretch(strain)
    return young * (stretch - 1.0) / stretch


def initial_slope(c10: float, c01: float) -> float:
    """Return Young's modulus of a Mooney-Rivlin material, dT/deps at eps = 0: 6 (C10 + C01)."""
    return 6.0 * (c10 + c01)


def cm_wavelength(
    strain: ArrayLike,
    aspect: float,
    thickness: float,
    poisson: float = 0.5,
    factor: float = 1.0,
) -> Array:
    """Return the Cerda-Mahadevan wavelength over W, the paper's eq. CM-wave.

    lambda = factor sqrt(2 pi L t) / [3 (1 - nu^2) eps]^(1/4), the balance of bending against the
    tension along wrinkles of length L.

    Parameters
    ----------
    strain : array_like
        Strain eps > 0, any shape.
    aspect, thickness : float
        L/W and t/W.
    poisson : float
        Poisson's ratio nu.
    factor : float
        1 for the model itself, `WAVELENGTH_FACTOR` for the curve of the paper's Fig. 5b.

    Returns
    -------
    ndarray
        lambda/W, same shape as `strain`.

    Raises
    ------
    ValueError
        If a strain is not positive.
    """
    stiffness = 3.0 * (1.0 - poisson**2) * _tensile(strain)
    return factor * math.sqrt(2.0 * math.pi * aspect * thickness) / stiffness**0.25


def cm_confinement(strain: ArrayLike, poisson: float = 0.5) -> Array:
    """Return Phi^2 = nu eps, what the original Cerda-Mahadevan model assumes (Table I).

    It takes W_act = W and W_proj = W (1 - nu eps), so that (W_act - W_proj)/W_proj is nu eps to
    first order.

    Parameters
    ----------
    strain : array_like
        Strain eps, any shape.
    poisson : float
        Poisson's ratio nu.

    Returns
    -------
    ndarray
        Same shape as `strain`.
    """
    return poisson * np.asarray(strain, dtype=np.float64)


def actual_width(strain: ArrayLike, poisson: float = 0.5) -> Array:
    """Return W_act/W = 1 - nu eps, the arc length across a sheet without transverse stress.

    Table I and Fig. 7a of the paper, for small strain.

    Parameters
    ----------
    strain : array_like
        Strain eps, any shape.
    poisson : float
        Poisson's ratio nu.

    Returns
    -------
    ndarray
        Same shape as `strain`.
    """
    return 1.0 - poisson * np.asarray(strain, dtype=np.float64)


def uniaxial_width(strain: ArrayLike) -> Array:
    """Return the width over W of an incompressible strip in simple tension, (1 + eps)^(-1/2).

    What `actual_width` with nu = 1/2 becomes at finite strain.

    Parameters
    ----------
    strain : array_like
        Strain eps > -1, any shape.

    Returns
    -------
    ndarray
        Same shape as `strain`.

    Raises
    ------
    ValueError
        If a strain is not above -1.
    """
    return _stretch(strain) ** -0.5
