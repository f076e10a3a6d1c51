"""Mansfield's strip as a sheet of the library: its relaxed energy between two clamps."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from verification.tools.biquadratic import OPTIONS, REMAINDERS
from verification.tools.sheared_strip import MansfieldStrip
from wrinklestudy.equilibrium import flat, newton
from wrinklestudy.equilibrium.tension_field import RelaxedProblem
from wrinklestudy.fem.boundary import NO_MIRRORS
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import SaintVenantKirchhoff
from wrinklestudy.mechanics.relaxed import RelaxedLaw, principal_stretches
from wrinklestudy.metrics.interpolant import evaluate
from wrinklestudy.typing import Array

_ORDER = 7  # as the tension field of the library
# As the tension field of the library, and for its reason: near the minimum single points change
# between taut and wrinkled again and again.
_OPTIONS = replace(OPTIONS, tolerance=1e-11, smooth=False)
_GRADING = 1.5  # cells shrink toward the clamps and the free ends


class StripField(NamedTuple):
    """The strip at one load.

    Parameters
    ----------
    displacement : (2, size) array
        As dof vectors on the space.
    angles : (n,) array
        Between the rays and the clamps, along the mid-line.
    normal, along : float
        Forces on a clamp over Y t.
    taut : float
        Part of the sheet that is neither wrinkled nor slack.
    """

    displacement: Array
    angles: Array
    normal: float
    along: float
    taut: float


def space_of(strip: MansfieldStrip, cells: tuple[int, int]) -> Space:
    """Return the space of the whole strip, clamps at both ends of X."""
    x, y = (
        0.5 * length * _graded(count)
        for length, count in zip((strip.distance, strip.length), cells, strict=True)
    )
    return Space(Grid(x, y), _ORDER)


def _graded(count: int) -> Array:
    s = np.linspace(-1.0, 1.0, count + 1)
    return np.sign(s) * (1.0 - (1.0 - np.abs(s)) ** _GRADING)


def solve(
    space: Space,
    strip: MansfieldStrip,
    law: SaintVenantKirchhoff,
    stations: Array,
    start: Array | None = None,
) -> StripField:
    """Return the tension field between the clamps X = -H/2, that rests, and X = H/2.

    Parameters
    ----------
    space : Space
    strip : MansfieldStrip
    law : SaintVenantKirchhoff
    stations : (n,) array
        Places on the mid-line.
    start : (2, size) array, optional
        A displacement near that sought: the remainder is then lowered from its last values only.

    Raises
    ------
    ArithmeticError
        If a minimisation fails.
    """
    undeformed = space.coordinates[:2]
    sheared = space.nodes_from_field(undeformed)
    for component, shift in enumerate((strip.extension, strip.shear)):
        slope = shift / strip.distance
        sheared[component, 0] += slope * (space.grid.x[:, None] - space.grid.x[0])
        sheared[component, 1] += slope
    moved = space.field_from_nodes(sheared)
    unrelaxed = flat.MembraneProblem(space, law, moved, NO_MIRRORS)
    free, solver = unrelaxed.assembler.free, unrelaxed.assembler.solver
    minimum = newton.minimise(unrelaxed, moved[free], solver, replace(OPTIONS, rise=0.0))
    taut = unrelaxed.position(minimum.unknowns)
    unknowns = minimum.unknowns if start is None else (undeformed + start)[free]
    problem = RelaxedProblem(space, RelaxedLaw(law), taut, taut, NO_MIRRORS)
    for remainder in REMAINDERS if start is None else REMAINDERS[-1:]:
        problem = RelaxedProblem(space, RelaxedLaw(law, remainder), taut, taut, NO_MIRRORS)
        minimum = newton.minimise(problem, unknowns, solver, _OPTIONS)
        if not minimum.converged:
            raise ArithmeticError(f"sheared strip, remainder {remainder:g}: {minimum.reason}")
        unknowns = minimum.unknowns
    position = problem.position(unknowns)
    end = space.edge_dofs("right", ["u"])
    young = 2.0 * (1.0 + law.poisson)
    normal, along = problem.reactions(unknowns)[:, end].sum(axis=1) / young
    angles = _angles(space, position, stations)
    taut_part = _taut_part(space, position, law)
    return StripField(position - undeformed, angles, float(normal), float(along), taut_part)


def _taut_part(space: Space, position: Array, law: SaintVenantKirchhoff) -> float:
    """Return the part of the area that is neither wrinkled nor slack, by its Gauss points."""
    stretches = principal_stretches(_metric(*space.derivatives(position, 2)))
    wrinkled, slack = RelaxedLaw(law).regions(stretches)
    return float(space.measure[~wrinkled & ~slack].sum() / space.measure.sum())


def _metric(first: Array, second: Array) -> Array:
    return np.stack([(first**2).sum(0), (second**2).sum(0), (first * second).sum(0)])


def _angles(space: Space, position: Array, stations: Array) -> Array:
    """Return the angles between the larger stretch and the clamps along X = 0."""
    nodes = space.nodes_from_field(position)
    first, second = (
        evaluate(space.grid, nodes, np.zeros(1), stations, *order)[:, 0]
        for order in ((1, 0), (0, 1))
    )
    cosine, sine = principal_stretches(_metric(first, second)).along
    angles: Array = 0.5 * np.pi - np.arctan2(sine, cosine)
    return angles
