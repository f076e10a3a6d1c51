"""First guesses of the wrinkled states of thin sheets, from tension field theory.

Far below the critical thickness many modes are unstable, and no few of them are near the state. Its
limit for no thickness is: the planar position of the tension field under wrinkles of the one
wavelength that is in balance with it (`envelope`). Two parts are relaxed by themselves, as each is
stiffer or softer than the rest and cheap alone: the position in the plane, and the corner of clamp
and free edge, where the compression of the flat state makes a flap.
"""

from dataclasses import replace

import numpy as np

from wrinklestudy.equilibrium import newton, tension_field
from wrinklestudy.equilibrium.envelope import envelope
from wrinklestudy.equilibrium.flat import ROUNDING
from wrinklestudy.equilibrium.planar import Planar
from wrinklestudy.equilibrium.problem import PlateProblem, Predicting
from wrinklestudy.fem.boundary import Clamp
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.transfer import coarsened, transferred
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

# Of the critical thickness: thinner sheets start from the tension field.
THIN = 0.2
_ACROSS = 24  # cells for the tension field
_CORNER = (0.15, 0.08)  # size of the corner, in units of W
_CELLS = 4  # at least, in each direction
_IN_PLANE = newton.NewtonOptions(tolerance=1e-8, max_iterations=12, smooth=False)
_FLAP = newton.NewtonOptions(tolerance=1e-14, max_iterations=60, rise=10.0)


def thin_seed(
    planar: Planar, thickness: float, observer: newton.Observer | None = None
) -> Array | None:
    """Return a position (3, size) near the wrinkled state of a thin sheet, or None without one.

    Parameters
    ----------
    planar : Planar
        With its flat state and modes.
    thickness : float
        t/W.
    observer : newton.Observer, optional
        Is told of each iteration of the tension field.
    """
    flat, modes = planar.flat, planar.modes
    if flat is None or modes is None or flat.law.linear_in_plane:
        return None  # a law of linear strain has no tension field
    space = flat.space
    grid = coarsened(space.grid, len(space.grid.x) - 1, _ACROSS)
    field = tension_field.solve(grid, flat.law, flat.strain, observer=observer)
    if not field.converged:
        return None
    wrinkles = envelope(field, thickness, modes.bending)
    if wrinkles is None:
        return None
    odd = modes.symmetry.odd_across is not None and modes.symmetry.odd_across[2]
    planes = transferred(field.position, field.space, space)
    position = np.concatenate([planes, wrinkles.deflection(space, odd)[None]])
    section = Section(flat.law, thickness, modes.bending)
    free = modes.symmetry.free(space)
    position = np.where(free, position, flat.sheet_position)
    free[2] = False
    position = _relaxed(PlateProblem(space, section, free, position), position, _IN_PLANE)
    return _with_corner(space, section, position, flat.sheet_position)


def _with_corner(space: Space, section: Section, position: Array, flat: Array) -> Array:
    """Return a position with the flap at the corner of clamp and free edge, in equilibrium."""
    x, y = space.grid.x, space.grid.y
    first = (
        min(int(np.searchsorted(x, x[-1] - _CORNER[0])), len(x) - 1 - _CELLS),
        min(int(np.searchsorted(y, y[-1] - _CORNER[1])), len(y) - 1 - _CELLS),
    )
    if min(first) < 0:
        return position
    inside = (..., slice(first[0], None), slice(first[1], None))
    corner = Space(Grid(x[first[0] :], y[first[1] :]), space.order)
    nodes = space.nodes_from_field(position)
    start = corner.field_from_nodes(nodes[inside])
    start[2] += corner.field_from_nodes(_bump(corner.grid, float(section.thickness)))
    held = np.ones_like(nodes, dtype=bool)
    held[..., 1:, 1:] = False
    fixed = corner.field_from_nodes(held[inside[0], : len(corner.grid.x), : len(corner.grid.y)]) > 0
    for component, edge, names in Clamp().held:
        fixed[component, corner.edge_dofs(edge, names)] = True
    plane = corner.field_from_nodes(space.nodes_from_field(flat)[inside])
    problem = PlateProblem(corner, section, ~fixed, start, plane)
    nodes[inside] = corner.nodes_from_field(_relaxed(problem, start, _FLAP))
    return space.field_from_nodes(nodes)


def _bump(grid: Grid, height: float) -> Array:
    """Return nodes (4, nx + 1, ny + 1) of a flap that vanishes with its slopes but at the edge."""
    s = (grid.x - grid.x[0]) / (grid.x[-1] - grid.x[0])
    r = (grid.y - grid.y[0]) / (grid.y[-1] - grid.y[0])
    along, across = 16.0 * height * s**2 * (1.0 - s) ** 2, r**2
    slope = 32.0 * height * s * (1.0 - s) * (1.0 - 2.0 * s) / (grid.x[-1] - grid.x[0])
    rise = 2.0 * r / (grid.y[-1] - grid.y[0])
    pairs = ((along, across), (slope, across), (along, rise), (slope, rise))
    return np.stack([np.outer(first, second) for first, second in pairs])


def _relaxed(problem: PlateProblem, start: Array, options: newton.NewtonOptions) -> Array:
    """Return the position where a part of the sheet is in equilibrium, or the start."""
    free, thickness = problem.assembler.free, problem.thickness
    options = replace(options, first_shift=thickness**2, noise=ROUNDING * thickness)
    smooth = Predicting(problem) if options.smooth else problem
    minimum = newton.minimise(smooth, start[free], problem.assembler.solver, options)
    return problem.position(minimum.unknowns) if minimum.converged else start
