"""The numbers that a finished figure shows, as a table: what is drawn is read from its axes."""

import csv
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection, QuadMesh
from matplotlib.colors import to_hex
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D

from wrinklestudy.files.origin import comment_line
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.typing import AnyPath, Array

_LARGEST = 20_000  # values of a picture; of a larger one every n-th row and column is written
_DIGITS = 9


class ShownSeries(NamedTuple):
    """One thing that is drawn in a panel.

    Parameters
    ----------
    panel : int
        Number of its axes in the figure, from 1.
    kind : str
        line, points, contour or picture.
    label : str
        Its name in the legend; the level of a contour line; empty without one.
    points : (n, 2) or (n, 3) array
        x, y as on the axes; the value as a third column for a picture or coloured points.
    """

    panel: int
    kind: str
    label: str
    points: Array


def shown_series(figure: Figure) -> list[ShownSeries]:
    """Return all that the axes of a figure show of numbers; bands, texts and frames are left out.

    Parameters
    ----------
    figure : Figure
        As it is saved.
    """
    parts = {
        axes.figure: [other for other in figure.axes if other.figure is axes.figure]
        for axes in figure.axes
    }
    names = {part: _names_by_colour(all_axes) for part, all_axes in parts.items()}
    return [
        series._replace(label=series.label or names[axes.figure].get(_colour(artist), ""))
        for number, axes in enumerate(figure.axes, 1)
        for artist in (*axes.lines, *axes.collections, *axes.images)
        for series in _of_artist(number, axes, artist)
        if len(series.points)
    ]


def _names_by_colour(all_axes: list[Axes]) -> dict[str, str]:
    """Return the names of the legend by colour, for curves that the colour alone names.

    A part of a page has a legend of its own: the same colour may be another sheet in the next part.
    """
    names: dict[str, set[str]] = {}
    for axes in all_axes:
        for line in axes.lines:
            if not str(line.get_label()).startswith("_"):
                names.setdefault(_colour(line), set()).add(str(line.get_label()))
    return {colour: labels.pop() for colour, labels in names.items() if len(labels) == 1}


def _colour(artist: Artist) -> str:
    return str(to_hex(artist.get_color())) if isinstance(artist, Line2D) else ""


def write_numbers(figure: Figure, path: AnyPath) -> None:
    """Write what a figure shows as CSV, whole or not at all.

    Comment lines say where the figure comes from and name the axes of each panel. The columns are
    panel, kind, series, x, y, value.
    """
    with atomic_path(path) as temporary, open(temporary, "w", encoding="utf-8", newline="") as file:
        file.write(comment_line())
        for number, axes in enumerate(figure.axes, 1):
            names = [text for text in (axes.get_xlabel(), axes.get_ylabel()) if text]
            title = f" ({axes.get_title()})" if axes.get_title() else ""
            file.write(f"# panel {number}{title}: {', '.join(names) or 'no labels'}\n")
        table = csv.writer(file, lineterminator="\n")
        table.writerow(("panel", "kind", "series", "x", "y", "value"))
        for series in shown_series(figure):
            head = (series.panel, series.kind, " ".join(series.label.split()))  # on one line
            for point in series.points:
                table.writerow((*head, *map(_text, point), *[""] * (3 - len(point))))


def _text(value: float) -> str:
    return "" if np.isnan(value) else f"{value:.{_DIGITS}g}"


def _of_artist(panel: int, axes: Axes, artist: Artist) -> Iterator[ShownSeries]:
    """Yield what one artist shows, if it is drawn in the coordinates of its axes."""
    name = str(artist.get_label())
    label = "" if name.startswith("_") else name
    if isinstance(artist, ContourSet):
        for level, path in zip(artist.levels, artist.get_paths(), strict=False):
            yield ShownSeries(panel, "contour", f"{level:g}", np.asarray(path.vertices))
    elif isinstance(artist, Line2D):
        if artist.get_transform() is axes.transData:
            yield ShownSeries(panel, "line", label, np.asarray(artist.get_xydata(), dtype=float))
    elif isinstance(artist, QuadMesh):
        values = np.asarray(artist.get_array(), dtype=float)
        if values.ndim < 3:  # a third axis holds colours, which are no numbers
            yield _picture(panel, label, np.asarray(artist.get_coordinates()), values)
    elif isinstance(artist, PathCollection):
        points: Array = np.ma.filled(np.ma.asarray(artist.get_offsets(), dtype=float), np.nan)
        shades = artist.get_array()
        if shades is not None and len(shades) == len(points):
            points = np.column_stack([points, np.asarray(shades, dtype=float)])
        yield ShownSeries(panel, "points", label, points)
    elif isinstance(artist, AxesImage):
        values = np.asarray(artist.get_array())
        if values.ndim == 2:
            yield _picture(panel, label, _corners(artist, values.shape), values)


def _corners(image: AxesImage, shape: tuple[int, ...]) -> Array:
    """Return the corners of the pixels of an image, (rows + 1, columns + 1, 2)."""
    left, right, bottom, top = image.get_extent()
    first, last = (bottom, top) if image.origin == "lower" else (top, bottom)
    x, y = np.linspace(left, right, shape[1] + 1), np.linspace(first, last, shape[0] + 1)
    return np.stack(np.meshgrid(x, y), axis=-1)


def _picture(panel: int, label: str, corners: Array, values: Array) -> ShownSeries:
    """Return the values of a picture at the middles of its cells, or at its points."""
    middles = corners
    if corners.shape[:2] != values.shape:
        middles = 0.25 * (corners[:-1, :-1] + corners[1:, :-1] + corners[:-1, 1:] + corners[1:, 1:])
        values = values.reshape(middles.shape[:2])
    step = int(np.ceil(np.sqrt(max(values.size / _LARGEST, 1.0))))
    thinned = (slice(None, None, step), slice(None, None, step))
    points = np.concatenate([middles[thinned], values[thinned][..., None]], axis=-1)
    return ShownSeries(panel, "picture", label, points.reshape(-1, 3))
