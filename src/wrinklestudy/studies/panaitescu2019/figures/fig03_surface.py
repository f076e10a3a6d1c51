"""Fig. 3c: the computed surface, deflection mapped to colour between +-3.5e-3 W.

The caption of the paper's figure gives the strain as (L - L0)/W0 = 0.12, which would be 0.06 of its
own definition (L - L0)/L0: both are shown. The paper gives its colour bar in thicknesses too, 2.5;
at t/W = 1e-3 it is 3.5 t. The surface is seen obliquely from above with the deflection drawn
larger than it is, by the factor given in the figure; the two dashed lines bound the central 80%
of the length, the part that the paper scanned.
"""

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from wrinklestudy.metrics.surface import SampledSurface
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.typing import Array

# The paper's colour bar, in units of W, and the part of the length that it scanned.
COLOR_LIMIT = 3.5e-3
SCANNED = 0.8

EXAGGERATION = 10.0
_SAMPLES = (3, 8)  # per cell along and across
_AZIMUTH, _ELEVATION = np.radians(-72.0), np.radians(40.0)
_CMAP = "coolwarm"  # grey in the middle, which leaves room for light and shade
_LIGHT = np.array([0.25, -0.55, 0.8]) / np.linalg.norm([0.25, -0.55, 0.8])


def projected(points: Array) -> tuple[Array, Array]:
    """Return the screen coordinates of points ``(3, ...)`` in an orthographic oblique view."""
    x, y, z = points
    sin_a, cos_a = np.sin(_AZIMUTH), np.cos(_AZIMUTH)
    sin_e, cos_e = np.sin(_ELEVATION), np.cos(_ELEVATION)
    return -sin_a * x + cos_a * y, cos_e * z - sin_e * (cos_a * x + sin_a * y)


def draw(inputs: Inputs) -> Figure:
    """Draw the surfaces of the states given, one below the other, with one colour bar."""
    states = inputs.loaded_states()
    figure = style.new(style.WIDE, 1.2 + 4.4 * len(states))
    panels = figure.subplots(len(states), 1, squeeze=False)[:, 0]
    for axes, state in zip(panels, states, strict=True):
        axes.set_aspect("equal")
        axes.axis("off")
        if state.status == "not-converged":
            axes.text(0.5, 0.5, "not converged", transform=axes.transAxes, ha="center")
        else:
            _surface(axes, state.surface(per_cell=_SAMPLES))
        title = rf"$\varepsilon = (L - L_0)/L_0 = {state.strain:g}$"
        axes.set_title(title, loc="left", fontsize=8.0, pad=4.0)
    figure.suptitle(rf"{states[0].note}, $z$ drawn $\times\,{EXAGGERATION:g}$", fontsize=8.0)
    scale = ScalarMappable(Normalize(-1e3 * COLOR_LIMIT, 1e3 * COLOR_LIMIT), _CMAP)
    figure.colorbar(scale, ax=list(panels), shrink=0.7, aspect=25, label="$10^3\\,z/W$")
    return figure


def _surface(axes: Axes, surface: SampledSurface) -> None:
    stretched = surface.position * np.array([1.0, 1.0, EXAGGERATION])[:, None, None]
    # Rows and columns are painted in order: the far ones must come first.
    toward = (np.cos(_AZIMUTH), np.sin(_AZIMUTH))
    flip = tuple(slice(None, None, 1 if part > 0.0 else -1) for part in toward)
    points = stretched[(slice(None), *flip)]
    u, v = projected(points)
    axes.pcolormesh(u, v, _colors(points), rasterized=True, linewidth=0.0, antialiased=False)
    _outline(axes, stretched)
    _scanned_part(axes, surface, stretched)


def _colors(points: Array) -> Array:
    """Return the colour of each cell, shape (m - 1, n - 1, 3): deflection times light."""
    corners = points[:, :-1, :-1], points[:, 1:, :-1], points[:, :-1, 1:], points[:, 1:, 1:]
    height = 0.25 * sum(corner[2] for corner in corners) / EXAGGERATION
    colors = colormaps[_CMAP](Normalize(-COLOR_LIMIT, COLOR_LIMIT)(height))[..., :3]
    normal = np.cross(corners[3] - corners[0], corners[2] - corners[1], axis=0)
    normal *= np.sign(normal[2]) / np.linalg.norm(normal, axis=0)
    light = np.clip(np.einsum("i...,i->...", normal, _LIGHT) / _LIGHT[2], 0.0, None)
    return np.clip(colors * (0.6 + 0.4 * light)[..., None], 0.0, 1.0)


def _outline(axes: Axes, points: Array) -> None:
    for edge in (points[:, 0], points[:, -1], points[:, :, 0], points[:, :, -1]):
        axes.plot(*projected(edge), color=style.BLACK, lw=0.5)


def _scanned_part(axes: Axes, surface: SampledSurface, points: Array) -> None:
    for end in (-SCANNED, SCANNED):
        row = int(np.argmin(np.abs(surface.reference_x - end * surface.reference_x[-1])))
        axes.plot(*projected(points[:, row]), "--", color=style.BLACK, lw=0.6)
