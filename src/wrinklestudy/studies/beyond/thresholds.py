"""The strain of birth as a function of thickness, from the critical thickness at each strain."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.beyond.power_law import PowerLaw, power_law
from wrinklestudy.typing import Array

# Strains up to which the birth strain is fitted: linear elasticity, and all before the first state
# that is wrinkled.
LINEAR = 1e-3


@dataclass(frozen=True, eq=False)
class Threshold:
    """Critical thickness of the flat sheet at small strains.

    Parameters
    ----------
    strain, thickness : ndarray, shape (n,)
        eps, and tau_1/W: a sheet of that thickness is born at that strain. Both increase.
    """

    strain: Array
    thickness: Array

    def law(self, up_to: float = np.inf) -> PowerLaw:
        """Return eps_c = factor x (t/W)^exponent over the strains up to one.

        Raises
        ------
        MissingError
            If there are fewer than three.
        """
        chosen = self.strain <= up_to
        if chosen.sum() < 3:
            raise MissingError(f"critical thicknesses at three strains up to {up_to:g}")
        return power_law(self.strain[chosen], thickness=self.thickness[chosen])


def threshold(sheet: SheetStates) -> Threshold:
    """Return the critical thickness at the strains of a sheet below its birth.

    Raises
    ------
    MissingError
        If the sheet has no such strain.
    """
    strain, critical = sheet.converged("strain", "critical_thickness")
    below = strain < (sheet.birth if np.isfinite(sheet.birth) else np.inf)
    if not below.any():
        raise MissingError(f"a strain below the birth of {sheet.label}")
    return Threshold(strain[below], critical[below])


def by_mesh(sheets: Iterable[SheetStates]) -> list[Threshold]:
    """Return the thresholds on the meshes of several sheets of one length, the thickest first.

    Thinner sheets have more cells across. Sheets without a strain below birth that the first one
    has too are left out.
    """
    ordered = sorted(sheets, key=lambda sheet: -sheet.thickness)
    thresholds: list[Threshold] = []
    for sheet in ordered:
        try:
            found = threshold(sheet)
        except MissingError:
            continue
        if not thresholds or len(np.intersect1d(found.strain, thresholds[0].strain)):
            thresholds.append(found)
    return thresholds


def largest_difference(coarse: Threshold, fine: Threshold) -> float:
    """Return the largest relative difference of two critical thicknesses at common strains.

    Raises
    ------
    MissingError
        If they have no strain in common.
    """
    common = np.intersect1d(coarse.strain, fine.strain)
    if not len(common):
        raise MissingError("a strain at which two meshes give the critical thickness")
    one, other = (np.interp(common, found.strain, found.thickness) for found in (coarse, fine))
    return float(np.abs(other / one - 1.0).max())
