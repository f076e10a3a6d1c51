"""A sheet with its states over strain, as figures and claims ask for it."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from wrinklestudy.results.cases import canonical
from wrinklestudy.results.rows import SheetRow, StateRow, columns, numbers_of
from wrinklestudy.typing import Array, Mask
from wrinklestudy.vocabulary import Status

# Strains of the study that are closer than this are the same
_SAME = 1e-9
# Columns that are zero on a flat sheet
_OF_WRINKLES = ("amplitude_over_thickness", "phi_squared", "phi_squared_central")


class MissingError(LookupError):
    """The study lacks what was asked for; the message names the case or the number."""


@dataclass(frozen=True, eq=False)
class SheetStates:
    """A sheet with its states by strain.

    Parameters
    ----------
    row : SheetRow
        Which sheet it is, where it is unstable and what it reaches over strain.
    states : tuple of StateRow
        Its states, by strain.
    """

    row: SheetRow
    states: tuple[StateRow, ...] = field(repr=False)

    @property
    def material(self) -> str:
        """Name of the model in the study."""
        return self.row.material

    @property
    def law(self) -> str:
        """Law of the strain energy."""
        return self.row.law

    @property
    def bending(self) -> str:
        """Bending law."""
        return self.row.bending

    @property
    def parity(self) -> str:
        """Parity of the wrinkles across the sheet."""
        return self.row.parity

    @property
    def aspect(self) -> float:
        """L/W."""
        return self.row.aspect

    @property
    def thickness(self) -> float:
        """t/W."""
        return self.row.thickness

    @property
    def size(self) -> tuple[float, float]:
        """L/W and t/W as they stand in file names and with measured data."""
        return canonical(self.aspect), canonical(self.thickness)

    @property
    def label(self) -> str:
        """The case in words."""
        return (
            f"{self.material} ({self.law}, {self.bending}, {self.parity}), "
            f"L/W = {self.aspect:g}, t/W = {self.thickness:g}"
        )

    @cached_property
    def peak(self) -> Mapping[str, float]:
        """The numbers of the sheet's row by column, NaN where there is none."""
        numbers = [column.name for column in columns(SheetRow).values() if column.kind is not str]
        return {name: numbers_of([self.row], name)[0] for name in numbers}

    @property
    def birth(self) -> float:
        """Strain at which wrinkles appear, a root of tau_1(eps) = t; NaN if there is none."""
        return self.peak["birth_strain"]

    @property
    def decay(self) -> float:
        """Strain at which they vanish, the other root; NaN if there is none in the range."""
        return self.peak["decay_strain"]

    @property
    def max_critical_thickness(self) -> float:
        """Largest tau_1/W over strain."""
        return self.peak["max_critical_thickness"]

    @property
    def strain_at_max(self) -> float:
        """Strain at which tau_1 is largest."""
        return self.peak["strain_at_max"]

    @property
    def status(self) -> tuple[Status, ...]:
        """Status of each state."""
        return tuple(row.status for row in self.states)

    @property
    def reasons(self) -> tuple[str, ...]:
        """Why each state has its status."""
        return tuple(row.reason for row in self.states)

    @cached_property
    def columns(self) -> Mapping[str, Array]:
        """The numbers of the states by column, NaN where there is none; ``strain`` increases."""
        numbers = [column.name for column in columns(StateRow).values() if column.kind is not str]
        return {name: np.array(numbers_of(self.states, name)) for name in numbers}

    def column(self, name: str) -> Array:
        """Return a column of the states; NaN where there is no such number."""
        return self.columns[name]

    def of_status(self, status: Status) -> Mask:
        """Return which states have the given status."""
        return np.array([row.status == status for row in self.states], dtype=np.bool_)

    @property
    def wrinkles(self) -> bool:
        """Whether the flat sheet is unstable at any strain or any state is wrinkled."""
        return math.isfinite(self.birth) or "wrinkled" in self.status

    @property
    def never_wrinkles(self) -> bool:
        """Whether every state is flat and the flat sheet is stable throughout."""
        return not self.wrinkles and "not-converged" not in self.status

    @property
    def end(self) -> float:
        """Strain up to which wrinkles persist: 0 without wrinkles, inf if there is no decay."""
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

    def wrinkled_above(self, above: float = 0.0) -> Mask:
        """Return which states beyond a strain are wrinkled."""
        return self.of_status("wrinkled") & (self.columns["strain"] > above)

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
        return self._columns(~self.of_status("not-converged"), names, "converged")

    def _columns(self, rows: Mask, names: tuple[str, ...], kind: str) -> tuple[Array, ...]:
        if not rows.any():
            raise MissingError(f"a {kind} state at the strains needed, of {self.label}")
        for name in names:  # a wrinkled state may lack a wavelength
            rows = rows & np.isfinite(self.columns[name])
            if not rows.any():
                raise MissingError(f"{name} in any {kind} state of {self.label}")
        return tuple(self.columns[name][rows] for name in names)

    def curve(self, name: str) -> tuple[Array, Array]:
        """Return strain and a column that vanishes where wrinkles appear and vanish.

        Birth and decay strain come from the eigenvalue problem of the flat sheet and are inserted
        with the value 0, unless they are farther from the states than these are from each other.
        NaN (a state that did not converge) leaves a gap.
        """
        strain = self.columns["strain"]
        reach = np.diff(strain).max(initial=0.0) if len(strain) > 1 else np.inf
        ends = np.array([self.birth, self.decay])
        ends = ends[(ends >= strain[0] - reach) & (ends <= strain[-1] + reach)]
        value = np.concatenate([self.columns[name], np.zeros(len(ends))])
        strain = np.concatenate([strain, ends])
        order = np.argsort(strain, kind="stable")
        return strain[order], value[order]

    def at(self, name: str, strain: float) -> float:
        """Return a number at a strain: that of the state, or one between two wrinkled states.

        The interpolation is the monotone cubic through the wrinkled states. Amplitude and Phi^2 are
        zero where the sheet is flat; nothing is interpolated across a state that did not converge.

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
        value = self.peak[name]
        if not math.isfinite(value):
            raise MissingError(f"{name} of {self.label}")
        return value
