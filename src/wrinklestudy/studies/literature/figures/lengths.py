"""Where sheets wrinkle, over strain and L/W, with t/W held and with t/L held."""

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.equilibrium.islands import Held
from wrinklestudy.studies.beyond import maps
from wrinklestudy.studies.literature.islands import HELD
from wrinklestudy.studies.panaitescu2019.claims.dimensions import EARLIER_ISLAND, LONG
from wrinklestudy.study.figures import strain_map, style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.series import number
from wrinklestudy.study.figures.strain_map import StrainMap

_FEWEST = 3  # L/W between which a boundary can be drawn


def draw(inputs: Inputs) -> Figure:
    """Draw the boundary of every model in a panel for each ratio, over the lengths of the finest.

    Raises
    ------
    ValueError
        If no model has enough lengths.
    """
    models = [
        (title, strain_map.of_table(rows)) for title, rows in maps.by_model(inputs.table("map"))
    ]
    drawn = [(title, shown) for title, shown in models if len(shown.aspects) >= _FEWEST]
    if not drawn:
        raise ValueError(f"map: none has {_FEWEST} lengths, between which it could be drawn")
    finest = max((shown for _, shown in drawn), key=lambda shown: len(shown.aspects))
    figure, panels = strain_map.panels(len(HELD))
    for axes, (held, thickness) in zip(panels, HELD.items(), strict=True):
        for (title, shown), look in zip(drawn, style.looks([t for t, _ in drawn]), strict=True):
            _boundary(axes, shown, held, thickness, look, title)
        strain_map.finish(axes, finest, f"${held} = {number(thickness)}$ held")
        axes.axhline(LONG, color=style.GREY, lw=0.8, ls=":", label=f"$L/W = {LONG:g}$")
        published = f"published end, $L/W = {EARLIER_ISLAND:g}$"
        axes.axhline(EARLIER_ISLAND, color=style.BLACK, lw=0.8, ls="--", label=published)
    style.grow(figure, style.legend_above(panels[0], columns=2))
    return figure


def _boundary(
    axes: Axes, shown: StrainMap, held: Held, thickness: float, look: style.Look, title: str
) -> None:
    """Draw where the critical thickness equals that of the sheet; wrinkled inside."""
    strains, aspects, values = strain_map.finer(shown)
    given = thickness * aspects[:, None] if held == "t/L" else thickness
    excess = (values / given) ** 2 - 1.0
    if (excess > 0.0).any():
        axes.contour(
            strains,
            aspects,
            excess,
            levels=[0.0],
            colors=look.color,
            linestyles=look.line,
            linewidths=1.1,
        )
    axes.plot([], [], look.line, color=look.color, label=title)
