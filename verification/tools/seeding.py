"""Minimisation of one sheet from many seeds: single modes of several sizes and random mixes."""

from typing import NamedTuple

import numpy as np

from verification.checks import Check, Table
from verification.tools.sheets import amplitude, energy_below
from wrinklestudy.equilibrium.modes import Modes
from wrinklestudy.equilibrium.planar import Planar
from wrinklestudy.equilibrium.quartic import pairs
from wrinklestudy.equilibrium.seeds import seed_position
from wrinklestudy.equilibrium.wrinkled import Equilibrium, WrinkleSettings, minimise_from
from wrinklestudy.typing import Array

SIZES = (0.3, 1.0, 3.0)  # of single modes, in parts of the amplitude that their own energy asks for
_MIXES = 4
_SAME = 1e-6  # relative difference of the energies saved, below which two states are the same
AGREE = 1e-8  # relative; what one and the same state must keep
_SETTINGS = WrinkleSettings(max_iterations=150)


class SeededMinima(NamedTuple):
    """States that many seeds led to."""

    planar: Planar
    thickness: float
    unstable: int  # modes of the flat state
    states: tuple[tuple[str, Equilibrium], ...]  # one per seed, with its name

    @property
    def converged(self) -> list[Equilibrium]:
        """States that are minima."""
        return [state for _, state in self.states if state.status == "wrinkled"]

    @property
    def gains(self) -> Array:
        """Energy below the flat state of each minimum, mu W^3."""
        return np.array([energy_below(state) for state in self.converged])

    @property
    def amplitudes(self) -> Array:
        """A/t of each minimum."""
        return np.array([amplitude(state) for state in self.converged])

    @property
    def distinct(self) -> int:
        """Number of minima of different energy."""
        gains = np.sort(self.gains)
        return int(np.sum(np.diff(gains) > _SAME * gains[1:])) + 1 if len(gains) else 0


def spread(values: Array) -> float:
    """Return (largest - smallest) / largest."""
    return float(np.ptp(values) / np.abs(values).max())


def seeds(modes: Modes, thickness: float, sizes: tuple[float, ...] = SIZES) -> dict[str, Array]:
    """Return amplitudes of the modes to start from, by name.

    A single mode has q^2 = (tau^2 - t^2) / (2 G) where its own reduced energy is least.
    """
    count = len(modes.squared)
    diagonal = np.array([k for k, (i, j) in enumerate(pairs(count)) if i == j])
    room = np.maximum(modes.squared - thickness**2, 0.0)
    size = np.sqrt(room / (2.0 * modes.quartic[diagonal, diagonal]))
    single = {
        f"mode {k + 1} x {factor:g}": factor * size * (np.arange(count) == k)
        for k in np.flatnonzero(room > 0.0)
        for factor in sizes
    }
    rng = np.random.default_rng(1)
    return single | {f"mix {k + 1}": size * rng.standard_normal(count) for k in range(_MIXES)}


def minima(planar: Planar, thickness: float, sizes: tuple[float, ...] = SIZES) -> SeededMinima:
    """Minimise the energy from all `seeds` of a planar state."""
    if planar.flat is None or planar.modes is None:
        raise ValueError(f"no flat state: {planar.reason}")
    states = []
    for name, q in seeds(planar.modes, thickness, sizes).items():
        start = seed_position(planar.flat, planar.modes, q)
        states.append((name, minimise_from(planar, thickness, start, _SETTINGS)))
    unstable = int(np.sum(planar.modes.squared > thickness**2))
    return SeededMinima(planar, thickness, unstable, tuple(states))


def checks(minima: SeededMinima) -> list[Check]:
    """Return the checks that all seeds lead to one minimum."""
    planar = minima.planar
    name = f"t/W = {minima.thickness:g}, strain {planar.strain:g}, {planar.settings.parity}"
    return [
        Check(
            f"{name}: seeds that end in a minimum",
            len(minima.converged),
            len(minima.states),
            kind="absolute",
            reason="every seed must lead to a wrinkled state",
        ),
        Check(
            f"{name}: spread of the energy saved",
            spread(minima.gains),
            AGREE,
            kind="at most",
            reason="one and the same minimum from every seed; relative",
        ),
        Check(
            f"{name}: spread of A/t",
            spread(minima.amplitudes),
            AGREE,
            kind="at most",
            reason="one and the same minimum from every seed; relative",
        ),
    ]


def table(cases: list[SeededMinima]) -> Table:
    """Return the minima, a row for each sheet, strain and parity."""
    rows: list[list[str | int]] = [
        [
            f"{f.thickness:g}",
            f"{f.planar.strain:g}",
            f.planar.settings.parity,
            " x ".join(map(str, f.planar.grid.cells)),
            f.unstable,
            len(f.states),
            f.distinct,
            f"{f.converged[0].energy:.9e}",
            f"{f.gains[0]:.6e}",
            f"{f.amplitudes[0]:.5f}",
        ]
        for f in cases
    ]
    return Table(
        "Minima from many seeds (energies of the quarter in mu W^3)",
        [
            "t/W", "strain", "parity", "cells", "unstable modes of the flat state", "seeds",
            "minima", "energy", "saved", "A/t",
        ],
        rows,
    )  # fmt: skip
