"""Thin sheets from the tension field: the same state as from the modes, in few iterations."""

import numpy as np
import pytest

from wrinklestudy.equilibrium import newton, planar
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.equilibrium.seeds import seed_position, seeds
from wrinklestudy.equilibrium.thin_seeds import THIN, thin_seed
from wrinklestudy.equilibrium.wrinkled import minimise_from, solve
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.vocabulary import PARITIES

LATEX = mooney_rivlin(6.21e4, 1.58e5)
THICKNESS, STRAIN = 2e-4, 0.12


@pytest.fixture(scope="module", params=PARITIES)
def flat_state(request):
    space = Space(make_grid(2.0, THICKNESS, MeshSettings(12, 24)))
    return planar.solve(space, LATEX, STRAIN, PlanarSettings(parity=request.param))


def test_leads_to_the_state_of_the_modes_sooner(flat_state):
    """The minimum within a parity is one, whatever the start."""
    assert THIN * flat_state.modes.critical_thickness > THICKNESS
    state = solve(flat_state, THICKNESS)
    start = seed_position(flat_state.flat, flat_state.modes, seeds(flat_state.modes, THICKNESS)[0])
    other = minimise_from(flat_state, THICKNESS, start)
    assert state.status == other.status == "wrinkled"
    assert state.energy == pytest.approx(other.energy, rel=1e-12)
    assert newton.count(state.history) <= newton.count(other.history) // 2


def test_keeps_what_mirrors_and_clamp_prescribe(flat_state):
    start = thin_seed(flat_state, THICKNESS)
    held = ~flat_state.modes.symmetry.free(flat_state.flat.space)
    assert np.array_equal(start[held], flat_state.flat.sheet_position[held])


def test_is_near_the_bottom_already(flat_state):
    """The start saves most of the energy that the wrinkles save."""
    problem = PlateProblem.of_flat(flat_state.flat, flat_state.modes, THICKNESS)
    start = thin_seed(flat_state, THICKNESS)[problem.assembler.free]
    state = solve(flat_state, THICKNESS)
    saved = state.flat_energy - state.energy
    assert problem.energy(start) < state.flat_energy - 0.8 * saved
