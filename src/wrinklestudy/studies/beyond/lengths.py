"""Wavelength and length of the wrinkles of many sheets, one row for each wrinkled state."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.typing import Array, Mask

# Sheets from this L/W are long: their wrinkles end before the clamps.
LONG = 2.5
_COLUMNS = (
    "strain",
    "wavelength_over_width",
    "projected_width_over_width",
    "envelope_length_over_width",
    "deformed_envelope_length_over_width",
    "envelope_amplitude_x_over_length",
    "amplitude_over_thickness",
    "envelope_amplitude_over_thickness",
)


@dataclass(frozen=True, eq=False)
class Lengths:
    """Lengths of wrinkled states in units of W, arrays of shape (n,).

    Parameters
    ----------
    aspect, thickness, strain : ndarray
        L/W, t/W, eps.
    wavelength, envelope : ndarray
        lambda on the deformed sheet, and l, the length over which the wrinkles are above half of
        their height, on the deformed mid-line.
    material_wavelength, material_envelope : ndarray
        The same on the undeformed sheet; lambda by the mean stretch across x = 0.
    place : ndarray
        |X|/L of the highest wrinkle; the flap at the corner of a thin sheet is none.
    middle : ndarray
        Height half-way between the clamps over that of the highest wrinkle.
    """

    aspect: Array
    thickness: Array
    strain: Array
    wavelength: Array
    material_wavelength: Array
    envelope: Array
    material_envelope: Array
    place: Array
    middle: Array

    @property
    def joined(self) -> Mask:
        """Which states have wrinkles of more than half of their height from end to end."""
        return self.middle > 0.5

    def where(self, chosen: Mask) -> "Lengths":
        """Return some of the states."""
        return Lengths(**{name: column[chosen] for name, column in vars(self).items()})

    @property
    def against_theory(self) -> Array:
        """The wavelength over 0.8 times the wavelength of Cerda and Mahadevan."""
        factor = theory.WAVELENGTH_FACTOR
        return np.array(
            [
                wavelength / theory.cm_wavelength(strain, aspect, thickness, factor=factor)
                for wavelength, strain, aspect, thickness in zip(
                    self.wavelength, self.strain, self.aspect, self.thickness, strict=True
                )
            ],
            dtype=np.float64,
        )

    def text(self, k: int) -> str:
        """Return a state in words."""
        return f"L/W = {self.aspect[k]:g}, t/W = {self.thickness[k]:g}, ε = {self.strain[k]:g}"


def lengths(sheets: Iterable[SheetStates]) -> Lengths:
    """Return the lengths of all wrinkled states of some sheets.

    Raises
    ------
    MissingError
        If there is none.
    """
    rows: list[tuple[float, ...]] = []
    for sheet in sheets:
        try:
            columns = sheet.wrinkled(*_COLUMNS)
        except MissingError:
            continue
        for state in zip(*columns, strict=True):
            strain, wavelength, width, envelope, deformed, place, height, highest = state
            rows.append(
                (
                    *(sheet.aspect, sheet.thickness, strain),
                    *(wavelength, wavelength / width, deformed, envelope),
                    *(place, height / highest),
                )
            )
    if not rows:
        raise MissingError("a wrinkled state with wavelength and envelope")
    return Lengths(*np.array(rows, dtype=np.float64).T)
