"""An annulus pulled between its edges at finite strain: wrinkled around the hole, taut farther out.

A point at the radius R moves to r(R). Where the hoop stretch r/R is below the natural width
n(r') radial wrinkles leave nothing but the radial tension, and equilibrium says

    R P(r') = C,    P the uniaxial nominal stress.

Where it is above, d(R P_r)/dR = P_theta with both stresses of the law. At the circle between the
two r/R = n(r'), and r and P_r, hence r', go through.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from verification.tools.biquadratic import Elements, relax
from wrinklestudy.mechanics.laws import MooneyRivlin
from wrinklestudy.typing import Array

_TOLERANCE = 1e-12
_LARGEST = 5.0  # stretch


@dataclass(frozen=True)
class Annulus:
    """An annulus of a Mooney-Rivlin sheet; the hole has radius 1.

    Parameters
    ----------
    law : MooneyRivlin
    outer : float
        Outer radius before the deformation.
    hole : float
        Radius of the hole after it.
    pull : float
        C = R P_r at the hole, the radial load for each radian and unit of thickness, over mu.
    """

    law: MooneyRivlin
    outer: float
    hole: float
    pull: float


class RadialState(NamedTuple):
    """Axisymmetric tension field on radii."""

    radii: Array
    positions: Array  # r at the radii
    interface: float  # R between wrinkled and taut; the outer radius if there is none
    load: float  # R P_r at the outer edge
    edge: float  # r at the outer edge


def uniaxial(law: MooneyRivlin, stretch: float) -> float:
    """Return the nominal stress 2 (c10 + c01/l)(l - l^-2)."""
    return 2.0 * (law.c10 + law.c01 / stretch) * (stretch - stretch**-2)


def radial(annulus: Annulus, radii: Array) -> RadialState:
    """Return the state from the radial equation, to about 1e-10.

    Parameters
    ----------
    annulus : Annulus
    radii : (n,) array
        Increasing, from 1 to the outer radius.

    Raises
    ------
    ValueError
        If the annulus is taut at the hole.
    """
    law = annulus.law

    def stretch(radius: float) -> float:
        """Return dr/dR of the wrinkled part."""
        load = annulus.pull / radius
        return float(brentq(lambda along: uniaxial(law, along) - load, 1.0, _LARGEST, xtol=1e-15))

    def slack(radius: float, position: Array) -> float:
        """Natural width less hoop stretch."""
        return float(stretch(radius) ** -0.5 - position[0] / radius)

    if slack(1.0, np.array([annulus.hole])) <= 0.0:
        raise ValueError("the annulus is taut at the hole")
    slack.terminal = True  # type: ignore[attr-defined]
    options = {"rtol": _TOLERANCE, "atol": _TOLERANCE, "method": "DOP853", "dense_output": True}
    wrinkled = solve_ivp(
        lambda radius, _: [stretch(radius)],
        (1.0, annulus.outer),
        [annulus.hole],
        events=slack,
        **options,
    )
    interface = float(wrinkled.t[-1])
    inside = np.minimum(radii, interface)
    positions = wrinkled.sol(inside)[0]
    if interface >= annulus.outer:
        return RadialState(radii, positions, interface, annulus.pull, float(positions[-1]))
    start = [float(wrinkled.y[0, -1]), stretch(interface)]
    taut = solve_ivp(
        lambda radius, state: _taut(law, radius, state),
        (interface, annulus.outer),
        start,
        **options,
    )
    outside = radii > interface
    positions[outside] = taut.sol(radii[outside])[0]
    edge, slope = taut.y[:, -1]
    load = annulus.outer * _stress(law, slope, edge / annulus.outer)[0]
    return RadialState(radii, positions, interface, load, float(edge))


def _stress(law: MooneyRivlin, along: float, hoop: float) -> tuple[float, float, float, float]:
    """Return P_r, P_theta, dP_r/d along and dP_r/d hoop."""
    first = law.c10 * (along - along**-3 * hoop**-2) + law.c01 * (along * hoop**2 - along**-3)
    second = law.c10 * (hoop - hoop**-3 * along**-2) + law.c01 * (hoop * along**2 - hoop**-3)
    own = law.c10 * (1.0 + 3.0 * along**-4 * hoop**-2) + law.c01 * (hoop**2 + 3.0 * along**-4)
    mixed = 2.0 * law.c10 * along**-3 * hoop**-3 + 2.0 * law.c01 * along * hoop
    return 2.0 * first, 2.0 * second, 2.0 * own, 2.0 * mixed


def _taut(law: MooneyRivlin, radius: float, state: Array) -> list[float]:
    """Return r' and r'' from d(R P_r)/dR = P_theta."""
    position, slope = state
    hoop = position / radius
    here, around, own, mixed = _stress(law, slope, hoop)
    turned = (slope - hoop) / radius
    return [slope, ((around - here) / radius - mixed * turned) / own]


class PlanarState(NamedTuple):
    """The same annulus as a sheet in two dimensions."""

    radii: Array
    positions: Array  # distance from the centre at these radii, mean over the angle
    uneven: float  # largest deviation from the mean
    interface: float
    load: float


def planar(annulus: Annulus, edge: float, cells: tuple[int, int]) -> PlanarState:
    """Return the tension field of a quarter of the annulus on biquadratic elements.

    Both edges are moved to circles, of the radii `annulus.hole` and `edge`; the straight sides are
    mirrors. The load is not prescribed.

    Parameters
    ----------
    annulus : Annulus
    edge : float
        Outer radius after the deformation.
    cells : (int, int)
        Along the radius and around.
    """
    lines = np.linspace(1.0, annulus.outer, cells[0] + 1)
    elements = Elements(lines, np.linspace(0.0, 0.5 * np.pi, cells[1] + 1), polar=True)
    radius, angle = elements.nodes
    direction = np.stack([np.cos(angle), np.sin(angle)])
    moved = annulus.hole + (edge - annulus.hole) * (radius - 1.0) / (annulus.outer - 1.0)
    start = moved * direction
    free = np.ones(start.shape, dtype=bool)
    outer = np.isclose(radius, annulus.outer)
    free[:, np.isclose(radius, 1.0) | outer] = False
    free[1, np.isclose(angle, 0.0)] = free[0, np.isclose(angle, 0.5 * np.pi)] = False
    start[1, np.isclose(angle, 0.0)] = start[0, np.isclose(angle, 0.5 * np.pi)] = 0.0
    state = relax(elements, annulus.law, start, free)
    load = float((state.reactions * direction)[:, outer].sum()) / (0.5 * np.pi)
    distance = np.hypot(*state.position)
    radii, of = np.unique(np.round(radius, 10), return_inverse=True)
    positions = np.bincount(of, distance) / np.bincount(of)
    uneven = float(np.abs(distance - positions[of]).max())
    return PlanarState(radii, positions, uneven, _interface(annulus.law, radii, positions), load)


def _interface(law: MooneyRivlin, radii: Array, positions: Array) -> float:
    """Return the radius up to which wrinkles reach, from positions at ends and middles of cells.

    Slopes of parabolas are taken at two Gauss points of each cell, where they are more accurate
    than elsewhere, and the excess of the natural width is continued to zero from the wrinkled side.
    """
    inner, middle, outer = positions[:-2:2], positions[1:-1:2], positions[2::2]
    start, width = radii[:-2:2], radii[2::2] - radii[:-2:2]
    shift = 0.5 / np.sqrt(3.0)
    places, excess = [], []
    for at in (-shift, shift):  # from the middle of the cell, in cells
        slope = (outer - inner + 4.0 * at * (outer - 2.0 * middle + inner)) / width
        place = start + (0.5 + at) * width
        position = middle + at * (outer - inner) + 2.0 * at**2 * (outer - 2.0 * middle + inner)
        places.append(place)
        excess.append(law.natural_width(slope) - position / place)
    place, own = (np.stack(pair, axis=1).ravel() for pair in (places, excess))
    taut = np.flatnonzero(own < 0.0)
    if not len(taut):
        return float(radii[-1])
    cells = taut[0] // 2  # wrinkled as a whole; the next one rounds off what happens within it
    if cells == 0:
        return float(radii[0])
    last = slice(max(0, 2 * cells - 4), 2 * cells)
    degree = min(2, 2 * cells - 1)
    return float(np.polyval(np.polyfit(own[last], place[last], degree), 0.0))
