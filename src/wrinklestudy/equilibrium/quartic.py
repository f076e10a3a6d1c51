"""The quartic part of the reduced energy of small wrinkles, see `modes`."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from wrinklestudy.equilibrium.flat import Flat, membrane_assembler
from wrinklestudy.mechanics import membrane
from wrinklestudy.typing import Array


def pairs(count: int) -> list[tuple[int, int]]:
    """Return the pairs of modes i <= j in the order of `quartic_form`."""
    return [(i, j) for i in range(count) for j in range(i, count)]


def quartic_form(flat: Flat, shapes: Array) -> tuple[Array, Array]:
    """Return the quartic form G and the in-plane displacements of the reduced energy.

    Parameters
    ----------
    flat : Flat
    shapes : (m, size) array
        Modes as dof vectors; there may be none.

    Returns
    -------
    quartic : (p, p) array
        G over the `pairs` of modes.
    relaxation : (p, 2, size) array
        In-plane displacement that belongs to z_P = 1.
    """
    if len(shapes) == 0:
        return np.empty((0, 0)), np.empty((0, 2, flat.space.size))
    strains, forces, loads, answers = _responses(flat, shapes, pairs(len(shapes)))
    relaxation = np.zeros((len(loads), 2, flat.space.size))
    relaxation[:, membrane_assembler(flat.space, flat.symmetry).free] = answers
    quartic = strains @ forces.T + loads @ answers.T
    return 0.5 * (quartic + quartic.T), relaxation


def quartic_coefficients(flat: Flat, shapes: Sequence[Array]) -> Array:
    """Return G_iiii of each mode alone, (m,): the diagonal of the form for equal pairs.

    The modes may be of different parities, since a square is even.
    """
    if len(shapes) == 0:
        return np.empty(0)
    alone = [(i, i) for i in range(len(shapes))]
    strains, forces, loads, answers = _responses(flat, np.array(shapes), alone)
    coefficients: Array = (strains * forces).sum(axis=1) + (loads * answers).sum(axis=1)
    return coefficients


def relaxations(flat: Flat, shapes: Array) -> Array:
    """Return the in-plane displacement that belongs to each deflection alone, (m, 2, size)."""
    answers = _responses(flat, shapes, [(i, i) for i in range(len(shapes))]).answers
    displacements = np.zeros((len(shapes), 2, flat.space.size))
    displacements[:, membrane_assembler(flat.space, flat.symmetry).free] = answers
    return displacements


class _Responses(NamedTuple):
    """What pairs of modes do to the membrane, a row for each pair."""

    strains: Array  # that the slopes cause, at points
    forces: Array  # to which these belong, times the areas of the points
    loads: Array  # on the free dofs
    answers: Array  # displacements of the free dofs that relax them


def _responses(flat: Flat, shapes: Array, modes: Sequence[tuple[int, int]]) -> _Responses:
    space = flat.space
    assembler = membrane_assembler(space, flat.symmetry)
    solver = assembler.solver
    tangents = space.derivatives(flat.position, 2)
    _, _, blocks = membrane.expansion(flat.law, tangents)
    relative = space.relative_thickness
    solver.factorise(assembler.tangent([relative * block for block in blocks]))
    stiffness = relative * membrane.stiffness(flat.law, tangents)
    vectors = membrane.frame(flat.law, tangents)
    slopes = space.derivatives(shapes, 2)
    strains, forces, loads = [], [], []
    for i, j in modes:
        twice = 1.0 if i == j else 2.0
        first, second = slopes[:, i], slopes[:, j]
        mixed = 0.5 * (first[0] * second[1] + first[1] * second[0])
        strain = twice * np.stack([first[0] * second[0], first[1] * second[1], mixed])
        force = np.einsum("km...,m...->k...", stiffness, strain)
        load = assembler.residual(membrane.gradient(force, vectors))
        strains.append(strain.reshape(-1))
        forces.append((force * space.measure).reshape(-1))
        loads.append(load[assembler.free])
    load_matrix = np.array(loads)
    answers = -solver.solve(load_matrix.T).T
    return _Responses(np.array(strains), np.array(forces), load_matrix, answers)
