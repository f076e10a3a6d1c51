"""Modes of a sheet whose pattern may slide across, in two families: odd and even.

Without a mirror at Y = 0 each wrinkle comes twice, as a sine and as a cosine across the sheet, with
critical thicknesses that agree to about 1e-8: any mixture of the two is as good a mode. Wrinkled
states are told apart by what they do at the centre of the sheet, where one family has a zero of the
deflection and the other a crest.
"""

from dataclasses import replace

import numpy as np

from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.modes import (
    DeflectionForms,
    Modes,
    Spectrum,
    corner_part,
    deflection_forms,
    spectrum,
)
from wrinklestudy.equilibrium.quartic import quartic_form
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.factorisation import symmetric
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import PARITIES, Parity

_MIRRORED = 1.0e-3  # how near to one the overlap of a mode with its mirror image must be


def families(flat: Flat, bending: str, parity: Parity, count: int = 8) -> tuple[Modes, Modes]:
    """Return the leading modes of a flat state of a parity at the centre, and of the other.

    Parameters
    ----------
    flat : Flat
        With its mirrors; beside one at Y = 0 the modes have their parity exactly.
    bending : str
        The bending law, a name in `mechanics.bending.BENDING_LAWS`.
    parity : {'antisymmetric', 'symmetric'}
        That comes first.
    count : int
        Largest number of modes of each.

    Raises
    ------
    ArithmeticError
        If the flat sheet is unstable at any thickness up to W.
    """
    if flat.symmetry.odd_across is not None:
        first, second = (
            _half_width(flat, bending, which, count) for which in (parity, opposite(parity))
        )
        return first, second
    # Of the modes of a whole sheet two in three are of interest: the others are odd along it.
    many = 3 * count if flat.symmetry.odd_along is None else 2 * count
    found = _spectrum(flat, bending, flat.symmetry, many)
    forms = deflection_forms(flat, bending, flat.symmetry)
    # The turn keeps the wrinkles of a sheet that is sheared, which are oblique.
    mirror = (flat.symmetry.odd_along is None, True)
    signs, vectors = np.linalg.eigh(_overlap(flat, forms, found.shapes, mirror))
    odd, even = vectors[:, signs < 0.0], vectors[:, signs >= 0.0]
    both = (odd, even) if parity == "antisymmetric" else (even, odd)
    first, second = (
        _within(flat, flat.symmetry, bending, forms, found, own, count) for own in both
    )
    return first, second


def _half_width(flat: Flat, bending: str, parity: Parity, count: int) -> Modes:
    """Return the modes of a parity beside a mirror at Y = 0."""
    symmetry = _across(flat.symmetry, parity)
    found = _spectrum(flat, bending, symmetry, 2 * count)
    forms = deflection_forms(flat, bending, symmetry)
    return _within(flat, symmetry, bending, forms, found, np.eye(len(found.squared)), count)


def opposite(parity: Parity) -> Parity:
    """Return the other parity."""
    return PARITIES[1 - PARITIES.index(parity)]


def _within(
    flat: Flat,
    symmetry: Symmetry,
    bending: str,
    forms: DeflectionForms,
    found: Spectrum,
    own: Array,
    count: int,
) -> Modes:
    """Return the modes within the span of some mixtures of all modes.

    Where x -> -x is a symmetry, those that are odd along the pull are left out: wrinkles are even.
    """
    if flat.symmetry.odd_along is None and own.shape[1] > 0:
        signs, vectors = np.linalg.eigh(_overlap(flat, forms, own.T @ found.shapes, (True, False)))
        if np.abs(np.abs(signs) - 1.0).max() < _MIRRORED and np.any(signs > 0.0):
            own = own @ vectors[:, signs > 0.0]
    values, mixed = np.linalg.eigh(own.T @ (found.squared[:, None] * own))
    values, mixed = values[::-1][:count], mixed[:, ::-1][:, :count]
    shapes = (own @ mixed).T @ found.shapes
    quartic, relaxation = quartic_form(flat, shapes)
    corner = corner_part(flat, forms.points, shapes)
    return Modes(symmetry, bending, values, shapes, corner, quartic, relaxation)


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


def _spectrum(flat: Flat, bending: str, symmetry: Symmetry, count: int) -> Spectrum:
    """Return modes for seeds; the search starts from no symmetry, so that it misses none."""
    start = np.random.default_rng(0).standard_normal(flat.space.size)
    return spectrum(flat, bending, symmetry, count, start=start)
