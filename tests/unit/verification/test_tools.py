"""The closed forms and tools of the verification themselves."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from verification.groups.closed_forms import LAW
from verification.groups.convergence import limit
from verification.groups.independent import extrapolated
from verification.mutations import MUTATIONS
from verification.tools import annulus
from verification.tools.bending import elastica_formula
from verification.tools.biquadratic import Elements, FlatProblem
from verification.tools.consistency import STEP, difference
from verification.tools.problem import held
from verification.tools.sheared_strip import MansfieldStrip
from verification.tools.singularity import halved, williams
from verification.tools.stiffness import flexure, stiffness_formula
from verification.tools.stretching import CASES, MODES, exact
from wrinklestudy.fem.boundary import QUARTER
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.upper_triangle import multiply
from wrinklestudy.material.homogeneous import nominal_stress
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.study.digest import PACKAGE, SOURCE


@given(order=st.floats(1.0, 6.0), error=st.floats(0.01, 1.0), sign=st.sampled_from([-1, 1]))
def test_limit_and_order_of_a_power_law(order, error, sign):
    sizes = np.array([1.0, 2 / 3, 1 / 2, 1 / 3])
    found = limit(sizes, 3.0 + sign * error * sizes**order)
    assert found.value == pytest.approx(3.0, abs=1e-3 * error)
    assert found.order == pytest.approx(order, rel=1e-3)


def test_differences_are_of_eighth_order():
    """Exact for polynomials of degree 8, wrong by -4! 4! h^8 f(9)/9! for one of degree 9."""
    x = np.array([1.3])
    for degree in (1, 5, 8):
        found = difference(lambda at, n=degree: at**n, x, np.ones(1))
        assert found == pytest.approx(degree * x ** (degree - 1), rel=1e-12)
    big = 1.0 / STEP  # makes the step 1
    found = difference(lambda at: at**9, np.zeros(1), big * np.ones(1))
    assert found * STEP == pytest.approx(-(24.0**2), rel=1e-12)


def test_held_lines_are_those_of_the_library():
    space = Space(make_grid(2.0, settings=MeshSettings(3, 4)))
    own = held(
        space,
        middle=("odd", "even", "even"),
        clamp=("odd", "odd", "both"),
        midline=("even", "odd", "odd"),
        edge=("free", "free", "free"),
    )
    assert np.array_equal(own, QUARTER.free(space))


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("mode", MODES)
def test_stress_of_homogeneous_states_is_that_of_the_fit(name, mode):
    law, stretches = CASES[name]
    for stretch in stretches:
        expected = nominal_stress(Material(law, 1.0), stretch, mode)
        assert exact(law, mode, stretch)[0] == pytest.approx(float(expected), rel=1e-13)


def test_williams_exponent_of_a_handbook():
    """0.7112 in plane strain with nu = 0.3, which is plane stress with nu/(1 - nu)."""
    assert williams(0.3 / 0.7) == pytest.approx(0.7112, abs=5e-5)


def test_flexure_without_stretch_has_the_stiffness_of_a_plate():
    """A thin block bends with mu t^3/3; stretched, with the formula for lambda3 of the law."""
    for stretch in (1.0, 1.7):
        expected = stiffness_formula(LAW, "thinning", stretch)[1]
        assert flexure(LAW, stretch, 1e-2) == pytest.approx(expected, rel=2e-5)
    assert stiffness_formula(LAW, "thinning", 1.0)[1] == pytest.approx(1 / 3, rel=1e-14)


def test_a_little_shortened_elastica_is_euler_buckling():
    """Deflection (2 L/pi) sqrt(shortening/L) and Euler's load in the limit."""
    found, _ = elastica_formula(LAW, 1e-6)
    assert found.deflection == pytest.approx(4.0 / np.pi * 1e-3, rel=1e-5)
    assert found.force == pytest.approx(np.pi**2 * 1e-9 / 3, rel=1e-5)


def test_halved_corner_keeps_all_grid_lines():
    grid = make_grid(2.0, settings=MeshSettings(5, 6))
    found = halved(grid, 2)
    assert found.cells == (9, 10)
    assert np.isin(grid.x, found.x).all()
    assert found.y[-1] - found.y[-2] == pytest.approx((grid.y[-1] - grid.y[-2]) / 4)


def test_a_square_root_is_extrapolated_to_its_zero():
    strain = np.array([0.03, 0.04, 0.05])
    assert extrapolated(strain, np.sqrt(strain - 0.025), 0.01) == pytest.approx(0.025, abs=1e-12)
    assert extrapolated(strain, np.sqrt(0.06 - strain), 0.07) == pytest.approx(0.06, abs=1e-12)


def test_rays_amid_a_long_strip_are_those_of_an_endless_one():
    """There all rays are parallel and carry Y sin^2 e/H with e = u sin + v cos."""
    short, long = (MansfieldStrip(1.0, length, 0.002, 0.006) for length in (8.0, 9.0))
    angle = long.endless_angle
    assert long.angle(0.0) == pytest.approx(angle, abs=1e-5)
    sine, cosine = np.sin(angle), np.cos(angle)
    tension = sine**2 * (0.002 * sine + 0.006 * cosine)
    more = np.subtract(long.forces, short.forces)  # of one more unit of length
    assert more == pytest.approx([tension * sine, tension * cosine], rel=1e-5)


def test_rays_do_not_depend_on_the_unit_of_length_or_the_load():
    strip, other = MansfieldStrip(1.0, 2.0, 0.002, 0.006), MansfieldStrip(100.0, 200.0, 0.1, 0.3)
    assert other.angle(30.0) == pytest.approx(strip.angle(0.3), rel=1e-9)
    assert strip.angle(0.0) < strip.angle(0.5) < strip.angle(1.0) == 0.5 * np.pi


@pytest.mark.parametrize("stretch", [1.1, 1.5])
def test_an_annulus_stretched_alike_everywhere_is_in_equilibrium(stretch):
    slopes = annulus._taut(LAW, 1.7, np.array([1.7 * stretch, stretch]))
    assert slopes == pytest.approx([stretch, 0.0], abs=1e-14)


def test_radial_wrinkles_carry_the_same_load_at_all_radii():
    case = annulus.Annulus(LAW, outer=1.5, hole=0.5, pull=1.0)
    radii = np.linspace(1.0, 1.5, 2001)
    state = annulus.radial(case, radii)
    assert state.interface == case.outer
    slope, middle = np.diff(state.positions) / np.diff(radii), 0.5 * (radii[1:] + radii[:-1])
    loads = middle * np.array([annulus.uniaxial(LAW, s) for s in slope])
    assert loads == pytest.approx(case.pull, rel=1e-6)


@pytest.mark.parametrize("polar", [False, True])
def test_biquadratic_residual_and_tangent_are_derivatives_of_the_energy(polar):
    elements = Elements(np.linspace(1.0, 2.0, 3), np.linspace(0.0, 1.0, 4), polar)
    first, second = elements.nodes
    position = 1.1 * np.stack([first, second])
    if polar:
        position = 1.1 * first * np.stack([np.cos(second), np.sin(second)])
    rng = np.random.default_rng(3)
    position += 0.01 * rng.standard_normal(position.shape)
    problem = FlatProblem(elements, LAW, position, np.ones(position.shape, dtype=bool))
    unknowns, direction = position.ravel(), rng.standard_normal(position.size)
    here, step = problem.derivatives(unknowns), 1e-5
    ahead, behind = unknowns + step * direction, unknowns - step * direction
    slope = (problem.energy(ahead) - problem.energy(behind)) / (2.0 * step)
    assert slope == pytest.approx(here.residual @ direction, rel=1e-7)
    turned = (problem.residual(ahead) - problem.residual(behind)) / (2.0 * step)
    assert multiply(here.tangent, direction) == pytest.approx(turned, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("mutation", MUTATIONS, ids=lambda mutation: mutation.what)
def test_what_a_mutation_replaces_occurs_once(mutation):
    text = (SOURCE / PACKAGE / mutation.file).read_text(encoding="utf-8")
    assert text.count(mutation.old) == 1
