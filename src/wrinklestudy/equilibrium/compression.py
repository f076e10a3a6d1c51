"""Where the flat sheet is compressed at its centre, over strain: where the thinnest sheet wrinkles.

A sheet without thickness wrinkles wherever it is narrower than uniaxial tension alone would make
it. The flat state tells this by itself: at the centre the natural width n(lambda) exceeds the
smaller stretch sqrt(b) there. As the strain grows the compressed zone shrinks toward the centre.
"""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from wrinklestudy.equilibrium.critical_map import FlatPath
from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.transfer import coarsened
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.mechanics.relaxed import RelaxedLaw, principal_stretches

# Strains that are looked at, beyond those of wrinkles of finite thickness.
STRAINS = tuple(round(0.05 * k, 2) for k in range(1, 61))


class CentralState(NamedTuple):
    """The flat state at the centre at one strain."""

    strain: float
    excess: float | None  # n/sqrt(b) - 1: compressed if positive; None if there is no flat state
    coarse_excess: float | None  # of a mesh with half the cells in each direction
    reason: str  # why there is no flat state; else empty


def central_excess(flat: Flat) -> float:
    """Return n/sqrt(b) - 1 at the centre of a sheet that was solved with both mirrors.

    n is the natural width under uniaxial tension at the larger stretch, b the squared smaller
    stretch; for incompressible laws n = a^(-1/4) with the squared larger stretch a.
    """
    nodes = flat.space.nodes_from_field(flat.position)
    along, across = nodes[:, 1, 0, 0], nodes[:, 2, 0, 0]
    stretches = principal_stretches(np.array([along @ along, across @ across, along @ across]))
    natural = RelaxedLaw(flat.law).natural_square(stretches.larger)
    return float(np.sqrt(natural / stretches.smaller)) - 1.0


def central_states(grid: Grid, law: Law, strains: Iterable[float] = STRAINS) -> list[CentralState]:
    """Return the state at the centre at strains, from the smallest to the largest.

    Parameters
    ----------
    grid : Grid
        Of the quarter sheet; `critical_map.map_grid` is fine enough.
    law : Law
        Dimensionless material law.
    strains : iterable of float
        eps > 0.
    """
    along, across = grid.cells
    meshes = (grid, coarsened(grid, along // 2, across // 2))
    paths = [FlatPath(Space(mesh), law) for mesh in meshes]
    states = []
    for strain in sorted({float(strain) for strain in strains}):
        try:
            fine, coarse = (central_excess(path.solve(strain)) for path in paths)
        except ArithmeticError as error:
            states.append(CentralState(strain, None, None, str(error)))
        else:
            states.append(CentralState(strain, fine, coarse, ""))
    return states
