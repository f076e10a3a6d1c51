"""Critical thicknesses of sheets of one L/W over strain: the columns of a map over (eps, L/W).

The flat state does not depend on the thickness, the bending law or the parity of the wrinkles, so
that one of them serves all sheets of one law, L/W and strain. Each is continued from those at
smaller strains, and so is each mode.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np

from wrinklestudy.equilibrium.critical_shape import ModeShape, mode_shape
from wrinklestudy.equilibrium.flat import Flat, stretched
from wrinklestudy.equilibrium.flat import solve as solve_flat
from wrinklestudy.equilibrium.modes import CriticalMode, critical_mode
from wrinklestudy.equilibrium.quartic import quartic_coefficients
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import Grid, MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.bending import BENDING_LAWS
from wrinklestudy.mechanics.laws import Law
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import PARITIES, MapStatus, Parity

# Design thickness t/W of the mesh: near L/W = 1.3 it takes thinner sheets, with more waves.
_DESIGN_THICKNESS, _SHORT_DESIGN_THICKNESS, _SHORT = 1.0e-3, 2.5e-4, 1.5
_ALONG = 0.5  # of the cells along that wrinkled states take
_ABOVE = 1.02  # a bound of tau_1 over what is expected
_REMEMBERED = 3  # strains from which the next flat state is extrapolated


@dataclass(frozen=True)
class CriticalState:
    """What is known of small wrinkles of one parity at one strain, in units of W.

    Parameters
    ----------
    strain : float
        eps of the clamps.
    bending : str
        Bending law.
    parity : {'antisymmetric', 'symmetric'}
        Of the deflection across y = 0.
    status : {'unstable', 'stable', 'not-converged'}
        Whether sheets thinner than tau_1 wrinkle, none does, or it is not known.
    reason : str
        Why it is not known; else empty.
    critical_thickness : float or None
        tau_1/W, zero where stable; None where it is not known.
    corner_thickness : float or None
        Largest critical thickness of a mode of the corners, where it is above tau_1; such modes
        are never counted as wrinkles. None without one.
    half_waves : int or None
        Crests and troughs across the whole width where the mode is largest.
    largest_at : float or None
        X/L of the largest |w| of the mode, 0 at the centre and 1/2 at the clamp.
    quartic : float or None
        g of the wrinkle just below tau_1, (A/t)^2 = ((tau_1/t)^2 - 1)/(2 g) with A the largest |w|
        over the sheet: g = G / max(phi)^2 of the reduced energy of `modes` for phi . B phi = 1,
        which does not depend on how the mode is scaled. Supercritical if g > 0, subcritical if
        g < 0. The part of bending, smaller by (t k)^2, is left out.
    """

    strain: float
    bending: str
    parity: Parity
    status: MapStatus
    reason: str = ""
    critical_thickness: float | None = None
    corner_thickness: float | None = None
    half_waves: int | None = None
    largest_at: float | None = None
    quartic: float | None = None


def map_grid(aspect: float, settings: MeshSettings | None = None) -> Grid:
    """Return the mesh on which tau_1 is computed over all strains.

    It has the cells across of a sheet of t/W = 1e-3, or of 2.5e-4 below L/W = 1.5, but half of its
    cells along, or as many as leave no cell at the corner wider than high: such cells have modes
    there that no finer mesh has. The default mesh gives tau_1 to 0.2% or better from L/W = 1.4 on,
    to 1% at 1.3, where tau_1/W stays below 3e-4 (strains up to 1, the paper's constants).

    Raises
    ------
    ValueError
        As `make_grid`.
    """
    settings = settings or MeshSettings()
    design = _SHORT_DESIGN_THICKNESS if aspect < _SHORT else _DESIGN_THICKNESS
    along, across = make_grid(aspect, design, settings).cells
    longest = 0.5 * aspect
    square = (longest / (0.5 / across)) ** (1.0 / settings.grading)
    lines = np.linspace(0.0, 1.0, max(math.ceil(_ALONG * along), math.ceil(square - 1e-9)) + 1)
    x = longest * (1.0 - (1.0 - lines) ** settings.grading)
    return Grid(x, np.linspace(0.0, 0.5, across + 1))


def critical_states(
    grid: Grid | Space,
    law: Law,
    strains: Iterable[float],
    bendings: Sequence[str] = (next(iter(BENDING_LAWS)),),
    parities: Sequence[Parity] = PARITIES,
    report: Callable[[float], None] | None = None,
) -> list[CriticalState]:
    """Return tau_1 with its mode for all strains, bending laws and parities, in this order.

    Parameters
    ----------
    grid : Grid or Space
        Of the quarter sheet; see `map_grid`.
    law : Law
        Dimensionless material law.
    strains : iterable of float
        eps > 0; computed from the smallest to the largest, each once.
    bendings, parities : sequences of str
    report : callable, optional
        Called with each strain when it is done.
    """
    space = grid if isinstance(grid, Space) else Space(grid)
    path = FlatPath(space, law)
    kinds = [(bending, parity) for bending in bendings for parity in parities]
    guesses = {kind: _ModeGuess() for kind in kinds}
    states: list[CriticalState] = []
    for strain in sorted({float(strain) for strain in strains}):
        try:
            states += _at_strain(path.solve(strain), guesses)
        except ArithmeticError as error:
            states += [CriticalState(strain, *k, "not-converged", str(error)) for k in kinds]
        if report is not None:
            report(strain)
    return states


@dataclass
class FlatPath:
    """Flat states at growing strains, each started from those before it."""

    space: Space
    law: Law
    known: list[tuple[float, Array]] = field(default_factory=list)

    def solve(self, strain: float) -> Flat:
        """Return the flat state at a strain, the largest so far.

        Raises
        ------
        NotConvergedError
            As `flat.solve`.
        """
        flat = solve_flat(self.space, self.law, strain, start=self._start(strain))
        beyond = flat.position - stretched(self.space, strain)
        self.known = [*self.known[1 - _REMEMBERED :], (strain, beyond)]
        return flat

    def _start(self, strain: float) -> Array | None:
        """Extrapolate by a polynomial what the states have beyond the first guess."""
        if not self.known:
            return None
        start = stretched(self.space, strain)
        for at, beyond in self.known:
            others = [other for other, _ in self.known if other != at]
            start += np.prod([(strain - other) / (at - other) for other in others]) * beyond
        return start


@dataclass
class _ModeGuess:
    """The last mode of one kind and what tau_1^2 was at the last strains."""

    shape: Array | None = None
    squared: list[tuple[float, float]] = field(default_factory=list)

    def near(self, strain: float) -> float | None:
        """Return a thickness a little above the tau_1 that is to be expected; None if unknown."""
        if not self.squared or self.squared[-1][1] == 0.0:
            return None
        (before, first), (last, second) = (self.squared[0], self.squared[-1])
        slope = (second - first) / (last - before) if last > before else 0.0
        return _ABOVE * float(np.sqrt(max(second + slope * (strain - last), 0.25 * second)))

    def learn(self, strain: float, mode: CriticalMode) -> None:
        """Keep a mode for the next strain."""
        self.shape = mode.shape
        highest = max(mode.thickness, mode.corner_thickness)
        self.squared = [*self.squared[-1:], (strain, highest**2)]


def _at_strain(flat: Flat, guesses: dict[tuple[str, Parity], _ModeGuess]) -> list[CriticalState]:
    """Return the states of all kinds at the strain of a flat state."""
    modes: dict[tuple[str, Parity], CriticalMode | ArithmeticError] = {}
    expected: dict[str, float] = {}  # the parities have nearly the same tau_1
    for (bending, parity), guess in guesses.items():
        symmetry = Symmetry.mirrored(parity)
        near = expected.get(bending) or guess.near(flat.strain)
        try:
            mode = critical_mode(flat, bending, symmetry, near, guess.shape)
        except ArithmeticError as error:
            modes[bending, parity] = error
            continue
        guess.learn(flat.strain, mode)
        expected[bending] = _ABOVE * max(mode.thickness, mode.corner_thickness)
        modes[bending, parity] = mode
    shapes = {
        kind: mode.shape
        for kind, mode in modes.items()
        if isinstance(mode, CriticalMode) and mode.shape is not None
    }
    quartic = dict(zip(shapes, quartic_coefficients(flat, list(shapes.values())), strict=True))
    return [_state(flat, kind, mode, quartic.get(kind)) for kind, mode in modes.items()]


def _state(
    flat: Flat,
    kind: tuple[str, Parity],
    mode: CriticalMode | ArithmeticError,
    quartic: float | None,
) -> CriticalState:
    bending, parity = kind
    if isinstance(mode, ArithmeticError):
        return CriticalState(flat.strain, bending, parity, "not-converged", str(mode))
    seen: ModeShape | None = None
    if mode.shape is not None:
        seen = mode_shape(flat.space, mode.shape, Symmetry.mirrored(parity))
    return CriticalState(
        flat.strain,
        bending,
        parity,
        "stable" if seen is None else "unstable",
        critical_thickness=mode.thickness,
        corner_thickness=mode.corner_thickness or None,
        half_waves=None if seen is None else seen.half_waves,
        largest_at=None if seen is None else seen.largest_at,
        quartic=None if seen is None or quartic is None else float(quartic) / seen.largest**2,
    )
