"""What is measured on a tension field: where it is wrinkled, and how much width the wrinkles hide.

In the limit of no thickness wrinkles have no amplitude, but the width that they take up has a
limit: at a point the natural width n under uniaxial tension exceeds the width sqrt(b) that the
sheet has there.
"""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.equilibrium.tension_field import TensionField
from wrinklestudy.mechanics.relaxed import RelaxedLaw, principal_stretches
from wrinklestudy.metrics.interpolant import evaluate, subdivided
from wrinklestudy.typing import Array, Mask

_PER_CELL = 50  # samples of a line per cell: the regions end within cells
# Across the sheet the excess ends with a jump that the elements round off, and beyond it wavers
# around zero by less than this part of its largest value. Along the mid-line it goes through zero.
_JUMP = 0.05
# Lines on which Phi^2 of two meshes is compared, in units of W from the middle.
_COMPARED = np.linspace(0.0, 0.25, 6)


@dataclass(frozen=True, eq=False)
class FieldSample:
    """A tension field on a tensor grid of points, arrays of shape (m, n).

    Parameters
    ----------
    excess : array
        n/sqrt(b) - 1, natural over actual width less one: the hidden part of the width where it is
        positive, in a taut sheet negative.
    natural_width : array
        n, the transverse stretch under uniaxial tension.
    wrinkled, slack : array of bool
    tension : array
        Nominal stress along the larger stretch, dW/d lambda_1, in units of mu.
    direction : array
        Angle between the fibre, the material line of the larger stretch, and the x axis in the
        undeformed sheet.
    width_stretch : array
        Deformed length of a line along Y for each unit of its length.
    """

    excess: Array
    natural_width: Array
    wrinkled: Mask
    slack: Mask
    tension: Array
    direction: Array
    width_stretch: Array


def sample(field: TensionField, x: Array, y: Array) -> FieldSample:
    """Return a tension field at points, reference coordinates x (m,) and y (n,) within its grid."""
    along, across = (
        evaluate(field.space.grid, field.nodes, x, y, *order) for order in ((1, 0), (0, 1))
    )
    metric = np.stack([(along**2).sum(0), (across**2).sum(0), (along * across).sum(0)])
    stretches, relaxed = principal_stretches(metric), RelaxedLaw(field.law)
    regions = relaxed.regions(stretches)
    width = np.sqrt(relaxed.natural_square(stretches.larger))
    cosine, sine = stretches.along
    stress, _ = relaxed.derivatives(metric)
    # dW/da is the derivative along the metric of the larger direction, (c^2, s^2, c s)
    slope = cosine**2 * stress[0] + sine**2 * stress[1] + cosine * sine * stress[2]
    return FieldSample(
        excess=width / np.sqrt(stretches.smaller) - 1.0,
        natural_width=width,
        wrinkled=regions.wrinkled,
        slack=regions.slack,
        tension=2.0 * np.sqrt(stretches.larger) * slope,
        direction=np.arctan2(sine, cosine),
        width_stretch=np.sqrt(metric[1]),
    )


@dataclass(frozen=True)
class Confinement:
    """What is measured on a tension field; lengths in units of W.

    Parameters
    ----------
    phi_squared : float
        (W_arc - W_proj)/W_proj on the material line X = 0.
    phi_squared_central : float
        n/sqrt(b) - 1 at the centre, 0 if it is taut: the limit of Phi^2 over the central wrinkle.
    arc_width, projected_width : float
        W_arc and W_proj on X = 0.
    wrinkled_width : float
        Length of the wrinkled part of X = 0 in the undeformed sheet.
    wrinkled_length_over_length : float
        Wrinkled part of Y = 0 over its length, both in the undeformed sheet.
    """

    phi_squared: float
    phi_squared_central: float
    arc_width: float
    projected_width: float
    wrinkled_width: float
    wrinkled_length_over_length: float


def confinement(field: TensionField) -> Confinement:
    """Measure the tension field of a sheet that was solved with both mirrors."""
    grid = field.space.grid
    middle = np.zeros(1)
    arc, projected = confined_widths(field, middle)
    across = sample(field, middle, _midpoints(grid.y)).excess[0]
    along = sample(field, _midpoints(grid.x), middle).excess[:, 0]
    threshold = max(_JUMP * float(across.max()), 0.0)
    central = float(sample(field, middle, middle).excess[0, 0])
    return Confinement(
        phi_squared=float(arc[0] / projected[0]) - 1.0,
        phi_squared_central=max(central, 0.0),
        arc_width=float(arc[0]),
        projected_width=float(projected[0]),
        wrinkled_width=2.0 * float((across > threshold) @ _weights(grid.y)),
        wrinkled_length_over_length=float((along > 0.0) @ _weights(grid.x)) / float(grid.x[-1]),
    )


def confined_widths(field: TensionField, x: Array) -> tuple[Array, Array]:
    """Return the arc width and the projected width of material lines X = const, (m,) each.

    W_arc - W_proj is the integral of n - sqrt(b) over the wrinkled part of the line.
    """
    lines = field.space.grid.y
    points = sample(field, x, _midpoints(lines))
    weights = _weights(lines)
    hidden = np.where(
        points.wrinkled, points.natural_width * (1.0 - 1.0 / (1.0 + points.excess)), 0.0
    )
    projected = 2.0 * points.width_stretch @ weights
    return projected + 2.0 * hidden @ weights, projected


def mesh_error(field: TensionField, coarser: TensionField) -> float:
    """Return an estimate of the error of Phi^2 at X = 0 by the mesh.

    The largest difference from a coarser mesh on lines X = const within W/4: the difference
    changes its sign along the sheet, and where it happens to be small the error need not be.
    """
    lines = np.minimum(_COMPARED, field.space.grid.x[-1])
    (arc, projected), (other_arc, other_projected) = (
        confined_widths(solved, lines) for solved in (field, coarser)
    )
    return float(np.abs(arc / projected - other_arc / other_projected).max())


def line_weights(lines: Array) -> tuple[Array, Array]:
    """Return points across the cells between grid lines, and weights that integrate over them."""
    return _midpoints(lines), _weights(lines)


def _midpoints(lines: Array) -> Array:
    edges = subdivided(lines, _PER_CELL)
    return 0.5 * (edges[:-1] + edges[1:])


def _weights(lines: Array) -> Array:
    return np.diff(subdivided(lines, _PER_CELL))
