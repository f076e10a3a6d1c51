"""The quartic part of the reduced energy of small wrinkles, see `modes`."""

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
    space = flat.space
    if len(shapes) == 0:
        return np.empty((0, 0)), np.empty((0, 2, space.size))
    assembler = membrane_assembler(space, flat.symmetry)
    solver = assembler.solver
    tangents = space.derivatives(flat.position, 2)
    _, _, blocks = membrane.expansion(flat.law, tangents)
    solver.factorise(assembler.tangent(blocks))
    stiffness = membrane.stiffness(flat.law, tangents)
    slopes = space.derivatives(shapes, 2)
    strains, forces, loads = [], [], []
    for i, j in pairs(len(shapes)):
        twice = 1.0 if i == j else 2.0
        first, second = slopes[:, i], slopes[:, j]
        mixed = 0.5 * (first[0] * second[1] + first[1] * second[0])
        strain = twice * np.stack([first[0] * second[0], first[1] * second[1], mixed])
        force = np.einsum("km...,m...->k...", stiffness, strain)
        load = assembler.residual(membrane.gradient(force, tangents))
        strains.append(strain.reshape(-1))
        forces.append((force * space.measure).reshape(-1))
        loads.append(load[assembler.free])
    load_matrix = np.array(loads)
    answers = -solver.solve(load_matrix.T).T
    relaxation = np.zeros((len(loads), 2, space.size))
    relaxation[:, assembler.free] = answers
    quartic = np.array(strains) @ np.array(forces).T + load_matrix @ answers.T
    return 0.5 * (quartic + quartic.T), relaxation
