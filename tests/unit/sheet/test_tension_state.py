"""The limit of no thickness of a sheet beside its flat and its wrinkled states."""

import numpy as np
import pytest

from wrinklestudy import MeshSettings, Sheet, mooney_rivlin
from wrinklestudy.metrics.confinement import confined_widths

LATEX = mooney_rivlin(c10=6.21e4, c01=1.58e5)
STRAIN = 0.12


@pytest.fixture(scope="module")
def limit():
    return Sheet(2, 1e-3, LATEX).tension_field(STRAIN)


def test_thinner_sheets_approach_the_limit_from_below(limit):
    """Bending stiffness keeps a sheet from hiding all the width that it need not have."""
    hidden = [Sheet(2, t, LATEX).solve(STRAIN).measures.phi_squared for t in (1e-3, 5e-4)]
    assert hidden[0] < hidden[1] < limit.confinement.phi_squared


def test_wrinkles_that_cost_nothing_make_the_sheet_softer_than_real_ones(limit):
    """Compression across the sheet holds it wider, which takes force; real wrinkles bear some."""
    state = Sheet(2, 1e-3, LATEX).solve(STRAIN)
    wrinkled, flat = state.equilibrium.nominal_stress, state.equilibrium.planar.flat.force
    assert limit.field.force < wrinkled < flat
    assert limit.row.nominal_stress_pa == limit.field.force * LATEX.shear_modulus


def test_the_thickness_plays_no_role(limit):
    other = Sheet(2, 2e-4, LATEX, bending="fvk", parity="symmetric").tension_field(STRAIN)
    assert other.confinement == limit.confinement


def test_a_sheet_that_is_taut_is_the_flat_one():
    sheet = Sheet(1, 1e-3, LATEX)
    limit, state = sheet.tension_field(0.1), sheet.solve(0.1)
    assert (limit.status, state.status) == ("flat", "flat")
    assert limit.confinement.phi_squared == 0.0
    width = state.measures.projected_width
    assert limit.confinement.projected_width == pytest.approx(width, rel=1e-5)
    assert limit.field.force == pytest.approx(state.equilibrium.nominal_stress, rel=1e-5)


def test_the_error_is_the_difference_from_a_sheet_with_half_the_cells(limit):
    """Which is found from its own coarser mesh, so that where a field starts from does not show."""
    coarse = Sheet(2, 1e-3, LATEX, mesh=MeshSettings(12, 18)).tension_field(STRAIN)
    assert coarse.field.space.grid.cells == limit.field.coarser.space.grid.cells
    lines = np.linspace(0.0, 0.25, 6)
    widths = [confined_widths(one.field, lines) for one in (limit, coarse)]
    (fine, rough) = (arc / projected for arc, projected in widths)
    assert limit.phi_squared_error == pytest.approx(np.abs(fine - rough).max(), rel=1e-3)
    assert limit.phi_squared_error >= abs(fine - rough)[0]


def test_the_numbers_are_plain_and_those_of_the_field(limit):
    values = limit.as_dict()
    assert values["status"] == limit.status == "wrinkled"
    assert values["reason"] == limit.reason == ""
    assert values["phi_squared"] == limit.confinement.phi_squared
    assert {type(value) for value in values.values()} == {float, int, str}


def test_an_observer_is_told_of_iterations_on_both_meshes():
    told = []
    sheet = Sheet(2, 1e-3, LATEX, mesh=MeshSettings(8, 12))
    state = sheet.tension_field(STRAIN, observer=lambda stage, last: told.append((stage, last)))
    assert {stage for stage, _ in told} == {"tension field"}
    iterations = len(state.field.history) + len(state.field.coarser.history)
    assert sum(last is not None for _, last in told) == iterations


@pytest.mark.parametrize("strain", [0.0, -0.1, 1.5, float("nan")])
def test_a_strain_that_is_not_allowed_is_refused(strain):
    with pytest.raises(ValueError, match=r"strain = .*: must be >= 1e-7 and <= 1"):
        Sheet(2, 1e-3, LATEX).tension_field(strain)
