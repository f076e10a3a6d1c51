"""Stability of both parities against sliding the pattern, and in the whole sheet at once.

Sliding the pattern sideways by a phase p mixes the two parities, w = w_a cos p + w_s sin p, and
with one harmonic the energy is E_a + (E_s - E_a) sin^2 p. The softest perturbation of each is then
the other, and for the eigenvalues mu of K v = mu t^3 B v

    E_s - E_a = mu_a t^3 w_s.B w_s / 2 = -mu_s t^3 w_a.B w_a / 2.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from verification.tools.mirrors import SLIDING
from verification.tools.sheets import (
    LATEX,
    PARITIES,
    THICKNESS,
    bending_square,
    both_parities,
    energy_below,
    planar_state,
    quarter,
    wrinkled,
)
from wrinklestudy.equilibrium import flat, mirror_stability
from wrinklestudy.equilibrium.mirror_stability import CLASSES, ClassStability
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.wrinkled import Equilibrium
from wrinklestudy.fem.space import Space
from wrinklestudy.vocabulary import Parity

STRAINS = (0.026, 0.03, 0.04, 0.05, 0.06, 0.07, 0.1, 0.14, 0.2, 0.3, 0.32, 0.36, 0.39)
SPECTRA = (0.06, 0.2)  # where the eigenvalues of all classes are computed
MESH, FINER = (12, 54), (12, 72)
COARSER = ((12, 24), (12, 36))
_ROOT, _NEAR = 3e-4, 1e-3  # accuracy of a root; how far from it the next one is sought


class Pair(NamedTuple):
    """The two parities at one strain."""

    strain: float
    states: tuple[Equilibrium, Equilibrium]
    classes: tuple[tuple[ClassStability, ...], tuple[ClassStability, ...]]

    @property
    def sliding(self) -> tuple[ClassStability, ClassStability]:
        """Stability of either against sliding."""
        first, second = (next(c for c in own if c[:2] == SLIDING) for own in self.classes)
        return first, second

    @property
    def softest(self) -> tuple[float, float]:
        """The eigenvalues mu_a and mu_s."""
        return self.sliding[0].softest, self.sliding[1].softest

    @property
    def difference(self) -> float:
        """E_s - E_a of the quarter, point by point."""
        return energy_below(self.states[0], self.states[1])

    @property
    def predicted(self) -> tuple[float, float]:
        """E_s - E_a from the eigenvalues of either parity."""
        squares = [bending_square(state) for state in self.states]
        mu = self.softest
        return 0.5 * mu[0] * squares[1], -0.5 * mu[1] * squares[0]


def solve_pair(space: Space, strain: float, every: bool = True, spectra: bool = False) -> Pair:
    """Return both parities with their stability.

    Parameters
    ----------
    space : Space
    strain : float
    every : bool
        Against all four classes, else against sliding alone.
    spectra : bool
        Eigenvalues of all classes, else of sliding alone (NaN for the others).
    """
    states = both_parities(space, strain)
    kinds = CLASSES if every else (SLIDING,)
    eigenvalues = CLASSES if spectra else (SLIDING,)
    first, second = (tuple(mirror_stability.classes(state, kinds, eigenvalues)) for state in states)
    return Pair(strain, states, (first, second))


def eigenvalue(space: Space, strain: float, parity: Parity) -> float:
    """Return the softest eigenvalue mu of one parity against sliding."""
    state = flat.solve(space, LATEX.law, strain)
    planar = planar_state(state, LATEX, PlanarSettings(parity=parity, modes=4))
    return mirror_stability.classes(wrinkled(planar, THICKNESS), (SLIDING,))[0].softest


def exchange(space: Space, parity: Parity, known: dict[float, float]) -> float:
    """Return the strain at which a parity becomes stable or unstable to sliding.

    Parameters
    ----------
    space : Space
    parity : {'antisymmetric', 'symmetric'}
    known : dict
        Eigenvalues of opposite sign at two strains on this space.
    """

    def softest(strain: float) -> float:
        return known[strain] if strain in known else eigenvalue(space, strain, parity)

    return float(brentq(softest, min(known), max(known), xtol=_ROOT))


def exchange_near(space: Space, parity: Parity, strain: float) -> float:
    """Return the root of mu from its values on both sides of a strain; NaN if there is none."""
    ends = np.array([strain - _NEAR, strain + _NEAR])
    low, high = (eigenvalue(space, float(end), parity) for end in ends)
    if low * high > 0.0:
        return float("nan")
    return float(ends[0] + 2.0 * _NEAR * low / (low - high))


class ParityPairs(NamedTuple):
    """Both parities over strain, and where they exchange stability."""

    pairs: tuple[Pair, ...]  # on MESH
    coarser: dict[tuple[int, int], tuple[Pair, ...]]
    roots: tuple[tuple[float, float, float], ...]  # both parities on MESH, the first on FINER


def parity_pairs() -> ParityPairs:
    """Return both parities over strain on several meshes, and where they exchange stability."""
    space, fine = quarter(*MESH), quarter(*FINER)
    pairs = tuple(solve_pair(space, strain, spectra=strain in SPECTRA) for strain in STRAINS)
    coarser = {}
    for mesh in COARSER:
        other = quarter(*mesh)
        coarser[mesh] = tuple(solve_pair(other, strain, every=False) for strain in STRAINS)
    roots = []
    for a, b in pairwise(pairs):
        if a.softest[0] * b.softest[0] < 0.0:
            known = {a.strain: a.softest[0], b.strain: b.softest[0]}
            root = exchange(space, PARITIES[0], known)
            symmetric = exchange_near(space, PARITIES[1], root)
            roots.append((root, symmetric, exchange_near(fine, PARITIES[0], root)))
    return ParityPairs(pairs, coarser, tuple(roots))
