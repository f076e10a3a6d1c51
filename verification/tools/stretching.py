"""Homogeneous stretch of the assembled sheet against the formulas of material tests."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from verification.tools.problem import VALUE, LoadedSheet, affine, held, nodes
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import laws
from wrinklestudy.mechanics.laws import Law, MooneyRivlin, SaintVenantKirchhoff
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

CASES: dict[str, tuple[Law, tuple[float, ...]]] = {
    "mooney-rivlin": (laws.mooney_rivlin(6.21e4, 1.58e5).law, (1.1, 1.5, 2.0)),
    "neo-hookean": (laws.neo_hookean(1.0).law, (1.1, 1.5, 2.0)),
    "svk": (laws.saint_venant_kirchhoff(1.0, 0.5).law, (1.05, 1.1)),
}
MODES = ("uniaxial", "shear", "biaxial")
THICKNESS = 1.0e-3
ASPECT = 2.0
_CELLS = MeshSettings(6, 5)
_SHAKE = 0.02  # of the first guess, in parts of a cell


class Stretched(NamedTuple):
    """Nominal stresses in units of mu, and how far the state is from being homogeneous."""

    along: float
    across: float
    width: float  # y(W/2) / (W/2)
    deviation: float  # largest difference of a node's position from the affine one


def exact(law: Law, mode: str, stretch: float) -> tuple[float, float, float]:
    """Return nominal stress along and across in units of mu, and the stretch across.

    With I1 = l1^2 + l2^2 + (l1 l2)^-2 and I2 = (l1 l2)^2 + l1^-2 + l2^-2 the nominal stress is
    T1 = 2 c10 (l1 - l1^-3 l2^-2) + 2 c01 (l1 l2^2 - l1^-3), T2 likewise; l2 = l1^(-1/2) uniaxial, 1
    in pure shear, l1 biaxial. SVK: T1 = 2 l1 (E11 + nu E22)/(1 - nu) with E = (l^2 - 1)/2, and
    E22 = -nu E11 uniaxial.
    """
    if isinstance(law, MooneyRivlin):
        across = {"uniaxial": stretch**-0.5, "shear": 1.0, "biaxial": stretch}[mode]

        def nominal(a: float, b: float) -> float:
            first = law.c10 * (a - a**-3 * b**-2)
            return 2.0 * (first + law.c01 * (a * b**2 - a**-3))

        return nominal(stretch, across), nominal(across, stretch), across
    if not isinstance(law, SaintVenantKirchhoff):
        raise TypeError(f"{type(law).__name__} has no closed form here")
    nu, green = law.poisson, 0.5 * (stretch**2 - 1.0)
    transverse = {"uniaxial": -nu * green, "shear": 0.0, "biaxial": green}[mode]
    across = (1.0 + 2.0 * transverse) ** 0.5
    first = 2.0 * stretch * (green + nu * transverse) / (1.0 - nu)
    return first, 2.0 * across * (transverse + nu * green) / (1.0 - nu), across


def solve(law: Law, mode: str, stretch: float) -> Stretched:
    """Solve a quarter sheet whose ends are pulled without holding its width.

    The end X = L/2 is moved to stretch L/2 and slides freely in y; the long edge is free
    (uniaxial) or moved (shear, biaxial). Newton starts from a shaken homogeneous state.
    """
    space = Space(make_grid(ASPECT, settings=_CELLS))
    across = exact(law, mode, stretch)[2]
    free = held(
        space,
        middle=("odd", "even", "even"),
        clamp=("odd", "free", "both"),
        midline=("even", "odd", "odd"),
        edge=("free", "free" if mode == "uniaxial" else "odd", "free"),
    )
    start = affine(space, stretch, across)
    expected = start.copy()
    shake = np.random.default_rng(4).uniform(-1.0, 1.0, start.shape) * space.cell_sizes.min()
    shake[2] *= 1e-3
    start[free] += _SHAKE * _value_scale(space, shake)[free]
    problem = LoadedSheet(space, Section(law, THICKNESS), free, start)
    position = problem.solve()
    forces = problem.reactions(position[free])
    line = nodes(space)
    line[VALUE, -1] = 1.0
    end = space.field_from_nodes(line) == 1.0
    line = nodes(space)
    line[VALUE, :, -1] = 1.0
    edge = space.field_from_nodes(line) == 1.0
    return Stretched(
        2.0 * float(forces[0, end].sum()) / THICKNESS,
        float(forces[1, edge].sum()) / (0.5 * ASPECT * THICKNESS),
        float(2.0 * position[1, edge].mean()),
        float(np.abs(space.nodes_from_field(position - expected)[:, VALUE]).max()),
    )


def _value_scale(space: Space, shake: Array) -> Array:
    """Return a field of which only the nodal values differ from zero."""
    values = space.nodes_from_field(shake)
    values[:, 1:] = 0.0
    return space.field_from_nodes(values)


def cases() -> Sequence[tuple[str, Law, str, float]]:
    """Return name of the law, law, mode and stretch of all cases."""
    return [
        (name, law, mode, stretch)
        for name, (law, stretches) in CASES.items()
        for mode in MODES
        for stretch in stretches
    ]
