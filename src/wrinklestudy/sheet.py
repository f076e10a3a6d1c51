"""One sheet for interactive use: material, L/W and t/W in, states and measures out."""

from dataclasses import dataclass, field
from functools import cached_property
from time import perf_counter
from typing import Any

from wrinklestudy.equilibrium import newton, planar, stability, wrinkled
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.metrics.measure import Measures, measure_position
from wrinklestudy.results.cases import resolved_thickness
from wrinklestudy.vocabulary import (
    ASPECT,
    BENDING_LAWS,
    PARITIES,
    STRAIN,
    THICKNESS,
    Bending,
    Parity,
)


@dataclass(frozen=True)
class State:
    """What `Sheet.solve` found at one strain.

    Parameters
    ----------
    strain : float
    equilibrium : wrinkled.Equilibrium
        Position, energy, inertia and history.
    measures : Measures or None
        What is measured on the mid-line, in units of W; None where it did not converge.
    seconds : float
        Wall time of the solve.
    """

    strain: float
    equilibrium: wrinkled.Equilibrium
    measures: Measures | None
    seconds: float

    @property
    def status(self) -> str:
        """'wrinkled', 'flat' or 'not-converged'."""
        return self.equilibrium.status

    def as_dict(self) -> dict[str, Any]:
        """Return the numbers of the state as plain values, None where there is none."""
        state = self.equilibrium
        material, thickness = state.planar.material, state.thickness
        row: dict[str, Any] = {"strain": self.strain, "status": state.status}
        if self.measures is not None:
            m = self.measures
            row |= {
                "amplitude_over_thickness": m.amplitude / thickness,
                "wavelength_over_width": m.wavelength,
                "arc_width_over_width": m.arc_width,
                "projected_width_over_width": m.projected_width,
                "phi_squared": m.phi_squared,
                "phi_squared_central": m.phi_squared_central,
                "shape_constant": m.shape_constant,
                "shape_constant_central": m.shape_constant_central,
                "nominal_stress_pa": state.nominal_stress * material.shear_modulus,
            }
        else:
            row |= dict.fromkeys(_MEASURED)
        return row | {
            "unstable_directions": state.unstable_directions,
            "newton_iterations": newton.count(state.history),
            "residual": state.residual,
            "reason": state.reason,
            "seconds": self.seconds,
        }


_MEASURED = (
    "amplitude_over_thickness",
    "wavelength_over_width",
    "arc_width_over_width",
    "projected_width_over_width",
    "phi_squared",
    "phi_squared_central",
    "shape_constant",
    "shape_constant_central",
    "nominal_stress_pa",
)


@dataclass(frozen=True)
class Sheet:
    """A clamped rectangular sheet.

    Parameters
    ----------
    aspect : float
        L/W.
    thickness : float
        t/W.
    material : Material
        From `mooney_rivlin`, `neo_hookean` or `saint_venant_kirchhoff`.
    bending : {'thinning', 'fixed-thickness', 'fvk'}
        The bending law.
    parity : {'antisymmetric', 'symmetric'}
        Of the wrinkles across the sheet.
    mesh : MeshSettings
        Cells for the reference sheet; longer and thinner sheets get more.

    Raises
    ------
    ValueError
        If a number or an option is not allowed.
    """

    aspect: float
    thickness: float
    material: Material
    bending: Bending = "thinning"
    parity: Parity = "antisymmetric"
    mesh: MeshSettings = field(default_factory=MeshSettings)

    def __post_init__(self) -> None:
        if self.aspect not in ASPECT:
            raise ValueError(f"aspect = {self.aspect:g}: must be {ASPECT}")
        if self.thickness not in THICKNESS:
            raise ValueError(f"thickness = {self.thickness:g}: must be {THICKNESS}")
        if self.bending not in BENDING_LAWS:
            allowed = ", ".join(BENDING_LAWS)
            raise ValueError(f"bending = {self.bending!r}: must be one of {allowed}")
        if self.parity not in PARITIES:
            raise ValueError(f"parity = {self.parity!r}: must be one of {', '.join(PARITIES)}")

    @cached_property
    def space(self) -> Space:
        """The finite element space on the quarter sheet."""
        return Space(make_grid(self.aspect, resolved_thickness(self.thickness), self.mesh))

    @property
    def settings(self) -> planar.PlanarSettings:
        """Settings of the planar stage."""
        return planar.PlanarSettings(self.bending, self.parity)

    def solve(self, strain: float, settings: wrinkled.WrinkleSettings | None = None) -> State:
        """Return the state of the sheet at a strain.

        Parameters
        ----------
        strain : float
            eps = (L' - L)/L of the clamps, 0 < eps <= 1.
        settings : wrinkled.WrinkleSettings, optional

        Raises
        ------
        ValueError
            If the strain is not allowed.
        """
        if strain not in STRAIN:
            raise ValueError(f"strain = {strain:g}: must be {STRAIN}")
        start = perf_counter()
        flat = planar.solve(self.space, self.material, strain, self.settings)
        found = wrinkled.solve(flat, self.thickness, settings)
        seconds = perf_counter() - start
        measures = None
        if found.status != "not-converged" and found.position is not None:
            grid, nodes = self.space.grid, self.space.nodes_from_field(found.position)
            measures = measure_position(grid.x, grid.y, nodes, self.parity)
        return State(strain, found, measures, seconds)

    def stability(self) -> stability.Stability:
        """Return birth and decay strain with the critical thicknesses between."""
        curve = stability.critical_curve(self.space, self.material, self.settings)
        return stability.find(curve, self.thickness)
