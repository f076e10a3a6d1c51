"""Figures on what others published, of made-up maps and sheets."""

import numpy as np
import pytest

from wrinklestudy.results.maps import MapRow
from wrinklestudy.results.tables import write_map
from wrinklestudy.studies.literature.figures import lengths, membranes
from wrinklestudy.studies.literature.membranes import MODELS, SMALL_STRAIN
from wrinklestudy.study.figures.inputs import Inputs

STRAINS, ASPECTS = np.linspace(0.02, 0.5, 13), (1.4, 1.8, 2.2, 2.6, 3.0, 3.4)
LAWS = ("foppl-von-karman", "svk", "neo-hookean", "mooney-rivlin")


def row(model, aspect, strain):
    """tau_1/W = 1.25e-3 at every L/W, a parabola in its square over strain that ends at 0.4."""
    tau = float(1.25e-3 * np.sqrt(max(25.0 * strain * (0.4 - strain), 0.0)))
    return MapRow(
        **{"material": model, "law": "mooney-rivlin", "bending": "fvk", "parity": "antisymmetric"},
        **{"aspect": aspect, "strain": float(strain), "reason": "", "corner_thickness": None},
        **dict.fromkeys(("half_waves", "largest_at", "quartic")),
        status="unstable" if tau else "stable",
        critical_thickness=tau,
        **{"cells_along": 18, "cells_across": 36},
    )


def inputs_of(folder, models):
    paths = []
    for model, aspects in models.items():
        paths.append(folder / f"{model}.csv")
        write_map([row(model, a, e) for a in aspects for e in STRAINS], paths[-1])
    return Inputs(analyses={"map": {"table": paths}})


def outline(axes):
    """Return the points of the drawn boundaries."""
    paths = [path for each in axes.collections for path in each.get_paths()]
    return np.concatenate([path.vertices for path in paths])


def test_the_ratio_that_is_held_decides_where_the_range_ends(tmp_path):
    """With t/W held every length wrinkles; with t/L = 5e-4 held those below 1.25e-3/5e-4 do."""
    figure = lengths.draw(inputs_of(tmp_path, {"mr-010-fvk": ASPECTS, "svk-00": (2.0, 3.0)}))
    left, right = (outline(axes) for axes in figure.axes)
    assert left[:, 1].max() == pytest.approx(ASPECTS[-1])
    assert right[:, 1].max() == pytest.approx(2.5, rel=2e-2)
    labels = [text.get_text() for text in figure.legends[0].get_texts()]
    assert [label for label in labels if "svk-00" in label] == []  # two lengths are no boundary


def test_a_study_without_enough_lengths_has_no_boundaries(tmp_path):
    with pytest.raises(ValueError, match="map: none has 3 lengths"):
        lengths.draw(inputs_of(tmp_path, {"mr-010-fvk": ASPECTS[:2]}))


def test_each_membrane_is_a_line_and_that_of_small_strain_the_widest(made_up, inputs_with):
    sheets = [
        made_up(material=model, law=law, bending="fvk", holes=())
        for model, law in zip(reversed(MODELS), reversed(LAWS), strict=True)
    ]
    figure = membranes.draw(inputs_with(*sheets))
    (axes,) = figure.axes
    widths = [line.get_linewidth() for line in axes.lines if line.get_marker() == "None"]
    assert len(widths) == len(MODELS)
    assert widths[0] > max(widths[1:])
    assert MODELS[0] == SMALL_STRAIN
    assert "Föppl" in figure.legends[0].get_texts()[0].get_text()
