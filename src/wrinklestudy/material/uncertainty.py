"""How well a curve is known: constants with a covariance make a band around the fitted stress."""

import numpy as np

from wrinklestudy.material.homogeneous import nominal_stress
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import law_of
from wrinklestudy.typing import Array

CONFIDENCE = 0.95
_STEP = 1e-6  # of the value of a constant


def stress_band(fit: Fit, stretch: Array, mode: str) -> tuple[Array, Array]:
    """Return the nominal stress of a fit and half the width of its 95 % band, both in Pa.

    q sqrt(g^T C g) with the derivatives g of the stress with respect to the constants, their
    covariance C and the quantile q of Student's distribution with (points - free constants) degrees
    of freedom: the band of the curve at one stretch, not of single measurements.

    Parameters
    ----------
    fit : Fit
    stretch : (n,) array
    mode : str
        Mode of deformation.
    """
    from scipy.special import stdtrit

    curve = nominal_stress(fit.material(), stretch, mode)
    slopes = np.zeros((len(fit.constants), *np.shape(stretch)))
    for k, (name, value) in enumerate(fit.constants.items()):
        if name not in fit.at_bound:
            step = _STEP * abs(value)
            ends = [
                nominal_stress(
                    law_of(fit.law).material(**{**fit.constants, name: value + sign * step}),
                    stretch,
                    mode,
                )
                for sign in (1.0, -1.0)
            ]
            slopes[k] = (ends[0] - ends[1]) / (2.0 * step)
    variance = np.einsum("i...,ij,j...->...", slopes, fit.covariance, slopes)
    freedom = fit.count - len(fit.constants) + len(fit.at_bound)
    quantile = float(stdtrit(freedom, 0.5 * (1.0 + CONFIDENCE)))
    return curve, quantile * np.sqrt(np.maximum(variance, 0.0))
