"""Modes of a sheet whose pattern may slide across, in two families: odd and even.

Without a mirror at Y = 0 each wrinkle comes twice, as a sine and as a cosine across the sheet, with
critical thicknesses that agree to about 1e-8: any mixture of the two is as good a mode. Wrinkled
states are told apart by what they do at the centre of the sheet, where one family has a zero of the
deflection and the other a crest.
"""

from dataclasses import replace
from functools import cached_property

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium.deflections import DeflectionForms, corner_part, deflection_forms
from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.modes import Modes, ModeSearch, Spectrum, spectrum
from wrinklestudy.equilibrium.quartic import quartic_form
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.factorisation import count_negative_eigenvalues
from wrinklestudy.fem.upper_triangle import symmetric
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import PARITIES, Parity

_MIRRORED = 1.0e-3  # how near to one the overlap of a mode with its mirror image must be
# Modes of both families that are looked for beside those that the thickness makes unstable; more
# would change the first guess, but not the number of iterations that it needs.
_SPARE, _FEWEST = 6, 12
_SEED = ModeSearch(1.0e-5, 2)  # modes for a first guess; tau to 1e-10


class Families:
    """The leading modes of a flat state, told apart by their parity at the centre.

    Parameters
    ----------
    flat : Flat
        With its mirrors; beside one at Y = 0 the modes have their parity exactly.
    bending : str
        The bending law, a name in `mechanics.bending.BENDING_LAWS`.
    thickness : float
        t/W of the sheet.
    count : int
        Largest number of modes of each parity.
    """

    def __init__(self, flat: Flat, bending: str, thickness: float, count: int = 8) -> None:
        self.flat, self.bending, self.thickness, self.count = flat, bending, thickness, count
        self._known: dict[Symmetry, DeflectionForms] = {}

    def modes(self, parity: Parity) -> Modes:
        """Return the modes of a parity.

        Parameters
        ----------
        parity : {'antisymmetric', 'symmetric'}

        Raises
        ------
        ArithmeticError
            If the flat sheet is unstable at any thickness up to W.
        """
        if self.flat.symmetry.odd_across is not None:
            return self._half_width(parity)
        forms, found = self._both
        # The turn keeps the wrinkles of a sheet that is sheared, which are oblique.
        mirror = (self.flat.symmetry.odd_along is None, True)
        signs, vectors = np.linalg.eigh(_overlap(self.flat, forms, found.shapes, mirror))
        own = vectors[:, signs < 0.0 if parity == "antisymmetric" else signs >= 0.0]
        return self._within(forms, found, own, self.flat.symmetry)

    def bent(self, symmetry: Symmetry) -> sparse.csr_array:
        """Return the bending matrix B on the deflections that a symmetry leaves free."""
        return self._forms(symmetry).bending

    def _forms(self, symmetry: Symmetry) -> DeflectionForms:
        if symmetry not in self._known:
            self._known[symmetry] = deflection_forms(self.flat, self.bending, symmetry)
        return self._known[symmetry]

    @cached_property
    def _both(self) -> tuple[DeflectionForms, Spectrum]:
        """Modes of both parities."""
        return self._spectrum(self.flat.symmetry, 3 * self.count)

    def _half_width(self, parity: Parity) -> Modes:
        """Return the modes of a parity beside a mirror at Y = 0."""
        symmetry = _across(self.flat.symmetry, parity)
        forms, found = self._spectrum(symmetry, 2 * self.count)
        return self._within(forms, found, np.eye(len(found.squared)), symmetry)

    def _spectrum(self, symmetry: Symmetry, most: int) -> tuple[DeflectionForms, Spectrum]:
        """Return modes for seeds; the search starts from no symmetry, so that it misses none."""
        forms = self._forms(symmetry)
        unstable = count_negative_eigenvalues(forms.shifted(self.thickness**2))
        count = min(max(unstable + _SPARE, _FEWEST), most)
        start = np.random.default_rng(0).standard_normal(self.flat.space.size)
        found = spectrum(self.flat, self.bending, symmetry, count, None, start, _SEED, forms)
        return forms, found

    def _within(
        self, forms: DeflectionForms, found: Spectrum, own: Array, symmetry: Symmetry
    ) -> Modes:
        """Return the modes within the span of some mixtures of all modes.

        Where x -> -x is a symmetry, those that are odd along the pull are left out: wrinkles are
        even.
        """
        flat, count = self.flat, self.count
        if flat.symmetry.odd_along is None and own.shape[1] > 0:
            overlap = _overlap(flat, forms, own.T @ found.shapes, (True, False))
            signs, vectors = np.linalg.eigh(overlap)
            if np.abs(np.abs(signs) - 1.0).max() < _MIRRORED and np.any(signs > 0.0):
                own = own @ vectors[:, signs > 0.0]
        values, mixed = np.linalg.eigh(own.T @ (found.squared[:, None] * own))
        values, mixed = values[::-1][:count], mixed[:, ::-1][:, :count]
        shapes = (own @ mixed).T @ found.shapes
        quartic, relaxation = quartic_form(flat, shapes)
        corner = corner_part(flat, forms.points, shapes)
        return Modes(symmetry, self.bending, values, shapes, corner, quartic, relaxation)


def opposite(parity: Parity) -> Parity:
    """Return the other parity."""
    return PARITIES[1 - PARITIES.index(parity)]


def _overlap(flat: Flat, forms: DeflectionForms, shapes: Array, mirror: tuple[bool, bool]) -> Array:
    """Return phi_i . B phi_j' with the images phi' of modes under X -> -X, Y -> -Y or both."""
    along, across = (-1 if side else 1 for side in mirror)
    signs = np.array([1.0, along, across, along * across])
    nodes = flat.space.nodes_from_field(shapes)[..., ::along, ::across] * signs[:, None, None]
    free = forms.assembler.free[0]
    images = flat.space.field_from_nodes(nodes)[:, free]
    overlap: Array = shapes[:, free] @ (symmetric(forms.bending) @ images.T)
    return 0.5 * (overlap + overlap.T)


def _across(symmetry: Symmetry, parity: Parity) -> Symmetry:
    """Return a symmetry whose mirror Y = 0 is for deflections of a parity."""
    return replace(symmetry, odd_across=Symmetry.mirrored(parity).odd_across)
