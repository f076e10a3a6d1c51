"""Critical thicknesses of the flat state, their modes and the reduced energy of small wrinkles.

For a deflection w of a flat state the energy is t/2 w.S w + t^3/2 w.B w, S (stress) and B (bending)
independent of t. The eigenproblem -S phi = tau^2 B phi gives critical thicknesses tau_1 > tau_2 >
...: the flat sheet is unstable exactly when t < tau_1.

With w = sum q_i phi_i and the in-plane displacement that relaxes the stress which w causes at
second order, the energy above the flat state is, for each unit of thickness,

    1/2 sum (t^2 - tau_i^2) q_i^2 + 1/2 sum z_P G_PQ z_Q,    z_P = q_i q_j for the pair P = (i, j).

All but t is independent of the thickness, so that it seeds the wrinkled state of every sheet
(`seeds`).
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from wrinklestudy.equilibrium.deflections import (
    CORNER_PART,
    DeflectionForms,
    corner_part,
    deflection_forms,
)
from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.quartic import quartic_form
from wrinklestudy.fem.boundary import QUARTER, Symmetry
from wrinklestudy.fem.factorisation import NotPositiveDefiniteError, count_negative_eigenvalues
from wrinklestudy.fem.upper_triangle import symmetric
from wrinklestudy.typing import Array, Mask

# Thinner than any sheet: modes of a smaller critical thickness count as always stable. Where no
# thickness wrinkles, thousands of tau^2 crowd below zero, and Lanczos never tells them apart; nor
# those near zero beside a leading mode of the corner.
_SMALLEST_THICKNESS = 1.0e-7
_SMALLEST_PART = 1.0 / 40.0  # of tau_1
# Thicknesses that are tried in turn as an upper bound of all tau_i; near tau_1 the eigenvalues are
# well apart. At small strains tau_1 goes like the root of the strain.
_FIRST_TRIAL = 1.6e-3
_TRIAL_OVER_ROOT = 0.01
_SMALLEST_TRIAL = 1.0e-6
_LARGEST_TRIAL = 1.0
_TRIAL_GROWTH = 2.0
_NEAR_GROWTH = 1.1  # where tau_1 is known roughly
_LOOSEST_TRIAL = 4.0  # the least bound that is sought, in units of tau_1
_FEWEST_VECTORS = 8


class ModeSearch(NamedTuple):
    """How Lanczos' method looks for modes.

    Parameters
    ----------
    tolerance : float
        Relative error of the modes; that of tau^2 is its square.
    vectors : int
        For each mode.
    """

    tolerance: float
    vectors: int


_CLOSE = ModeSearch(1.0e-10, 4)
_EQUAL = ModeSearch(1.0e-6, 4)  # modes that are equal to 1e-8 are told apart no better


@dataclass(frozen=True)
class Modes:
    """Leading modes of a flat state within one symmetry.

    Parameters
    ----------
    symmetry : Symmetry
        Of the sheet with these deflections.
    bending : str
        The bending law, a name in `mechanics.bending.BENDING_LAWS`.
    squared : (m,) array
        tau_i^2 > 0 in units of W^2, falling. Modes that no thickness makes unstable, or only one
        below tau_1/40, are left out, so that there may be fewer than were asked for, or none.
    shapes : (m, size) array
        Modes as dof vectors with phi_i . B phi_j = delta_ij.
    corner : (m,) array
        Part of the bending energy that sits at the corner of clamp and free edge.
    quartic : (p, p) array
        G of the reduced energy over the pairs i <= j (both orders of a pair counted).
    relaxation : (p, 2, size) array
        In-plane displacement that belongs to z_P = 1.
    """

    symmetry: Symmetry
    bending: str
    squared: Array
    shapes: Array
    corner: Array
    quartic: Array
    relaxation: Array

    @property
    def thickness(self) -> Array:
        """Critical thicknesses tau_i in units of W."""
        return np.sqrt(self.squared)

    @property
    def wrinkles(self) -> Mask:
        """Which modes are wrinkles of the sheet, not flaps of its corners."""
        return self.corner < CORNER_PART

    @property
    def critical_thickness(self) -> float:
        """Largest critical thickness tau_1 of a wrinkle, in units of W."""
        return float(self.thickness[self.wrinkles].max(initial=0.0))


class CriticalMode(NamedTuple):
    """The wrinkle that the thickest unstable sheet has."""

    thickness: float  # tau_1/W; zero where no thickness wrinkles
    shape: Array | None  # the mode as in `Modes`; None where no thickness wrinkles
    corner_thickness: float  # largest of a mode of the corners above tau_1; zero without one


class Spectrum(NamedTuple):
    """Leading critical thicknesses squared, modes and the part of their energy at the corner.

    As in `Modes`: those that some thickness makes unstable.
    """

    squared: Array
    shapes: Array
    corner: Array


def spectrum(
    flat: Flat,
    bending: str = "thinning",
    symmetry: Symmetry = QUARTER,
    count: int = 8,
    near: float | None = None,
    start: Array | None = None,
    search: ModeSearch = _CLOSE,
    forms: DeflectionForms | None = None,
) -> Spectrum:
    """Return the largest critical thicknesses of a flat state and their modes, see `Modes`.

    One factorisation counts the modes that a thickness makes unstable (Sylvester's law of inertia),
    and no others are looked for.

    Parameters
    ----------
    flat : Flat
        The flat equilibrium.
    bending : str
        The bending law, a name in `mechanics.bending.BENDING_LAWS`.
    symmetry : Symmetry
        Of the sheet with these deflections.
    count : int
        Largest number of modes.
    near : float, optional
        A thickness a little above tau_1, where that is known: it saves most of the time.
    start : (size,) array, optional
        A deflection like the leading mode, where one is known.
    search : ModeSearch
        How closely they are found.
    forms : DeflectionForms, optional
        Of the flat state, where they are known.

    Raises
    ------
    ArithmeticError
        If the flat sheet is unstable at any thickness up to W.
    """
    forms = forms or deflection_forms(flat, bending, symmetry)
    if _definite(forms, _SMALLEST_THICKNESS):
        return Spectrum(np.empty(0), np.empty((0, flat.space.size)), np.empty(0))
    trial = min(_FIRST_TRIAL, max(_TRIAL_OVER_ROOT * abs(flat.strain) ** 0.5, _SMALLEST_TRIAL))
    trial = _trial(forms, near or trial, _TRIAL_GROWTH if near is None else _NEAR_GROWTH)
    least = max(_SMALLEST_PART * trial / _LOOSEST_TRIAL, _SMALLEST_THICKNESS)
    unstable = 1 if count == 1 else count_negative_eigenvalues(forms.shifted(least**2))
    first = None if start is None else start[forms.assembler.free[0]]
    squared, vectors = _eigen(forms, min(count, unstable), trial, first, search)
    kept = squared >= _SMALLEST_PART**2 * squared[0]
    shapes = np.zeros((kept.sum(), flat.space.size))
    shapes[:, forms.assembler.free[0]] = vectors.T[kept]
    return Spectrum(squared[kept], shapes, corner_part(flat, forms.points, shapes))


def critical_thickness(
    flat: Flat,
    bending: str = "thinning",
    symmetry: Symmetry = QUARTER,
    near: float | None = None,
) -> float:
    """Return tau_1, the largest critical thickness of a wrinkle, in units of W.

    Modes of the corners are passed over; zero where no thickness wrinkles. See `spectrum` for the
    parameters and errors.
    """
    return critical_mode(flat, bending, symmetry, near).thickness


def critical_mode(
    flat: Flat,
    bending: str = "thinning",
    symmetry: Symmetry = QUARTER,
    near: float | None = None,
    start: Array | None = None,
) -> CriticalMode:
    """Return tau_1 with its mode; see `spectrum` for the parameters and errors."""
    # Without a mirror each mode comes twice, and neither of two that are all but equal is found
    # alone. A good bound sets the first well apart.
    copies = 2 ** [symmetry.odd_along, symmetry.odd_across].count(None)
    count = copies if near is not None else 2 * copies
    search = _CLOSE if copies == 1 else _EQUAL
    while True:
        squared, shapes, corner = spectrum(flat, bending, symmetry, count, near, start, search)
        wrinkles = np.flatnonzero(corner < CORNER_PART)
        if len(wrinkles) > 0:
            first = int(wrinkles[0])  # they fall
            highest = float(np.sqrt(squared[0])) if first > 0 else 0.0
            return CriticalMode(float(np.sqrt(squared[first])), shapes[first], highest)
        if len(squared) < count:
            return CriticalMode(0.0, None, float(np.sqrt(squared.max(initial=0.0))))
        count *= 2


def critical_modes(
    flat: Flat,
    bending: str = "thinning",
    symmetry: Symmetry = QUARTER,
    count: int = 8,
) -> Modes:
    """Return the leading modes of a flat state with the reduced energy of their amplitudes.

    See `spectrum` for the parameters and errors.
    """
    squared, shapes, corner = spectrum(flat, bending, symmetry, count)
    quartic, relaxation = quartic_form(flat, shapes)
    return Modes(symmetry, bending, squared, shapes, corner, quartic, relaxation)


def _eigen(
    forms: DeflectionForms,
    count: int,
    trial: float,
    start: Array | None = None,
    search: ModeSearch = _CLOSE,
) -> tuple[Array, Array]:
    """Solve -S phi = mu B phi for the largest mu below sigma, the square of a trial thickness.

    The solver of the assembler must hold S + sigma B, and at least `count` of the mu be positive.

    In the form B phi = theta (S + sigma B) phi, theta = 1/(sigma - mu), the right side is definite
    even where B is not: for Mooney-Rivlin d2W/dg12^2 is negative beyond a shear that the corner
    reaches.
    """
    from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigsh

    size = forms.assembler.size
    try:
        theta, vectors = eigsh(
            symmetric(forms.bending),
            k=count,
            M=symmetric(forms.shifted(trial**2)),
            Minv=LinearOperator(
                (size, size), matvec=forms.assembler.solver.solve, dtype=np.float64
            ),
            which="LA",
            v0=np.ones(size) if start is None else start,
            ncv=min(max(search.vectors * count, _FEWEST_VECTORS), size),
            tol=search.tolerance,
        )
    except ArpackNoConvergence:
        raise ArithmeticError("the critical thicknesses are not found") from None
    order = np.argsort(theta)[::-1]
    theta, vectors = theta[order], vectors[:, order]
    vectors = vectors / np.sqrt(theta)  # phi . B phi = 1
    largest = np.abs(vectors).argmax(axis=0)
    return trial**2 - 1.0 / theta, vectors * np.sign(vectors[largest, np.arange(count)])


def _trial(forms: DeflectionForms, trial: float, growth: float) -> float:
    """Return a thickness that makes S + trial^2 B definite, at most a few times tau_1 > 0.

    The matrix is left factorised in the solver of the assembler.
    """
    while _definite(forms, trial / _LOOSEST_TRIAL):
        trial /= _LOOSEST_TRIAL
    while not _definite(forms, trial):
        trial *= growth
        if trial > _LARGEST_TRIAL:
            raise ArithmeticError("the flat sheet is unstable at any thickness")
    return trial


def _definite(forms: DeflectionForms, thickness: float) -> bool:
    """Factorise S + t^2 B in the solver of the assembler; return whether it is definite."""
    try:
        forms.assembler.solver.factorise(forms.shifted(thickness**2))
    except NotPositiveDefiniteError:
        return False
    return True
