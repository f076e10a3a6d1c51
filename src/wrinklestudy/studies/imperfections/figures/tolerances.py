"""Change of amplitude and decay strain against the size of each imperfection."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.studies.imperfections.effects import (
    AMPLITUDE,
    DECAY,
    GRAVITY,
    Effect,
    effects,
    words,
)
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.typing import Array

_LINES = ("-", "--", ":")
_FLOOR = 1.0e-5  # changes below it are not drawn


def draw(inputs: Inputs) -> Figure:
    """Draw clamps on the left and thickness on the right, amplitude above and decay below."""
    rows = inputs.table("imperfection").to_dict("records")
    found = [effect for effect in effects(rows) if not effect.kind.startswith(GRAVITY)]
    thickness = [effect for effect in found if effect.kind.startswith("thickness")]
    clamps = [effect for effect in found if effect not in thickness]
    figure = style.new(style.WIDE, 10.5)
    axes = figure.subplots(2, 2, sharey="row", sharex="col")
    heights = []
    for column, own in enumerate((clamps, thickness)):
        top, low = axes[:, column]
        for effect, look in zip(own, style.looks([e.kind for e in own]), strict=True):
            _amplitudes(top, effect, look)
            _points(low, effect.sizes, effect.decay, look, "-", "")
        for panel, limit in ((top, AMPLITUDE), (low, DECAY)):
            panel.axhline(limit, color=style.GREY, lw=0.8, zorder=0)
            panel.set_xscale("log")
            panel.set_yscale("log")
        heights.append(style.legend_above(top, whole_width=False))
    axes[0, 0].set_ylabel(r"$|\Delta A|/A$")
    axes[1, 0].set_ylabel(r"$|\Delta\varepsilon_\mathrm{decay}|$")
    axes[1, 0].set_xlabel("shift over $W$, or angle (rad)")
    axes[1, 1].set_xlabel("difference or amplitude over $t$")
    style.grow(figure, max(heights))
    return figure


def _amplitudes(axes: Axes, effect: Effect, look: style.Look) -> None:
    for k, change in enumerate(effect.amplitude.values()):
        label = words(effect.kind) if k == 0 else ""
        _points(axes, effect.sizes, change, look, _LINES[min(k, len(_LINES) - 1)], label)


def _points(
    axes: Axes, sizes: Array, change: Array, look: style.Look, line: str, label: str
) -> None:
    """Draw |change|: filled markers where it is positive, open ones where it is negative."""
    shown = np.abs(change) > _FLOOR  # not where it is unknown, either
    axes.plot(sizes[shown], np.abs(change)[shown], line, color=look.color, lw=0.8)
    for sign, face in ((1.0, look.color), (-1.0, "white")):
        own = shown & (sign * change > 0.0)
        axes.plot(sizes[own], np.abs(change)[own], look.marker, color=look.color, mfc=face)
    if label:
        axes.plot([], [], f"{look.marker}-", color=look.color, label=label)
