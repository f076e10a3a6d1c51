"""The critical mode over strain and L/W: its waves, its place, and how near the parities are."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colorbar import Colorbar
from matplotlib.colors import BoundaryNorm, Normalize
from matplotlib.figure import Figure

from wrinklestudy.studies.beyond import maps
from wrinklestudy.study.figures import strain_map, style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.strain_map import StrainMap
from wrinklestudy.typing import Array

# Differences of the parities below the error of an eigenvalue and above a hundredth are drawn as
# these.
_LEAST, _MOST = 1e-10, 1e-2
_PLACES = Normalize(0.0, 0.4)  # of |x|/L, the same for all models
_EMPTY = "0.85"  # grey where there is no mode: white stands for parities that agree
_WAVES = (5, 7, 9, 11, 13, 17, 25, 41)  # between which numbers of half-waves have one colour


def draw(inputs: Inputs) -> Figure:
    """Draw half-waves, place along x and the difference of the parities, a row for each model."""
    models = list(maps.by_model(inputs.table("map")))
    figure = style.new(2.6 * style.COLUMN, 5.6 * len(models))
    for line, (title, rows) in zip(
        figure.subplots(len(models), 3, squeeze=False), models, strict=True
    ):
        odd, even = (rows[rows.parity == parity] for parity in ("antisymmetric", "symmetric"))
        waves = strain_map.of_table(odd, "half_waves")
        bar = _shade(figure, line[0], waves, waves.values, BoundaryNorm(_WAVES, 256))
        bar.set_label("half-waves, antisymmetric")
        place = strain_map.of_table(rows, "largest_at")
        bar = _shade(figure, line[1], place, place.values, _PLACES)
        bar.set_label("largest at $|x|/L$")
        bar.set_ticks([0.0, 0.1, 0.2, 0.3, 0.4])
        first, second = strain_map.of_table(odd), strain_map.of_table(even)
        _parities(figure, line[2], first, second)
        for axes, shown in zip(line, (waves, place, first), strict=True):
            strain_map.finish(axes, shown, title if axes is line[0] else "", strain_map.FEW_TICKS)
    return figure


def _parities(figure: Figure, axes: Axes, odd: StrainMap, even: StrainMap) -> None:
    """Colour by which parity has the larger tau_1, the stronger the larger the difference is."""
    lowest, highest = np.log10([_LEAST, _MOST])
    most = highest - lowest
    bar = _shade(
        figure, axes, odd, _digits(odd.values, even.values), Normalize(-most, most), "RdBu"
    )
    powers = np.array([lowest + 4.0, highest])
    labels = [f"10^{{{power:.0f}}}" for power in powers]
    bar.set_ticks(
        [*(lowest - powers), 0.0, *(powers - lowest)],
        labels=[*(f"$-{x}$" for x in labels), "0", *(f"${x}$" for x in labels)],
    )
    bar.ax.tick_params(labelsize=6.5)
    bar.set_label(r"$\tau_1$, antisym. / sym. $-$ 1")


def _digits(odd: Array, even: Array) -> Array:
    """Return by how many powers of ten the parities differ more than rounding, with its sign.

    Positive where antisymmetric wrinkles appear on thicker sheets than symmetric ones do.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        apart = odd / even - 1.0
    size = np.clip(np.abs(apart), _LEAST, _MOST)
    return np.asarray(np.sign(apart) * np.log10(size / _LEAST))


def _shade(
    figure: Figure,
    axes: Axes,
    shown: StrainMap,
    values: Array,
    norm: Normalize | None = None,
    colours: str = "viridis",
) -> Colorbar:
    """Colour the points of a map, grey where there is no mode; return the bar of the colours."""
    axes.set_facecolor(_EMPTY)
    mesh = axes.pcolormesh(
        shown.strains,
        shown.aspects,
        np.ma.masked_invalid(values),
        norm=norm,
        cmap=colours,
        shading="nearest",
        rasterized=True,
    )
    return figure.colorbar(mesh, ax=axes, location="top", aspect=25)
