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
    Modes,
    corner_part,
    critical_modes,
    deflection_forms,
    spectrum,
)
from wrinklestudy.equilibrium.quartic import quartic_form
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.factorisation import symmetric
from wrinklestudy.fem.space import Space
from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import PARITIES, Parity


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
    start = _unbiased(flat.space)
    if flat.symmetry.odd_across is not None:
        first, second = (
            critical_modes(flat, bending, _across(flat.symmetry, which), count, start)
            for which in (parity, opposite(parity))
        )
        return first, second
    squared, shapes, _ = spectrum(flat, bending, flat.symmetry, 2 * count, start=start)
    forms = deflection_forms(flat, bending, flat.symmetry)
    free = forms.assembler.free[0]
    images = _reflected(flat, shapes)
    overlap = shapes[:, free] @ (symmetric(forms.bending) @ images[:, free].T)
    signs, vectors = np.linalg.eigh(0.5 * (overlap + overlap.T))
    odd, even = vectors[:, signs < 0.0], vectors[:, signs >= 0.0]
    both = (odd, even) if parity == "antisymmetric" else (even, odd)
    first, second = (_within(flat, bending, forms.points, squared, own, shapes) for own in both)
    return first, second


def opposite(parity: Parity) -> Parity:
    """Return the other parity."""
    return PARITIES[1 - PARITIES.index(parity)]


def _within(
    flat: Flat, bending: str, points: Array, squared: Array, own: Array, shapes: Array
) -> Modes:
    """Return the modes within the span of some mixtures of all modes."""
    values, mixed = np.linalg.eigh(own.T @ (squared[:, None] * own))
    shapes = (own @ mixed[:, ::-1]).T @ shapes
    quartic, relaxation = quartic_form(flat, shapes)
    corner = corner_part(flat, points, shapes)
    return Modes(flat.symmetry, bending, values[::-1], shapes, corner, quartic, relaxation)


def _across(symmetry: Symmetry, parity: Parity) -> Symmetry:
    """Return a symmetry whose mirror Y = 0 is for deflections of a parity."""
    return replace(symmetry, odd_across=Symmetry.mirrored(parity).odd_across)


def _reflected(flat: Flat, shapes: Array) -> Array:
    """Return modes after a turn by pi about the centre, or after Y -> -Y beside a mirror X = 0.

    The turn keeps the wrinkles of a sheet that is sheared, which are oblique.
    """
    nodes = flat.space.nodes_from_field(shapes)
    if flat.symmetry.odd_along is None:
        turned = nodes[..., ::-1, ::-1] * np.array([1.0, -1.0, -1.0, 1.0])[:, None, None]
    else:
        turned = nodes[..., ::-1] * np.array([1.0, 1.0, -1.0, -1.0])[:, None, None]
    return flat.space.field_from_nodes(turned)


def _unbiased(space: Space) -> Array:
    """Return a deflection without any symmetry, so that the search for modes misses none."""
    return np.random.default_rng(0).standard_normal(space.size)
