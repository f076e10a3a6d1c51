"""The reader of measured stress-strain files, and the files that come with the project."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.material.data import Measurement, read
from wrinklestudy.material.homogeneous import MODES

DATA = Path(__file__).parents[3] / "data"


def _read(tmp_path: Path, text: str, encoding: str = "utf-8") -> Measurement:
    path = tmp_path / "sample.csv"
    path.write_text(text, encoding=encoding)
    return read(path)


def test_strain_and_stretch_pascal_and_megapascal_are_the_same_data(tmp_path: Path) -> None:
    first = _read(tmp_path, "stretch,stress_pa,standard_error_pa\n1.25,250000,4000\n")
    second = _read(tmp_path, "standard_error_mpa,strain,stress_mpa\n0.004,0.25,0.25\n")
    assert first.standard_error is not None
    assert second.standard_error is not None
    assert (first.stretch, first.stress) == (second.stretch, second.stress)
    assert first.standard_error == pytest.approx(second.standard_error)
    assert first.mode.tolist() == ["uniaxial"]


def test_header_note_blank_lines_spaces_quotes_and_byte_order_mark(tmp_path: Path) -> None:
    text = '# Latex, batch 7\n#\n# pulled at 1 mm/s\n\n"strain" , stress_pa,mode\n0.1, 1e5 ,shear\n'
    text += ",,\n"
    data = _read(tmp_path, text, encoding="utf-8-sig")
    assert data.note == "Latex, batch 7\n\npulled at 1 mm/s"
    assert data.source == "sample.csv"
    assert data.mode.tolist() == ["shear"]
    assert data.standard_error is None
    np.testing.assert_allclose(data.stretch, 1.1)


rows = st.lists(
    st.tuples(
        st.floats(0.01, 11.0),
        st.floats(-1e9, 1e9),
        st.sampled_from(MODES),
        st.floats(1e-3, 1e9),
    ),
    min_size=1,
    max_size=5,
)


@given(rows)
def test_what_is_written_is_what_is_read(
    tmp_path_factory: pytest.TempPathFactory, table: list[tuple[float, float, str, float]]
) -> None:
    lines = [f"{lam!r},{stress!r},{mode},{error!r}" for lam, stress, mode, error in table]
    text = "\n".join(["stretch,stress_pa,mode,standard_error_pa", *lines])
    data = _read(tmp_path_factory.mktemp("data"), text)
    assert data.standard_error is not None
    found = zip(data.stretch, data.stress, data.mode, data.standard_error, strict=True)
    assert [tuple(row) for row in found] == table


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("", ["is empty"]),
        ("# only a note\n", ["is empty"]),
        ("strain,stress_pa\n", ["no data"]),
        ("strain,stress\n0,0\n", ["line 1", "'stress'", "stress_pa"]),
        ("# note\nstrain,mode\n0,shear\n", ["line 2", "stress_pa or stress_kpa", "is missing"]),
        ("stress_pa\n0\n", ["line 1", "stretch or strain or", "is missing"]),
        ("strain,stretch,stress_pa\n0,1,0\n", ["line 1", "stretch and strain exclude"]),
        ("strain,stress_pa,stress_pa\n0,1,0\n", ["line 1", "'stress_pa' stands twice"]),
        ("strain,stress_pa\n0,0\n0.1\n", ["line 3", "1 cells where 2"]),
        ("strain,stress_pa\n0,0\n\n0.1,\n", ["line 4", "stress_pa", "''", "a number is needed"]),
        ("strain,stress_pa\n0.1,1.0e5 Pa\n", ["line 2", "stress_pa", "'1.0e5 Pa'"]),
        ("strain,stress_pa\n0.1,nan\n", ["line 2", "stress_pa", "'nan'", "a number is needed"]),
        ("strain,stress_pa\n-1,1\n", ["line 2", "strain", ">= -0.99"]),
        ("stretch,stress_pa\n1,0\n1e-300,1\n", ["line 3", "stretch", ">= 0.01"]),
        (
            "stretch,stress_mpa\n1,0\n1.1,1e200\n",
            ["line 3", "stress_mpa", "must be >= -1e+09 and <= 1e+09"],
        ),
        (
            "# width: 1 mm\n# thickness: 1e-5 mm\nstretch,force_n\n1,0\n1.1,1e12\n",
            ["line 5", "force_n", "a stress of 1e+23 Pa"],
        ),
        ("stretch,stress_pa\n0,1\n", ["line 2", "stretch", ">= 0.01"]),
        (
            "stretch,stress_pa,mode\n1,1,planar\n",
            ["line 2", "'planar'", "uniaxial, biaxial, shear"],
        ),
        (
            "stretch,stress_pa,standard_error_pa\n1,1,0\n",
            ["line 2", "standard_error_pa", ">= 1e-6"],
        ),
    ],
)
def test_a_bad_file_gets_one_line_with_file_place_and_remedy(
    tmp_path: Path, text: str, parts: list[str]
) -> None:
    with pytest.raises(ValueError, match=r"sample\.csv") as caught:
        _read(tmp_path, text)
    message = str(caught.value)
    assert "\n" not in message
    assert [part for part in parts if part not in message] == []


def test_files_that_are_no_text_or_not_there(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"absent\.csv: cannot be read"):
        read(tmp_path / "absent.csv")
    (tmp_path / "image.csv").write_bytes(b"\x89PNG\xff\xfe")
    with pytest.raises(ValueError, match=r"image\.csv, line 1: is not UTF-8"):
        read(tmp_path / "image.csv")
    (tmp_path / "long.csv").write_text("1" * 200_000)
    with pytest.raises(ValueError, match=r"long\.csv: has column names but no data"):
        read(tmp_path / "long.csv")


cells = st.sampled_from(
    [
        "strain",
        "stretch",
        "stress_pa",
        "mode",
        "shear",
        "0.1",
        "1e999",
        "-2",
        "",
        '"',
        "#",
        "nan",
        "é",
    ]
)


@given(st.lists(st.lists(cells, max_size=4), max_size=5))
def test_any_text_is_read_or_refused_in_one_line(
    tmp_path_factory: pytest.TempPathFactory, table: list[list[str]]
) -> None:
    text = "\n".join(",".join(row) for row in table)
    try:
        data = _read(tmp_path_factory.mktemp("data"), text)
    except ValueError as error:
        assert "\n" not in str(error)  # noqa: PT017
    else:
        assert data.stretch.shape == data.stress.shape == data.mode.shape
        assert np.isfinite(data.stretch).all()


def test_a_window_takes_its_ends_whatever_the_rounding(tmp_path: Path) -> None:
    text = "strain,stress_pa\n" + "\n".join(f"{k / 100},{k}" for k in range(51))
    data = _read(tmp_path, text)
    for last in range(1, 51):  # 1 + 0.14 is not the number written 1.14
        chosen = data.select((1.0, float(f"1.{last:02d}")))
        assert chosen.stress.tolist() == list(range(last + 1))


def test_select_by_mode_keeps_all_columns_together(tmp_path: Path) -> None:
    text = (
        "stretch,stress_pa,mode,standard_error_pa\n1.1,1,shear,3\n1.2,2,biaxial,4\n1.3,5,shear,6\n"
    )
    chosen = _read(tmp_path, text).select((1.2, 2.0), ["shear"])
    assert chosen.standard_error is not None
    assert (*chosen.stretch, *chosen.stress, *chosen.mode, *chosen.standard_error) == (
        1.3,
        5.0,
        "shear",
        6.0,
    )


@pytest.mark.parametrize(
    ("stretch", "modes", "message"),
    [
        ((1.5, 1.0), None, r"stretch = 1\.5, 1: .* smallest < largest"),
        ((float("nan"), 2.0), None, "smallest < largest"),
        (None, ["planar"], "'planar' is unknown: allowed are uniaxial, biaxial, shear"),
        (None, ["biaxial"], r"sample\.csv: has no biaxial data, only uniaxial"),
        (None, "uniaxial", "must be a list"),
        (None, [], "must be a list"),
    ],
)
def test_a_bad_selection_is_refused(
    tmp_path: Path, stretch: tuple[float, float] | None, modes: list[str] | None, message: str
) -> None:
    data = _read(tmp_path, "stretch,stress_pa\n1.1,1\n")
    with pytest.raises(ValueError, match=message):
        data.select(stretch, modes)


def test_the_latex_file_is_the_published_law_and_says_so() -> None:
    data = read(DATA / "latex_panaitescu2019.csv")
    assert "NOT MEASURED" in data.note
    assert "rebuilt from the" in data.note
    lam = data.stretch
    np.testing.assert_allclose(lam, 1.0 + np.arange(51) / 100.0, rtol=1e-15)
    published = 2.0 * (lam - lam**-2) * (6.21e4 + 1.58e5 / lam)
    np.testing.assert_allclose(data.stress, published, atol=1e-6)


def test_treloar_has_three_modes_in_the_order_of_their_constraint() -> None:
    data = read(DATA / "treloar1944.csv")
    assert "Trans. Faraday Soc. 40" in data.note
    assert [int(np.sum(data.mode == mode)) for mode in MODES] == [24, 16, 13]
    at = np.linspace(1.15, 3.5, 20)
    stress = {}
    for mode in MODES:
        chosen = data.select(None, [mode])
        # rubber is stable: each nominal curve rises, so that a misplaced digit would show
        assert (np.diff(chosen.stretch) > 0.0).all()
        assert (np.diff(chosen.stress) > 0.0).all()
        stress[mode] = np.interp(at, chosen.stretch, chosen.stress)
    # at the same stretch a side that is held, or pulled as well, makes the sheet stiffer
    assert (stress["uniaxial"] < stress["shear"]).all()
    assert (stress["shear"] < stress["biaxial"]).all()
