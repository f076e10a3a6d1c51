"""The singularity of the flat state where the clamp meets the free edge."""

from collections.abc import Sequence

import numpy as np
from scipy.optimize import brentq

from verification.checks import Check, Table
from wrinklestudy.equilibrium import flat, newton
from wrinklestudy.fem.grid import Grid, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import membrane
from wrinklestudy.mechanics.laws import mooney_rivlin

# By strain: cell heights at the corner and largest energy densities
Densities = dict[float, list[tuple[float, float]]]

C10, C01 = 6.21e4, 1.58e5  # Pa
MATERIAL = mooney_rivlin(C10, C01)
ASPECT = 2.0
CELLS_AT_CORNER = 2  # that are halved in each direction
SMALL_STRAIN = 3.0e-3
DEEPEST = 6  # halvings for the exponent of the singularity, an even number


def williams(poisson: float) -> float:
    """Return the exponent of displacements at a right-angled corner of clamped and free edge.

    The smallest root of sin^2(pi e/2) = (4 - (1 + nu)^2 e^2)/((3 - nu)(1 + nu)) in plane stress;
    stresses grow like r^(e - 1) (Williams, J. Appl. Mech. 19, 526, 1952).
    """

    def equation(e: float) -> float:
        right = (4.0 - (1.0 + poisson) ** 2 * e**2) / ((3.0 - poisson) * (1.0 + poisson))
        return float(np.sin(0.5 * np.pi * e) ** 2 - right)

    return float(brentq(equation, 0.1, 1.0))


def halved(grid: Grid, times: int) -> Grid:
    """Return a grid whose last cells in each direction are halved some times."""
    lines = [grid.x, grid.y]
    for _ in range(times):
        last = [line[-CELLS_AT_CORNER - 1 :] for line in lines]
        middles = [0.5 * (ends[:-1] + ends[1:]) for ends in last]
        lines = [
            np.sort(np.concatenate([line, middle]))
            for line, middle in zip(lines, middles, strict=True)
        ]
    return Grid(lines[0], lines[1])


def peak_density(space: Space, strain: float) -> tuple[float, float]:
    """Return the cell height at the corner and the largest energy density W of the flat state."""
    # at small strain the terms of W(a) cancel, so that it is not known to more digits
    state = flat.solve(space, MATERIAL.law, strain, newton.NewtonOptions(tolerance=1e-14))
    gradient = space.derivatives(state.position, 2)
    density = membrane.energy(MATERIAL.law, gradient)
    return float(np.diff(space.grid.y)[-1]), float(density.max())


def twist_limit() -> float:
    """Return the stretch in pure shear from which d2W/dg12^2 is negative: l^4 = l^2 + 1 + c10/c01.

    From d2W/dg12^2 = 2 c10/det^2 + 2 c01 (tr/det^2 - 1) with det = l^2 and tr = l^2 + 1.
    """
    return float((0.5 + np.sqrt(1.25 + C10 / C01)) ** 0.5)


def exponents(strains: Sequence[float]) -> tuple[list[Check], Table, Densities]:
    """Return the exponent of the flat state's singularity, and the densities that are plotted."""
    checks, rows = [], []
    expected = williams(MATERIAL.law.poisson)
    spaces = [Space(halved(make_grid(ASPECT), times)) for times in range(0, DEEPEST + 1, 2)]
    plotted = {}
    for strain in (SMALL_STRAIN, *strains):
        peaks = [peak_density(space, strain) for space in spaces]
        plotted[strain] = peaks
        (big, low), (small, high) = peaks[-2:]
        exponent = 1.0 + 0.5 * float(np.log(high / low) / np.log(small / big))
        rows.append([f"{strain:g}", f"{peaks[0][1]:.3g}", f"{peaks[-1][1]:.3g}", f"{exponent:.4f}"])
        if strain == SMALL_STRAIN:
            reason = "root of Williams' equation for clamped and free edges, plane stress"
            name = f"exponent of the corner's singularity, strain {strain:g}"
            checks.append(Check(name, exponent, expected, 5e-3, "absolute", reason))
    columns = ("strain", "W/mu, default mesh", f"{DEEPEST} halvings", "exponent e, W ~ r^(2e-2)")
    return checks, Table("Largest energy density of the flat state", columns, rows), plotted
