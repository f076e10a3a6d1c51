"""The table beside a figure holds the numbers that are drawn, and only them."""

import csv

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.figure import Figure

from wrinklestudy.study.figures.shown_numbers import shown_series, write_numbers


def by_kind(figure):
    return {series.kind: series for series in shown_series(figure)}


def test_lines_and_points_with_their_names():
    figure = Figure()
    axes = figure.add_subplot()
    axes.plot([1.0, 2.0, 3.0], [4.0, np.nan, 6.0], label="theory")
    axes.scatter([0.5], [0.25], c=[7.0], label="measured")
    shown = by_kind(figure)
    assert (shown["line"].panel, shown["line"].label) == (1, "theory")
    assert np.array_equal(shown["line"].points[:, 1], [4.0, np.nan, 6.0], equal_nan=True)
    assert shown["points"].points.tolist() == [[0.5, 0.25, 7.0]]


def test_a_picture_has_its_values_at_the_middles_of_its_cells():
    figure = Figure()
    x, y = np.array([0.0, 1.0, 3.0]), np.array([0.0, 2.0])
    figure.add_subplot().pcolormesh(x, y, [[5.0, 6.0]])
    assert by_kind(figure)["picture"].points.tolist() == [[0.5, 1.0, 5.0], [2.0, 1.0, 6.0]]
    figure = Figure()
    figure.add_subplot().imshow([[1.0, 2.0]], extent=(0.0, 4.0, 0.0, 1.0), origin="lower")
    assert by_kind(figure)["picture"].points.tolist() == [[1.0, 0.5, 1.0], [3.0, 0.5, 2.0]]


def test_a_picture_of_colours_has_no_numbers():
    """A lit surface is drawn in colours that say nothing by themselves."""
    figure = Figure()
    figure.add_subplot().pcolormesh(np.arange(4.0), np.arange(3.0), np.full((2, 3, 3), 0.5))
    figure.add_subplot().imshow(np.full((2, 3, 3), 0.5))
    assert shown_series(figure) == []


def test_a_contour_lies_where_the_function_has_its_level():
    figure = Figure()
    x = np.linspace(0.0, 2.0, 41)
    figure.add_subplot().contour(x, x, np.add.outer(x, 2.0 * x).T, levels=[1.5])
    contour = by_kind(figure)["contour"]
    assert contour.label == "1.5"
    assert np.allclose(contour.points @ [1.0, 2.0], 1.5) or np.allclose(
        contour.points @ [2.0, 1.0], 1.5
    )


def test_lines_across_the_panel_are_no_numbers_of_it():
    """A line in parts of the axes marks something; its coordinates are not those of the axes."""
    figure = Figure()
    axes = figure.add_subplot()
    axes.plot([0.0, 1.0], [0.5, 0.5], transform=axes.transAxes)
    assert shown_series(figure) == []


@settings(max_examples=30, deadline=None)
@given(
    label=st.text(min_size=1).filter(lambda text: not text.startswith("_") and "\0" not in text),
    value=st.floats(allow_nan=False, allow_infinity=False),
)
def test_any_name_and_number_comes_back(tmp_path_factory, label, value):
    """Quotes and commas in a name stay in its cell, line ends become spaces."""
    figure = Figure()
    figure.add_subplot().plot([1.0], [value], label=label)
    path = tmp_path_factory.mktemp("numbers") / "a.csv"
    try:
        label.encode()
    except UnicodeEncodeError:
        return
    write_numbers(figure, path)
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("# panel")))
    assert rows[1][2] == " ".join(label.split())
    assert float(rows[1][4]) == pytest.approx(value, rel=1e-8)
