"""Cylindrical bending stiffness of a uniformly stretched sheet, and Rivlin's exact flexure."""

import numpy as np
from scipy import optimize

from verification.tools.problem import SLOPE_X, SLOPE_Y, VALUE, LoadedSheet, affine, nodes
from verification.tools.stretching import exact
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.upper_triangle import multiply
from wrinklestudy.mechanics.laws import Law, MooneyRivlin, SaintVenantKirchhoff
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

THICKNESS = 1.0e-2


def stiffness_formula(law: Law, bending: str, stretch: float) -> tuple[float, float]:
    """Return the stiffness D/t^3 of a uniaxially stretched sheet along and across the pull.

    psi = t W(a) + (t^3/6) lambda3^2 b.W''.b: D = (t^3/3) lambda3^2 d2W/dg^2 in the direction of
    bending, per reference area and for the curvature b = n.x,kk.
    """
    nu = law.poisson
    if bending == "fvk":
        return 1.0 / (6.0 * (1.0 - nu)), 1.0 / (6.0 * (1.0 - nu))
    if isinstance(law, MooneyRivlin):
        along = 2.0 * law.c10 * stretch**-5 + 2.0 * law.c01 * stretch**-6
        across = 2.0 * law.c10 * stretch + 2.0 * law.c01 * stretch**3
        squared = 1.0 / stretch
    elif isinstance(law, SaintVenantKirchhoff):
        along = across = 0.5 / (1.0 - nu)
        squared = 1.0 - nu * (stretch**2 - 1.0)
    else:
        raise TypeError(f"{type(law).__name__} has no closed form here")
    if bending == "fixed-thickness":
        squared = 1.0
    return along * squared / 3.0, across * squared / 3.0


def stiffness(law: Law, bending: str, stretch: float) -> tuple[float, float]:
    """Return the same from the assembled tangent: its value on w = X^2/2 and w = Y^2/2.

    The part of the tension along X, 2 t W_g11 times the integral of w,1^2, is taken off.
    """
    thickness, length = THICKNESS, 1.0
    space = Space(Grid(np.linspace(0.0, length, 5), np.linspace(0.0, 0.5, 5)))
    nominal, _, across = exact(law, "uniaxial", stretch)
    position = affine(space, stretch, across)
    free = np.zeros(position.shape, dtype=bool)
    free[2] = True
    problem = LoadedSheet(space, Section(law, thickness, bending), free, position)
    tangent = problem.derivatives(position[free])[2]
    stiffnesses = []
    for axis, line, slope in ((0, space.grid.x[:, None], SLOPE_X), (1, space.grid.y, SLOPE_Y)):
        deflection = nodes(space)
        deflection[VALUE], deflection[slope] = 0.5 * line**2, line
        w = space.field_from_nodes(deflection)
        twice = float(w @ multiply(tangent, w))
        if axis == 0:
            twice -= thickness * nominal / stretch * 0.5 * length**3 / 3.0
        stiffnesses.append(twice / (0.5 * length) / thickness**3)
    return stiffnesses[0], stiffnesses[1]


def flexure(law: MooneyRivlin, stretch: float, bend: float) -> float:
    """Return the exact energy of bending a stretched block across the pull, over t^3 b^2/2.

    Rivlin's flexure (Proc. R. Soc. A 195, 463, 1949) of an incompressible block that is held at a
    stretch along X and bent into a cylinder around that axis: r^2 is linear in Z, so that the
    squared stretch p around the cylinder is p0 + 2 c Z/lambda with the angle c Y. With the energy
    W(p) of plane stress, U(c) = int W(p) dZ; traction-free faces mean W(p+) = W(p-), which is
    also dU/dp0 = 0.

    Parameters
    ----------
    law : MooneyRivlin
    stretch : float
        lambda along the pull; the width of the block is free.
    bend : float
        t lambda3 kappa, thickness over radius in the deformed state: about the difference of the
        stretches of both faces in parts of their mean.
    """
    across = stretch**-0.5  # of the straight block
    half = bend * across**2  # of the range of p
    points, weights = np.polynomial.legendre.leggauss(20)

    def energy(p: Array) -> Array:
        return law.energy(np.array([np.full_like(p, stretch**2), p, np.zeros_like(p)]))

    def jump(middle: float) -> float:
        ends = energy(np.array([middle - half, middle + half]))
        return float(ends[1] - ends[0])

    middle = float(optimize.brentq(jump, across**2, across**2 + half, xtol=1e-15))
    straight = energy(np.array([across**2]))[0]
    mean = float(0.5 * weights @ (energy(middle + half * points) - straight))
    # half = c t/lambda and b = lambda2 c; energies for each unit of thickness
    curvature = half * stretch * across / THICKNESS
    return mean / (0.5 * THICKNESS**2 * curvature**2)


def flexure_plate(law: MooneyRivlin, bending: str, stretch: float, bend: float) -> float:
    """Return the same from the plate's energy psi(a, b), least over the stretch across."""
    across = stretch**-0.5
    half = bend * across**2
    angle = half * stretch / THICKNESS  # c
    section = Section(law, THICKNESS, bending)

    def energy(squared: float) -> float:
        # a cylinder of the angle c Y: b = c^2 r = c sqrt(a22)
        metric = np.array([stretch**2, squared, 0.0])[:, None]
        curvature = np.array([0.0, angle * squared**0.5, 0.0])[:, None]
        return float(section.energy(metric, curvature)[0])

    least = optimize.minimize_scalar(
        energy, bounds=(0.9 * across**2, 1.1 * across**2), method="bounded", options={"xatol": 1e-9}
    )
    straight = float(law.energy(np.array([stretch**2, across**2, 0.0])[:, None])[0]) * THICKNESS
    return (float(least.fun) - straight) / (0.5 * THICKNESS**3 * (angle * across) ** 2)
