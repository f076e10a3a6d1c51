"""Fig. 6, second form: A/t over strain, every curve labelled where there is room beside it."""

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.against_strain import BELOW, coarse, extremes, holes, styled
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.series import number
from wrinklestudy.typing import Array

_COLUMN = "amplitude_over_thickness"
_BOX = np.array([0.2, 0.055])  # width and height of a label, in parts of the axes
_GAP = 0.045  # between a curve and the middle of its label
_SAMPLES = 400  # of each curve, to see whether a label covers it


def draw(inputs: Inputs) -> Figure:
    """Draw the curves of all lengths on the left, those of all thicknesses on the right."""
    like = inputs.series[0]
    lengths = [sheet for sheet in inputs.series if sheet.thickness == like.thickness]
    thicknesses = [sheet for sheet in inputs.series if sheet.aspect == like.aspect]
    figure = style.new(style.WIDE, 5.6)
    left, right = figure.subplots(1, 2)
    _curves(left, sorted(lengths, key=lambda s: s.aspect), "L/W", lambda s: s.aspect)
    _curves(
        right, sorted(thicknesses, key=lambda s: -s.thickness), "W/t", lambda s: 1.0 / s.thickness
    )
    left.set_title(rf"$t/W = {number(like.thickness)}$", fontsize=8.5)
    right.set_title(rf"$L/W = {number(like.aspect)}$", fontsize=8.5)
    return figure


def _curves(
    axes: Axes, sheets: list[SheetStates], symbol: str, value: Callable[[SheetStates], float]
) -> None:
    """Draw the sheets of one panel; those that never wrinkle are named together in its corner."""
    pairs = styled(sheets)
    names = [f"${symbol} = {_short(value(sheet))}$" for sheet, _ in pairs]
    for (sheet, look), name in zip(pairs, names, strict=True):
        axes.plot(*sheet.curve(_COLUMN), look.line, color=look.color, lw=0.8, label=name)
        wrinkled = sheet.of_status("wrinkled")
        points = sheet.column("strain")[wrinkled], sheet.column(_COLUMN)[wrinkled]
        axes.plot(*points, look.marker, color=look.color, ms=2.4)
        coarse(axes, sheet, sheet.column("strain"), sheet.column(_COLUMN))
        holes(axes, sheet, look.color)
    highest = extremes(sheets, _COLUMN)[1] or 1.0
    axes.set_ylim(-BELOW * highest, 1.2 * highest)
    axes.set_xlim(0.0, 1.02 * float(axes.dataLim.x1))
    axes.set(xlabel=r"strain $\varepsilon$", ylabel="$A/t$")
    never = [_short(value(sheet)) for sheet in sheets if sheet.never_wrinkles]
    if never:
        text = f"never wrinkles: ${symbol} = {', '.join(never)}$"
        axes.text(0.97, 0.97, text, transform=axes.transAxes, ha="right", va="top", fontsize=7.0)
    curves = [_in_axes(axes, *sheet.curve(_COLUMN)) for sheet in sheets]
    taken: list[Array] = []
    for (sheet, look), name, curve in zip(pairs, names, curves, strict=True):
        if not sheet.never_wrinkles:
            x, y = middle = _place(curve, np.concatenate(curves), taken)
            taken.append(middle)
            shown = axes.text(x, y, name, transform=axes.transAxes, fontsize=6.5, color=look.color)
            shown.set(ha="center", va="center")


def _in_axes(axes: Axes, strain: Array, amplitude: Array) -> Array:
    """Return many points of a curve in parts of the axes, (n, 2)."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    dense = np.linspace(strain[0], strain[-1], _SAMPLES)
    values = np.interp(dense, strain, amplitude)
    return np.column_stack([(dense - left) / (right - left), (values - low) / (high - low)])


def _place(curve: Array, drawn: Array, taken: list[Array]) -> Array:
    """Return the middle of a label nearest to the top of a curve that covers nothing."""
    nearest = np.argsort(np.abs(np.arange(len(curve)) - int(np.argmax(curve[:, 1]))), kind="stable")
    for shift in ((0.0, _GAP), (0.6 * _BOX[0], 0.4 * _GAP), (0.0, -_GAP)):
        for at in nearest:
            middle: Array = curve[at] + np.array(shift)
            inside = (np.abs(drawn - middle) < 0.5 * _BOX).all(axis=1).any()
            over = any((np.abs(other - middle) < _BOX).all() for other in taken)
            within = ((middle > 0.55 * _BOX) & (middle < 1.0 - 0.55 * _BOX)).all()
            if within and curve[at, 1] > 0.3 * curve[:, 1].max() and not (inside or over):
                return middle
    return np.asarray(curve[nearest[0]] + np.array((0.0, _GAP)))


def _short(value: float) -> str:
    return number(float(f"{value:.3g}"))
