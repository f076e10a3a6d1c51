"""Birth, decay and largest amplitude against C01/C10 and against Poisson's ratio."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.beyond.rubber import (
    MEASURED,
    curves,
    interval,
    sampled_shares,
    share,
)
from wrinklestudy.studies.beyond.selections import CHECK, POISSON, RATIO, named
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.style import BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILLION

_TICKS = np.array([0.0, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0])
_FITS = {"treloar": (GREEN, "fit, all modes"), "treloar-uniaxial": (ORANGE, "fit, uniaxial")}
_HEIGHT = "max_amplitude_over_thickness"


def draw(inputs: Inputs) -> Figure:
    """Draw the wrinkled range of strains and the largest A/t of each rubber."""
    figure = style.new(style.WIDE, 9.0)
    (top, top_svk), (low, low_svk) = figure.subplots(2, 2, sharex="col", sharey="row")
    given = named(inputs.series, RATIO, CHECK)
    others = named(inputs.series, POISSON)
    own = [sheet for sheet in inputs.series if sheet not in [*given, *others]]
    _ratios(top, low, inputs, [*given, *own])
    for sheet in own:
        ends = (sheet.decay - MEASURED, sheet.decay + MEASURED)
        top.axhspan(*ends, color=SKY, alpha=0.35, lw=0.5, label=f"decay measured to {MEASURED:g}")
    _fits(top, low, inputs)
    pairs = sorted(
        ((inputs.material(sheet.material).law.poisson, sheet) for sheet in others),
        key=lambda pair: pair[0],
    )
    _poisson(top_svk, low_svk, pairs)
    top.set_ylabel(r"strain $\varepsilon$")
    top.set_ylim(bottom=0.0)
    low.set_ylabel(r"$\max_\varepsilon A/t$")
    low.set_ylim(bottom=0.0)
    style.grow(figure, style.legend_above(top, first=("decay", "birth"), columns=3))
    return figure


def _ratios(top: Axes, low: Axes, inputs: Inputs, sheets: list[SheetStates]) -> None:
    """Draw the sheets of Mooney-Rivlin rubbers, and the curves through those that make them."""
    materials = {sheet.material: inputs.material(sheet.material) for sheet in sheets}
    through = [sheet for sheet in sheets if not sheet.material.startswith(CHECK)]
    try:
        found = curves(through, [materials[sheet.material] for sheet in through])
        fine = np.linspace(found.shares[0], found.shares[-1], 400)
        top.plot(fine, found.at("birth strain", fine), "-", color=BLUE)
        top.plot(fine, found.at("decay strain", fine), "-", color=VERMILLION)
        low.plot(fine, found.at("largest A/t", fine), "-", color=PURPLE)
    except MissingError:
        pass  # too few ratios for a curve: the points remain
    for sheet in sheets:
        x, checks = share(materials[sheet.material]), sheet.material.startswith(CHECK)
        face = "white" if checks else None
        label = "left out of the curves" if checks else None
        top.plot([x], [sheet.birth], "o", color=BLUE, mfc=face, label=None if checks else "birth")
        top.plot(
            *([x], [sheet.decay], "s"),
            color=VERMILLION,
            mfc=face,
            label=label if checks else "decay",
        )
        low.plot([x], [sheet.peak[_HEIGHT]], "D", color=PURPLE, mfc=face)
    ticks = _TICKS / (1.0 + _TICKS)
    low.set_xticks(ticks, [f"{tick:g}" for tick in _TICKS])
    low.minorticks_off()
    low.set_xlabel("$C_{01}/C_{10}$")


def _fits(top: Axes, low: Axes, inputs: Inputs) -> None:
    """Shade the ratios that two fits to the same rubber allow."""
    for name, (color, label) in _FITS.items():
        known = interval(sampled_shares(inputs.fit(name)))
        for axes in (top, low):
            axes.axvspan(
                *(known.low, known.high),
                color=color,
                alpha=0.35,
                lw=0.5,
                label=f"{label} (95%)" if axes is top else None,
            )


def _poisson(top: Axes, low: Axes, pairs: list[tuple[float, SheetStates]]) -> None:
    """Draw the Saint Venant-Kirchhoff sheets."""
    nu = [poisson for poisson, _ in pairs]
    top.plot(nu, [sheet.birth for _, sheet in pairs], "o-", color=BLUE)
    top.plot(nu, [sheet.decay for _, sheet in pairs], "s-", color=VERMILLION)
    flat = [poisson for poisson, sheet in pairs if not sheet.wrinkles]
    heights = [0.0 if poisson in flat else sheet.peak[_HEIGHT] for poisson, sheet in pairs]
    low.plot(nu, heights, "D-", color=PURPLE)
    low.set_xlabel(r"Poisson's ratio $\nu$ (SVK)")
