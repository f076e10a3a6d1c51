"""Panels that are figures of their own, together on one page as a publication prints them."""

from collections.abc import Callable, Sequence

from matplotlib.figure import Figure, FigureBase, SubFigure

from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs

# Draws a panel on a part of a page, or without one as a figure of its own size.
Draw = Callable[[Inputs, SubFigure | None], FigureBase]


def draw(panels: Sequence[tuple[Draw, Inputs]], columns: int = 1) -> Figure:
    """Draw panels with their letters, row after row.

    A row is as tall as its tallest panel is on its own, legend included.

    Parameters
    ----------
    panels : sequence of (callable, Inputs)
        How each panel is drawn, and from what.
    columns : int
        Panels beside each other.

    Returns
    -------
    Figure
        With ``len(panels)`` parts.
    """
    sizes = [draw_panel(inputs, None).get_figure(root=True) for draw_panel, inputs in panels]
    tall = [float(alone.get_figheight()) for alone in sizes if alone is not None]
    heights = [max(tall[k : k + columns]) for k in range(0, len(tall), columns)]
    width = columns * max(float(alone.get_figwidth()) for alone in sizes if alone is not None)
    page = Figure(figsize=(width, sum(heights)), layout="constrained")
    places = page.subfigures(len(heights), columns, height_ratios=heights, squeeze=False).flat
    for (draw_panel, inputs), place, letter in zip(panels, places, "abcdefgh", strict=False):
        draw_panel(inputs, place)
        place.text(0.01, 0.02, f"({letter})", va="bottom", fontsize=style.LETTER)
    return page
