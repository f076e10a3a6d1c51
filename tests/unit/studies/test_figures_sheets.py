"""Figures of several sheets: models side by side, and rows of aspects and thicknesses."""

import numpy as np
import pytest

from wrinklestudy.results.load import read_limits
from wrinklestudy.results.peaks import sheet_row
from wrinklestudy.results.tables import read_states
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.studies.panaitescu2019.figures import (
    fig05_amplitude,
    fig05_wavelength,
    fig06_aspect,
    fig06_labelled,
    fig06_thickness,
    fig07_collapse,
    fig07_slaving,
    fig07_width,
)
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.against_strain import COARSE
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.series import labels as series_labels
from wrinklestudy.study.figures.series import note

LAWS = ("mooney-rivlin", "neo-hookean", "svk")


def lines(axes, label):
    return [line for line in axes.lines if line.get_label() == label]


def points(axes, label):
    """Coordinates of the marks of one label, of all the lines that bear it."""
    found = [np.array(line.get_xydata()) for line in lines(axes, label)]
    return [tuple(row) for row in np.concatenate(found)]


def labels(figure):
    return [text.get_text() for text in figure.legends[0].get_texts()]


@pytest.fixture
def three_laws(made_up, inputs_with):
    sheets = [
        made_up(material=f"latex-{k}", law=law, scale=1.0 - 0.2 * k) for k, law in enumerate(LAWS)
    ]
    return inputs_with(*sheets)


@pytest.fixture
def aspects(made_up, inputs_with):
    """L/W = 1.5 never wrinkles, 2 has a hole beside its maximum, 3.5 a hole and no wrinkles.

    They are given in another order.
    """
    return inputs_with(
        made_up(aspect=2.5, scale=1.2, decay=0.3, holes=()),
        made_up(aspect=1.5, birth=None, decay=None, holes=()),
        made_up(aspect=2.0),
        made_up(aspect=3.5, birth=None, decay=None, holes=(0.2,)),
    )


def test_each_law_is_a_series_with_a_look_of_its_own(three_laws):
    figure = fig05_amplitude.draw(three_laws)
    assert labels(figure)[:3] == [style.law_label(law) for law in LAWS]
    looks = [style.looks([law])[0] for law in LAWS]
    for attribute in ("color", "marker", "line"):
        assert len({getattr(look, attribute) for look in looks}) == 3
    (axes,) = figure.axes
    peaks = [max(points(axes, style.law_label(law)), key=lambda p: p[1])[1] for law in LAWS]
    assert peaks == pytest.approx([peaks[0], 0.8 * peaks[0], 0.6 * peaks[0]])


def test_models_come_in_the_order_in_which_they_are_given(made_up, inputs_with):
    figure = fig05_wavelength.draw(
        inputs_with(made_up(material="b", law="svk"), made_up(material="a", law="neo-hookean"))
    )
    names = [style.law_label("svk"), style.law_label("neo-hookean")]
    assert labels(figure)[:2] == names


def test_models_are_named_by_what_tells_them_apart(made_up, inputs_with):
    fixed = made_up(material="latex-fixed", bending="fixed-thickness")
    two = inputs_with(made_up(), fixed, made_up(material="nh", law="neo-hookean")).series
    assert series_labels(two) == ["MR, thinning", "MR, fixed-thickness", "NH, thinning"]
    assert note(two) == "$L/W = 2$, $t/W = 10^{-3}$"
    other = inputs_with(made_up(), made_up(material="treloar")).series
    assert [label.split(":")[0] for label in series_labels(other)] == ["latex", "treloar"]
    alone = inputs_with(fixed).series
    assert note(alone) == "$L/W = 2$, $t/W = 10^{-3}$, fixed-thickness"
    assert series_labels(alone) == [style.law_label("mooney-rivlin")]


def test_a_label_occurs_once_in_a_legend(three_laws):
    for module in (fig05_amplitude, fig05_wavelength, fig06_aspect, fig07_width, fig07_slaving):
        names = labels(module.draw(three_laws))
        assert len(names) == len(set(names))


def test_maxima_are_those_of_the_summary_at_their_aspect(aspects):
    peaks, _ = fig06_aspect.draw(aspects).axes
    expected = {}
    for table, limits in zip(aspects.metrics, aspects.stability, strict=True):
        row = sheet_row(read_limits(limits), read_states(table))
        expected[row.aspect] = row.max_amplitude_over_thickness
    assert points(peaks, "$L/W = 2.5$") == [(2.5, expected[2.5])]
    assert expected[2.5] == pytest.approx(120.0 * 0.135**2, rel=0.06)
    assert expected[2.0] is None


@pytest.mark.parametrize("module", [fig05_amplitude, fig06_aspect, fig07_collapse])
def test_every_point_lies_inside_the_axes(module, aspects):
    for axes in module.draw(aspects).axes:
        found = np.concatenate(
            [line.get_xydata() for line in axes.lines if line.get_transform() == axes.transData]
        )
        found = found[np.isfinite(found).all(axis=1)]
        assert len(found)
        low, high = np.array([axes.get_xlim(), axes.get_ylim()]).T
        assert (found >= low).all()
        assert (found <= high).all()


def test_a_sheet_that_never_wrinkles_stands_at_zero_and_an_unknown_one_does_not(aspects):
    figure = fig06_aspect.draw(aspects)
    peaks, curves = figure.axes
    assert points(peaks, "never wrinkles") == [(1.5, 0.0)]
    holes = lines(peaks, "maximum not known")
    assert [list(hole.get_xdata()) for hole in holes] == [[2.0], [3.5]]
    assert all(hole.get_transform() == peaks.get_xaxis_transform() for hole in holes)
    assert {line.get_marker() for line in lines(peaks, "never wrinkles")} == {"v"}
    assert all(point[0] != 3.5 for point in points(peaks, "never wrinkles"))
    assert len(lines(curves, "not converged")) == 2
    rows = labels(figure)
    assert rows[:4] == [f"$L/W = {aspect}$" for aspect in ("1.5", "2", "2.5", "3.5")]
    assert rows[4:] == ["never wrinkles", "maximum not known"]


def test_a_sheet_that_wrinkles_between_two_strains_is_not_called_flat(made_up, inputs_with):
    narrow = made_up(birth=0.13, decay=0.19, holes=())
    (one,) = inputs_with(narrow).series
    assert "wrinkled" not in one.status
    assert not one.never_wrinkles
    assert np.isnan(one.peak["max_amplitude_over_thickness"])


def test_a_row_of_sheets_says_what_they_share(aspects):
    assert note(aspects.series) == "Mooney\N{EN DASH}Rivlin, $t/W = 10^{-3}$"


def test_six_sheets_have_six_looks(made_up, inputs_with):
    sheets = [made_up(aspect=aspect, holes=()) for aspect in (1.5, 1.8, 2.0, 2.5, 3.0, 3.5)]
    figure = fig06_aspect.draw(inputs_with(*sheets))
    marks = [lines(figure.axes[0], f"$L/W = {sheet.aspect:g}$")[0] for sheet in sheets]
    assert len({line.get_color() for line in marks}) == 6
    assert len({line.get_marker() for line in marks}) == 6
    assert len({line.get_color() for line in figure.axes[1].lines}) == 6


def test_thicknesses_are_drawn_against_width_over_thickness(made_up, inputs_with):
    thick = made_up(thickness=1.25e-3, holes=())
    thin = made_up(thickness=5e-4, scale=2.0, holes=())
    figure = fig06_thickness.draw(inputs_with(thin, thick))
    axes = figure.axes[0]
    assert axes.get_xlabel() == "$W/t$"
    assert points(axes, r"$t/W = 5 \times 10^{-4}$")[0][0] == pytest.approx(2000.0)
    assert points(axes, r"$t/W = 1.25 \times 10^{-3}$")[0][0] == pytest.approx(800.0)
    assert labels(figure)[0] == r"$t/W = 1.25 \times 10^{-3}$"


def test_a_curve_does_not_reach_for_a_decay_beyond_its_states(made_up, inputs_with):
    """States to 0.46, at most 0.12 apart: a decay at 0.5 ends the curve, one at 0.7 does not."""
    for decay, end in ((0.5, 0.5), (0.7, 0.46)):
        (one,) = inputs_with(made_up(decay=decay, holes=())).series
        assert one.curve("amplitude_over_thickness")[0][-1] == end


def test_large_strains_collapse_on_lines_of_constant_shape(aspects):
    figure = fig07_collapse.draw(aspects)
    (axes,) = figure.axes
    marked = [line for line in axes.lines if line.get_marker() not in ("None", "o", "x")]
    strains = {2.5: [], 2.0: [0.32, 0.36]}
    for line in marked:
        shown = np.isfinite(line.get_ydata())
        ratio = (line.get_ydata() / line.get_xdata())[shown]
        constant = 0.35 if line.get_markerfacecolor() == "white" else 0.7
        assert ratio == pytest.approx(np.full(len(ratio), constant))
    amplitudes = sorted(y for line in marked for y in line.get_ydata() if np.isfinite(y))
    two = [100.0 * (eps - 0.03) * (0.4 - eps) for eps in strains[2.0]]
    long = [120.0 * (0.2 - 0.03) * (0.3 - 0.2)]
    assert amplitudes == pytest.approx(sorted([*two, *two, *long, *long]))
    assert lines(axes, "$C = 1$")[0].get_ydata()[1] == lines(axes, "$C = 1$")[0].get_xdata()[1]
    sinusoid = lines(axes, r"$C = 1/\pi$")[0]
    assert sinusoid.get_ydata() == pytest.approx(theory.SINUSOID_CONSTANT * sinusoid.get_xdata())
    names = labels(figure)
    assert [name for name in names if "L/W" in name] == ["$L/W = 2$", "$L/W = 2.5$"]
    assert "2 not converged" in names


def test_a_missing_stability_file_leaves_the_ends_open(made_up, tmp_path):
    table, _ = made_up(holes=()).write(tmp_path)
    (one,) = Inputs((table,)).series
    assert np.isnan([one.birth, one.decay]).all()
    assert len(one.curve("amplitude_over_thickness")[0]) == len(one.states)


@pytest.mark.parametrize(
    "figure",
    [
        fig05_amplitude,
        fig05_wavelength,
        fig06_aspect,
        fig06_labelled,
        fig07_collapse,
        fig07_slaving,
    ],
)
def test_states_on_too_coarse_a_mesh_are_crossed_through(made_up, inputs_with, figure):
    """Where the mesh is fine enough nothing is crossed."""
    for cells, marked in ((5.9, True), (6.1, False)):
        drawn = figure.draw(inputs_with(made_up(cells_per_wavelength=cells, holes=())))
        crosses = [line for axes in drawn.axes for line in lines(axes, COARSE)]
        assert bool(crosses) == marked
