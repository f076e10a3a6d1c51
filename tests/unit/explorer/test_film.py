"""A film: a frame for each state that has a shape, with its strain, on one scale."""

import shutil

import numpy as np
import pytest
from PIL import Image

from wrinklestudy.explorer import film
from wrinklestudy.results.vtu import IN_WIDTHS
from wrinklestudy.study.figures.one_sheet import PicturedSheet

PICTURED = PicturedSheet(2.0, 1e-3, "mooney-rivlin", IN_WIDTHS)


@pytest.fixture
def frames(monkeypatch, tmp_path, content):
    """What the axes hold in each frame of a film, and the film."""
    seen = []
    draw = film._draw

    def recorded(drawn, pictured, states, row, shape):
        draw(drawn, pictured, states, row, shape)
        profile, mark = drawn.profile.lines[1], drawn.amplitude.lines[1]
        limits = [
            limit
            for axes in (drawn.sheet, drawn.profile, drawn.amplitude)
            for limit in (*axes.get_xlim(), *axes.get_ylim())
        ]
        seen.append(
            {
                "title": drawn.sheet.get_title(),
                "height": float(np.abs(profile.get_ydata()).max()),
                "mark": (mark.get_xdata()[0], mark.get_ydata()[0]),
                "limits": limits,
            }
        )

    monkeypatch.setattr(film, "_draw", recorded)
    shown = content.sheets[0]
    film.write_film(PICTURED, shown.sheet, shown.shapes, tmp_path / "film.gif")
    return seen, Image.open(tmp_path / "film.gif")


def test_each_converged_state_is_a_frame_with_its_strain_and_values(frames, content):
    seen, picture = frames
    shown = content.sheets[0]
    known = [row for row in shown.sheet.states if row.status != "not-converged"]
    assert picture.n_frames == len(seen) == len(known)
    for row, frame in zip(known, seen, strict=True):
        assert f"\\varepsilon = {row.strain:.3f}$" in frame["title"]
        assert frame["mark"] == (row.strain, row.amplitude_over_thickness)
        assert (frame["height"] > 0.1) == (row.status == "wrinkled")
        assert ("flat" in frame["title"]) == (row.status == "flat")
        assert ("drawn $\\times" in frame["title"]) == (row.status == "wrinkled")


def test_all_frames_have_one_scale(frames):
    seen, _ = frames
    for frame in seen[1:]:
        assert frame["limits"] == pytest.approx(seen[0]["limits"])


def test_mp4_without_ffmpeg_is_refused_before_anything_is_drawn(monkeypatch, tmp_path):
    monkeypatch.setattr(shutil, "which", lambda _: None)
    with pytest.raises(ValueError, match="MP4 needs ffmpeg, which is not installed"):
        film.check_writer(tmp_path / "film.mp4")
    film.check_writer(tmp_path / "film.gif")


def test_without_any_shape_there_is_no_film(tmp_path, content):
    shown = content.sheets[0]
    with pytest.raises(ValueError, match="no state converged"):
        film.write_film(PICTURED, shown.sheet, [None] * len(shown.shapes), tmp_path / "film.gif")
    assert list(tmp_path.iterdir()) == []
