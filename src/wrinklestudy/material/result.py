"""A fitted law with its uncertainty, and the material file that holds it."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from wrinklestudy.mechanics.laws import (
    Material,
    mooney_rivlin,
    neo_hookean,
    saint_venant_kirchhoff,
)
from wrinklestudy.typing import Array

# Constants in Pa that each law has; svk is incompressible, nu = 1/2.
CONSTANTS = {
    "mooney-rivlin": ("c10", "c01"),
    "neo-hookean": ("c10",),
    "svk": ("young",),
}


def material_of(law: str, constants: Mapping[str, float]) -> Material:
    """Return the material of a law from its constants in Pa.

    Parameters
    ----------
    law : str
        One of `LAWS`.
    constants : mapping
        The constants that `CONSTANTS` names for the law.

    Raises
    ------
    ValueError
        If a constant is outside its bounds.
    """
    if law == "svk":
        return saint_venant_kirchhoff(constants["young"], 0.5)
    if law == "neo-hookean":
        return neo_hookean(constants["c10"])
    return mooney_rivlin(constants["c10"], constants["c01"])


@dataclass(frozen=True, eq=False)
class Fit:
    """Constants of a law fitted to data, with their covariance.

    Parameters
    ----------
    law : str
        One of `LAWS`.
    constants : dict
        Constants in Pa by name: c10 and c01, c10, or young.
    covariance : ndarray, shape ``(p, p)``
        Covariance of the constants in Pa^2, in the order of `constants`. Rows and columns of a
        constant that sits on its bound are zero: the others are conditional on it.
    at_bound : tuple of str
        Constants that the bound >= 0 holds at zero; their true uncertainty is one-sided.
    rms_pa : float
        Root mean square of law minus measurement over the points used.
    count : int
        Number of points used.
    stretch_range : tuple of float
        Smallest and largest stretch of the points used.
    modes : tuple of str
        Deformation modes of the points used.
    condition_number : float
        Of the design matrix with columns scaled to unit length: 1 where the data tell the
        constants apart perfectly, large where only a combination of them is known.
    source : str
        Name of the data.
    """

    law: str
    constants: dict[str, float]
    covariance: Array
    at_bound: tuple[str, ...]
    rms_pa: float
    count: int
    stretch_range: tuple[float, float]
    modes: tuple[str, ...]
    condition_number: float
    source: str

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the constants in the order of the covariance."""
        return tuple(self.constants)

    @property
    def standard_errors(self) -> dict[str, float]:
        """Standard errors of the constants in Pa."""
        return dict(zip(self.constants, np.sqrt(np.diag(self.covariance)).tolist(), strict=True))

    @property
    def correlation(self) -> Array:
        """Correlation of the constants, shape ``(p, p)``; zero beside a constant on its bound."""
        error = np.sqrt(np.diag(self.covariance))
        scale = np.where(error > 0.0, error, 1.0)
        correlation = self.covariance / np.outer(scale, scale)
        np.fill_diagonal(correlation, 1.0)
        return correlation

    def material(self) -> Material:
        """Return the fitted material."""
        return material_of(self.law, self.constants)

    def as_dict(self) -> dict[str, Any]:
        """Return the fit as plain numbers, strings and lists for JSON."""
        material = self.material()
        return {
            "law": self.law,
            "parameters": list(self.parameters),
            "constants_pa": dict(self.constants),
            "shear_modulus_pa": material.shear_modulus,
            "young_modulus_pa": material.young_modulus,
            "poisson": material.law.poisson,
            "standard_errors_pa": self.standard_errors,
            "covariance_pa2": self.covariance.tolist(),
            "correlation": self.correlation.tolist(),
            "at_bound": list(self.at_bound),
            "rms_pa": self.rms_pa,
            "count": self.count,
            "stretch_range": list(self.stretch_range),
            "modes": list(self.modes),
            "condition_number": self.condition_number,
            "source": self.source,
        }
