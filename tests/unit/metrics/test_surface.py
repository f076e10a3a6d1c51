"""The interpolant of a state: evaluation, mirroring, profile, surface, largest deflection."""

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from wrinklestudy.fem.boundary import QUARTER, Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.metrics.interpolant import DeformedSheet, evaluate
from wrinklestudy.metrics.measure import measure_sheet
from wrinklestudy.metrics.profile import profile_from_state
from wrinklestudy.metrics.surface import envelope, full_surface, sheet_peak
from wrinklestudy.vocabulary import FLAP

GRID_X = 1.0 - (1.0 - np.linspace(0.0, 1.0, 7)) ** 1.5
GRID_Y = np.linspace(0.0, 0.5, 5)
GRID = Grid(GRID_X, GRID_Y)
# Even in X with a level clamp; odd in Y. Both are cubic on each cell, so the element holds them.
ALONG = Polynomial([1.0, 0.0, -3.0, 2.0])
ACROSS = Polynomial([0.0, 1.0, 0.0, -4.0])
ONE = Polynomial([1.0])
LINE = Polynomial([0.0, 1.0])


def dofs(f, g, grid_x=GRID_X, grid_y=GRID_Y):
    """Value, d/dX, d/dY, d2/dXdY of f(X) g(Y) at the nodes."""
    pairs = ((f, g), (f.deriv(), g), (f, g.deriv()), (f.deriv(), g.deriv()))
    return np.stack([np.outer(a(grid_x), b(grid_y)) for a, b in pairs])


def state(deflection, symmetry=QUARTER):
    """A sheet stretched by 10% and narrowed by 5% with the given deflection."""
    nodes = np.stack([1.1 * dofs(LINE, ONE), 0.95 * dofs(ONE, LINE), deflection])
    return DeformedSheet(GRID, nodes, symmetry)


def test_a_bicubic_is_reproduced_with_its_derivatives():
    generator = np.random.default_rng(3)
    f, g = Polynomial(generator.normal(size=4)), Polynomial(generator.normal(size=4))
    x, y = np.linspace(0.0, 1.0, 23), np.linspace(0.0, 0.5, 17)
    for dx, dy in ((0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (0, 2)):
        exact = np.outer(f.deriv(dx)(x), g.deriv(dy)(y))
        found = evaluate(GRID, dofs(f, g), x, y, dx, dy)
        assert found == pytest.approx(exact, abs=1e-11)


def test_the_peak_between_nodes_is_found():
    """z = Y - 4 Y^3 peaks at Y = 1/sqrt(12), between the nodes 1/4 and 3/8."""
    found = measure_sheet(state(1e-2 * dofs(ALONG, ACROSS)))
    assert found.amplitude == pytest.approx(1e-2 * (2.0 / 3.0) / np.sqrt(12.0), rel=1e-7)
    assert found.amplitude > 1.02e-2 * ACROSS(GRID_Y).max()  # nodes alone would miss it
    assert found.extrema == pytest.approx(0.95 / np.sqrt(12.0) * np.array([-1.0, 1.0]), rel=1e-6)
    assert found.projected_width == pytest.approx(0.95, rel=1e-14)


def test_the_profile_has_the_parity_of_the_state():
    odd = profile_from_state(state(dofs(ALONG, ACROSS)), x=0.3)
    assert odd.z == pytest.approx(-odd.z[::-1], abs=1e-15)
    assert odd.z == pytest.approx(ALONG(0.3) * ACROSS(odd.y / 0.95), abs=1e-13)
    assert odd.x == pytest.approx(0.33)
    level = Polynomial([1.0, 0.0, -3.0])
    even = profile_from_state(state(dofs(ALONG, level), Symmetry.mirrored("symmetric")), x=-0.3)
    assert even.z == pytest.approx(even.z[::-1], abs=1e-15)
    assert even.z == pytest.approx(ALONG(0.3) * level(even.y / 0.95), abs=1e-13)
    assert even.x == pytest.approx(-0.33)


def test_a_line_off_the_sheet_is_refused():
    with pytest.raises(ValueError, match=r"x = 1.2: must lie between -L/2 and L/2 = 1"):
        profile_from_state(state(dofs(ALONG, ACROSS)), x=1.2)


def test_the_full_sheet_is_the_function_continued():
    """Even in X and odd in Y, the polynomial holds on the whole sheet and so do its derivatives."""
    even = Polynomial([1.0, 0.0, -1.0])
    whole = state(dofs(even, ACROSS)).unfolded()
    x, y = np.linspace(-1.0, 1.0, 31), np.linspace(-0.5, 0.5, 29)
    for dx, dy in ((0, 0), (1, 0), (0, 1), (1, 1)):
        found = whole.evaluate(x, y, dx, dy)
        assert found[2] == pytest.approx(
            np.outer(even.deriv(dx)(x), ACROSS.deriv(dy)(y)), abs=1e-12
        )
    flat = whole.evaluate(x, y)
    assert flat[0] == pytest.approx(np.outer(1.1 * x, np.ones(29)), abs=1e-14)
    assert flat[1] == pytest.approx(np.outer(np.ones(31), 0.95 * y), abs=1e-14)


def test_the_normal_is_that_of_the_graph():
    """For x = 1.1 X, y = 0.95 Y the surface is the graph z(x, y): n ~ (-z,x, -z,y, 1)."""
    even = Polynomial([0.1, 0.0, -0.1])
    surface = full_surface(state(dofs(even, ACROSS)), per_cell=(2, 3))
    x, y = surface.reference_x, surface.reference_y
    graph = np.stack(
        [
            -np.outer(even.deriv()(x), ACROSS(y)) / 1.1,
            -np.outer(even(x), ACROSS.deriv()(y)) / 0.95,
            np.ones((len(x), len(y))),
        ]
    )
    assert surface.normal == pytest.approx(graph / np.linalg.norm(graph, axis=0), abs=1e-12)
    assert surface.position.shape == (3, 25, 25)


def test_the_largest_deflection_of_the_sheet_is_found_where_it_is():
    """z = (X^2 - X^3)(Y - 4 Y^3) is largest at X = 2/3, Y = 1/sqrt(12), inside cells."""
    hump = Polynomial([0.0, 0.0, 1.0, -1.0])
    peak = sheet_peak(state(-1e-3 * dofs(hump, ACROSS)))
    exact = 1e-3 * (4.0 / 27.0) * (2.0 / 3.0) / np.sqrt(12.0)
    assert peak.amplitude == pytest.approx(exact, rel=1e-9)
    assert (peak.x, peak.y) == pytest.approx((2.0 / 3.0, 1.0 / np.sqrt(12.0)), abs=1e-4)


def test_profiles_do_not_depend_on_how_the_sheet_was_solved():
    """The whole sheet and the quarter that it unfolds from are one function."""
    sheet = state(1e-2 * dofs(ALONG, ACROSS))
    for x in (0.0, -0.3):
        whole, quarter = (profile_from_state(s, x=x) for s in (sheet.unfolded(), sheet))
        assert np.array_equal(whole.y, quarter.y)
        assert np.array_equal(whole.z, quarter.z)


def test_the_envelope_is_as_long_as_the_deflection_is_above_half_of_its_height():
    """1 - 3 X^2 + 2 X^3 is 1/2 at X = 1/2, so half of the sheet; stretched by 10%."""
    lengths = envelope(state(1e-3 * dofs(ALONG, ACROSS)))
    assert lengths.length == pytest.approx(1.0, rel=1e-3)
    assert lengths.deformed_length == pytest.approx(1.1 * lengths.length, rel=1e-12)
    whole = envelope(state(1e-3 * dofs(ALONG, ACROSS)).unfolded())
    assert whole.length == pytest.approx(lengths.length, rel=1e-12)


def test_two_zones_of_wrinkles_count_without_what_lies_between_them():
    """(4 X (1 - X))^2 is above 1/2 for |X - 1/2| < sqrt(1 - 1/sqrt 2)/2, in either half."""
    hump = Polynomial([0.0, 0.0, 16.0, -32.0, 16.0])
    lengths = envelope(state(1e-3 * dofs(hump, ACROSS)))
    assert lengths.length == pytest.approx(2.0 * np.sqrt(1.0 - np.sqrt(0.5)), rel=2e-2)


def test_a_flap_at_the_corner_of_the_clamp_is_no_wrinkle():
    """A flap three times as high as the wrinkles leaves their length and place as they are."""
    x = 1.0 - (1.0 - np.linspace(0.0, 1.0, 25)) ** 1.5
    shapes = ((1.1, LINE, ONE), (0.95, ONE, LINE), (1e-3, ALONG, ACROSS))
    nodes = np.stack([factor * dofs(f, g, x) for factor, f, g in shapes])
    sheet = DeformedSheet(Grid(x, GRID_Y), nodes, QUARTER)
    flap = np.zeros_like(nodes)
    flap[2, 0, -3, -1] = 3.0 * np.abs(nodes[2, 0]).max()
    with_flap = DeformedSheet(sheet.grid, nodes + flap, QUARTER)
    assert sheet_peak(with_flap).x > 1.0 - FLAP
    assert envelope(with_flap) == envelope(sheet)
    assert envelope(sheet).x == 0.0
    assert envelope(sheet).amplitude == pytest.approx(sheet_peak(sheet).amplitude, rel=1e-2)
