"""What the figures are drawn from: tables, states and materials, read when they are needed."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np

from wrinklestudy.material.result import Fit
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.profile import Profile, profile_from_state
from wrinklestudy.metrics.surface import SampledSurface, full_surface
from wrinklestudy.results.fields import deformed_sheet, read_wrinkle
from wrinklestudy.results.load import load_sheets
from wrinklestudy.results.materials import load_fit
from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study import measurements
from wrinklestudy.study.figures.series import number
from wrinklestudy.study.figures.style import law_label
from wrinklestudy.study.measurements import Points, Scan, SheetSize


@dataclass(frozen=True, eq=False)
class StateFile:
    """One wrinkle file.

    Parameters
    ----------
    strain, aspect, thickness : float
        eps, L/W, t/W.
    law : str
        Strain energy.
    status : str
        wrinkled, flat or not-converged.
    parity : {'antisymmetric', 'symmetric'}
        Of the wrinkle.
    sheet : DeformedSheet or None
        Its shape; None where it did not converge.
    """

    strain: float
    aspect: float
    thickness: float
    law: str
    status: str
    parity: str
    sheet: DeformedSheet | None = field(repr=False)

    @property
    def note(self) -> str:
        """The sheet as a line of text for a figure."""
        sheet = f"$L/W = {self.aspect:g}$, $t/W = {number(self.thickness)}$"
        return f"{law_label(self.law)}, {sheet}"

    def profile(self, per_cell: int = 8) -> Profile:
        """Return the cross-section half-way between the clamps, in units of W."""
        return profile_from_state(self._known(), per_cell=per_cell)

    def surface(self, per_cell: tuple[int, int]) -> SampledSurface:
        """Return the full deformed sheet, in units of W."""
        return full_surface(self._known(), per_cell)

    def _known(self) -> DeformedSheet:
        if self.sheet is None:
            raise ValueError(f"state at strain {self.strain:g}: {self.status}, has no shape")
        return self.sheet


@dataclass(frozen=True)
class Inputs:
    """Paths of everything that a figure may be drawn from; read on demand.

    Parameters
    ----------
    metrics, stability : tuple of Path
        Tables of the metrics stage and files of the stability stage, those of the sheets to show.
    materials, states, data : tuple of Path
        Material files, wrinkle files, stress-strain files that the materials were fitted to.
    experiment : tuple of Path
        Files of measured data.
    """

    metrics: tuple[Path, ...] = ()
    stability: tuple[Path, ...] = ()
    materials: tuple[Path, ...] = ()
    states: tuple[Path, ...] = ()
    data: tuple[Path, ...] = ()
    experiment: tuple[Path, ...] = ()

    @cached_property
    def series(self) -> list[SheetStates]:
        """The sheets of the tables, in their order.

        Raises
        ------
        ValueError
            If there is no table, or one has no rows or is not a table of states.
        """
        if not self.metrics:
            raise ValueError("metrics: no table given, this figure shows sheets")
        return load_sheets(self.metrics, self.stability)

    def loaded_states(self) -> list[StateFile]:
        """Return the states by strain.

        Raises
        ------
        ValueError
            If there is none, or they are not of one sheet.
        """
        states = sorted((_load_state(path) for path in self.states), key=lambda one: one.strain)
        if not states:
            raise ValueError("states: none given, this figure shows states")
        if len({(one.aspect, one.thickness, one.law, one.parity) for one in states}) > 1:
            raise ValueError("states: must be of one sheet (L/W, t/W, law, parity)")
        return states

    def fits(self) -> list[Fit]:
        """Return the fits of the materials, in the order of the files."""
        return [load_fit(path) for path in self.materials]

    def measured_stress(self) -> Points | None:
        """Return the measured stress (Pa) against strain, if there is a file."""
        paths = self._measured("stress")
        return measurements.read_stress(paths[0]) if paths else None

    @cached_property
    def scans(self) -> list[Scan]:
        """The scanned profiles by sheet and strain, without those that cannot tell."""
        scans = [measurements.read_scan(path) for path in self._measured("profiles")]
        known = [scan for scan in scans if scan is not None]
        return sorted(known, key=lambda scan: (scan.sheet, scan.strain))

    def scans_of(self, sheets: Sequence[SheetSize]) -> list[Scan]:
        """Return the scanned profiles of some sheets (L/W, t/W)."""
        return [one for one in self.scans if one.sheet in sheets]

    def measured_amplitude(self) -> dict[SheetSize, Points]:
        """Return measured A/t against strain by sheet: of the table and of the scans."""
        found = self._measured_table("amplitude")
        for one in self.scans:
            amplitude, error = one.measures.amplitude, one.error
            _add(found, one, amplitude / one.sheet[1], error / one.sheet[1])
        return found

    def measured_wavelength(self) -> dict[SheetSize, Points]:
        """Return measured lambda/W against strain by sheet: of the table and of the scans."""
        found = self._measured_table("wavelength")
        for one in self.scans:
            if one.wrinkled:
                _add(found, one, one.measures.wavelength, one.wavelength_error)
        return found

    def _measured(self, kind: str) -> list[Path]:
        return sorted(path for path in self.experiment if measurements.kind(path) == kind)

    def _measured_table(self, kind: str) -> dict[SheetSize, Points]:
        paths = self._measured(kind)
        return measurements.read_sheets(paths[0]) if paths else {}


def _add(found: dict[SheetSize, Points], scan: Scan, value: float, error: float) -> None:
    one = Points(np.array([scan.strain]), np.array([value]), np.array([error]))
    found[scan.sheet] = found[scan.sheet].joined(one) if scan.sheet in found else one


def _load_state(path: Path) -> StateFile:
    row, datasets = read_wrinkle(path)
    return StateFile(
        strain=row.strain,
        aspect=row.aspect,
        thickness=row.thickness,
        law=row.law,
        status=row.status,
        parity=row.parity,
        sheet=None if row.status == "not-converged" else deformed_sheet(row, datasets),
    )
