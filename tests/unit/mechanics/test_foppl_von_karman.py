"""The membrane of Foppl and von Karman: linear in the plane, quadratic in the slopes."""

import numpy as np
import pytest

from wrinklestudy import MeshSettings, Sheet, foppl_von_karman
from wrinklestudy.equilibrium import tension_field
from wrinklestudy.fem.grid import make_grid
from wrinklestudy.material.homogeneous import nominal_stress
from wrinklestudy.mechanics import membrane, plate
from wrinklestudy.mechanics.section import Section

NU, T = 0.3, 0.05
MATERIAL = foppl_von_karman(1.3e6, NU)
SECTION = Section(MATERIAL.law, T, "fvk")


def energy(values):
    """Membrane and bending energy in units of the shear modulus, from u_a,b, w,a and w,ab."""
    gradient = values[:2, :2].T - np.eye(2)
    slope, curvature = values[:2, 2], np.array([[values[2, 2], values[4, 2]], [0, values[3, 2]]])
    curvature[1, 0] = curvature[0, 1]
    strain = 0.5 * (gradient + gradient.T + np.outer(slope, slope))

    def plane_stress(tensor):
        return ((1 - NU) * (tensor**2).sum() + NU * np.trace(tensor) ** 2) / (1 - NU)

    return T * plane_stress(strain) + T**3 / 12 * plane_stress(curvature)


def state(seed=3):
    values = 0.3 * np.random.default_rng(seed).standard_normal((5, 3))
    values[0, 0] += 1.0
    values[1, 1] += 1.0
    return values


def test_energy_is_that_of_the_textbook():
    values = state()
    assert plate.energy(SECTION, values[..., None])[0] == pytest.approx(energy(values), rel=1e-13)


def test_gradient_and_hessian_are_derivatives_of_the_energy():
    """The energy is a polynomial of degree 4: central differences of two steps are exact."""
    values, step = state(), 1e-3

    def difference(function):
        rows = []
        for place in np.ndindex(5, 3):
            unit = np.zeros((5, 3))
            unit[place] = step
            near, far = (function(values + k * unit) - function(values - k * unit) for k in (1, 2))
            rows.append((8 * near - far) / (12 * step))
        return np.array(rows)

    def gradient(at):
        return plate.gradient(*plate.respond(SECTION, at[..., None]))[..., 0].ravel()

    np.testing.assert_allclose(gradient(values), difference(energy), rtol=1e-9, atol=1e-12)
    expected = difference(gradient).reshape(5, 3, 5, 3)
    blocks = plate.hessian(*plate.respond(SECTION, values[..., None]))
    pairs = [(i, j) for i in range(3) for j in range(i, 3)]
    for (i, j), block in zip(pairs, blocks, strict=True):
        entries = [(a, b) for a in range(5) for b in range(a if i == j else 0, 5)]
        for row, (a, b) in zip(block, entries, strict=True):
            assert row[0] == pytest.approx(expected[a, i, b, j], abs=1e-11)


def test_a_flat_sheet_has_the_energy_and_gradient_of_the_plate():
    values = state()[..., None]
    values[:2, 2] = values[2:] = 0.0
    density, slope, _ = membrane.expansion(MATERIAL.law, values[:2, :2])
    assert T * density[0] == pytest.approx(plate.energy(SECTION, values)[0], rel=1e-13)
    whole = plate.gradient(*plate.respond(SECTION, values))
    np.testing.assert_allclose(T * slope, whole[:2, :2], rtol=1e-12, atol=1e-16)


@pytest.mark.parametrize("stretch", [0.7, 1.0, 1.5])
def test_tension_is_that_of_hooke(stretch):
    """Y eps in simple tension, Y eps/(1 - nu) in both directions, Y eps/(1 - nu^2) if held."""
    strain = 1.3e6 * (stretch - 1.0)
    for mode, factor in (("uniaxial", 1.0), ("biaxial", 1 - NU), ("shear", 1 - NU**2)):
        expected = pytest.approx(strain / factor, rel=1e-12, abs=1e-7)
        assert nominal_stress(MATERIAL, stretch, mode) == expected


@pytest.fixture(scope="module")
def sheet():
    return Sheet(2, 1e-3, foppl_von_karman(), "fvk", mesh=MeshSettings(12, 18))


def test_amplitude_grows_without_end(sheet):
    """With a finite strain the same sheet is flat again at a strain of 0.3 to 0.6."""
    states = [sheet.solve(strain).measures for strain in (0.1, 0.3, 0.5)]
    for name in ("amplitude", "phi_squared"):
        values = [getattr(measures, name) for measures in states]
        assert values == sorted(values)
        assert values[2] > 1.4 * values[0] > 0.0


def test_a_sheet_far_below_its_critical_thickness_is_solved():
    """Other laws start from the tension field there, which this one has not."""
    sheet = Sheet(2, 3e-4, foppl_von_karman(), "fvk", mesh=MeshSettings(8, 24))
    assert sheet.mode(0.15).critical_thickness > 5.0 * 3e-4
    assert sheet.solve(0.15).status == "wrinkled"


def test_critical_thickness_goes_like_the_root_of_the_strain(sheet):
    """The flat state is linear in eps and bending does not change: tau^2 = C eps, no decay."""
    low, high = (sheet.mode(strain).critical_thickness for strain in (0.1, 0.4))
    assert high == pytest.approx(2.0 * low, rel=1e-8)
    stability = sheet.stability()
    assert stability.birth_strain == pytest.approx(0.1 * (1e-3 / low) ** 2, rel=1e-3)
    assert stability.decay_strain is None


def test_another_bending_law_and_the_tension_field_are_refused_in_one_line():
    message = r"^bending = 'thinning': must be fvk with the law foppl-von-karman$"
    with pytest.raises(ValueError, match=message):
        Sheet(2, 1e-3, foppl_von_karman())
    with pytest.raises(ValueError, match=message):
        Section(MATERIAL.law, T)
    with pytest.raises(ValueError, match=r"^law foppl-von-karman: has no tension field"):
        tension_field.solve(make_grid(2.0), MATERIAL.law, 0.1)
