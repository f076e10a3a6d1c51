"""The planar stage: flat state of one material, L/W and strain, with its critical thicknesses."""

from dataclasses import dataclass

from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.flat import solve as solve_flat
from wrinklestudy.equilibrium.modes import Modes, critical_modes
from wrinklestudy.equilibrium.newton import Observer
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import laws
from wrinklestudy.vocabulary import Parity


@dataclass(frozen=True)
class PlanarSettings:
    """Options of the planar stage.

    Parameters
    ----------
    bending : str
        The bending law, a name in `mechanics.bending.BENDING_LAWS`.
    parity : {'antisymmetric', 'symmetric'}
        Of the deflection across y = 0.
    modes : int
        Number of critical thicknesses and modes.
    """

    bending: str = "thinning"
    parity: Parity = "antisymmetric"
    modes: int = 8

    @property
    def symmetry(self) -> Symmetry:
        """Mirrors of the sheet with a deflection of this parity."""
        return Symmetry.mirrored(self.parity)


@dataclass(frozen=True)
class Planar:
    """A flat state with its modes and its material; ``flat`` and ``modes`` are None if it failed.

    Parameters
    ----------
    grid : Grid
    material : Material
    name : str
        Name of the material in the study.
    strain : float
        eps of the clamps.
    settings : PlanarSettings
    flat : Flat or None
    modes : Modes or None
    reason : str
        Why there is no flat state; empty if there is one.
    """

    grid: Grid
    material: laws.Material
    name: str
    strain: float
    settings: PlanarSettings
    flat: Flat | None
    modes: Modes | None
    reason: str = ""


def solve(
    grid: Grid | Space,
    material: laws.Material,
    strain: float,
    settings: PlanarSettings | None = None,
    name: str = "material",
    observer: Observer | None = None,
) -> Planar:
    """Return the flat state at a strain with its critical thicknesses and modes.

    A state that does not converge is returned as such, with the reason.

    Parameters
    ----------
    grid : Grid or Space
        Grid of the part of the sheet that is solved.
    material : Material
    strain : float
        eps = (L' - L)/L of the clamps.
    settings : PlanarSettings, optional
    name : str
        Name of the material.
    observer : Observer, optional
        Is told how it goes on.
    """
    settings = settings or PlanarSettings()
    space = grid if isinstance(grid, Space) else Space(grid)
    try:
        flat = solve_flat(
            space, material.law, strain, symmetry=settings.symmetry, observer=observer
        )
        if observer is not None:
            observer("modes", None)
        modes = critical_modes(flat, settings.bending, settings.symmetry, settings.modes)
    except ArithmeticError as error:
        return Planar(space.grid, material, name, strain, settings, None, None, str(error))
    return Planar(space.grid, material, name, strain, settings, flat, modes)
