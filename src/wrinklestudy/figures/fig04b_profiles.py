"""Fig. 4b: profiles half-way between the clamps, shifted up in proportion to the strain."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.figures import style
from wrinklestudy.figures.inputs import Inputs, State, sheet_note

# The largest deflection is drawn as this multiple of the median distance of two profiles.
_FILL = 1.0


def draw(inputs: Inputs) -> Figure:
    """Draw z(y) of every state given at the height of its strain; a hole where none converged."""
    states = [one for one in inputs.loaded_states() if one.status != "not-converged"]
    if not states:
        raise ValueError("states: none of them converged, there is no profile to draw")
    profiles = [state.profile() for state in states]
    largest = max(float(np.abs(profile.z).max()) for profile in profiles)
    factor = _spacing(states) * _FILL / largest if largest > 0.0 else 1.0
    figure, axes = style.panel(style.COLUMN, 9.5)
    for state, profile in zip(states, profiles, strict=True):
        axes.plot(
            profile.y, state.strain + factor * profile.z, color=style.BLUE, lw=0.7, clip_on=False
        )
    bottom = states[0].strain - 1.6 * _spacing(states)
    top = states[-1].strain + 3.4 * _spacing(states)
    axes.set_ylim(max(bottom, -1.0), top)
    axes.set_xlim(-0.62, 0.62)
    axes.set_xlabel("$y/W$")
    axes.set_ylabel(r"strain $\varepsilon$")
    axes.tick_params(axis="y", right=False, which="both")
    _scale_bar(axes, factor, states[0], largest)
    note = sheet_note(states[0].aspect, states[0].thickness)
    axes.text(0.04, 0.985, note, transform=axes.transAxes, ha="left", va="top", fontsize=7)
    return figure


def _spacing(states: list[State]) -> float:
    strains = [state.strain for state in states]
    return float(np.median(np.diff(strains))) if len(strains) > 1 else 0.1


def _scale_bar(axes: Axes, factor: float, state: State, largest: float) -> None:
    """Draw a vertical bar of a whole number of thicknesses near the largest deflection."""
    count = max(1, round(2.0 * largest / state.thickness))
    length = count * state.thickness * factor
    top = axes.get_ylim()[1] - 0.6 * (axes.get_ylim()[1] - state.strain) * 0.04
    axes.plot([0.52, 0.52], [top - length, top], color=style.BLACK, lw=1.2, solid_capstyle="butt")
    axes.text(0.50, top - 0.5 * length, f"${count}\\,t$", ha="right", va="center", fontsize=7)
