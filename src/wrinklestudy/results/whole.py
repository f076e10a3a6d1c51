"""What a sheet without mirrors was found to be at one strain."""

from dataclasses import dataclass, replace
from time import perf_counter

import numpy as np

from wrinklestudy.equilibrium import newton
from wrinklestudy.equilibrium.imperfections import Imperfections, bifurcation
from wrinklestudy.equilibrium.whole import WholeEquilibrium, WholeSettings, solve
from wrinklestudy.equilibrium.wrinkled import WrinkleSettings
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.measure import measure_sheet
from wrinklestudy.metrics.phase_band import PhaseBand, phase_band
from wrinklestudy.metrics.profile import FoldedProfileError
from wrinklestudy.results.rows import Row, StateRow, described, like
from wrinklestudy.results.solved import State
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import WHOLE_STATUSES, Parity, Part


@dataclass(frozen=True)
class WholeRow(Row):
    """A state of a half or a whole sheet."""

    strain: float = described("eps = (L' - L)/L of the middles of the clamps", shown=True)
    status: str = described(
        "wrinkled, unwrinkled (not flat, but too thick to wrinkle), flat or not-converged",
        allowed=WHOLE_STATUSES,
        shown=True,
    )
    symmetry: str = described("part of the sheet that was solved", shown=True)
    parity: str = described(
        "of the pattern at the centre: antisymmetric (z = 0) or symmetric (a crest)", shown=True
    )
    amplitude_over_thickness: float | None = like(StateRow, "amplitude_over_thickness")
    amplitude_low: float | None = described(
        "least A/t over the phase of the pattern, beyond the unwrinkled sheet",
        measured=True,
        shown=True,
    )
    amplitude_high: float | None = described(
        "largest A/t over the phase of the pattern, beyond the unwrinkled sheet",
        measured=True,
        shown=True,
    )
    envelope_amplitude: float | None = described(
        "largest value over t of the envelope of the wrinkles on x = 0, at any phase",
        measured=True,
        shown=True,
    )
    wavelength_over_width: float | None = like(StateRow, "wavelength_over_width")
    cells_per_wavelength: float | None = like(StateRow, "cells_per_wavelength")
    arc_width_over_width: float | None = like(StateRow, "arc_width_over_width")
    projected_width_over_width: float | None = like(StateRow, "projected_width_over_width")
    phi_squared: float | None = like(StateRow, "phi_squared")
    tilt: float | None = described(
        "angle of the crests with the pull at the centre, in radians", measured=True, shown=True
    )
    nominal_stress_pa: float | None = like(StateRow, "nominal_stress_pa")
    critical_thickness: float | None = described(
        "tau_1/W: the flat sheet is unstable if t is less", shown=True
    )
    bifurcation: str = described(
        "sharp if the wrinkles break a symmetry of the sheet, else rounded",
        allowed=("sharp", "rounded"),
        shown=True,
    )
    bifurcation_reason: str = described("which symmetry they break", shown=True)
    pin_reaction: float | None = described(
        "what the pin against sliding carries, over its stiffness and t",
        of_equilibrium=True,
        shown=True,
    )
    softest_eigenvalue: float | None = described(
        "smallest eigenvalue without the pin, in units of the bending stiffness",
        of_equilibrium=True,
        shown=True,
    )
    newton_iterations: int = like(StateRow, "newton_iterations")
    residual: float | None = like(StateRow, "residual")
    reason: str = like(StateRow, "reason")


@dataclass(frozen=True)
class WholeState(State):
    """What `Sheet.solve` found of a half or a whole sheet at one strain.

    Parameters
    ----------
    strain, measures, seconds
        See `State`.
    equilibrium : WholeEquilibrium or None
        None where there is no flat state to start from.
    part : {'quarter', 'half', 'half-width', 'whole'}
    parity : {'antisymmetric', 'symmetric'}
        Of the pattern at the centre.
    aspect : float
        L/W.
    material : Material
    imperfections : Imperfections
    reason : str
        Why there is no equilibrium; empty if there is one.
    """

    # Other numbers belong to a sheet without mirrors; what is measured on its shape is the same.
    equilibrium: WholeEquilibrium | None  # type: ignore[assignment]
    part: Part
    parity: Parity
    aspect: float
    material: Material
    imperfections: Imperfections
    reason: str

    @property
    def status(self) -> str:
        """'wrinkled', 'unwrinkled', 'flat' or 'not-converged'."""
        return "not-converged" if self.equilibrium is None else self.equilibrium.status

    @property
    def shape(self) -> DeformedSheet:
        """The deformed sheet.

        Raises
        ------
        ValueError
            If there is no equilibrium to show.
        """
        solved = self.equilibrium
        if solved is None or solved.status == "not-converged":
            raise ValueError(f"state at strain {self.strain:g}: {self.status}, has no shape")
        return _shape(solved, solved.position)

    @property
    def band(self) -> PhaseBand | None:
        """The amplitude over all phases of the pattern, in units of W; None where it is unknown."""
        solved = self.equilibrium
        if solved is None or solved.status in ("not-converged", "unwrinkled"):
            return None
        if solved.status == "flat":
            return PhaseBand(0.0, 0.0, 0.0)
        other = solved.partner
        if other is None or other.status != "wrinkled":
            return None
        first, second = (whole_wrinkles(state) for state in (solved, other))
        return phase_band(first.grid, first.nodes[2], second.nodes[2])

    def row(self) -> WholeRow:  # type: ignore[override]
        """Return the state as a row of numbers."""
        solved = self.equilibrium
        if solved is None:
            return _unknown(self)
        row = replace(
            _unknown(self),
            status=solved.status,
            nominal_stress_pa=solved.nominal_stress * self.material.shear_modulus,
            critical_thickness=solved.critical_thickness,
            pin_reaction=_or_none(solved.pin_reaction),
            softest_eigenvalue=_or_none(solved.softest),
            newton_iterations=newton.count(solved.history),
            residual=solved.residual,
            reason=solved.reason,
        )
        measures, band, t = self.measures, self.band, solved.thickness
        if measures is None:
            return replace(row, nominal_stress_pa=None)
        row = replace(
            row,
            amplitude_over_thickness=measures.amplitude / t,
            wavelength_over_width=_or_none(measures.wavelength),
            cells_per_wavelength=_or_none(measures.cells_per_wavelength(_cells_across(solved))),
            arc_width_over_width=measures.arc_width,
            projected_width_over_width=measures.projected_width,
            phi_squared=measures.phi_squared,
            tilt=_tilt(solved, self.parity) if solved.status == "wrinkled" else None,
        )
        if band is None:
            return row
        low, high, top = (value / t for value in band)
        return replace(row, amplitude_low=low, amplitude_high=high, envelope_amplitude=top)


def solve_whole(
    space: Space,
    material: Material,
    strain: float,
    thickness: float,
    settings: WholeSettings,
    part: Part,
    imperfections: Imperfections,
    options: WrinkleSettings | None = None,
    observer: newton.Observer | None = None,
) -> WholeState:
    """Return the state of a half or a whole sheet, one without an equilibrium included.

    See `equilibrium.whole.solve` for the parameters.
    """
    start, solved, reason = perf_counter(), None, ""
    try:
        solved = solve(space, material.law, strain, thickness, settings, options, observer)
    except ArithmeticError as error:
        reason = str(error)
    seconds = perf_counter() - start
    measures = None
    if solved is not None and solved.status != "not-converged":
        try:
            measures = measure_sheet(_shape(solved, solved.position))
        except FoldedProfileError as error:
            solved = replace(solved, status="not-converged", reason=str(error))
    return WholeState(
        strain,
        solved,
        measures,
        seconds,
        part,
        settings.parity,
        space.grid.aspect,
        material,
        imperfections,
        reason,
    )


def _unknown(state: WholeState) -> WholeRow:
    how = bifurcation(state.imperfections, state.aspect, state.parity)
    return WholeRow(
        strain=state.strain,
        status="not-converged",
        symmetry=state.part,
        parity=state.parity,
        amplitude_over_thickness=None,
        amplitude_low=None,
        amplitude_high=None,
        envelope_amplitude=None,
        wavelength_over_width=None,
        cells_per_wavelength=None,
        arc_width_over_width=None,
        projected_width_over_width=None,
        phi_squared=None,
        tilt=None,
        nominal_stress_pa=None,
        critical_thickness=None,
        bifurcation=how.kind,
        bifurcation_reason=how.reason,
        pin_reaction=None,
        softest_eigenvalue=None,
        newton_iterations=0,
        residual=None,
        reason=state.reason,
    )


def _shape(solved: WholeEquilibrium, position: Array) -> DeformedSheet:
    space = solved.flat.space
    return DeformedSheet(space.grid, space.nodes_from_field(position), solved.symmetry)


def whole_wrinkles(solved: WholeEquilibrium) -> DeformedSheet:
    """Return the whole sheet with its deflection beyond that of the unwrinkled one."""
    position = solved.position.copy()
    position[2] = solved.wrinkles
    return _shape(solved, position).unfolded()


def _tilt(solved: WholeEquilibrium, parity: str) -> float:
    """Return the angle of the crest, or of the line of zeros, through the centre with the pull.

    On a line z = const. dy/dx = -z,x/z,y, and on a crest z,y = 0 it is -z,xy/z,yy, with the
    deflection z beyond that of the sheet without wrinkles: a lifted clamp tilts no crest.
    """
    whole, centre = whole_wrinkles(solved), np.array([0.0])
    orders = ((1, 0), (0, 1)) if parity == "antisymmetric" else ((1, 1), (0, 2))
    along, across = (float(whole.evaluate(centre, centre, *o)[2, 0, 0]) for o in orders)
    place = [whole.evaluate(centre, centre, *order)[:2, 0, 0] for order in ((1, 0), (0, 1))]
    direction = place[0] - along / across * place[1] if across else place[0]
    return float(np.arctan2(direction[1], direction[0]))


def _cells_across(solved: WholeEquilibrium) -> int:
    """Return the number of cells from edge to edge."""
    grid = solved.flat.space.grid
    return grid.cells[1] * (2 if grid.y[0] == 0.0 else 1)


def _or_none(value: float) -> float | None:
    return None if value != value else float(value)
