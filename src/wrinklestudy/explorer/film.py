"""A film of one sheet over strain: the lit sheet, its profile and the amplitude curve."""

import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.animation import FFMpegWriter, PillowWriter
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.files.storage import atomic_path
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.profile import profile_from_state
from wrinklestudy.metrics.surface import full_surface
from wrinklestudy.results.rows import StateRow
from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.oblique import ObliqueView, projected
from wrinklestudy.study.figures.one_sheet import PicturedSheet, exaggeration

_PER_SECOND = 8
_DPI = 110
_SIZE = (16.0, 13.0)  # cm
_SAMPLES = (200, 360)  # of the sheet, about that many along and across
_HIGHER = 2.0  # wrinkles are drawn than in pictures of one state
_ROOM = 1.2  # of the axes over what they hold


@dataclass(frozen=True, eq=False)
class _Axes:
    """What is drawn into, with the limits that hold for the whole film."""

    figure: Figure
    sheet: Axes
    profile: Axes
    amplitude: Axes
    view: ObliqueView


def check_writer(path: Path) -> None:
    """Refuse a film that cannot be written here.

    Raises
    ------
    ValueError
        If it needs ffmpeg and there is none; one line.
    """
    if path.suffix == ".mp4" and shutil.which("ffmpeg") is None:
        raise ValueError(f"{path}: MP4 needs ffmpeg, which is not installed; .gif does without")


def write_film(
    pictured: PicturedSheet,
    states: SheetStates,
    shapes: Sequence[DeformedSheet | None],
    output: Path,
) -> None:
    """Write a film with a frame for each state that has a shape.

    Parameters
    ----------
    pictured : PicturedSheet
        What is said of the sheet.
    states : SheetStates
        By strain.
    shapes : sequence of DeformedSheet or None
        Of these states.
    output : Path
        .gif or .mp4.

    Raises
    ------
    ValueError
        If there is no shape at all, or no ffmpeg for MP4; one line.
    """
    check_writer(output)
    frames = [
        (row, shape) for row, shape in zip(states.states, shapes, strict=True) if shape is not None
    ]
    if not frames:
        raise ValueError(f"{states.label}: no state converged, there is nothing to show")
    with style.applied():
        drawn = _prepared(states, frames)
        with (
            atomic_path(output) as path,
            _writer(output).saving(drawn.figure, str(path), _DPI) as writer,
        ):
            for row, shape in frames:
                _draw(drawn, pictured, states, row, shape)
                writer.grab_frame()


def _writer(output: Path) -> FFMpegWriter | PillowWriter:
    return FFMpegWriter(_PER_SECOND) if output.suffix == ".mp4" else PillowWriter(_PER_SECOND)


def _prepared(states: SheetStates, frames: Sequence[tuple[StateRow, DeformedSheet]]) -> _Axes:
    """Return axes with a scale that all frames share."""
    largest = max(row.amplitude_over_thickness or 0.0 for row, _ in frames)
    limit = max(largest, 0.1) * states.thickness
    view = ObliqueView(exaggeration(limit / _HIGHER) if largest > 0.0 else 1.0, limit)
    figure = style.new(*_SIZE)
    places = figure.add_gridspec(2, 1, height_ratios=[1.5, 1.0])
    above, below = figure.add_subfigure(places[0]), figure.add_subfigure(places[1])
    sheet = above.add_subplot()
    profile, amplitude = below.subplots(1, 2)
    drawn = _Axes(figure, sheet, profile, amplitude, view)
    above.colorbar(view.scale(states.thickness), ax=sheet, shrink=0.6, aspect=18, label="$z/t$")
    return drawn


def _draw(
    drawn: _Axes,
    pictured: PicturedSheet,
    states: SheetStates,
    row: StateRow,
    shape: DeformedSheet,
) -> None:
    """Draw a frame over the one before."""
    for axes in (drawn.sheet, drawn.profile, drawn.amplitude):
        axes.clear()
    flat = row.status == "flat"
    shape = shape.flattened() if flat else shape
    _draw_sheet(drawn, states, shape)
    scale = drawn.view.exaggeration
    what = "flat" if flat else rf"wrinkled, $z$ drawn $\times\,{scale:g}$"
    drawn.sheet.set_title(
        rf"{pictured.note}" + "\n" + rf"strain $\varepsilon = {row.strain:.3f}$: {what}",
        fontsize=9.0,
    )
    _draw_profile(drawn, states, shape)
    _draw_amplitude(drawn, states, row)


def _draw_sheet(drawn: _Axes, states: SheetStates, shape: DeformedSheet) -> None:
    axes = drawn.sheet
    along, across = shape.grid.cells
    per_cell = max(1, _SAMPLES[0] // (2 * along)), max(1, _SAMPLES[1] // (2 * across))
    points = drawn.view.draw(axes, full_surface(shape, per_cell))
    for end in (0, -1):  # the clamps
        axes.plot(*projected(points[:, end]), color=style.BLACK, lw=2.0, clip_on=False)
    half = 0.5 * states.aspect * (1.0 + states.states[-1].strain)
    corners = np.array([(x, y, 0.0) for x in (-half, half) for y in (-0.5, 0.5)]).T
    u, v = projected(corners)
    lift = drawn.view.exaggeration * drawn.view.limit
    axes.set_xlim(u.min() - 0.03, u.max() + 0.03)
    axes.set_ylim(v.min() - 0.3 * lift, v.max() + lift)
    axes.set_aspect("equal")
    axes.axis("off")


def _draw_profile(drawn: _Axes, states: SheetStates, shape: DeformedSheet) -> None:
    axes, line = drawn.profile, profile_from_state(shape, per_cell=8)
    reach = _ROOM * drawn.view.limit / states.thickness
    axes.axhline(0.0, color=style.GREY, lw=0.5)
    axes.plot(line.y, line.z / states.thickness, color=style.BLUE)
    axes.set_xlim(-0.52, 0.52)
    axes.set_ylim(-reach, reach)
    axes.set_xlabel("$y/W$ half-way between the clamps")
    axes.set_ylabel("$z/t$")


def _draw_amplitude(drawn: _Axes, states: SheetStates, row: StateRow) -> None:
    axes = drawn.amplitude
    axes.plot(*states.curve("amplitude_over_thickness"), color=style.BLUE)
    height = row.amplitude_over_thickness or 0.0
    axes.plot([row.strain], [height], "o", ms=6.0, color=style.VERMILLION, clip_on=False)
    axes.set_xlim(0.0, 1.02 * states.states[-1].strain)
    axes.set_ylim(0.0, _ROOM * drawn.view.limit / states.thickness)
    axes.set_xlabel(r"strain $\varepsilon$")
    axes.set_ylabel("$A/t$")
