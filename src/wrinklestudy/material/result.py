"""A fitted law with its uncertainty, and the material file that holds it."""

from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from wrinklestudy.material.branches import BRANCHES, Loop
from wrinklestudy.material.preload import KEEP, Offset
from wrinklestudy.material.stability import StretchStability, stability
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
    largest_stress_pa : float
        Largest magnitude of the stresses used.
    aicc : float
        Akaike's information criterion corrected for few points, n ln(RSS/n) + 2 k +
        2 k (k + 1)/(n - k - 1), of n points with k free constants and the residual sum of squares
        RSS in Pa^2, weighted where standard errors are known (weights of mean 1). The lower, the
        better, between laws that are fitted to the same points; NaN if n <= k + 1, and for a law of
        small strains, which no least squares of its own fit.
    branch, cycle, preload : str, int, str
        As in `wrinklestudy.material.choice.Choice`.
    offsets : dict
        Stress at stretch 1 by mode, as it was before anything was removed.
    loops : dict
        Loading and unloading by mode, where there is more than one loading.
    warnings : tuple of str
        What a person must know, one line each; see `wrinklestudy.material.remarks`.
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
    largest_stress_pa: float
    aicc: float
    branch: str = BRANCHES[0]
    cycle: int = 1
    preload: str = KEEP
    offsets: dict[str, Offset] = field(default_factory=dict)
    loops: dict[str, Loop] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()

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

    @property
    def rms_percent(self) -> float:
        """The root mean square misfit in per cent of the largest stress."""
        return 100.0 * self.rms_pa / self.largest_stress_pa

    @property
    def stability(self) -> StretchStability:
        """Where the stress of the law rises with stretch, over the range of the data."""
        return stability(self.material(), self.stretch_range)

    @property
    def polyconvex(self) -> bool | None:
        """Whether the energy is polyconvex; None where that is not known."""
        return law_of(self.law).polyconvex(self.constants)

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
            "largest_stress_pa": self.largest_stress_pa,
            "rms_percent": self.rms_percent,
            "aicc": None if self.aicc != self.aicc else self.aicc,
            "stable": self.stability.stable,
            "unstable_from_stretch": self.stability.lost_at,
            "polyconvex": self.polyconvex,
            "branch": self.branch,
            "cycle": self.cycle,
            "preload": self.preload,
            "stress_at_rest": {mode: asdict(offset) for mode, offset in self.offsets.items()},
            "loops": {mode: _plain(asdict(loop)) for mode, loop in self.loops.items()},
            "warnings": list(self.warnings),
        }


def _plain(values: dict[str, Any]) -> dict[str, Any]:
    """Return values with None for NaN."""
    return {key: None if value != value else value for key, value in values.items()}
