"""Fig. 2: the sheet from above, lit from the side, in true deformed shape at growing strain.

Grey is the light that a matt surface sends up, n . l with the true unit normal n and the light l
at 25 degrees above the sheet to its left, as a multiple of that of the flat sheet. All panels have
the same scales of length and of grey. The undeformed sheet is a rectangle and needs no computation.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs, StateFile
from wrinklestudy.typing import Array

# Elevation of the light, and grey of the flat sheet (0 black, 1 white).
ELEVATION = np.radians(25.0)
FLAT_GREY = 0.68

_GAP = 1.22  # distance of neighbouring sheets in units of W
_SAMPLES = (5, 5)  # per cell, so that a drawn cell is hardly larger than a pixel
_CLAMP = 0.07  # length of a drawn clamp in units of W


def brightness(normal: Array) -> Array:
    """Return the grey level of a surface with unit normals ``(3, ...)``, clipped to [0, 1].

    n . l / sin(elevation) times the grey of the flat sheet; the light comes from negative y.
    """
    light = np.array([0.0, -np.cos(ELEVATION), np.sin(ELEVATION)])
    lit = np.einsum("i...,i->...", normal, light) / np.sin(ELEVATION)
    return np.clip(FLAT_GREY * lit, 0.0, 1.0)


def draw(inputs: Inputs) -> Figure:
    """Draw the undeformed sheet and the states given, side by side, pulled up and down."""
    states = inputs.loaded_states()
    aspect = states[0].aspect
    longest = aspect * (1.0 + states[-1].strain)
    width = _GAP * (len(states) + 1)
    figure, axes = style.panel(style.WIDE, style.WIDE * (longest + 0.75) / width)
    axes.set_aspect("equal")
    axes.axis("off")
    _rectangle(axes, aspect)
    for k, state in enumerate(states, 1):
        _sheet(axes, state, _GAP * k)
    _scale_bar(axes, longest)
    note = f"{states[0].note}, light from the left"
    axes.text(-0.5, 0.5 * longest + 0.2, note, ha="left", va="bottom")
    axes.set_xlim(-0.62, width - _GAP + 0.62)
    axes.set_ylim(-0.5 * longest - 0.36, 0.5 * longest + 0.36)
    return figure


def _rectangle(axes: Axes, aspect: float) -> None:
    corners = np.array([[-0.5, 0.5], [-0.5, 0.5]])
    ends = 0.5 * aspect * np.array([[-1.0, -1.0], [1.0, 1.0]])
    _shaded(axes, corners, ends, np.full((2, 2), FLAT_GREY))
    _clamps(axes, 0.0, 0.5 * aspect)
    _caption(axes, 0.0, 0.5 * aspect, r"$\varepsilon = 0$")


def _sheet(axes: Axes, state: StateFile, offset: float) -> None:
    half = 0.5 * state.aspect * (1.0 + state.strain)
    if state.status == "not-converged":
        axes.text(offset, 0.0, "not converged", ha="center", va="center", rotation=90)
    else:
        surface = state.surface(per_cell=_SAMPLES)
        along, across = surface.position[0], surface.position[1]
        _shaded(axes, across + offset, along, brightness(surface.normal))
    _clamps(axes, offset, half)
    _caption(axes, offset, half, rf"$\varepsilon = {state.strain:g}$")


def _shaded(axes: Axes, x: Array, y: Array, grey: Array) -> None:
    """Fill the cells of a grid of points with the mean grey of their corners; draw its edges."""
    mean = 0.25 * (grey[:-1, :-1] + grey[1:, :-1] + grey[:-1, 1:] + grey[1:, 1:])
    axes.pcolormesh(x, y, mean, cmap="gray", vmin=0.0, vmax=1.0, rasterized=True, linewidth=0.0)
    for edge in (0, -1):
        axes.plot(x[:, edge], y[:, edge], color=style.GREY, lw=0.4)


def _clamps(axes: Axes, offset: float, half: float) -> None:
    for end in (half, -half - _CLAMP):
        axes.add_patch(
            Rectangle((offset - 0.53, end), 1.06, _CLAMP, facecolor="#303030", edgecolor="none")
        )


def _caption(axes: Axes, offset: float, half: float, text: str) -> None:
    axes.text(offset, -half - _CLAMP - 0.06, text, ha="center", va="top")


def _scale_bar(axes: Axes, longest: float) -> None:
    height = 0.5 * longest + 0.02
    axes.plot([-0.5, 0.5], [height, height], color=style.BLACK, lw=1.0, solid_capstyle="butt")
    axes.text(0.0, height - 0.04, "$W$", ha="center", va="top")
