"""The strain at which the centre of the flat sheet is compressed no more."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.studies.beyond.compression import Ending, endings, turns
from wrinklestudy.studies.beyond.rubber import ratio, share
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs

_SHOWN_ASPECT = 2.0
_LINEAR = 1e-6  # excess up to which the axis is linear


def draw(inputs: Inputs) -> Figure:
    """Draw the end of compression over C01/C10, and the excess over strain behind it."""
    figure = style.new(style.WIDE, 6.0)
    left, right = figure.subplots(1, 2, width_ratios=[1.15, 1.0])
    table = inputs.table("compression")
    found = endings(table, inputs.material)
    _ends(left, found)
    shown = table[table["aspect"] == _nearest(found)]
    curves = {
        float(ratio(share(inputs.material(str(name))))): rows.sort_values("strain")
        for name, rows in shown.groupby("material", sort=False)
    }
    looks = style.ordered(len(curves))
    for (of_rubber, rows), look in zip(sorted(curves.items()), looks, strict=True):
        right.plot(
            *(rows["strain"], rows["central_excess"]),
            color=look.color,
            label=f"{of_rubber:.3g}",
        )
    right.set_yscale("symlog", linthresh=_LINEAR)
    right.axhline(0.0, color=style.GREY, lw=0.6)
    right.set_xlabel(r"strain $\varepsilon$")
    right.set_ylabel(r"$n/\sqrt{b} - 1$ at the centre")
    title = f"$L/W = {_nearest(found):g}$, $C_{{01}}/C_{{10}}$:"
    right.legend(title=title, bbox_to_anchor=(1.0, 1.0), loc="upper left", labelspacing=0.3)
    style.grow(figure, style.legend_above(left, columns=4))
    return figure


def _nearest(found: list[Ending]) -> float:
    return min({ending.aspect for ending in found}, key=lambda a: abs(a - _SHOWN_ASPECT))


def _ends(axes: Axes, found: list[Ending]) -> None:
    """Draw the strains where compression ends, and between which ratios it ceases to end."""
    by_aspect = turns(found)
    last = max(ending.last for ending in found)
    lasting = np.unique([turn.first_lasting for turn in by_aspect.values()])
    right_end = 1.25 * max([r for r in lasting if np.isfinite(r)], default=1.0)
    for (aspect, turn), look in zip(by_aspect.items(), style.ordered(len(by_aspect)), strict=True):
        own = [ending for ending in found if ending.aspect == aspect and ending.ends]
        axes.errorbar(
            [ending.ratio for ending in own],
            [ending.strain for ending in own],
            yerr=[ending.error for ending in own],
            fmt=f"{look.marker}-",
            color=look.color,
            capsize=1.5,
            label=f"$L/W = {aspect:g}$",
        )
        if own and np.isfinite(turn.first_lasting):
            axes.axvspan(turn.last_ending, turn.first_lasting, color=look.color, alpha=0.15, lw=0.0)
            middle = 0.5 * (turn.last_ending + turn.first_lasting)
            axes.annotate(
                *("", (middle, last)),
                xytext=(middle, own[-1].strain),
                arrowprops={"arrowstyle": "->", "color": look.color, "lw": 0.8, "ls": ":"},
            )
    axes.set_xlim(-0.02 * right_end, right_end)
    axes.set_ylim(0.0, last)
    axes.set_xlabel("$C_{01}/C_{10}$")
    axes.set_ylabel("compression ends at strain")
