"""Pictures of one sheet: true lengths, the stated exaggeration, birth and decay where they are."""

import numpy as np
import pytest

from wrinklestudy.equilibrium.stability import Stability
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.results.vtu import IN_WIDTHS, LengthUnit
from wrinklestudy.study.figures.one_sheet import PicturedSheet, draw_stability, draw_state

MM = PicturedSheet(2.0, 1e-3, "mooney-rivlin", LengthUnit("mm", 140.0))
RATIOS = PicturedSheet(2.0, 1e-3, "mooney-rivlin", IN_WIDTHS)


@pytest.fixture
def shape(made_up):
    """A function from a strain to a made-up sheet."""
    grid = Grid(np.linspace(0.0, 1.0, 7), np.linspace(0.0, 0.5, 21))
    return lambda strain: DeformedSheet(grid, made_up().position(strain), Symmetry.mirrored())


@pytest.mark.parametrize(("sheet", "scale"), [(MM, 140.0), (RATIOS, 1e3)])
def test_the_profile_is_that_of_the_sheet_in_its_unit(shape, sheet, scale):
    figure = draw_state(sheet, 0.12, shape(0.12))
    profile = figure.axes[1].lines[1].get_ydata()
    largest = np.abs(shape(0.12).evaluate(np.zeros(1), np.linspace(0, 0.5, 2001))[2]).max()
    assert np.abs(profile).max() == pytest.approx(scale * largest, rel=1e-3)


@pytest.mark.parametrize("factor", [1.0, 0.1, 0.003])
def test_wrinkles_are_drawn_by_the_factor_that_is_stated(shape, factor):
    """On the screen, a deflection is cos(elevation) of what is drawn."""
    sheet = shape(0.12)
    sheet.nodes[2] *= factor
    figure = draw_state(RATIOS, 0.12, sheet)
    stated = float(figure.get_suptitle().rpartition("times\\,")[2].rstrip("$"))
    largest = np.abs(figure.axes[1].lines[1].get_ydata()).max() * 1e-3
    assert 0.02 <= stated * largest <= 0.05
    limit = figure.axes[2].get_ylim()[1]  # of the scale of colours
    assert limit == pytest.approx(1e3 * largest, rel=1e-3)


def test_a_flat_sheet_is_called_flat(shape):
    figure = draw_state(MM, 0.01, shape(0.01))
    assert figure.get_suptitle().endswith("flat")
    assert not figure.axes[1].lines[1].get_ydata().any()


def test_birth_and_decay_lie_on_curve_and_thickness():
    """tau_1^2 = c eps (1/2 - eps): the curve between the points is that function."""
    strains = np.array([0.01, 0.03, 0.06, 0.1, 0.16, 0.24, 0.32, 0.4, 0.5])
    tau = 5e-3 * np.sqrt(strains * (0.5 - strains))
    birth, decay = 0.25 - np.sqrt(0.0625 - 0.04), 0.25 + np.sqrt(0.0625 - 0.04)
    table = tuple(zip(strains.tolist(), tau.tolist(), strict=True))
    found = Stability(1e-3, birth, decay, ((birth, decay),), tau.max(), 0.24, 0.5, "", table)
    axes = draw_stability(MM, found).axes[0]
    line, curve = axes.lines[0].get_xdata(), axes.lines[0].get_ydata()
    np.testing.assert_allclose(curve, 0.7 * np.sqrt(line * (0.5 - line)), atol=0.004)
    marks = [x.get_xydata()[0] for x in axes.lines if len(x.get_xdata()) == 1]
    np.testing.assert_allclose(marks, [(birth, 0.14), (decay, 0.14)], rtol=1e-12)


def test_a_sheet_that_never_wrinkles_has_no_marks():
    found = Stability(2e-3, None, None, (), 1e-3, 0.2, 0.5, "", ((0.2, 1e-3), (0.5, 5e-4)))
    axes = draw_stability(RATIOS, found).axes[0]
    assert [line for line in axes.lines if len(line.get_xdata()) == 1] == []
    assert axes.get_ylim()[1] > 2.0
