"""Sheets and states that several groups of the verification share."""

from typing import NamedTuple

from wrinklestudy.equilibrium import flat
from wrinklestudy.equilibrium.deflections import deflection_forms
from wrinklestudy.equilibrium.modes import critical_modes
from wrinklestudy.equilibrium.planar import Planar, PlanarSettings
from wrinklestudy.equilibrium.wrinkled import Equilibrium, solve
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.upper_triangle import multiply
from wrinklestudy.mechanics import plate
from wrinklestudy.mechanics.laws import Material, mooney_rivlin, neo_hookean, saint_venant_kirchhoff
from wrinklestudy.mechanics.section import Section
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.measure import measure_sheet
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import Parity

ASPECT, THICKNESS = 2.0, 1.0e-3
# The laws that have closed forms here and are used in published analyses
BENDING_LAWS = ("thinning", "fixed-thickness", "fvk")
PARITIES: tuple[Parity, Parity] = ("antisymmetric", "symmetric")

# The constants of Panaitescu et al. (2019) in Pa; those of other groups (10 to 1) with mu = 1
LATEX = mooney_rivlin(6.21e4, 1.58e5)
NEO_HOOKEAN = neo_hookean(0.5)
TEN_TO_ONE = mooney_rivlin(0.5 - 1.0 / 22.0, 1.0 / 22.0)
SVK = saint_venant_kirchhoff()


def quarter(along: int, across: int, aspect: float = ASPECT, thickness: float = THICKNESS) -> Space:
    """Return the space on the quarter sheet; cells as in `MeshSettings`."""
    return Space(make_grid(aspect, thickness, MeshSettings(along, across)))


def planar_state(state: flat.Flat, material: Material, settings: PlanarSettings) -> Planar:
    """Return the planar state of a flat state that is already known."""
    modes = critical_modes(state, settings.bending, settings.symmetry, settings.modes)
    grid = state.space.grid
    return Planar(grid, material, "material", state.strain, settings, state, modes)


def both_parities(
    space: Space,
    strain: float,
    material: Material = LATEX,
    thickness: float = THICKNESS,
    modes: int = 4,
) -> tuple[Equilibrium, Equilibrium]:
    """Return the antisymmetric and the symmetric state of a sheet.

    Raises
    ------
    ArithmeticError
        If one of them is not wrinkled.
    """
    state = flat.solve(space, material.law, strain)
    planar = [
        planar_state(state, material, PlanarSettings(parity=p, modes=modes)) for p in PARITIES
    ]
    return wrinkled(planar[0], thickness), wrinkled(planar[1], thickness)


def wrinkled(planar: Planar, thickness: float) -> Equilibrium:
    """Return the wrinkled state from its planar state.

    Raises
    ------
    ArithmeticError
        If it is not wrinkled.
    """
    state = solve(planar, thickness)
    if state.status != "wrinkled":
        where = f"{planar.settings.parity}, strain {planar.strain:g}, t/W {thickness:g}"
        raise ArithmeticError(f"{where}: {state.status} {state.reason}")
    return state


class SolvedState(NamedTuple):
    """What is known about an equilibrium that converged."""

    flat: flat.Flat
    space: Space
    position: Array


def solved(state: Equilibrium) -> SolvedState:
    """Return flat state, space and position of an equilibrium.

    Raises
    ------
    ValueError
        If it has none.
    """
    if state.planar.flat is None or state.position is None:
        raise ValueError(f"status {state.status!r}: no position")
    return SolvedState(state.planar.flat, state.planar.flat.space, state.position)


def amplitude(state: Equilibrium) -> float:
    """Return A/t on the mid-line."""
    _, space, position = solved(state)
    return amplitude_of(space, position, state.planar.settings.parity) / state.thickness


def amplitude_of(space: Space, position: Array, parity: Parity) -> float:
    """Return A/W of a position on the mid-line."""
    nodes = space.nodes_from_field(position)
    return measure_sheet(DeformedSheet(space.grid, nodes, Symmetry.mirrored(parity))).amplitude


def energy_below(state: Equilibrium, reference: Equilibrium | None = None) -> float:
    """Return the energy of a reference (the flat state by default) less that of a state.

    The densities are subtracted point by point, so that the difference of two energies which
    agree in many digits keeps its own.
    """
    known, space, position = solved(state)
    other = known.sheet_position if reference is None else solved(reference).position
    section = Section(known.law, state.thickness, state.planar.settings.bending)
    above, below = (plate.energy(section, space.derivatives(p)) for p in (other, position))
    return float(((above - below) * space.measure).sum())


def bending_square(state: Equilibrium) -> float:
    """Return t^3 w.B w of the deflection of a state with the bending matrix of its flat state."""
    known, _, position = solved(state)
    settings = state.planar.settings
    forms = deflection_forms(known, settings.bending, settings.symmetry)
    deflection = position[2][forms.assembler.free[0]]
    return state.thickness**3 * float(deflection @ multiply(forms.bending, deflection))
