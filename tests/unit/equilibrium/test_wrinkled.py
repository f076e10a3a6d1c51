"""The wrinkled state on a coarse mesh: equilibrium, energy, refusals and records."""

import numpy as np
import pytest

from wrinklestudy.equilibrium import planar
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.equilibrium.seeds import seed_position
from wrinklestudy.equilibrium.wrinkled import WrinkleSettings, minimise_from, solve
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.files.storage import read_h5
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.results.fields import write_planar, write_wrinkle
from wrinklestudy.stages.wrinkle import run

LATEX = mooney_rivlin(6.21e4, 1.58e5)


@pytest.fixture(scope="module")
def flat_state():
    return planar.solve(Space(make_grid(2.0, settings=MeshSettings(10, 18))), LATEX, 0.1)


def amplitude(state):
    """Largest deflection at the nodes."""
    return np.abs(state.planar.flat.space.nodes_from_field(state.position)[2, 0]).max()


@pytest.fixture(scope="module")
def wrinkled(flat_state):
    return solve(flat_state, 1e-3)


def test_is_a_stable_equilibrium_below_the_flat_state(wrinkled):
    assert wrinkled.status == "wrinkled"
    assert wrinkled.unstable_directions == 0
    assert wrinkled.energy < wrinkled.flat_energy
    assert abs(wrinkled.residual) < 1e-20


def test_the_residual_vanishes_in_an_independent_check(flat_state, wrinkled):
    """No displacement changes the energy at first order: differences in random directions."""
    problem = PlateProblem.of_flat(flat_state.flat, flat_state.modes, 1e-3)
    free = problem.assembler.free
    point = wrinkled.position[free]
    rng = np.random.default_rng(0)
    for _ in range(3):
        step = 1e-7 * rng.standard_normal(point.size)
        up, down = problem.energy(point + step), problem.energy(point - step)
        curvature = up + down - 2 * wrinkled.energy
        assert abs(up - down) < 1e-3 * curvature


def test_other_seeds_and_large_amplitudes_end_in_the_same_state(flat_state, wrinkled):
    scale = 1e-3 / np.abs(flat_state.modes.shapes[0]).max()
    for amplitudes in (0.3 * scale * np.eye(8)[0], 8 * scale * np.eye(8)[1]):
        start = seed_position(flat_state.flat, flat_state.modes, amplitudes)
        again = minimise_from(flat_state, 1e-3, start)
        assert again.status == "wrinkled"
        assert again.energy == pytest.approx(wrinkled.energy, rel=1e-12)


def test_above_the_critical_thickness_the_sheet_is_flat(flat_state):
    tau = flat_state.modes.critical_thickness
    state = solve(flat_state, 1.001 * tau)
    assert state.status == "flat"
    assert state.unstable_directions == 0
    assert np.all(state.position[2] == 0)
    just_below = solve(flat_state, 0.999 * tau)
    assert just_below.status == "wrinkled"
    assert 0 < amplitude(just_below) < 0.3 * tau


def test_the_amplitude_grows_like_the_square_root_of_the_distance(flat_state):
    """A pitchfork: A^2 is proportional to tau_1 - t near the critical thickness."""
    tau = flat_state.modes.critical_thickness
    squares = [amplitude(solve(flat_state, (1 - d) * tau)) ** 2 for d in (0.001, 0.002)]
    assert squares[1] / squares[0] == pytest.approx(2.0, rel=0.02)


def test_what_does_not_converge_is_recorded_with_its_history(flat_state, tmp_path):
    state = solve(flat_state, 1e-3, WrinkleSettings(max_iterations=2))
    assert state.status == "not-converged"
    assert state.reason == "no convergence in 2 iterations"
    write_wrinkle(state, tmp_path / "state.h5")
    data, attrs = read_h5(tmp_path / "state.h5")
    assert attrs["status"] == "not-converged"
    assert data["history"].shape == (2, len(attrs["history_columns"]))


def test_a_failed_flat_state_is_passed_on(flat_state):
    failed = planar.Planar(
        flat_state.grid, LATEX, "latex", 0.1, flat_state.settings, None, None, "no flat state"
    )
    state = solve(failed, 1e-3)
    assert (state.status, state.reason) == ("not-converged", "no flat state")


def test_planar_file_gives_the_same_wrinkled_state(flat_state, wrinkled, tmp_path):
    """The file stores the modes in single precision: enough for a seed, not part of the answer."""
    write_planar(flat_state, tmp_path / "planar.h5")
    run(tmp_path / "planar.h5", 1e-3, {}, tmp_path / "state.h5")
    data, attrs = read_h5(tmp_path / "state.h5")
    assert attrs["energy"] == pytest.approx(wrinkled.energy, rel=1e-13)
    nodes = flat_state.flat.space.nodes_from_field(wrinkled.position)
    assert np.allclose(data["position"], nodes, atol=1e-10)


def test_refuses_a_thickness_that_is_not_positive(flat_state):
    with pytest.raises(ValueError, match=r"thickness = -0\.001"):
        solve(flat_state, -1e-3)


def test_sheets_of_small_strain_are_similar(flat_state):
    """In the limit of small strains the Foppl-von Karman equations hold: t^2/eps alone counts.

    Rounding keeps the Newton decrement of such states above the tolerance.
    """
    heights = []
    for strain in (1e-5, 1e-7):
        thickness = 6e-3 * strain**0.5
        state = solve(planar.solve(flat_state.flat.space, LATEX, strain), thickness)
        assert state.status == "wrinkled"
        heights.append(amplitude(state) / thickness)
    assert heights[0] == pytest.approx(heights[1], rel=20 * 1e-5)
    assert heights[0] > 0.5
