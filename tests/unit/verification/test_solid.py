"""The solid of the verification: law, element and condensation against FElupe and closed forms."""

from pathlib import Path

import felupe
import numpy as np
import pandas as pd
import pytest

from verification.groups import solid as group
from verification.solid_run import write_best
from verification.tools import solid_table
from verification.tools.sheets import LATEX, NEO_HOOKEAN, SVK
from verification.tools.solid_law import SolidLaw
from verification.tools.solid_space import solid_space
from verification.tools.solid_states import SolidSheet, cubic
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.upper_triangle import symmetric
from wrinklestudy.studies.panaitescu2019.solid import FILE, solid_ends

ROOT = Path(__file__).parents[3]

LAW = SolidLaw.of(LATEX)


def energy(gradient, pressure):
    """W of the docstring of `solid_law`."""
    det = np.linalg.det(gradient)
    cofactor = det * np.linalg.inv(gradient).T
    rest = pressure - 2 * LAW.c10 - 4 * LAW.c01
    return (
        LAW.c10 * ((gradient**2).sum() - 3) + LAW.c01 * ((cofactor**2).sum() - 3) + rest * (det - 1)
    )


def test_stress_and_tangent_are_derivatives_of_the_energy():
    rng = np.random.default_rng(1)
    gradient, pressure, step = np.eye(3) + 0.3 * rng.standard_normal((3, 3)), 0.7, 1e-4
    points = LAW.points(gradient.reshape(9, 1), np.array([pressure]))
    tangent = LAW.tangent(gradient.reshape(9, 1), np.array([pressure]))
    for entry in range(9):
        change = np.zeros(9)
        change[entry] = step
        moved = [gradient + sign * change.reshape(3, 3) for sign in (1, -1)]
        slope = (energy(moved[0], pressure) - energy(moved[1], pressure)) / (2 * step)
        assert points.stress[entry, 0] == pytest.approx(slope, rel=1e-6, abs=1e-7)
        stresses = [LAW.points(m.reshape(9, 1), np.array([pressure])).stress[:, 0] for m in moved]
        column = (stresses[0] - stresses[1]) / (2 * step)
        np.testing.assert_allclose(tangent[:, entry, 0], column, rtol=1e-5, atol=1e-6)


def test_another_law_than_mooney_rivlin_is_refused():
    with pytest.raises(TypeError, match="svk: the solid needs Mooney-Rivlin"):
        SolidLaw.of(SVK)


@pytest.mark.parametrize("material", [LATEX, NEO_HOOKEAN])
def test_a_cube_under_uniaxial_tension_has_the_incompressible_stress(material):
    """P = 2 (lambda - lambda^-2) (c10 + c01/lambda), and the error falls like mu/K."""
    law, stretch = SolidLaw.of(material), 1.4
    exact = 2 * (stretch - stretch**-2) * (law.c10 + law.c01 / stretch)

    def stress(bulk):
        def residual(width):
            pressure = bulk * (stretch * width**2 - 1)
            gradient = np.diag([stretch, width, width]).reshape(9, 1)
            return law.points(gradient, np.array([pressure])).stress[:, 0]

        low, high = 0.8 * stretch**-0.5, 1.2 * stretch**-0.5
        for _ in range(80):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if residual(middle)[4] > 0 else (middle, high)
        return residual(low)[0]

    errors = [abs(stress(bulk) - exact) for bulk in (1e3, 1e4)]
    assert errors[1] < 1e-3 * exact
    assert errors[0] / errors[1] == pytest.approx(10.0, rel=0.02)


def small(part, layers=1):
    grid = Grid(np.array([0.0, 0.6, 1.0]), np.array([0.0, 0.5]))
    return solid_space(grid, 0.2, part, layers)


def test_a_homogeneous_deformation_is_represented_exactly():
    space = small("both")
    field = np.zeros((len(space.blocks), *space.shape))
    x, y = np.meshgrid(*space.lines, indexing="ij")
    field[space.blocks.index((0, 0, True))] = 0.3 * x + 0.1 * y
    field[space.blocks.index((2, 1, False))] = -0.2 * 0.1  # of zeta: a stretch of 0.8 along z
    expected = np.array([1.3, 0.1, 0, 0, 1, 0, 0, 0, 0.8])
    gradient = space.deformation(field.ravel())
    np.testing.assert_allclose(
        gradient, np.broadcast_to(expected[:, None, None], gradient.shape), atol=1e-13
    )
    assert space.measure.sum() == pytest.approx(0.1, rel=1e-14)


def felupe_tangent(space, displacement, pressure_value, law):
    """Stiffness of the displacements at a fixed pressure, assembled by FElupe alone."""
    cells = space.grid.cells
    places, columns = [], []
    element = felupe.ArbitraryOrderLagrangeElement(order=3, dim=3)
    for i in range(cells[0]):
        for j in range(cells[1]):
            low = np.array([space.grid.x[i], space.grid.y[j], -0.5 * space.thickness])
            high = np.array([space.grid.x[i + 1], space.grid.y[j + 1], 0.5 * space.thickness])
            places.append(low + 0.5 * (np.asarray(element.points) + 1) * (high - low))
    points, number = np.unique(np.round(np.concatenate(places), 12), axis=0, return_inverse=True)
    mesh = felupe.Mesh(points, number.reshape(-1, 64), "VTK_LAGRANGE_HEXAHEDRON")
    region = felupe.RegionLagrange(mesh, order=3, dim=3)
    for component, power, _ in space.blocks:
        for node in range(space.shape[0] * space.shape[1]):
            a, b = divmod(node, space.shape[1])
            here = np.isclose(points[:, 0], space.lines[0][a]) & np.isclose(
                points[:, 1], space.lines[1][b]
            )
            column = np.zeros((len(points), 3))
            column[here, component] = (points[here, 2] / (0.5 * space.thickness)) ** power
            columns.append(column.ravel())
    combine = np.array(columns).T
    field = felupe.Field(region, dim=3, values=(combine @ displacement).reshape(-1, 3))
    container = felupe.FieldContainer([field])
    gradient = container.extract()[0]
    tangent = law.tangent(gradient.reshape(9, -1), np.full(gradient[0, 0].size, pressure_value))
    shape = (3, 3, 3, 3, *gradient.shape[2:])
    form = felupe.IntegralForm([tangent.reshape(shape)], container, region.dV, container)
    whole = form.assemble().toarray()
    return combine.T @ whole @ combine


def test_the_tangent_is_the_one_that_felupe_assembles():
    """Without bulk modulus, where nothing is condensed, at a random displacement."""
    space = small("both")
    displacement = 0.02 * np.random.default_rng(2).standard_normal(space.size)
    gradient = space.deformation(displacement)
    at = np.full(space.measure.shape, 0.4)
    nothing = np.zeros((len(space.element.pressure), len(space.volume)))
    problem = space.condensed(LAW, 1e-14, gradient, nothing, at)
    expected = felupe_tangent(space, displacement, 0.4, LAW)[np.ix_(space.free, space.free)]
    scale = np.abs(expected).max()
    np.testing.assert_allclose(symmetric(problem.tangent).toarray(), expected, atol=1e-10 * scale)


def test_condensation_gives_the_step_of_the_uncondensed_problem():
    """[[K, D^T], [D, -V/K]] solved whole, against one Newton step without the pressure."""
    space, bulk, rng = small("even"), 50.0, np.random.default_rng(3)
    displacement = 0.02 * rng.standard_normal(space.size)
    pressure = rng.standard_normal((len(space.element.pressure), len(space.volume)))
    gradient = space.deformation(displacement)
    at = space.element.pressure.T @ pressure
    problem = space.condensed(LAW, bulk, gradient, pressure, at)
    bare = space.condensed(LAW, 1e-14, gradient, pressure, at)  # K and residual at fixed pressure
    count, cells = pressure.shape
    coupling = np.zeros((count, cells, space.size))
    for cell in range(cells):
        for local, dof in enumerate(np.concatenate(space._dofs)[:, cell]):
            coupling[:, cell, dof] += problem.coupling[cell, :, local]
    coupling = coupling.reshape(count * cells, -1)[:, space.free]
    mismatch = problem.mismatch.ravel()
    over = np.tile(space.volume / bulk, count)
    stiffness = symmetric(bare.tangent).toarray()
    residual = problem.residual - coupling.T @ (mismatch / over)
    whole = np.block([[stiffness, coupling.T], [coupling, -np.diag(over)]])
    step = np.linalg.solve(whole, -np.concatenate([residual, mismatch]))
    moved = np.zeros(space.size)
    moved[space.free] = np.linalg.solve(symmetric(problem.tangent).toarray(), -problem.residual)
    np.testing.assert_allclose(moved[space.free], step[: space.free.sum()], rtol=1e-7, atol=1e-9)
    change = space.pressure_step(problem, moved, bulk).ravel()
    np.testing.assert_allclose(change, step[space.free.sum() :], rtol=1e-6, atol=1e-8)


def test_pressures_are_orthonormal_in_the_mean():
    for part, layers in (("even", 1), ("odd", 1), ("both", 1), ("even", 2)):
        element = small(part, layers).element
        weights = element.weights / element.weights.sum()
        product = (element.pressure * weights) @ element.pressure.T
        np.testing.assert_allclose(product, np.eye(len(product)), atol=1e-12)


@pytest.mark.parametrize("layers", [1, 2])
def test_a_flat_solid_under_tension_is_stable_and_as_thick_as_incompressible(layers):
    """At the middle of the sheet det F = 1 up to mu/K and no stress acts on the faces."""
    sheet = SolidSheet(LATEX, 0.02, (4, 4), 1e4, layers)
    state, space = sheet.flat(0.2), sheet.spaces["even"]
    assert state.unstable == 0
    assert sheet.mode(0.2).unstable == 0
    gradient = space.deformation(state.displacement)
    points = LAW.points(gradient, space.element.pressure.T @ state.pressure)
    assert np.abs(points.volume[:, 0] - 1).max() < 1e-3
    assert np.abs(points.stress[8, :, 0]).max() < 1e-3 * points.stress[0, :, 0].max()


def test_a_cubic_is_interpolated_exactly():
    lines = np.array([0, 1, 2, 3, 4.5, 6, 7.5]) / 3
    at = np.linspace(0, 2.5, 17)
    np.testing.assert_allclose(cubic(lines, lines**3 - lines, at), at**3 - at, atol=1e-13)


def test_extrapolation_takes_out_the_fourth_power():
    assert group.extrapolated(2 + 5 * 2.0**4, 2 + 5.0, 2.0) == pytest.approx(2.0, rel=1e-13)


@pytest.mark.parametrize(
    ("decay", "says"),
    [
        (0.3985, "it is the plate that the solid is"),
        (0.3245, "the solid rules it out"),
        (0.4001, "the solid does not decide on it"),
    ],
)
def test_the_verdict_on_a_bending_law_follows_its_numbers(decay, says):
    best = {
        "birth": group.Estimate(0.0247, 1e-5, 0.0247, 0.0, 0.0),
        "decay": group.Estimate(0.3988, 2e-4, 0.3988, 0.0, 0.0),
    }
    assert says in group.verdicts(best, {"thinning": (0.0247, decay)})


def test_the_study_reads_what_follows_from_the_kept_table(tmp_path):
    write_best(pd.read_csv(ROOT / solid_table.ENDS), tmp_path / "solid.csv")
    assert (tmp_path / "solid.csv").read_text() == FILE.read_text()
    ends = solid_ends()
    assert ends.keys() == {"birth", "decay"}
    assert ends["decay"].ratio == pytest.approx(LATEX.law.c01 / LATEX.law.c10, rel=1e-6)
    assert all(0.0 < end.bar < group.ERROR_BAR for end in ends.values())
