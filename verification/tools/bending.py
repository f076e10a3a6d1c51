"""Bending of the assembled sheet against closed forms: Euler buckling, elastica, clamped plate."""

from typing import NamedTuple

import numpy as np
from scipy import linalg, optimize, special
from skfem import Basis, LinearForm

from verification.tools.problem import SLOPE_X, SLOPE_Y, VALUE, LoadedSheet, affine, held, nodes
from wrinklestudy.fem.element import ElementQuadHermite
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array, Mask

STRIP_LENGTH = 2.0
STRIP_THICKNESS = 1.0e-3
PLATE_THICKNESS = 1.0e-2
PLATE_DEFLECTION = 1.0e-4
# w_max D / (q a^4) of the clamped square plate (Timoshenko and Woinowsky-Krieger, table 35; more
# digits by Taylor and Govindjee, Commun. Numer. Meth. Eng. 20, 757, 2004)
CLAMPED_PLATE = 0.00126531908


def _strip(cells: int) -> tuple[Space, Mask]:
    """Return a quarter strip with clamped ends whose width is held everywhere."""
    space = Space(Grid(np.linspace(0.0, 0.5 * STRIP_LENGTH, cells + 1), np.array([0.0, 0.25, 0.5])))
    free = held(
        space,
        middle=("odd", "free", "even"),
        clamp=("odd", "free", "both"),
        midline=("even", "free", "even"),
        edge=("even", "free", "even"),
    )
    free[1] = False
    return space, free


class Buckling(NamedTuple):
    """Critical compression of a wide strip: force per width and strain."""

    force: float
    strain: float


def euler(law: Law, bending: str, thickness: float, cells: int) -> Buckling:
    """Return the compression at which the lowest stiffness of the flat strip vanishes."""
    space, free = _strip(cells)
    free[:2] = False
    section = Section(law, thickness, bending)

    def softest(strain: float) -> float:
        position = affine(space, 1.0 - strain, 1.0)
        problem = LoadedSheet(space, section, free, position)
        upper = problem.derivatives(position[free])[2].toarray()
        metric = problem.shift().toarray()
        full = [matrix + np.triu(matrix, 1).T for matrix in (upper, metric)]
        return float(linalg.eigh(*full, eigvals_only=True, subset_by_index=[0, 0])[0])

    guess = (2.0 * np.pi / STRIP_LENGTH) ** 2 * thickness**2 / 12.0
    strain = float(optimize.brentq(softest, 0.5 * guess, 2.0 * guess, xtol=1e-12 * guess))
    position = affine(space, 1.0 - strain, 1.0)
    forces = LoadedSheet(space, section, free, position).reactions(position[free])
    end = space.edge_dofs("right", ["u"])
    return Buckling(-2.0 * float(forces[0, end].sum()), strain)


def euler_formula(law: Law, thickness: float) -> float:
    """Return 4 pi^2 D/L^2 per width with D = mu t^3/(6 (1 - nu))."""
    rigidity = thickness**3 / (6.0 * (1.0 - law.poisson))
    return 4.0 * np.pi**2 * rigidity / STRIP_LENGTH**2


class Elastica(NamedTuple):
    """A clamped strip after large end shortening: force per width and deflection."""

    force: float
    deflection: float


def elastica_formula(law: Law, shortening: float) -> tuple[Elastica, float]:
    """Return force and deflection of the inextensible strip, and the modulus k.

    Shortening/L = 2 - 2 E(k)/K(k), P = 16 K^2 D/L^2, deflection = k L/K.
    """

    def missing(m: float) -> float:
        return float(2.0 - 2.0 * special.ellipe(m) / special.ellipk(m) - shortening)

    m = float(optimize.brentq(missing, 1e-9, 1.0 - 1e-9, xtol=1e-15))
    quarter = float(special.ellipk(m))
    rigidity = STRIP_THICKNESS**3 / (6.0 * (1.0 - law.poisson))
    force = 16.0 * quarter**2 * rigidity / STRIP_LENGTH**2
    return Elastica(force, m**0.5 * STRIP_LENGTH / quarter), m


def _elastica_shape(space: Space, m: float) -> Array:
    """Return the inextensible strip as a position: sin(theta/2) = k sn(4 K s/L)."""
    rate = 4.0 * special.ellipk(m) / STRIP_LENGTH
    s = space.grid.x
    # x = int cos(theta) ds by Gauss: scipy's incomplete elliptic integral is wrong at some points
    points, weights = np.polynomial.legendre.leggauss(8)
    half_cells = 0.5 * np.diff(s)[:, None]
    inner = s[:-1, None] + half_cells * (1.0 + points)
    pieces = (1.0 - 2.0 * m * special.ellipj(rate * inner, m)[0] ** 2) @ weights
    sn, cn, dn, _ = (part[:, None] for part in special.ellipj(rate * s, m))
    values = np.array([nodes(space)] * 3)
    values[0, VALUE] = np.concatenate([[0.0], np.cumsum(half_cells[:, 0] * pieces)])[:, None]
    values[0, SLOPE_X] = 1.0 - 2.0 * m * sn**2
    values[1, VALUE], values[1, SLOPE_Y] = space.grid.y, 1.0
    values[2, VALUE] = -2.0 * np.sqrt(m) / rate * (1.0 + cn)
    values[2, SLOPE_X] = 2.0 * np.sqrt(m) * sn * dn
    return space.field_from_nodes(values)


def elastica(law: Law, bending: str, shortening: float, cells: int) -> Elastica:
    """Return force and deflection of the strip from the assembled sheet."""
    space, free = _strip(cells)
    start = _elastica_shape(space, elastica_formula(law, shortening)[1])
    # at the clamp: z = 0 and no slope, exactly
    fixed = ~free
    fixed[:2] = False
    start[fixed] = np.where(np.abs(start[fixed]) < 1e-12, 0.0, start[fixed])
    problem = LoadedSheet(space, Section(law, STRIP_THICKNESS, bending), free, start)
    position = problem.solve()
    forces = problem.reactions(position[free])
    end = space.edge_dofs("right", ["u"])
    heights = space.nodes_from_field(position)[2, VALUE, :, 0]
    return Elastica(-2.0 * float(forces[0, end].sum()), abs(float(heights[0] - heights[-1])))


def clamped_plate(law: Law, bending: str, cells: int) -> float:
    """Return w_max D/(q a^4) of a clamped square plate under a small uniform pressure.

    The pressure is such that w_max is about `PLATE_DEFLECTION` of the thickness, so that the
    stretching of the mid-plane changes it by the square of that only.
    """
    lines = np.linspace(0.0, 0.5, cells + 1)
    space = Space(Grid(lines, lines))
    free = held(
        space,
        middle=("odd", "even", "even"),
        clamp=("odd", "odd", "both"),
        midline=("even", "odd", "even"),
        edge=("odd", "odd", "both"),
    )
    rigidity = PLATE_THICKNESS**3 / (6.0 * (1.0 - law.poisson))
    pressure = PLATE_DEFLECTION * PLATE_THICKNESS * rigidity / CLAMPED_PLATE
    basis = Basis(space.mesh, ElementQuadHermite(), intorder=6)
    load = np.zeros((3, space.size))
    load[2] = pressure * LinearForm(lambda v, _: v).assemble(basis)
    section = Section(law, PLATE_THICKNESS, bending)
    position = LoadedSheet(space, section, free, affine(space, 1.0, 1.0), load).solve(rough=0.1)
    return float(space.nodes_from_field(position)[2, VALUE, 0, 0]) * rigidity / pressure
