"""The tension field beside the thinnest sheet that was computed: where they are wrinkled."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure

from wrinklestudy.results.tension import FieldLines, read_lines
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs, StateFile
from wrinklestudy.study.figures.series import number

_SAMPLES = 6  # per cell
_FIBRES = 1.1  # density of the lines
_EDGE = 0.01  # of the largest excess: rounding at the free edge, where there is none, is less


def draw(inputs: Inputs) -> Figure:
    """Draw a quarter of both in the undeformed sheet, with the edge of the field's wrinkles."""
    state = next(one for one in inputs.states_of_sheets() if one.sheet is not None)
    field = nearest_field(inputs, state)
    figure = style.new(style.WIDE, 4.2)
    left, right = figure.subplots(1, 2, sharex=True, sharey=True)
    _field(left, field)
    _sheet(figure, right, state)
    for axes in (left, right):
        axes.contour(field.x, field.y, field.excess.T, [_edge(field)], colors=[style.VERMILLION])
        axes.set_aspect("equal")
        axes.set_xlabel("$X/W$")
    left.set_ylabel("$Y/W$")
    left.set_title(rf"tension field, $\varepsilon = {field.strain:g}$")
    right.set_title(rf"$t/W = {number(state.thickness)}$, $\varepsilon = {state.strain:g}$")
    return figure


def nearest_field(inputs: Inputs, state: StateFile) -> FieldLines:
    """Return the tension field of the material and L/W of a state at the nearest strain."""
    fields = [field for path in inputs.fields("tension") for field in read_lines(path)]
    same = [field for field in fields if field.aspect == state.aspect]
    return min(same, key=lambda field: abs(field.strain - state.strain))


def _edge(field: FieldLines) -> float:
    return _EDGE * float(field.excess.max())


def _field(axes: Axes, field: FieldLines) -> None:
    """Shade the wrinkled region, and draw the fibres, which run along its wrinkles."""
    wrinkled = np.where(field.excess > _edge(field), 1.0, np.nan)
    shade = ListedColormap([style.SKY])
    axes.pcolormesh(
        field.x, field.y, wrinkled.T, cmap=shade, alpha=0.35, shading="nearest", rasterized=True
    )
    inside = np.isfinite(wrinkled)
    along, across = (np.where(inside, of(field.direction), np.nan).T for of in (np.cos, np.sin))
    axes.streamplot(
        *(field.x, field.y, along, across),
        density=_FIBRES,
        color=style.BLUE,
        linewidth=0.5,
        arrowstyle="-",
    )


def _sheet(figure: Figure, axes: Axes, state: StateFile) -> None:
    """Colour the height of the wrinkles."""
    surface = state.surface((_SAMPLES, _SAMPLES))
    height = np.abs(surface.position[2])
    quarter = np.ix_(surface.reference_x >= 0.0, surface.reference_y >= 0.0)
    shown = axes.pcolormesh(
        surface.reference_x[surface.reference_x >= 0.0],
        surface.reference_y[surface.reference_y >= 0.0],
        (height / height.max())[quarter].T,
        cmap="Greys",
        shading="nearest",
        rasterized=True,
    )
    figure.colorbar(shown, ax=axes, label=r"$|z| / \max |z|$", shrink=0.6)
