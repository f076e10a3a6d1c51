"""One sheet of the study with its states, as the claims ask for it."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from wrinklestudy.typing import Array

# Two strains of the study closer than this are the same
_SAME = 1e-9
_NAMES = {"aspect": "L/W", "thickness": "t/W"}
# What is zero on a flat sheet
_OF_WRINKLES = ("amplitude_over_thickness", "phi_squared", "phi_squared_central")


class MissingError(LookupError):
    """The study lacks what a claim needs; the message names the case or the number."""


@dataclass(frozen=True, eq=False)
class SheetStates:
    """A sheet with its states by strain.

    Parameters
    ----------
    material : str
        Name of the model in the study.
    law, bending, parity : str
        Strain energy, bending law, parity of the wrinkles.
    aspect, thickness : float
        L/W and t/W.
    status : tuple of str
        wrinkled, flat or not-converged, of each state.
    columns : mapping
        Numeric columns of the states by name, NaN where there is no number; ``strain`` increases.
    reasons : tuple of str
        Why each state has its status.
    birth, decay : float
        Strains at which wrinkles appear and vanish, roots of tau_1(eps) = t; NaN without.
    max_critical_thickness, strain_at_max : float
        Largest tau_1/W over strain and where.
    peak : mapping
        Numbers of the table of peaks.
    """

    material: str
    law: str
    bending: str
    parity: str
    aspect: float
    thickness: float
    status: tuple[str, ...] = field(repr=False)
    columns: Mapping[str, Array] = field(repr=False)
    reasons: tuple[str, ...] = field(repr=False)
    birth: float
    decay: float
    max_critical_thickness: float
    strain_at_max: float
    peak: Mapping[str, float] = field(repr=False)

    @property
    def label(self) -> str:
        """The case in words."""
        return (
            f"{self.material} ({self.law}, {self.bending}, {self.parity}), "
            f"L/W = {self.aspect:g}, t/W = {self.thickness:g}"
        )

    @property
    def wrinkles(self) -> bool:
        """Whether the flat sheet is unstable at any strain or a wrinkled state was found."""
        return math.isfinite(self.birth) or "wrinkled" in self.status

    @property
    def end(self) -> float:
        """Strain up to which wrinkles persist: 0 without wrinkles, inf if no decay was found."""
        if not self.wrinkles:
            return 0.0
        return self.decay if math.isfinite(self.decay) else math.inf

    def limits(self) -> tuple[float, float]:
        """Return birth and decay strain.

        Raises
        ------
        MissingError
            If the sheet does not have both.
        """
        if not (math.isfinite(self.birth) and math.isfinite(self.decay)):
            raise MissingError(f"birth and decay strain in the range computed, of {self.label}")
        return self.birth, self.decay

    def wrinkled_above(self, above: float = 0.0) -> NDArray[np.bool_]:
        """Return which states beyond a strain are wrinkled."""
        wrinkled = np.array([status == "wrinkled" for status in self.status], dtype=np.bool_)
        return wrinkled & (self.columns["strain"] > above)

    def wrinkled(self, *names: str, above: float = 0.0) -> tuple[Array, ...]:
        """Return columns of the wrinkled states beyond a strain that have all of these numbers.

        Raises
        ------
        MissingError
            If there is no such state.
        """
        return self._columns(self.wrinkled_above(above), names, "wrinkled")

    def converged(self, *names: str) -> tuple[Array, ...]:
        """Return columns of all converged states, wrinkled and flat, that have all these numbers.

        Raises
        ------
        MissingError
            If there is no such state.
        """
        rows = np.array([status != "not-converged" for status in self.status], dtype=np.bool_)
        return self._columns(rows, names, "converged")

    def _columns(
        self, rows: NDArray[np.bool_], names: tuple[str, ...], kind: str
    ) -> tuple[Array, ...]:
        if not rows.any():
            raise MissingError(f"a {kind} state at the strains needed, of {self.label}")
        for name in names:  # a wrinkled state may lack a wavelength
            rows = rows & np.isfinite(self.columns[name])
            if not rows.any():
                raise MissingError(f"{name} in any {kind} state of {self.label}")
        return tuple(self.columns[name][rows] for name in names)

    def at(self, name: str, strain: float) -> float:
        """Return a number at a strain: that of the state, or between two wrinkled neighbours.

        Between two neighbouring wrinkled states the monotone cubic through the wrinkled states is
        taken. Amplitude and Phi^2 are zero where the sheet is flat; nothing is interpolated
        across a state that did not converge.

        Raises
        ------
        MissingError
            If there is no such number.
        """
        strains = self.columns["strain"]
        here = np.flatnonzero(np.abs(strains - strain) < _SAME)
        if len(here):
            value = float(self.columns[name][here[0]])
        elif self._outside(strain) and name in _OF_WRINKLES:
            value = 0.0
        else:
            value = self._between(name, strain)
        if not math.isfinite(value):
            raise MissingError(f"{name} at strain {strain:g} of {self.label}")
        return value

    def _outside(self, strain: float) -> bool:
        if not self.wrinkles:
            return True
        return strain <= self.birth or strain >= self.decay

    def _between(self, name: str, strain: float) -> float:
        from scipy.interpolate import PchipInterpolator

        strains = self.columns["strain"]
        after = int(np.searchsorted(strains, strain))
        if not 0 < after < len(strains):
            return math.nan
        if {self.status[after - 1], self.status[after]} != {"wrinkled"}:
            return math.nan
        known, values = self.wrinkled("strain", name)
        return float(PchipInterpolator(known, values)(strain))

    def peak_value(self, name: str) -> float:
        """Return a number of the table of peaks.

        Raises
        ------
        MissingError
            If there is none.
        """
        value = self.peak.get(name, math.nan)
        if not math.isfinite(value):
            raise MissingError(f"{name} of {self.label}")
        return value


def attribute_text(name: str, value: str | float) -> str:
    """Return an attribute of a sheet in words, for messages."""
    text = value if isinstance(value, str) else f"{value:g}"
    return f"{_NAMES.get(name, name)} = {text}"
