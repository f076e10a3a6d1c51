"""Critical thicknesses against the inertia of the plate, reduced energy against the full one."""

import numpy as np
import pytest
import scipy.linalg

from wrinklestudy.equilibrium import deflections, flat, modes, planar, quartic, seeds, wrinkled
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.fem.boundary import QUARTER, Symmetry
from wrinklestudy.fem.factorisation import count_negative_eigenvalues
from wrinklestudy.fem.grid import Grid, MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.upper_triangle import multiply, symmetric
from wrinklestudy.mechanics.laws import mooney_rivlin, saint_venant_kirchhoff

LATEX = mooney_rivlin(6.21e4, 1.58e5).law


@pytest.fixture(scope="module")
def state():
    return flat.solve(Space(make_grid(2.0, settings=MeshSettings(10, 16))), LATEX, 0.1)


@pytest.mark.parametrize("bending", ["thinning", "fixed-thickness", "fvk"])
@pytest.mark.parametrize("parity", ["antisymmetric", "symmetric"])
def test_unstable_directions_of_the_plate_follow_from_the_modes(state, bending, parity):
    """Between tau_k and tau_(k+1) the tangent of the flat plate has k negative eigenvalues."""
    leading_modes = modes.critical_modes(state, bending, Symmetry.mirrored(parity), 4)
    tau = leading_modes.thickness
    for count, thickness in enumerate([1.01 * tau[0], 0.5 * (tau[0] + tau[1]), 0.99 * tau[1]]):
        problem = PlateProblem.of_flat(state, leading_modes, thickness)
        start = np.zeros((3, state.space.size))
        start[:2] = state.position
        _, residual, tangent = problem.derivatives(start[problem.assembler.free])
        assert np.abs(residual).max() < 1e-12
        assert count_negative_eigenvalues(tangent) == count


def test_modes_are_orthonormal_in_bending(state):
    stress, bent, assembler, _ = deflections.deflection_forms(state, "thinning", QUARTER)
    leading_modes = modes.spectrum(state, count=5)
    shapes = leading_modes.shapes[:, assembler.free[0]].T
    assert np.allclose(shapes.T @ multiply(bent, shapes), np.eye(5), atol=1e-8)
    assert np.allclose(
        -shapes.T @ multiply(stress, shapes),
        np.diag(leading_modes.squared),
        atol=1e-8 * leading_modes.squared[0],
    )


def test_reduced_energy_is_the_energy_of_small_wrinkles(state):
    """E - E_flat = t (1/2 sum (t^2 - tau^2) q^2 + 1/2 z G z) up to sixth order."""
    leading_modes, thickness = modes.critical_modes(state, count=3), 1e-4
    problem = PlateProblem.of_flat(state, leading_modes, thickness)
    free = problem.assembler.free
    direction = np.array([1.0, -0.4, 0.3])
    first, second = np.array(quartic.pairs(3)).T
    flat_energy = problem.energy(seeds.seed_position(state, leading_modes, 0 * direction)[free])

    def remainder(size):
        q = size * direction
        z = q[first] * q[second]
        quartic = 0.5 * z @ leading_modes.quartic @ z
        expected = 0.5 * np.sum((thickness**2 - leading_modes.squared) * q**2) + quartic
        full = problem.energy(seeds.seed_position(state, leading_modes, q)[free]) - flat_energy
        return (full / thickness - expected) / quartic

    # In parts of the quartic term the remainder falls like the amplitude squared. The sheet is
    # so thin that the part of bending in the quartic term, smaller by (t k)^2, does not show.
    amplitude = 0.1 / np.abs(leading_modes.shapes[0]).max()
    large, small = abs(remainder(2 * amplitude)), abs(remainder(amplitude))
    assert small < 0.05
    assert small < 0.35 * large


def test_seeds_are_stationary_and_below_the_flat_state(state):
    leading_modes, thickness = modes.critical_modes(state, count=4), 8e-4
    assert np.sum(leading_modes.thickness > thickness) >= 2
    starts = seeds.seeds(leading_modes, thickness)
    first, second = np.array(quartic.pairs(4)).T

    def energy(q):
        z = q[first] * q[second]
        return (
            0.5 * np.sum((thickness**2 - leading_modes.squared) * q**2)
            + 0.5 * z @ leading_modes.quartic @ z
        )

    lowest = energy(starts[0])
    assert lowest < 0
    for q in starts[1:]:
        assert energy(q) >= lowest
    for k in range(4):
        step = 1e-4 * np.abs(starts[0]).max() * np.eye(4)[k]
        assert energy(starts[0] + step) >= lowest
        assert energy(starts[0] - step) >= lowest


def test_a_thick_sheet_has_no_seeds(state):
    leading_modes = modes.critical_modes(state, count=3)
    assert seeds.seeds(leading_modes, 1.01 * leading_modes.critical_thickness) == []


def test_corner_modes_of_a_uniform_grid_are_recognised():
    """On a uniform 16 x 24 grid a mode of the corner passes the wrinkle from strain 0.3 on."""
    grid = Grid(np.linspace(0, 1, 17), np.linspace(0, 0.5, 25))
    state = flat.solve(grid, LATEX, 0.45)
    leading_modes = modes.critical_modes(state, count=6)
    leading = int(np.argmax(leading_modes.squared))
    assert not leading_modes.wrinkles[leading]
    graded = flat.solve(make_grid(2.0, settings=MeshSettings(16, 24)), LATEX, 0.45)
    assert leading_modes.critical_thickness == pytest.approx(
        modes.critical_thickness(graded), rel=0.02
    )


def test_critical_thickness_of_small_strains_goes_like_their_root(state):
    strains = np.array([1e-7, 1e-5, 1e-3])
    thicknesses = [modes.critical_thickness(flat.solve(state.space, LATEX, e)) for e in strains]
    ratio = thicknesses / np.sqrt(strains)
    assert np.abs(np.diff(ratio)).max() < 10 * strains[-1] * ratio[0]
    assert abs(ratio[1] - ratio[0]) < 10 * strains[1] * ratio[0]


def test_inertia_counts_the_modes_that_a_whole_spectrum_has(state):
    """Of the dense eigenproblem -S phi = mu B phi as many mu exceed t^2 as inertia counts."""
    forms = deflections.deflection_forms(state, "fvk", QUARTER)
    stress, bent = (symmetric(form).toarray() for form in (forms.stress, forms.bending))
    squared = scipy.linalg.eigh(-stress, bent, eigvals_only=True)[::-1]
    for thickness in (1e-6, 1e-4, 5e-4, 1e-3, 2e-3):
        expected = int(np.sum(squared > thickness**2))
        assert count_negative_eigenvalues(forms.shifted(thickness**2)) == expected
    leading_modes = modes.spectrum(state, "fvk", count=6).squared
    assert leading_modes == pytest.approx(squared[:6], rel=1e-8)


@pytest.mark.parametrize("poisson", [0.0, 1e-8])
def test_a_sheet_that_does_not_contract_has_no_modes(poisson):
    """SVK with nu = 0 is in uniaxial tension everywhere: nothing is compressed."""
    law = saint_venant_kirchhoff(1e6, poisson)
    space = Space(make_grid(2.0, settings=MeshSettings(10, 16)))
    known = planar.solve(space, law, 0.12)
    assert known.flat is not None
    assert known.modes is not None
    assert modes.critical_thickness(known.flat) == 0.0
    assert known.modes.squared.shape == (0,)
    assert known.modes.critical_thickness == 0.0
    assert seeds.seeds(known.modes, 1e-6) == []
    state = wrinkled.solve(known, 1e-6)
    assert state.status == "flat"
    assert state.unstable_directions == 0


def test_near_decay_there_are_fewer_modes_than_asked_for_and_wrinkles_form_from_them():
    """SVK decays where the compression ends: the last modes vanish one after the other."""
    material = saint_venant_kirchhoff(1e6, 0.5)
    space = Space(make_grid(5.0, settings=MeshSettings(10, 30)))
    known = planar.solve(space, material, 0.45, planar.PlanarSettings("fvk"))
    assert known.modes is not None
    tau = known.modes.thickness
    assert 1 < len(tau) < 8
    assert known.modes.quartic.shape == (len(quartic.pairs(len(tau))),) * 2
    forms = deflections.deflection_forms(known.flat, "fvk", QUARTER)
    assert count_negative_eigenvalues(forms.shifted((0.99 * tau[-1]) ** 2)) == len(tau)
    state = wrinkled.solve(known, 0.5 * (tau[0] + tau[1]))
    assert state.status == "wrinkled"
    assert state.energy < state.flat_energy


def test_a_hint_of_tau_1_changes_nothing(state):
    free = modes.critical_thickness(state)
    for near in (0.5 * free, 0.98 * free, 1.02 * free, 30.0 * free):
        assert modes.critical_thickness(state, near=near) == pytest.approx(free, rel=1e-9)
