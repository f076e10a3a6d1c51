"""A fitted law with its uncertainty, and the material file that holds it."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from wrinklestudy.mechanics.laws import Material, law_of
from wrinklestudy.typing import Array


@dataclass(frozen=True, eq=False)
class Fit:
    """Constants of a law fitted to data, with their covariance.

    Parameters
    ----------
    law : str
        A name in `LAWS`.
    constants : dict
        Fitted constants by name, in the units of `units`.
    covariance : ndarray, shape ``(p, p)``
        Covariance of the constants, in their order and units. Rows and columns of a constant that
        sits on its bound are zero: the others are conditional on it.
    at_bound : tuple of str
        Constants that their bounds hold; their true uncertainty is one-sided.
    rms_pa : float
        Root mean square of law minus measurement over the points used.
    count : int
        Number of points used.
    stretch_range : tuple of float
        Smallest and largest stretch of the points used.
    modes : tuple of str
        Deformation modes of the points used.
    condition_number : float
        Of the derivatives of the stress with respect to the constants, columns scaled to unit
        length: 1 where the data tell the constants apart perfectly, large where only a combination
        of them is known.
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
    def units(self) -> dict[str, str]:
        """Units of the constants: 'Pa', or '' for pure numbers."""
        units = {constant.name: constant.unit for constant in law_of(self.law).constants}
        return {name: units[name] for name in self.constants}

    @property
    def standard_errors(self) -> dict[str, float]:
        """Standard errors of the constants in their units."""
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
        return law_of(self.law).material(**self.constants)

    def as_dict(self) -> dict[str, Any]:
        """Return the fit as plain numbers, strings and lists for JSON.

        ``constants_pa`` and ``standard_errors_pa`` have the constants in Pa alone, and
        ``covariance_pa2`` is there if all are.
        """
        material, units, errors = self.material(), self.units, self.standard_errors
        pascals = [name for name, unit in units.items() if unit == "Pa"]
        covariance = self.covariance.tolist()
        in_pascals = {"covariance_pa2": covariance} if len(pascals) == len(units) else {}
        return {
            "law": self.law,
            "parameters": list(self.parameters),
            "constants": dict(self.constants),
            "units": units,
            "constants_pa": {name: self.constants[name] for name in pascals},
            "shear_modulus_pa": material.shear_modulus,
            "young_modulus_pa": material.young_modulus,
            "poisson": material.law.poisson,
            "standard_errors": errors,
            "standard_errors_pa": {name: errors[name] for name in pascals},
            "covariance": covariance,
            **in_pascals,
            "correlation": self.correlation.tolist(),
            "at_bound": list(self.at_bound),
            "rms_pa": self.rms_pa,
            "count": self.count,
            "stretch_range": list(self.stretch_range),
            "modes": list(self.modes),
            "condition_number": self.condition_number,
            "source": self.source,
        }
