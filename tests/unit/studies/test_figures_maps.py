"""Figures of maps: what they show of made-up maps whose boundaries are known."""

import numpy as np
import pandas as pd
import pytest
from matplotlib.figure import Figure

from wrinklestudy.results.maps import MapRow
from wrinklestudy.results.tables import write_map
from wrinklestudy.studies.beyond import maps
from wrinklestudy.studies.beyond.figures import (
    map_length,
    map_modes,
    map_quartic,
    map_thickness,
)
from wrinklestudy.study.figures import strain_map
from wrinklestudy.study.figures.inputs import Inputs

STRAINS = np.linspace(0.01, 0.6, 30)
ASPECTS = np.linspace(1.0, 4.0, 16)


def tau(aspect, strain):
    """tau^2 = (1.5e-3)^2 (1 - (L/W - 2.5)^2) 16 eps (0.5 - eps), where both are positive."""
    ridge, curve = 1.0 - (aspect - 2.5) ** 2, 16.0 * strain * (0.5 - strain)
    return 1.5e-3 * np.sqrt(max(ridge, 0.0) * max(curve, 0.0))


def row(aspect, strain, parity, hole=False):
    thickness = None if hole else float(tau(aspect, strain))
    mode = {"half_waves": None, "largest_at": None, "quartic": None}
    if thickness:
        mode = {"half_waves": 8 if parity == "antisymmetric" else 7, "largest_at": 0.1 * aspect}
        mode["quartic"] = 0.1 * (3.0 - aspect)
    status = "not-converged" if hole else "unstable" if thickness else "stable"
    return MapRow(
        material=maps.PAPER_MATERIAL,
        law="mooney-rivlin",
        bending="thinning",
        parity=parity,
        aspect=float(aspect),
        strain=float(strain),
        status=status,
        critical_thickness=thickness,
        corner_thickness=None,
        cells_along=18,
        cells_across=36,
        reason="made up" if hole else "",
        **mode,
    )


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("map")
    paths = []
    for k, aspect in enumerate(ASPECTS):
        paths.append(folder / f"aspect{k}.csv")
        parities = ("antisymmetric", "symmetric")
        write_map([row(aspect, e, parity) for e in STRAINS for parity in parities], paths[-1])
    return Inputs(analyses={"map": {"table": paths}})


def texts(figure):
    return [text.get_text() for axes in figure.axes for text in axes.texts]


def test_the_tips_of_the_island_are_those_of_the_map(inputs):
    """At t/W = 1e-3 the roots of 2.25 (1 - (a - 2.5)^2) = 1."""
    shown = texts(map_thickness.draw(inputs))
    off = np.sqrt(1.0 - 1.0 / 2.25)
    numbers = [float(text) for text in shown if text.replace(".", "").isdigit()]
    assert numbers == pytest.approx([2.5 - off, 2.5 + off], rel=5e-3)


def test_a_map_in_lengths_is_that_in_widths_over_the_aspect(inputs):
    shown = strain_map.of_table(inputs.table("map"))
    lengths = shown.in_lengths()
    assert lengths.values[3] == pytest.approx(shown.values[3] / ASPECTS[3])
    numbers = [float(t) for t in texts(map_length.draw(inputs)) if t.replace(".", "").isdigit()]
    # 9 (1 - (a - 2.5)^2) = a^2; the ridge begins with a kink at 1.5, between two L/W of the map
    assert numbers == pytest.approx(np.sort(np.roots([10.0, -45.0, 47.25])), rel=0.02)


def test_a_hole_of_a_map_stays_a_hole(tmp_path):
    rows = [
        row(a, e, "symmetric", hole=(a == ASPECTS[5] and e == STRAINS[4]))
        for a in ASPECTS
        for e in STRAINS
    ]
    write_map(rows, tmp_path / "map.csv")
    shown = strain_map.of_table(pd.read_csv(tmp_path / "map.csv"))
    assert np.argwhere(np.isnan(shown.values)).tolist() == [[5, 4]]
    figure = map_thickness.draw(Inputs(analyses={"map": {"table": [tmp_path / "map.csv"]}}))
    labels = [text.get_text() for legend in figure.legends for text in legend.get_texts()]
    assert "not converged" in labels


def test_edges_are_the_roots_of_the_interpolated_square():
    squared = np.array([tau(2.5, e) ** 2 for e in STRAINS])
    found = maps.edges(STRAINS, squared, 1e-3)
    roots = np.sort(np.roots([-16.0, 8.0, -1.0 / 2.25]))
    assert [found.birth, found.decay] == pytest.approx(roots, abs=3e-3)
    lasting = maps.edges(STRAINS, np.linspace(1.0, 2.0, 30) * 1e-6, 1e-3)
    assert lasting.birth <= STRAINS[0]
    assert np.isnan(lasting.decay)
    assert np.isnan(maps.edges(STRAINS, squared, 2e-3)).all()


def test_the_sign_along_the_boundary_is_that_of_the_modes_there(inputs):
    """Made up to change its sign at L/W = 3, at birth and at decay alike."""
    table = inputs.table("map")
    odd = table[table.parity == "antisymmetric"]
    at_birth, at_decay = maps.along_boundary(
        strain_map.of_table(odd), strain_map.of_table(odd, "quartic"), np.array([5e-4, 1e-3])
    )
    for values in (at_birth, at_decay):
        known = np.isfinite(values[1])
        assert known.any()
        assert np.array_equal(values[1][known] > 0.0, ASPECTS[known] < 3.0)
    labels = [
        text.get_text()
        for legend in map_quartic.draw(inputs).legends
        for text in legend.get_texts()
    ]
    assert any("subcritical" in label for label in labels)


def test_modes_are_drawn_with_one_row_of_panels_for_each_model(inputs):
    figure = map_modes.draw(inputs)
    assert isinstance(figure, Figure)
    assert len(figure.axes) == 6  # three panels with their colour bars
