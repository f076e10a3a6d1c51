"""Fig. 4: profiles half-way between the clamps, shifted up in proportion to the strain.

Panel (b) of the paper shows the computed profiles; scanned profiles of the same sheet, if
given, are panel (a) beside it, on the same scale, with offset, tilt and noise removed.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.metrics.profile import Profile
from wrinklestudy.results.cases import canonical
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs, StateFile

# The largest deflection is drawn as this multiple of the median distance of two profiles.
_FILL = 1.0
_HEIGHT = 9.5
# Part of the axes above the highest profile: room for the scale and the name of the sheet.
_HEAD = 0.12

Curve = tuple[float, Profile | None]


def draw(inputs: Inputs) -> Figure:
    """Draw z(y) of every state at the height of its strain, or a note if none converged."""
    states = inputs.loaded_states()
    first = states[0]
    computed = [(state.strain, _profile(state)) for state in states]
    scans = inputs.scans_of([(canonical(first.aspect), canonical(first.thickness))])
    scanned = [(scan.strain, scan.profile) for scan in scans]
    spacing = _spacing(computed)
    largest = max(_height(curve) for curve in computed + scanned)
    factor = _FILL * spacing / (largest or first.thickness)
    figure = style.new(style.WIDE if scans else style.COLUMN, _HEIGHT)
    panels = figure.subplots(1, 2 if scans else 1, squeeze=False, sharey=True)[0]
    _panel(panels[-1], computed, factor, style.BLUE)
    if scans:
        _panel(panels[0], scanned, factor, style.BLACK)
        for axes, text in zip(panels, ("(a) measured", "(b) computed"), strict=True):
            axes.set_title(text, loc="left", fontsize=8.0, pad=3.0)
    strains = [strain for strain, _ in computed + scanned]
    low, high = min(strains) - 1.6 * spacing, max(strains) + 1.1 * spacing
    panels[0].set_ylim(low, low + (high - low) / (1.0 - _HEAD))
    panels[0].set_ylabel(r"strain $\varepsilon$")
    _scale_bar(panels[-1], factor, first.thickness, largest)
    place: dict[str, Any] = {"transform": panels[-1].transAxes, "ha": "left", "va": "top"}
    panels[-1].text(0.04, 0.985, first.note.replace(", ", "\n", 1), fontsize=7, **place)
    return figure


def _profile(state: StateFile) -> Profile | None:
    return None if state.status == "not-converged" else state.profile()


def _height(curve: Curve) -> float:
    return 0.0 if curve[1] is None else float(np.abs(curve[1].z).max())


def _panel(axes: Axes, curves: Sequence[Curve], factor: float, color: str) -> None:
    for strain, profile in curves:
        if profile is None:
            axes.text(0.0, strain, "not converged", ha="center", va="center", fontsize=5)
        else:
            axes.plot(profile.y, strain + factor * profile.z, color=color, lw=0.7)
    axes.set_xlim(-0.62, 0.62)
    axes.set_xlabel("$y/W$")
    axes.tick_params(axis="y", right=False, which="both")


def _spacing(curves: Sequence[Curve]) -> float:
    """Return the median distance of neighbouring strains."""
    strains = [strain for strain, _ in curves]
    return float(np.median(np.diff(strains))) if len(strains) > 1 else 0.1


def _scale_bar(axes: Axes, factor: float, thickness: float, largest: float) -> None:
    """Draw a vertical bar of a whole number of thicknesses, about the largest peak to trough."""
    count = max(1, round(2.0 * largest / thickness))
    length = count * thickness * factor
    top = axes.get_ylim()[1] - 0.02 * float(np.ptp(axes.get_ylim()))
    axes.plot([0.52, 0.52], [top - length, top], color=style.BLACK, lw=1.2, solid_capstyle="butt")
    axes.text(0.50, top - 0.5 * length, f"${count}\\,t$", ha="right", va="center", fontsize=7)
