"""Figures show what tables and states hold, no more; the same inputs give the same bytes."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Annotation

from wrinklestudy import figures, metrics, theory
from wrinklestudy.figures import (
    fig01_stress,
    fig02_sheet,
    fig03c_surface,
    fig04b_profiles,
    fig05a_amplitude,
    fig05b_wavelength,
    fig07a_width,
    fig07b_confinement,
    fig07c_slaving,
    style,
)
from wrinklestudy.figures.inputs import Inputs, power_of_ten
from wrinklestudy.material import fit
from wrinklestudy.store import write_h5, write_json

DATA = Path(__file__).parents[2] / "data"
GRID_X, GRID_Y = np.linspace(0.0, 1.0, 7), np.linspace(0.0, 0.5, 21)
STRAINS = (0.02, 0.06, 0.1, 0.12, 0.2, 0.32, 0.36, 0.46)
WRINKLED = [0.06, 0.1, 0.12, 0.32, 0.36]
HOLE = 0.2
BIRTH, DECAY = 0.03, 0.4


def position(strain, amplitude):
    """A stretched sheet with z = A sin(k Y) exp(-(Y/0.2)^2) cos^2(pi X / 2)."""
    k = 2.0 * np.pi / (0.14 - 0.1 * strain)
    f, df = np.cos(0.5 * np.pi * GRID_X) ** 2, -0.5 * np.pi * np.sin(np.pi * GRID_X)
    packet = np.exp(-((GRID_Y / 0.2) ** 2))
    g = np.sin(k * GRID_Y) * packet
    dg = (k * np.cos(k * GRID_Y) - 50.0 * GRID_Y * np.sin(k * GRID_Y)) * packet
    field = np.zeros((3, 4, 7, 21))
    field[0, 0], field[0, 1] = (1.0 + strain) * GRID_X[:, None], 1.0 + strain
    narrow = (1.0 + strain) ** -0.5
    field[1, 0], field[1, 2] = narrow * GRID_Y, narrow
    field[2] = amplitude * np.stack([np.outer(a, b) for b in (g, dg) for a in (f, df)])
    return field


def write_state(path, strain, law="mooney-rivlin", scale=1.0):
    wrinkled = BIRTH < strain < DECAY
    status = "not-converged" if strain == HOLE else "wrinkled" if wrinkled else "flat"
    amplitude = scale * 0.1 * (strain - BIRTH) * (DECAY - strain) if wrinkled else 0.0
    datasets = {"grid/x": GRID_X, "grid/y": GRID_Y, "position": position(strain, amplitude)}
    numbers = {name: 1.0 for name, text in metrics.COLUMNS.items() if "(" in text}
    case = {"material": f"latex-{law}", "law": law, "bending": "thinning"}
    sheet = {"parity": "antisymmetric", "aspect": 2.0, "thickness": 1e-3, "strain": strain}
    counts = dict.fromkeys(("newton_iterations", "cells_along", "cells_across"), 5)
    counts |= {"unstable_directions": 0, "residual": 0.0, "critical_thickness": 1e-3}
    counts |= {"planar_width_over_width": (1.0 + strain) ** -0.5}
    write_h5(path, datasets, numbers | case | sheet | counts | {"status": status, "reason": ""})
    return path


def write_study(folder, laws):
    """Tables of one sheet for each law, amplitudes falling from law to law."""
    states, sheets = [], []
    for k, law in enumerate(laws):
        for strain in STRAINS:
            states.append(write_state(folder / f"{law}{strain}.h5", strain, law, 1.0 - 0.2 * k))
        sheet = {"material": f"latex-{law}", "law": law, "bending": "thinning", "aspect": 2.0}
        sheet |= {"parity": "antisymmetric", "thickness": 1e-3, "critical_thickness": []}
        limits = {"birth_strain": BIRTH, "decay_strain": DECAY}
        limits |= {"max_critical_thickness": 1.5e-3, "strain_at_max": 0.1}
        sheets.append(folder / f"{law}.json")
        write_json(sheets[-1], sheet | limits)
    tables = folder / "metrics.csv", folder / "stability.csv"
    metrics.run(states, sheets, *tables)
    return Inputs(*tables, states=tuple(states[: len(STRAINS)]))


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    return write_study(tmp_path_factory.mktemp("study"), ["mooney-rivlin"])


@pytest.fixture(scope="module")
def three_laws(tmp_path_factory):
    return write_study(tmp_path_factory.mktemp("laws"), ["mooney-rivlin", "neo-hookean", "svk"])


@pytest.fixture(scope="module")
def materials(tmp_path_factory):
    folder = tmp_path_factory.mktemp("materials")
    latex, rubber = DATA / "latex_panaitescu2019.csv", DATA / "treloar1944.csv"
    fit.run(latex, "mooney-rivlin", "latex", None, None, folder / "latex.json")
    fit.run(rubber, "mooney-rivlin", "uni", (1, 1.65), ["uniaxial"], folder / "uni.json")
    fit.run(rubber, "mooney-rivlin", "all", (1, 1.65), None, folder / "all.json")
    paths = tuple(folder / f"{name}.json" for name in ("latex", "uni", "all"))
    return Inputs(Path(), Path(), materials=paths, data=(latex, rubber))


def run(name, inputs, materials, output):
    shown = figures.state_strains(name, STRAINS)
    states = [path for path, eps in zip(inputs.states, STRAINS, strict=True) if eps in shown]
    figures.run(
        name,
        inputs.metrics,
        inputs.stability,
        materials.materials,
        states,
        output,
        data=materials.data,
    )


def series_points(axes, label):
    """Coordinates of the marked points of a series."""
    (line,) = (line for line in axes.lines if line.get_label() == label)
    return np.asarray(line.get_xdata()), np.asarray(line.get_ydata())


def labels(figure):
    return [text.get_text() for text in figure.legends[0].get_texts()]


@pytest.mark.parametrize("name", figures.FIGURES)
def test_two_runs_give_the_same_bytes(name, inputs, materials, tmp_path):
    suffixes = (".pdf", ".png", ".svg") if name == "fig07c_slaving" else (".pdf",)
    first = [tmp_path / f"first{suffix}" for suffix in suffixes]
    second = [tmp_path / f"second{suffix}" for suffix in suffixes]
    run(name, inputs, materials, first)
    run(name, inputs, materials, second)
    assert [path.read_bytes() for path in first] == [path.read_bytes() for path in second]
    assert first[0].read_bytes().startswith(b"%PDF")
    assert sorted(tmp_path.iterdir()) == sorted(first + second)


def test_a_figure_that_cannot_be_drawn_leaves_the_old_file(inputs, tmp_path):
    output = tmp_path / "fig02_sheet.pdf"
    output.write_text("old")
    with pytest.raises(ValueError, match="states: none given"):
        figures.run("fig02_sheet", inputs.metrics, inputs.stability, [], [], output)
    assert output.read_text() == "old"


def test_unknown_names_and_formats_are_refused_before_drawing(tmp_path):
    with pytest.raises(ValueError, match=r"figure 'fig9': must be one of fig01_stress, "):
        figures.run("fig9", "m.csv", "s.csv", [], [], tmp_path / "a.pdf")
    with pytest.raises(ValueError, match=r"a.jpg: a figure must end in one of .pdf, .png, .svg"):
        figures.run("fig01_stress", "m.csv", "s.csv", [], [], tmp_path / "a.jpg")


def test_a_table_without_a_column_is_named(inputs, tmp_path):
    path = tmp_path / "metrics.csv"
    path.write_text("material,law\nlatex,svk\n")
    with pytest.raises(ValueError, match=r"metrics.csv: column 'bending' is missing"):
        fig05a_amplitude.draw(Inputs(path, inputs.stability))


def test_the_states_of_a_figure_are_the_nearest_of_the_study():
    assert figures.state_strains("fig02_sheet", [0.5, 0.1, 0.22, 0.3]) == [0.1, 0.22, 0.3, 0.5]
    assert figures.state_strains("fig02_sheet", [0.1]) == [0.1]
    assert figures.state_strains("fig04b_profiles", [0.3, 0.1]) == [0.1, 0.3]
    assert figures.state_strains("fig05a_amplitude", [0.3, 0.1]) == []


def test_importing_the_package_loads_no_plotting():
    code = "import sys, wrinklestudy.figures; print(*sys.modules)"
    command = [sys.executable, "-c", code]
    loaded = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    assert not {"matplotlib", "numpy", "pandas"} & set(loaded)


def test_amplitudes_are_the_computed_ones_with_a_gap_and_zeros_at_birth_and_decay(inputs):
    (axes,) = fig05a_amplitude.draw(inputs).axes
    (series,) = inputs.sheet_series()
    strain, amplitude = series_points(axes, series.label)
    assert list(strain) == WRINKLED
    # from the table, whose measure sees the envelope take a little off A
    assert amplitude == pytest.approx(100.0 * (strain - BIRTH) * (DECAY - strain), rel=0.1)
    assert list(series_points(axes, "birth, decay")[0]) == [BIRTH, DECAY]
    assert list(series_points(axes, "birth, decay")[1]) == [0.0, 0.0]
    assert list(series_points(axes, "flat")[0]) == [0.02, 0.46]
    assert list(series_points(axes, "not converged")[0]) == [HOLE]
    assert axes.get_xlim()[1] > max(*STRAINS, DECAY)
    line = axes.lines[0]
    assert list(line.get_xdata()) == sorted([*STRAINS, BIRTH, DECAY])
    assert np.isnan(line.get_ydata()[line.get_xdata() == HOLE]).all()
    assert np.isfinite(line.get_ydata()[line.get_xdata() != HOLE]).all()


def test_each_law_is_a_series_with_a_look_of_its_own(three_laws):
    figure = fig05a_amplitude.draw(three_laws)
    assert labels(figure)[:3] == list(style.LAW_NAMES.values())
    looks = [style.looks([law])[0] for law in style.LAW_NAMES]
    for attribute in ("color", "marker", "line"):
        assert len({getattr(look, attribute) for look in looks}) == 3
    (axes,) = figure.axes
    peaks = [series_points(axes, name)[1].max() for name in style.LAW_NAMES.values()]
    assert peaks == pytest.approx([peaks[0], 0.8 * peaks[0], 0.6 * peaks[0]])


def test_a_label_occurs_once_in_a_legend(three_laws):
    for module in (fig05a_amplitude, fig05b_wavelength, fig07a_width, fig07c_slaving):
        names = labels(module.draw(three_laws))
        assert len(names) == len(set(names))


def test_the_wavelength_is_drawn_beside_the_closed_form(inputs):
    (axes,) = fig05b_wavelength.draw(inputs).axes
    strain, wavelength = series_points(axes, inputs.sheet_series()[0].label)
    assert list(strain) == WRINKLED
    narrow = (0.14 - 0.1 * strain) * (1.0 + strain) ** -0.5
    assert wavelength == pytest.approx(narrow, rel=0.06)
    (line,) = (one for one in axes.lines if "lambda" in str(one.get_label()))
    closed = 0.8 * np.sqrt(2.0 * np.pi * 2.0 * 1e-3) / (2.25 * line.get_xdata()) ** 0.25
    assert line.get_ydata() == pytest.approx(closed)


def test_the_width_of_flat_and_wrinkled_states_is_drawn(inputs):
    (axes,) = fig07a_width.draw(inputs).axes
    label = inputs.sheet_series()[0].label
    both = [*series_points(axes, label)[0], *series_points(axes, "flat")[0]]
    assert sorted(both) == [strain for strain in STRAINS if strain != HOLE]
    strain, width = series_points(axes, "flat")
    assert width == pytest.approx((1.0 + strain) ** -0.5)


def test_the_confinement_vanishes_outside_and_has_an_inset_with_nu_eps(inputs):
    (axes,) = fig07b_confinement.draw(inputs).axes
    (inset,) = axes.child_axes
    assert inset.get_yscale() == "log"
    line = inset.lines[0]
    assert line.get_ydata() == pytest.approx(0.5 * line.get_xdata())
    flat = series_points(axes, "flat")
    assert list(flat[1]) == [0.0, 0.0]
    assert list(inset.lines[1].get_xdata()) == WRINKLED


def test_slaving_points_lie_on_the_lines_of_their_constants(inputs):
    """Every point is at A/t over Phi lambda/t = C of its row; the arrows follow the strain."""
    (axes,) = fig07c_slaving.draw(inputs).axes
    rows = inputs.sheet_series()[0].rows
    marked = [line for line in axes.lines if line.get_marker() == "o" and len(line.get_xdata())]
    for line, column in zip(marked, ("shape_constant", "shape_constant_central"), strict=True):
        ratio = line.get_ydata() / line.get_xdata()
        expected = np.where(rows["status"] == "wrinkled", rows[column], np.nan)
        assert ratio == pytest.approx(expected, nan_ok=True)
    for name, constant in (("$C = 1$", 1.0), (r"$C = 1/\pi$", theory.SINUSOID_CONSTANT)):
        x, y = series_points(axes, name)
        assert y == pytest.approx(constant * x)
    arrows = [child for child in axes.texts if isinstance(child, Annotation)]
    rises = [arrow.xy[1] - arrow.xyann[1] for arrow in arrows]
    assert [rise > 0.0 for rise in rises] == [True, False, True, False]


def test_a_profile_is_drawn_for_every_state_that_converged(inputs):
    (axes,) = fig04b_profiles.draw(inputs).axes
    curves = [line for line in axes.lines if len(line.get_xdata()) > 10]
    heights = [float(np.mean(line.get_ydata())) for line in curves]
    assert heights == pytest.approx([strain for strain in STRAINS if strain != HOLE])
    words = [text.get_position()[1] for text in axes.texts if text.get_text() == "not converged"]
    assert words == [HOLE]
    ends = [line.get_xdata()[-1] for line in curves]
    assert ends == pytest.approx([0.5 * (1.0 + eps) ** -0.5 for eps in STRAINS if eps != HOLE])


def test_the_scale_bar_of_the_profiles_is_to_scale(inputs):
    (axes,) = fig04b_profiles.draw(inputs).axes
    bar = next(line for line in axes.lines if len(line.get_xdata()) == 2)
    count = next(text.get_text() for text in axes.texts if text.get_text().endswith("t$"))
    largest = axes.lines[STRAINS.index(0.12)].get_ydata() - 0.12
    drawn = np.ptp(bar.get_ydata()) / int(count.strip("$\\,t")) / 1e-3
    table = inputs.sheet_series()[0].rows.set_index("strain")["amplitude_over_thickness"]
    assert np.abs(largest).max() / drawn == pytest.approx(1e-3 * table[0.12], rel=0.01)


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
    figure = fig03c_surface.draw(Inputs(Path(), Path(), states=inputs.states[1:4]))
    *panels, bar = figure.axes
    assert bar.get_ylim() == pytest.approx((-3.5, 3.5))
    assert bar.get_ylabel() == "$10^3\\,z/W$"
    assert [axes.get_title(loc="left")[-6:] for axes in panels] == [" 0.06$", "= 0.1$", " 0.12$"]


def test_the_far_side_of_the_surface_is_painted_first(inputs):
    """Seen from above, what is farther is higher in the picture; cells are painted row by row."""
    figure = fig03c_surface.draw(Inputs(Path(), Path(), states=inputs.states[:1]))
    height = figure.axes[0].collections[0].get_coordinates()[..., 1]
    assert (np.diff(height, axis=0) < 0.0).all()
    assert (np.diff(height, axis=1) < 0.0).all()


def test_stress_is_normalised_by_the_stated_modulus_and_both_are_printed(materials):
    figure = fig01_stress.draw(materials)
    paper, rubber = figure.axes
    strain, stress = series_points(paper, "Mooney\N{EN DASH}Rivlin, fit")
    expected = theory.uniaxial_mooney_rivlin(strain, 6.21e-2, 1.58e-1)
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


@pytest.mark.parametrize(
    ("value", "text"), [(1e-3, "10^{-3}"), (7e-4, r"7 \times 10^{-4}"), (2.0, r"2 \times 10^{0}")]
)
def test_powers_of_ten(value, text):
    assert power_of_ten(value) == text
