"""Measured data lies over a figure where it is given, and leaves no trace where it is not."""

import numpy as np
import pytest
from matplotlib.collections import PolyCollection

from wrinklestudy.stages.figures import run as draw_figure
from wrinklestudy.studies.panaitescu2019 import CATALOGUE
from wrinklestudy.studies.panaitescu2019.figures import (
    fig01_stress,
    fig04_profiles,
    fig05_amplitude,
    fig05_wavelength,
    fig06_aspect,
    fig06_thickness,
    fig07_collapse,
    fig07_confinement,
    fig07_slaving,
)
from wrinklestudy.study.figures.inputs import Inputs

MODULES = {
    "fig01_stress": fig01_stress,
    "fig04_profiles": fig04_profiles,
    "fig05_amplitude": fig05_amplitude,
    "fig05_wavelength": fig05_wavelength,
    "fig06_aspect": fig06_aspect,
    "fig06_thickness": fig06_thickness,
    "fig07_confinement": fig07_confinement,
    "fig07_slaving": fig07_slaving,
    "fig07_collapse": fig07_collapse,
}


@pytest.fixture
def both(inputs, materials, experiment):
    """Make inputs with the measured data of some kinds."""

    def make(*names):
        shown = tuple(path for path in experiment if not names or path.stem in names)
        return Inputs(
            inputs.metrics,
            inputs.stability,
            materials.materials,
            inputs.states,
            materials.data,
            shown,
        )

    return make


def marks(axes):
    """Measured points and their bars: x, y and the ends of the bars along y."""
    found = []
    for container in axes.containers:
        line, _, bars = container.lines
        ends = [one[:, 1] for one in bars[-1].get_segments() if len(one)]  # none without an error
        found.append((line.get_xdata(), line.get_ydata(), ends))
    return found


def texts(figure):
    legends = [*figure.legends, *(axes.get_legend() for axes in figure.axes)]
    entries = [text for one in legends if one is not None for text in one.get_texts()]
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    return " ".join([*(text.get_text() for text in entries), *titles])


def test_every_figure_that_shows_measured_data_is_here():
    shown = {entry.name for entry in CATALOGUE.figures if entry.measured}
    assert set(MODULES) == {name for name in shown if not name.endswith("_page")}  # made of these


@pytest.mark.parametrize("name", MODULES)
def test_without_files_nothing_is_said_of_measurements(name, inputs, materials):
    computed = Inputs(
        inputs.metrics, inputs.stability, materials.materials, inputs.states, materials.data
    )
    figure = MODULES[name].draw(computed)
    assert "measured" not in texts(figure)
    assert not any(axes.containers for axes in figure.axes)
    expected = 2 if name in ("fig01_stress", "fig06_aspect", "fig06_thickness") else 1
    assert len(figure.axes) == expected


@pytest.mark.parametrize("name", [name for name in MODULES if name != "fig01_stress"])
def test_data_of_another_sheet_changes_nothing(name, made_up, inputs_with, both):
    options = {"states": (0.1, 0.2)} if name == "fig04_profiles" else {}
    other = inputs_with(
        made_up(aspect=7.0, thickness=3e-4), experiment=both().experiment, **options
    )
    figure = MODULES[name].draw(other)
    assert "measured" not in texts(figure)
    assert not any(axes.containers for axes in figure.axes)


@pytest.mark.parametrize("name", ["fig04_profiles", "fig05_amplitude"])
def test_two_runs_with_measurements_give_the_same_bytes(name, both, tmp_path):
    given = both()
    outputs = [tmp_path / "first.pdf", tmp_path / "second.pdf"]
    for output in outputs:
        draw_figure(
            CATALOGUE.name,
            name,
            output=output,
            metrics=given.metrics,
            stability=given.stability,
            states=given.states,
            experiment=given.experiment,
        )
    assert outputs[0].read_bytes() == outputs[1].read_bytes()


def test_amplitudes_are_drawn_with_band_and_bars_of_their_error(both):
    figure = fig05_amplitude.draw(both("amplitude"))
    (axes,) = figure.axes
    ((strain, amplitude, bars),) = marks(axes)
    assert list(strain) == [0.1, 0.3, 0.55]
    assert list(amplitude) == [2.5, 4.5, 0.0]
    assert np.array(bars) == pytest.approx(np.array([[2.3, 2.7], [4.2, 4.8], [-0.1, 0.1]]))
    (band,) = (one for one in axes.collections if isinstance(one, PolyCollection))
    low, high = band.get_paths()[0].get_extents().get_points()
    assert (low, high) == (pytest.approx([0.1, -0.1]), pytest.approx([0.55, 4.8]))
    assert axes.get_ylim()[1] > 4.8
    assert axes.get_xlim()[1] > 0.55
    assert "measured" in texts(figure)


def test_scans_count_as_measured_amplitudes_and_wavelengths(both):
    given = both("0.1", "0.2", "wavelength")
    ((strain, amplitude, _),) = marks(fig05_amplitude.draw(given).axes[0])
    assert list(strain) == [0.1, 0.2]
    assert amplitude == pytest.approx(np.full(2, 2.5), rel=0.01)
    ((strain, wavelength, _),) = marks(fig05_wavelength.draw(given).axes[0])
    assert sorted(strain) == [0.1, 0.1, 0.2]
    assert sorted(wavelength)[:2] == pytest.approx(np.full(2, 17.0 / 140.0), rel=0.01)
    assert max(wavelength) == 0.15


def test_the_largest_measured_amplitude_of_each_sheet_is_drawn(both):
    """Of the file: L/W = 2 and 3 at t/W = 1e-3, and t/W = 7e-4 at L/W = 2, without an error."""
    ((aspect, amplitude, bars),) = marks(fig06_aspect.draw(both("amplitude")).axes[0])
    assert list(zip(aspect, amplitude, strict=True)) == [(2.0, 4.5), (3.0, 1.5)]
    assert np.array(bars) == pytest.approx(np.array([[4.2, 4.8], [1.3, 1.7]]))
    figure = fig06_thickness.draw(both("amplitude"))
    ((ratio, amplitude, _),) = marks(figure.axes[0])
    order = np.argsort(ratio)
    assert ratio[order] == pytest.approx([1000.0, 1.0 / 7e-4])
    assert list(amplitude[order]) == [4.5, 5.0]
    assert figure.axes[0].get_ylim()[1] > 5.0


def test_measured_stress_is_normalised_as_the_panel(both):
    figure = fig01_stress.draw(both("stress"))
    ((strain, stress, bars),) = marks(figure.axes[0])
    assert list(strain) == [0.1, 0.6]
    assert stress == pytest.approx([0.11, 0.4])
    assert bars[0] == pytest.approx([0.105, 0.115])
    assert figure.axes[0].get_xlim()[1] > 0.6
    assert not marks(figure.axes[1])


def test_scanned_profiles_stand_beside_the_computed_on_one_scale(both):
    figure = fig04_profiles.draw(both())
    scanned, computed = figure.axes
    assert [axes.get_title(loc="left") for axes in figure.axes] == ["(a) measured", "(b) computed"]
    heights = [line.get_ydata().mean() for line in scanned.lines]
    # each about its strain: an odd wave on a line that noise of a hundredth has moved a little
    assert heights == pytest.approx([0.1, 0.2], abs=2e-4)
    assert scanned.get_ylim() == computed.get_ylim()
    ends = [line.get_xdata()[[0, -1]] for line in scanned.lines]
    halves = [0.5 * (1.0 + strain) ** -0.5 for strain in (0.1, 0.2)]
    assert np.array(ends) == pytest.approx(np.outer(halves, [-1.0, 1.0]), abs=1e-6)
    bar = next(line for line in computed.lines if len(line.get_xdata()) == 2)
    count = next(text.get_text() for text in computed.texts if text.get_text().endswith("t$"))
    thickness = np.ptp(bar.get_ydata()) / int(count.strip("$\\,t"))
    assert np.ptp(scanned.lines[0].get_ydata()) / thickness == pytest.approx(5.0, rel=0.02)


def test_measured_confinement_and_slaving_follow_from_the_scans(both):
    given = both()
    scans = given.scans
    ((strain, confinement, _),) = marks(fig07_confinement.draw(given).axes[0])
    assert list(strain) == [0.1, 0.2]
    assert confinement == pytest.approx([1e3 * one.measures.phi_squared for one in scans])
    full, central = marks(fig07_slaving.draw(given).axes[0])
    for (x, y, _), name in ((full, "shape_constant"), (central, "shape_constant_central")):
        assert y / x == pytest.approx([getattr(one.measures, name) for one in scans])
    ((x, y, _), _) = marks(fig07_collapse.draw(given).axes[0])
    assert len(x) == 1  # 0.2 alone is beyond 0.15
    # a wave of full width in the middle of the sheet: C of a sinusoid over the central wrinkle
    assert central[1] / central[0] == pytest.approx(np.full(2, 1.0 / np.pi), rel=0.02)


def test_an_unknown_file_is_refused_in_one_line(inputs, tmp_path):
    given = Inputs(inputs.metrics, inputs.stability, experiment=(tmp_path / "amplitudes.csv",))
    with pytest.raises(ValueError, match=r"amplitudes.csv: unknown measured data; allowed are"):
        fig05_amplitude.draw(given)
