"""Pages that put the panels of one figure of the paper together."""

import numpy as np
import pytest

from wrinklestudy.studies.panaitescu2019.figures import (
    fig05_amplitude,
    fig05_page,
    fig05_wavelength,
    fig06_aspect,
    fig06_page,
    fig07_collapse,
    fig07_page,
    fig07_width,
)
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.shown_numbers import shown_series


@pytest.fixture
def sheets(made_up, inputs_with):
    """The figure sheet first, then one of another length and one of another thickness."""
    own = made_up(aspect=2.0)
    return inputs_with(own, made_up(aspect=2.5, scale=1.2), made_up(thickness=5e-4, scale=1.5))


def drawn(figure):
    """The numbers of a figure without the panel that they are in, as text: NaN equals NaN."""
    return [(s.kind, s.label, str(s.points.tolist())) for s in shown_series(figure)]


def test_a_page_shows_what_its_panels_show(made_up, inputs_with):
    inputs = inputs_with(made_up(law="mooney-rivlin"), made_up(material="nh", law="neo-hookean"))
    with style.applied():
        whole = drawn(fig05_page.draw(inputs))
        single = [*drawn(fig05_amplitude.draw(inputs)), *drawn(fig05_wavelength.draw(inputs))]
    assert whole == single


def test_panels_of_other_sheets_show_their_own(sheets):
    """Panel a of figure 6 has both lengths but not the other thickness; 7a the first sheet only."""
    with style.applied():
        page = fig06_page.draw(sheets)
        alone = fig06_aspect.draw(sheets.only(lambda sheet: sheet.thickness == 1e-3))
        assert drawn(page)[: len(drawn(alone))] == drawn(alone)
        far = drawn(fig07_page.draw(sheets))
        width = drawn(fig07_width.draw(sheets.only(lambda sheet: sheet.size == (2.0, 1e-3))))
        collapse = drawn(fig07_collapse.draw(sheets.only(lambda s: s.thickness == 1e-3)))
    assert far[: len(width)] == width
    assert far[-len(collapse) :] == collapse


def test_nothing_of_a_panel_lies_on_another(sheets):
    """Axes and legends of different parts do not overlap, and all lie on the page."""
    with style.applied():
        figure = fig07_page.draw(sheets)
        figure.draw_without_rendering()
    boxes = [part.get_tightbbox() for part in figure.subfigs]
    page = figure.bbox  # in pixels, like those of the parts
    for number, box in enumerate(boxes):
        assert (box.min >= page.min - 2.0).all(), number
        assert (box.max <= page.max + 2.0).all(), number
        for other in boxes[:number]:
            overlap = np.minimum(box.max, other.max) - np.maximum(box.min, other.min)
            assert (overlap <= 2.0).any()
