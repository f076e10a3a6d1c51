"""The critical mode over strain and L/W: its waves, its place, and how near the parities are."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm, TwoSlopeNorm
from matplotlib.figure import Figure

from wrinklestudy.studies.beyond import maps
from wrinklestudy.study.figures import strain_map, style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.strain_map import StrainMap
from wrinklestudy.typing import Array

# Differences of the parities below rounding and above a hundredth are drawn as these.
_LEAST, _MOST = 1e-14, 1e-2


def draw(inputs: Inputs) -> Figure:
    """Draw half-waves, place along x and the difference of the parities, a row for each model."""
    models = list(maps.by_model(inputs.table("map")))
    figure = style.new(2.6 * style.COLUMN, 5.6 * len(models))
    for line, (title, rows) in zip(
        figure.subplots(len(models), 3, squeeze=False), models, strict=True
    ):
        odd, even = (rows[rows.parity == parity] for parity in ("antisymmetric", "symmetric"))
        waves = strain_map.of_table(odd, "half_waves")
        _shade(figure, line[0], waves, waves.values, "half-waves, antisymmetric", LogNorm(6, 40))
        place = strain_map.of_table(rows, "largest_at")
        _shade(figure, line[1], place, place.values, "largest at $|x|/L$")
        first, second = strain_map.of_table(odd), strain_map.of_table(even)
        digits = _digits(first.values, second.values)
        scale = TwoSlopeNorm(0.0, np.log10(_LEAST / _MOST), -np.log10(_LEAST / _MOST))
        label = r"$\pm\lg$ difference of the parities"
        _shade(figure, line[2], first, digits, label, scale, "RdBu")
        for axes, shown in zip(line, (waves, place, first), strict=True):
            strain_map.finish(axes, shown, title if axes is line[0] else "")
    return figure


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
    label: str,
    norm: LogNorm | TwoSlopeNorm | None = None,
    colours: str = "viridis",
) -> None:
    """Colour the points of a map; white where there is no mode."""
    mesh = axes.pcolormesh(
        shown.strains,
        shown.aspects,
        np.ma.masked_invalid(values),
        norm=norm,
        cmap=colours,
        shading="nearest",
        rasterized=True,
    )
    figure.colorbar(mesh, ax=axes, location="top", label=label, aspect=25)
