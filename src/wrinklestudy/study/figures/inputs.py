"""What the figures are drawn from: tables, states and materials, read when they are needed."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.profile import Profile, profile_from_state
from wrinklestudy.metrics.surface import SampledSurface, full_surface
from wrinklestudy.results.analyses import joined_table
from wrinklestudy.results.fields import deformed_sheet, read_wrinkle
from wrinklestudy.results.load import load_sheets
from wrinklestudy.results.materials import load_fit, load_material
from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study import measurements
from wrinklestudy.study.figures.series import number
from wrinklestudy.study.figures.style import law_label
from wrinklestudy.study.measurements import Points, Scan, SheetSize
from wrinklestudy.typing import AnalysisFiles

if TYPE_CHECKING:
    import pandas as pd


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
        The deformed sheet; None if it did not converge.
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
        return profile_from_state(self.known, per_cell=per_cell)

    def surface(self, per_cell: tuple[int, int]) -> SampledSurface:
        """Return the full deformed sheet, in units of W."""
        return full_surface(self.known, per_cell)

    @property
    def known(self) -> DeformedSheet:
        """The deformed sheet.

        Raises
        ------
        ValueError
            If the state did not converge.
        """
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
    constants : tuple of Path
        Material files, for their constants.
    analyses : mapping
        Files of the analyses that the entry of the figure names, by stage and output.
    """

    metrics: tuple[Path, ...] = ()
    stability: tuple[Path, ...] = ()
    materials: tuple[Path, ...] = ()
    states: tuple[Path, ...] = ()
    data: tuple[Path, ...] = ()
    experiment: tuple[Path, ...] = ()
    constants: tuple[Path, ...] = ()
    analyses: AnalysisFiles = field(default_factory=dict)

    @cached_property
    def series(self) -> list[SheetStates]:
        """The sheets of the tables, in their order.

        Raises
        ------
        ValueError
            If there is no table, or a table has no rows or is not one of states.
        """
        if not self.metrics:
            raise ValueError("metrics: no table given, this figure shows sheets")
        return load_sheets(self.metrics, self.stability)

    def only(self, shown: Callable[[SheetStates], bool]) -> "Inputs":
        """Return the same with some of the sheets alone, for a panel beside others.

        Raises
        ------
        ValueError
            As `series`.
        """
        pairs = zip(self.metrics, self.series, strict=True)  # a table is of one sheet
        return replace(self, metrics=tuple(table for table, sheet in pairs if shown(sheet)))

    def loaded_states(self) -> list[StateFile]:
        """Return the states by strain.

        Raises
        ------
        ValueError
            If there are none, or they are not all of the same sheet.
        """
        states = self.states_of_sheets()
        if len({(state.aspect, state.thickness, state.law, state.parity) for state in states}) > 1:
            raise ValueError("states: must be of one sheet (L/W, t/W, law, parity)")
        return states

    def states_of_sheets(self) -> list[StateFile]:
        """Return the states by strain and thickness, of one sheet or several.

        Raises
        ------
        ValueError
            If there are none.
        """
        states = [_load_state(path) for path in self.states]
        if not states:
            raise ValueError("states: none given, this figure shows states")
        return sorted(states, key=lambda state: (state.strain, state.thickness))

    def fits(self) -> list[Fit]:
        """Return the fits of the materials, in the order of the files."""
        return [load_fit(path) for path in self.materials]

    def material(self, name: str) -> Material:
        """Return a material by its name in the study, fitted or given; see `FigureEntry`.

        Raises
        ------
        ValueError
            If the figure has no file of it.
        """
        return load_material(self._constants_of(name))

    def fit(self, name: str) -> Fit:
        """Return the fit of a material by its name in the study; see `FigureEntry`.

        Raises
        ------
        ValueError
            If the figure has no file of it, or its constants were given.
        """
        return load_fit(self._constants_of(name))

    def _constants_of(self, name: str) -> Path:
        for path in self.constants:
            if path.stem == name:
                return path
        raise ValueError(f"material {name}: no file given, this figure shows its constants")

    def table(self, analysis: str) -> "pd.DataFrame":
        """Return the table of an analysis over the whole study.

        Raises
        ------
        ValueError
            If the study has none.
        """
        return joined_table(self._analysis(analysis, "table"))

    def fields(self, analysis: str) -> list[Path]:
        """Return the files with the fields of an analysis.

        Raises
        ------
        ValueError
            If the study has none.
        """
        return list(self._analysis(analysis, "fields"))

    def _analysis(self, analysis: str, output: str) -> Sequence[Path]:
        paths = self.analyses.get(analysis, {}).get(output, ())
        if not paths:
            raise ValueError(f"{analysis}: no {output} given, this figure shows the analysis")
        return paths

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
        return [scan for scan in self.scans if scan.sheet in sheets]

    def measured_amplitude(self) -> dict[SheetSize, Points]:
        """Return measured A/t against strain by sheet: of the table and of the scans."""
        points_by_sheet = self._measured_table("amplitude")
        for scan in self.scans:
            amplitude, error = scan.measures.amplitude, scan.error
            _add(points_by_sheet, scan, amplitude / scan.sheet[1], error / scan.sheet[1])
        return points_by_sheet

    def measured_wavelength(self) -> dict[SheetSize, Points]:
        """Return measured lambda/W against strain by sheet: of the table and of the scans."""
        points_by_sheet = self._measured_table("wavelength")
        for scan in self.scans:
            if scan.wrinkled:
                _add(points_by_sheet, scan, scan.measures.wavelength, scan.wavelength_error)
        return points_by_sheet

    def _measured(self, kind: str) -> list[Path]:
        return sorted(path for path in self.experiment if measurements.kind(path) == kind)

    def _measured_table(self, kind: str) -> dict[SheetSize, Points]:
        paths = self._measured(kind)
        return measurements.read_sheets(paths[0]) if paths else {}


def _add(points_by_sheet: dict[SheetSize, Points], scan: Scan, value: float, error: float) -> None:
    point = Points(np.array([scan.strain]), np.array([value]), np.array([error]))
    points_by_sheet[scan.sheet] = (
        points_by_sheet[scan.sheet].joined(point) if scan.sheet in points_by_sheet else point
    )


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
