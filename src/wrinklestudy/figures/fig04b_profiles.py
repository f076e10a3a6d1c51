"""Fig. 4b: profiles half-way between the clamps, shifted up in proportion to the strain."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.figures import style
from wrinklestudy.figures.inputs import Inputs, State, sheet_note

# The largest deflection is drawn as this multiple of the median distance of two profiles.
_FILL = 1.0


def draw(inputs: Inputs) -> Figure:
    """Draw z(y) of every state given at the height of its strain; words where none converged."""
    states = inputs.loaded_states()
    profiles = [one.profile() if one.status != "not-converged" else None for one in states]
    largest = max(float(np.abs(one.z).max()) if one is not None else 0.0 for one in profiles)
    spacing = _spacing(states)
    factor = _FILL * spacing / (largest or states[0].thickness)
    figure, axes = style.panel(style.COLUMN, 9.5)
    for state, profile in zip(states, profiles, strict=True):
        if profile is None:
            axes.text(0.0, state.strain, "not converged", ha="center", va="center", fontsize=5)
        else:
            axes.plot(profile.y, state.strain + factor * profile.z, color=style.BLUE, lw=0.7)
    axes.set_ylim(states[0].strain - 1.6 * spacing, states[-1].strain + 3.4 * spacing)
    axes.set_xlim(-0.62, 0.62)
    axes.set_xlabel("$y/W$")
    axes.set_ylabel(r"strain $\varepsilon$")
    axes.tick_params(axis="y", right=False, which="both")
    _scale_bar(axes, factor, states[0].thickness, largest)
    note = sheet_note(states[0].aspect, states[0].thickness)
    axes.text(0.04, 0.985, note, transform=axes.transAxes, ha="left", va="top", fontsize=7)
    return figure


def _spacing(states: list[State]) -> float:
    """Return the median distance of neighbouring strains."""
    strains = [state.strain for state in states]
    return float(np.median(np.diff(strains))) if len(strains) > 1 else 0.1


def _scale_bar(axes: Axes, factor: float, thickness: float, largest: float) -> None:
    """Draw a vertical bar of a whole number of thicknesses, about the largest peak to trough."""
    count = max(1, round(2.0 * largest / thickness))
    length = count * thickness * factor
    top = axes.get_ylim()[1] - 0.02 * float(np.ptp(axes.get_ylim()))
    axes.plot([0.52, 0.52], [top - length, top], color=style.BLACK, lw=1.2, solid_capstyle="butt")
    axes.text(0.50, top - 0.5 * length, f"${count}\\,t$", ha="right", va="center", fontsize=7)
