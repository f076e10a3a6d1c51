"""Figures show what tables and states hold, no more; the same inputs give the same bytes."""

import re
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Annotation

from wrinklestudy.stages import material
from wrinklestudy.stages.figures import run as draw_figure
from wrinklestudy.studies.panaitescu2019 import CATALOGUE, figures, theory
from wrinklestudy.studies.panaitescu2019.figures import (
    fig01_stress,
    fig02_sheet,
    fig03_surface,
    fig04_profiles,
    fig05_amplitude,
    fig05_wavelength,
    fig07_confinement,
    fig07_slaving,
    fig07_width,
)
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.series import labels as series_labels
from wrinklestudy.study.figures.series import number

STUDY = "panaitescu2019"
STRAINS = (0.02, 0.06, 0.1, 0.12, 0.2, 0.32, 0.36, 0.46)
WRINKLED = [0.06, 0.1, 0.12, 0.32, 0.36]
FLAT = [0.02, 0.46]
HOLE = 0.2
BIRTH, DECAY = 0.03, 0.4
OF_STATES = ("fig02_sheet", "fig03_surface", "fig04_profiles")


def run(name, inputs, output):
    names = [one.name for one in fields(inputs) if one.name != "analyses"]
    paths = {name: getattr(inputs, name) for name in names}
    shown = CATALOGUE.figure(name).strains_shown(STRAINS)
    states = [path for path, eps in zip(inputs.states, STRAINS, strict=False) if eps in shown]
    draw_figure(STUDY, name, output=output, **paths | {"states": states})


def series_points(axes, label):
    """Coordinates of the marked points of a series."""
    (line,) = (line for line in axes.lines if line.get_label() == label)
    return np.asarray(line.get_xdata()), np.asarray(line.get_ydata())


def labels(figure):
    return [text.get_text() for text in figure.legends[0].get_texts()]


@pytest.fixture(scope="module")
def everything(inputs, materials):
    return Inputs(
        inputs.metrics, inputs.stability, materials.materials, inputs.states, materials.data
    )


@pytest.mark.parametrize("name", CATALOGUE.figure_names)
def test_two_runs_give_the_same_bytes(name, everything, tmp_path):
    suffixes = (".pdf", ".png", ".svg") if name == "fig06_aspect" else (".pdf",)
    first = [tmp_path / f"first{suffix}" for suffix in suffixes]
    second = [tmp_path / f"second{suffix}" for suffix in suffixes]
    run(name, everything, first)
    run(name, everything, second)
    assert [path.read_bytes() for path in first] == [path.read_bytes() for path in second]
    assert first[0].read_bytes().startswith(b"%PDF")
    assert sorted(tmp_path.iterdir()) == sorted(first + second)


@pytest.mark.parametrize(
    "name", [name for name in CATALOGUE.figure_names if name != "fig01_stress"]
)
def test_a_sheet_of_which_nothing_converged_is_drawn(name, made_up, inputs_with, tmp_path):
    nothing = made_up(holes=STRAINS, birth=None, decay=None)
    states = STRAINS if name in OF_STATES else ()
    run(name, inputs_with(nothing, states=states), tmp_path / "a.pdf")
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize(
    "name", [name for name in CATALOGUE.figure_names if name != "fig01_stress"]
)
def test_a_sheet_that_never_wrinkles_is_drawn(name, made_up, inputs_with, tmp_path):
    flat = made_up(holes=(), birth=None, decay=None)
    states = STRAINS if name in OF_STATES else ()
    run(name, inputs_with(flat, states=states), tmp_path / "a.pdf")
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")


def test_every_module_of_a_figure_is_in_the_catalogue_under_its_name():
    modules = {path.stem for path in Path(figures.__file__).parent.glob("fig[0-9]*.py")}
    assert modules == set(CATALOGUE.figure_names)
    assert all(entry.module.endswith(f".{entry.name}") for entry in CATALOGUE.figures)


def test_figures_are_numbered_as_in_the_paper():
    panels = [entry.panel for entry in CATALOGUE.figures]
    assert len(set(panels)) == len(panels)
    for entry in CATALOGUE.figures:
        assert entry.name.startswith(f"fig{int(re.match('[0-9]+', entry.panel).group()):02}_")


def test_a_figure_that_cannot_be_drawn_leaves_the_old_file(tmp_path):
    output = tmp_path / "fig02_sheet.pdf"
    output.write_text("old")
    with pytest.raises(ValueError, match="states: none given"):
        draw_figure(STUDY, "fig02_sheet", output=output)
    with pytest.raises(ValueError, match="metrics: no table given"):
        draw_figure(STUDY, "fig06_aspect", output=output)
    with pytest.raises(ValueError, match="materials: none given"):
        draw_figure(STUDY, "fig01_stress", output=[output])
    assert output.read_text() == "old"
    assert list(tmp_path.iterdir()) == [output]


def test_unknown_names_and_formats_are_refused_before_drawing(tmp_path):
    with pytest.raises(ValueError, match=r"figure 'fig9': must be one of fig01_stress, "):
        draw_figure(STUDY, "fig9", output=tmp_path / "a.pdf")
    with pytest.raises(ValueError, match=r"a.jpg: a figure must end in one of .pdf, .png, .svg"):
        draw_figure(STUDY, "fig01_stress", output=tmp_path / "a.jpg")


def test_a_table_without_a_column_or_without_rows_is_named(inputs, tmp_path):
    path = tmp_path / "metrics.csv"
    path.write_text("material,law\nlatex,svk\n")
    with pytest.raises(ValueError, match=r"metrics.csv: column 'bending' is missing"):
        fig05_amplitude.draw(Inputs((path,), inputs.stability))
    path.write_text(inputs.metrics[0].read_text().split("\n")[0] + "\n")
    with pytest.raises(ValueError, match=r"metrics.csv: has no rows"):
        fig05_amplitude.draw(Inputs((path,), inputs.stability))


def test_states_of_two_sheets_are_not_one_figure(made_up, tmp_path):
    paths = tuple(
        made_up(material=name, aspect=aspect).write_state(tmp_path, 0.1)
        for name, aspect in (("a", 2.0), ("b", 3.0))
    )
    with pytest.raises(ValueError, match="states: must be of one sheet"):
        fig04_profiles.draw(Inputs(states=paths))


def test_amplitudes_are_the_computed_ones_with_a_gap_and_zeros_at_birth_and_decay(inputs):
    (axes,) = fig05_amplitude.draw(inputs).axes
    (label,) = series_labels(inputs.series)
    strain, amplitude = series_points(axes, label)
    assert list(strain) == WRINKLED
    assert amplitude == pytest.approx(100.0 * (strain - BIRTH) * (DECAY - strain))
    assert list(series_points(axes, "birth, decay")[0]) == [BIRTH, DECAY]
    assert list(series_points(axes, "birth, decay")[1]) == [0.0, 0.0]
    assert list(series_points(axes, "flat")[0]) == FLAT
    assert list(series_points(axes, "not converged")[0]) == [HOLE]
    assert axes.get_xlim()[1] > max(*STRAINS, DECAY)
    line = axes.lines[0]
    assert list(line.get_xdata()) == sorted([*STRAINS, BIRTH, DECAY])
    assert np.isnan(line.get_ydata()[line.get_xdata() == HOLE]).all()
    assert np.isfinite(line.get_ydata()[line.get_xdata() != HOLE]).all()


def test_the_wavelength_is_drawn_beside_the_closed_form(inputs):
    (axes,) = fig05_wavelength.draw(inputs).axes
    strain, wavelength = series_points(axes, series_labels(inputs.series)[0])
    assert list(strain) == WRINKLED
    assert wavelength == pytest.approx(0.14 - 0.1 * strain)
    (line,) = (one for one in axes.lines if "lambda" in str(one.get_label()))
    closed = 0.8 * np.sqrt(2.0 * np.pi * 2.0 * 1e-3) / (2.25 * line.get_xdata()) ** 0.25
    assert line.get_ydata() == pytest.approx(closed)


def test_the_width_of_flat_and_wrinkled_states_is_drawn(inputs):
    (axes,) = fig07_width.draw(inputs).axes
    label = series_labels(inputs.series)[0]
    both = [*series_points(axes, label)[0], *series_points(axes, "flat")[0]]
    assert sorted(both) == [strain for strain in STRAINS if strain != HOLE]
    strain, width = series_points(axes, "flat")
    assert width == pytest.approx((1.0 + strain) ** -0.5)


def test_the_confinement_vanishes_outside_and_has_an_inset_with_nu_eps(inputs):
    (axes,) = fig07_confinement.draw(inputs).axes
    (inset,) = axes.child_axes
    assert inset.get_yscale() == "log"
    line = inset.lines[0]
    assert line.get_ydata() == pytest.approx(0.5 * line.get_xdata())
    flat = series_points(axes, "flat")
    assert list(flat[1]) == [0.0, 0.0]
    assert list(inset.lines[1].get_xdata()) == WRINKLED


def test_slaving_points_lie_on_the_lines_of_their_constants(inputs):
    """Every point is at A/t over Phi lambda/t = C of its row; the arrows follow the strain."""
    figure = fig07_slaving.draw(inputs)
    (axes,) = figure.axes
    marked = [line for line in axes.lines if line.get_marker() == "o" and len(line.get_xdata())]
    for line, constant in zip(marked, (0.7, 0.35), strict=True):
        ratio = line.get_ydata() / line.get_xdata()
        expected = [constant if strain in WRINKLED else np.nan for strain in STRAINS]
        assert ratio == pytest.approx(expected, nan_ok=True)
    for name, constant in (("$C = 1$", 1.0), (r"$C = 1/\pi$", theory.SINUSOID_CONSTANT)):
        x, y = series_points(axes, name)
        assert y == pytest.approx(constant * x)
    arrows = [child for child in axes.texts if isinstance(child, Annotation)]
    rises = [arrow.xy[1] - arrow.xyann[1] for arrow in arrows]
    assert [rise > 0.0 for rise in rises] == [True, False, True, False]
    assert "1 not converged" in labels(figure)


def test_a_profile_is_drawn_for_every_state_that_converged(inputs):
    (axes,) = fig04_profiles.draw(inputs).axes
    curves = [line for line in axes.lines if len(line.get_xdata()) > 10]
    heights = [float(np.mean(line.get_ydata())) for line in curves]
    assert heights == pytest.approx([strain for strain in STRAINS if strain != HOLE])
    words = [text.get_position()[1] for text in axes.texts if text.get_text() == "not converged"]
    assert words == [HOLE]
    ends = [line.get_xdata()[-1] for line in curves]
    assert ends == pytest.approx([0.5 * (1.0 + eps) ** -0.5 for eps in STRAINS if eps != HOLE])


def test_the_scale_bar_of_the_profiles_is_to_scale(inputs):
    (axes,) = fig04_profiles.draw(inputs).axes
    bar = next(line for line in axes.lines if len(line.get_xdata()) == 2)
    count = next(text.get_text() for text in axes.texts if text.get_text().endswith("t$"))
    drawn = np.ptp(bar.get_ydata()) / int(count.strip("$\\,t")) / 1e-3
    curve = axes.lines[STRAINS.index(0.12)].get_ydata() - 0.12
    state = inputs.loaded_states()[STRAINS.index(0.12)]
    assert curve / drawn == pytest.approx(state.profile().z)


def test_the_sheet_from_above_has_its_true_lengths(inputs):
    (axes,) = fig02_sheet.draw(inputs).axes
    texts = [text.get_text() for text in axes.texts]
    assert [f"$\\varepsilon = {eps:g}$" in texts for eps in (0, *STRAINS)] == [True] * (
        1 + len(STRAINS)
    )
    assert "not converged" in texts
    spans = [np.ptp(mesh.get_coordinates()[..., 1]) for mesh in axes.collections]
    assert spans == pytest.approx([2.0, *(2.0 * (1.0 + eps) for eps in STRAINS if eps != HOLE)])


def test_the_light_comes_from_the_side():
    """Flat is grey; a slope that faces the light is brighter, one that turns away darker."""
    slope = np.array([0.0, 0.15, -0.15])
    normal = np.stack([0.0 * slope, -slope, np.ones(3)]) / np.sqrt(1.0 + slope**2)
    flat, toward, away = fig02_sheet.brightness(normal)
    assert flat == pytest.approx(fig02_sheet.FLAT_GREY)
    assert away < flat < toward < 1.0


def test_the_colour_bar_of_the_surface_is_that_of_the_paper(inputs):
    figure = fig03_surface.draw(Inputs(states=inputs.states[1:4]))
    *panels, bar = figure.axes
    assert bar.get_ylim() == pytest.approx((-3.5, 3.5))
    assert bar.get_ylabel() == "$10^3\\,z/W$"
    assert [axes.get_title(loc="left")[-6:] for axes in panels] == [" 0.06$", "= 0.1$", " 0.12$"]


def test_the_far_side_of_the_surface_is_painted_first(inputs):
    """Seen from above, what is farther is higher in the picture; cells are painted row by row."""
    figure = fig03_surface.draw(Inputs(states=inputs.states[:1]))
    height = figure.axes[0].collections[0].get_coordinates()[..., 1]
    assert (np.diff(height, axis=0) < 0.0).all()
    assert (np.diff(height, axis=1) < 0.0).all()


def test_stress_is_normalised_by_the_stated_modulus_and_both_are_printed(materials):
    figure = fig01_stress.draw(materials)
    paper, rubber = figure.axes
    strain, stress = series_points(paper, "Mooney\N{EN DASH}Rivlin, fit")
    stretch = 1.0 + strain
    expected = 2.0 * (stretch - stretch**-2) * (6.21e-2 + 1.58e-1 / stretch)
    assert stress == pytest.approx(expected, abs=1e-6)
    printed = "".join(text.get_text() for text in paper.texts)
    assert "Y = 1$ MPa" in printed
    assert "1.32$ MPa" in printed
    assert rubber.get_ylabel() == "$T$ (MPa)"
    assert {"treloar1944, uniaxial", "treloar1944, equibiaxial", "treloar1944, pure shear"} < {
        line.get_label() for line in rubber.lines
    }
    curves = [line for line in rubber.lines if len(line.get_xdata()) == 200]
    assert len(curves) == 2 * 3


def test_the_curve_of_a_fit_goes_through_the_points_that_it_is_of(tmp_path):
    """Loading and unloading of one file, both without their preload, are two panels."""
    stretch = np.linspace(1.0, 1.5, 11)
    pull = 2e5 * (stretch - stretch**-2)
    rows = [*zip(stretch, pull, strict=True), *zip(stretch[::-1], 0.7 * pull[::-1], strict=True)]
    data = tmp_path / "cyclic.csv"
    text = "".join(f"{lam},{1e4 + value}\n" for lam, value in rows)
    data.write_text("stretch,stress_pa\n" + text)
    files = []
    for branch in ("loading", "unloading"):
        files.append(tmp_path / f"{branch}.json")
        options = {"branch": branch, "preload": "remove"}
        material.run("neo-hookean", branch, files[-1], csv=data, **options)
    figure = fig01_stress.draw(Inputs(materials=tuple(files), data=(data,)))
    assert len(figure.axes) == 2
    for axes, part in zip(figure.axes, (1.0, 0.7), strict=True):
        points, curve = (line.get_xydata() for line in axes.lines[:2])
        assert len(points) == 11
        top = points[np.argmax(points[:, 0])]
        assert top == pytest.approx([0.5, part * pull[-1] / 1e6], rel=1e-6)
        assert curve[-1] == pytest.approx(top, rel=1e-6)


def test_svk_of_the_initial_slope_is_told_from_that_with_the_stated_modulus(materials):
    paper = fig01_stress.draw(materials).axes[0]
    names = [line.get_label() for line in paper.lines]
    svk = [name for name in names if "SVK" in name or "Kirchhoff" in name]
    assert svk == [
        "Saint Venant\N{EN DASH}Kirchhoff, initial slope",
        "SVK, $Y$ as stated",
    ]
    looks = {(line.get_color(), line.get_linestyle()) for line in paper.lines}
    assert len(looks) == len(names)
    fit, stated = (series_points(paper, name)[1] for name in svk)
    assert fit[1:] / stated[1:] == pytest.approx(np.full(199, 1.3206), rel=1e-3)


@pytest.mark.parametrize("module", [fig02_sheet, fig03_surface, fig04_profiles])
def test_figures_of_states_name_law_and_sheet_of_the_data(module, made_up, tmp_path):
    sheet = made_up(law="svk", aspect=2.5, thickness=7e-4)
    figure = module.draw(Inputs(states=(sheet.write_state(tmp_path, 0.1),)))
    texts = [text.get_text() for axes in figure.axes for text in axes.texts]
    texts.append(figure.get_suptitle())
    note = next(text for text in texts if "L/W" in text)
    assert style.law_label("svk") in note
    assert r"$L/W = 2.5$, $t/W = 7 \times 10^{-4}$" in note


@pytest.mark.parametrize(
    ("value", "text"), [(1e-3, "10^{-3}"), (7e-4, r"7 \times 10^{-4}"), (2.0, "2"), (0.05, "0.05")]
)
def test_numbers_of_a_sheet(value, text):
    assert number(value) == text
