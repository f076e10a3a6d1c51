"""Wrinkles of a thin sheet far from threshold: one wavelength under a slowly varying amplitude.

The tension field says how much width the wrinkles hide, not how many they are. In a thin sheet the
deflection w = a(X, Y) sin(k Y) hides it; per reference area, averaged over a wave, it costs

    T a,X^2/4 + t^2 B (k^4 a^2 + 6 k^2 a,Y^2)/4 + C/2 (k^2 a^2/2 - (n^2 - b))^2

for each unit of thickness: the tension T along the fibres, the bending stiffness t^3 B across them,
and the stiffness C of the metric across them against what is hidden too little or too much, n
being the natural width and b the squared width stretch. Minimised over a and k: the balance of
bending and tension that sets the wavelength (Cerda and Mahadevan, Phys. Rev. Lett. 90, 074302,
2003), over the length and the width that the tension field itself has.
"""

from dataclasses import dataclass

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium.tension_field import TensionField
from wrinklestudy.fem.factorisation import make_solver
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.transfer import transferred
from wrinklestudy.mechanics.relaxed import RelaxedLaw, principal_stretches
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

_ACROSS = 120  # intervals across half the width, for the amplitude
_FACTOR = 0.8  # of the wavelength of Cerda and Mahadevan, to begin with
_SLIGHT = 1e-7  # hidden part of the squared width from which the amplitude begins to be sought
_NOTHING = 1e-3  # of the thickness: a lower amplitude is none
_SAME_WAVE = 2e-3  # relative change of k at which the search for it ends
_MAX_WAVES = 20
_MAX_ITERATIONS = 60
_MAX_HALVINGS = 20
_TOLERANCE = 1e-10


@dataclass(frozen=True, eq=False)
class ThinWrinkles:
    """Wrinkles of one wave number under an envelope, lengths in units of W.

    Parameters
    ----------
    space : Space
        The grid that the amplitude is given on.
    amplitude : (nx + 1, ny + 1) array
        a at its nodes.
    wave_number : float
        k, per length of the undeformed width.
    width_stretch : float
        Deformed over undeformed width at the centre.
    """

    space: Space
    amplitude: Array
    wave_number: float
    width_stretch: float

    @property
    def wavelength(self) -> float:
        """2 pi/k on the deformed sheet, at its centre."""
        return 2.0 * np.pi / self.wave_number * self.width_stretch

    @property
    def largest_amplitude(self) -> float:
        """The largest a on X = 0."""
        return float(self.amplitude[0].max())

    def deflection(self, space: Space, odd: bool) -> Array:
        """Return w = a sin(k Y), or a cos(k Y), as a dof vector (size,) of a space.

        Parameters
        ----------
        space : Space
            On a grid of the same rectangle.
        odd : bool
            Whether w is odd in Y.
        """
        x, y = self.space.grid.x, self.space.grid.y
        slope_x, slope_y = (_slope(self.amplitude, lines, n) for n, lines in enumerate((x, y)))
        slope_x[0] = slope_x[-1] = 0.0  # mirror and clamp
        nodes = np.stack([self.amplitude, slope_x, slope_y, _slope(slope_x, y, 1)])
        smooth = transferred(self.space.field_from_nodes(nodes), self.space, space)
        a, a_x, a_y, a_xy = space.nodes_from_field(smooth)
        k = self.wave_number
        sine, cosine = np.sin(k * space.grid.y), np.cos(k * space.grid.y)
        wave, slope = (sine, k * cosine) if odd else (cosine, -k * sine)
        parts = (a * wave, a_x * wave, a_y * wave + a * slope, a_xy * wave + a_x * slope)
        return space.field_from_nodes(np.stack(parts))


def envelope(field: TensionField, thickness: float, bending: str) -> ThinWrinkles | None:
    """Return the wrinkles of a sheet of thickness t/W, or None where it has none.

    It has none where the field hides no width, or too little for a sheet so thick.

    Parameters
    ----------
    field : TensionField
        Converged, of the quarter sheet.
    thickness : float
        t/W.
    bending : str
        The bending law, a name in `BENDING_LAWS`.
    """
    grid = Grid(field.space.grid.x, np.linspace(0.0, field.space.grid.y[-1], _ACROSS + 1))
    space = Space(grid)
    nodes = space.nodes_from_field(transferred(field.position, field.space, space))
    densities = _densities(field, grid, nodes, thickness, bending)
    if densities is None:
        return None
    length = 2.0 * float(grid.x[-1])
    k = 2.0 * np.pi * (2.25 * field.strain) ** 0.25 / _FACTOR
    k /= np.sqrt(2.0 * np.pi * length * thickness * (1.0 + field.strain))
    stretch = float(np.hypot(*nodes[:, 2, 0, 0]))
    hidden = np.sqrt(2.0 * np.maximum(densities.hidden, _SLIGHT))
    amplitude = densities.amplitude(k, hidden / k)
    for _ in range(_MAX_WAVES):
        if not amplitude.max() > _NOTHING * thickness:
            return None
        last, k = k, densities.balance(amplitude, k)
        amplitude = densities.amplitude(k, amplitude * last / k)
        if abs(k - last) <= _SAME_WAVE * k:
            break
    return ThinWrinkles(space, amplitude, k, stretch)


class _Densities:
    """The energy of an amplitude on a grid; the arrays have the shape of its nodes."""

    def __init__(
        self, grid: Grid, tension: Array, bending: Array, stiffness: Array, hidden: Array
    ) -> None:
        weights = np.outer(_trapezoidal(grid.x), _trapezoidal(grid.y))
        along, across = (_differences(lines) for lines in (grid.x, grid.y))
        one_x, one_y = (sparse.eye_array(len(lines)) for lines in (grid.x, grid.y))
        self.hidden, self._shape = hidden, hidden.shape
        self._stiffness = (stiffness * weights).ravel()
        self._bending = (bending * weights).ravel()
        in_x = np.outer(np.diff(grid.x), _trapezoidal(grid.y))
        in_y = np.outer(_trapezoidal(grid.x), np.diff(grid.y))
        tension, bending = (_between(tension, 0) * in_x, _between(bending, 1) * in_y)
        self._pulled = _squares(sparse.kron(along, one_y), tension)
        self._bent = _squares(sparse.kron(one_x, across), bending)
        free = np.ones(self._shape, dtype=bool)
        free[-1] = False  # the clamp
        self._free = np.flatnonzero(free)

    def balance(self, amplitude: Array, k: float) -> float:
        """Return the k of least energy for what an amplitude hides at another k: phi = k a held."""
        phi = k * amplitude.ravel()
        return float((phi @ (self._pulled @ phi) / (self._bending @ phi**2)) ** 0.25)

    def amplitude(self, k: float, start: Array) -> Array:
        """Return the amplitude of least energy at a wave number, by Newton's method."""
        linear = 0.5 * self._pulled + 3.0 * k**2 * self._bent
        linear = sparse.csr_array(linear + sparse.diags_array(0.5 * k**4 * self._bending))
        hidden, free = self.hidden.ravel(), self._free

        def energy(a: Array) -> float:
            surplus = 0.5 * k**2 * a**2 - hidden
            return 0.5 * float(a @ (linear @ a) + self._stiffness @ surplus**2)

        solver = make_solver()
        a = np.zeros(hidden.size)
        a[free] = start.ravel()[free]
        for _ in range(_MAX_ITERATIONS):
            surplus = 0.5 * k**2 * a**2 - hidden
            residual = linear @ a + self._stiffness * surplus * k**2 * a
            # without the part that is negative where too little is hidden: definite everywhere
            local = self._stiffness * (k**4 * a**2 + k**2 * np.maximum(surplus, 0.0))
            tangent = (linear + sparse.diags_array(local))[free][:, free]
            solver.factorise(sparse.triu(tangent, format="csr"))
            step = np.zeros_like(a)
            step[free] = -solver.solve(residual[free])
            decrement, now, length = -float(residual @ step), energy(a), 1.0
            for _ in range(_MAX_HALVINGS):
                if energy(a + length * step) <= now - 1e-4 * length * decrement:
                    break
                length *= 0.5
            a = np.abs(a + length * step)
            if decrement <= _TOLERANCE * now:
                break
        return a.reshape(self._shape)


def _densities(
    field: TensionField, grid: Grid, nodes: Array, thickness: float, bending: str
) -> _Densities | None:
    """Return the coefficients of the energy at nodes, or None where no width is hidden."""
    along, across = nodes[:, 1], nodes[:, 2]
    metric = np.stack([(along**2).sum(0), (across**2).sum(0), (along * across).sum(0)])
    stretches, relaxed = principal_stretches(metric), RelaxedLaw(field.law)
    natural = relaxed.natural_square(stretches.larger)
    hidden = natural - stretches.smaller
    if not (np.isfinite(hidden).all() and (natural > 0.0).all() and hidden[:-1].max() > 0.0):
        return None
    uniaxial = np.stack([stretches.larger, natural, np.zeros_like(natural)])
    stress, stiffness = field.law.derivatives(uniaxial)
    section = Section(field.law, 1.0, bending)
    bent = section.derivatives(uniaxial, np.zeros_like(uniaxial)).bending[1, 1]
    tension = np.maximum(2.0 * stress[0], 0.0)
    return _Densities(grid, tension, thickness**2 * bent, stiffness[1, 1], hidden)


def _trapezoidal(lines: Array) -> Array:
    wide = np.diff(lines)
    return 0.5 * (np.append(wide, 0.0) + np.append(0.0, wide))


def _between(values: Array, axis: int) -> Array:
    rows = np.moveaxis(values, axis, 0)
    return np.moveaxis(0.5 * (rows[1:] + rows[:-1]), 0, axis)


def _differences(lines: Array) -> sparse.csr_array:
    """Return the matrix of the slopes between points."""
    steep = 1.0 / np.diff(lines)
    shape = (len(steep), len(lines))
    return sparse.csr_array(sparse.diags_array([-steep, steep], offsets=[0, 1], shape=shape))


def _squares(slopes: sparse.csr_array, weights: Array) -> sparse.csr_array:
    """Return the matrix of the sum of weighted squares of slopes."""
    return sparse.csr_array(slopes.T @ sparse.diags_array(weights.ravel()) @ slopes)


def _slope(values: Array, lines: Array, axis: int) -> Array:
    return np.asarray(np.gradient(values, lines, axis=axis, edge_order=2))
