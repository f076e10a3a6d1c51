"""The command that measures scans: what it prints, reads, draws and refuses."""

import json

import numpy as np
import pytest

from wrinklestudy.cli import main

KEYS = {
    "file",
    "wrinkled",
    "amplitude",
    "amplitude_error",
    "wavelength",
    "wavelength_error",
    "arc_width",
    "projected_width",
    "phi_squared",
    "phi_squared_error",
    "shape_constant",
    "noise",
    "left_out",
    "reason",
}
HALF, HEIGHT, WAVELENGTH = 66.0, 0.4, 17.0


def heights(y):
    """A symmetric packet: its middle peak has the height of the packet."""
    return HEIGHT * np.cos(2.0 * np.pi * y / WAVELENGTH) * np.exp(-((y / 25.0) ** 2))


@pytest.fixture
def scan(tmp_path):
    """Write a scan of a packet in mm."""

    def written(name="scan.csv", names="y,w", unit=1.0, points=500, noise=0.01, change=None):
        y = np.linspace(-HALF, HALF, points)
        z = heights(y) + noise * np.random.default_rng(0).standard_normal(points)
        if change is not None:
            change(y, z)
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        rows = "".join(f"{a * unit:.9g},{b * unit:.9g}\n" for a, b in zip(y, z, strict=True))
        path.write_text(f"{names}\n{rows}", encoding="utf-8")
        return path

    return written


def measured(capsys, *arguments):
    assert main(["measure", *map(str, arguments), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def refused(capsys, *arguments):
    assert main(["measure", *map(str, arguments)]) == 2
    out, err = capsys.readouterr()
    assert not out
    assert err.count("\n") == 1
    return err.removeprefix("wrinklestudy measure: ").strip()


def test_a_list_with_an_object_for_each_scan_is_printed(scan, capsys):
    (result,) = measured(capsys, scan())
    assert set(result) >= KEYS
    assert result["wrinkled"]
    assert result["reason"] is None
    assert abs(result["amplitude"] - HEIGHT) < 3.0 * result["amplitude_error"]
    assert result["projected_width"] == pytest.approx(2.0 * HALF)
    confinement = result["arc_width"] / result["projected_width"] - 1.0
    assert confinement == pytest.approx(result["phi_squared"], rel=1e-9)
    slope = result["wavelength"] * result["phi_squared"] ** 0.5
    assert result["shape_constant"] == pytest.approx(result["amplitude"] / slope)
    assert result["noise"] == pytest.approx(0.01, rel=0.1)


def test_lengths_are_in_the_unit_of_the_file(scan, capsys):
    here, there = measured(
        capsys,
        scan("mm.csv", "y_mm,w_mm"),
        scan("m.csv", "y_m,z_m", 1e-3),
    )
    assert (here["unit"], there["unit"]) == ("mm", "m")
    for name in ("amplitude", "amplitude_error", "wavelength", "arc_width", "noise"):
        assert there[name] == pytest.approx(1e-3 * here[name], rel=1e-4)
    assert there["phi_squared"] == pytest.approx(here["phi_squared"], rel=1e-4)


def test_deflections_in_another_unit_are_brought_to_that_of_y(scan, capsys, tmp_path):
    """A laser gives micrometres on a stage in millimetres."""
    plain = scan("plain.csv", "y_mm,w_mm")
    lines = plain.read_text().splitlines()[1:]
    cells = [line.split(",") for line in lines]
    mixed = tmp_path / "mixed.csv"
    rows = "".join(f"{a},{1e3 * float(b):.9g}\n" for a, b in cells)
    mixed.write_text("y_mm,w_um\n" + rows)
    first, second = measured(capsys, plain, mixed)
    assert second["unit"] == "mm"
    assert second["amplitude"] == pytest.approx(first["amplitude"], rel=1e-6)


def test_a_folder_means_its_tables(scan, capsys, tmp_path):
    scan("scans/b.csv")
    scan("scans/a.csv", noise=0.02)
    (tmp_path / "scans" / "notes.txt").write_text("none")
    results = measured(capsys, tmp_path / "scans")
    assert [result["file"][-5:] for result in results] == ["a.csv", "b.csv"]
    (tmp_path / "empty").mkdir()
    assert refused(capsys, tmp_path / "empty").endswith("empty: the folder has no *.csv")


def test_lost_points_are_counted_and_change_nothing(scan, capsys):
    def lose(_, z):
        z[100:106] = -9999.0
        z[250] = np.nan

    (whole,) = measured(capsys, scan())
    (lost,) = measured(capsys, scan(change=lose))
    assert (whole["left_out"], lost["left_out"]) == (0, 7)
    assert abs(lost["phi_squared"] - whole["phi_squared"]) < whole["phi_squared_error"]


def test_what_cannot_be_told_is_null_with_a_reason(scan, capsys):
    (result,) = measured(capsys, scan(points=60))
    assert (result["wrinkled"], result["amplitude"], result["phi_squared_error"]) == (
        False,
        None,
        None,
    )
    assert "points per wavelength; at least 10 are needed" in result["reason"]


def test_noise_above_the_wrinkle_is_said(scan, capsys):
    (result,) = measured(capsys, scan(noise=2.0, points=200))
    assert not result["wrinkled"]
    assert result["reason"] == "nothing stands out of the noise"
    # what hides there is in the error
    assert 2.0 * result["amplitude_error"] + 1e-12 > HEIGHT


def test_text_has_a_sentence_and_numbers_to_the_digits_of_their_errors(scan, capsys):
    assert main(["measure", str(scan(names="y_mm,w_mm"))]) == 0
    out = capsys.readouterr().out
    first, *table = out.splitlines()
    assert first.endswith("scan.csv: wrinkled.")
    assert all(len(line) < 80 for line in table)
    value, _, error, unit = table[0].split()[2:]
    assert len(value.partition(".")[2]) == len(error.partition(".")[2])
    assert unit == "mm"
    assert table[-1].split() == ["points", "left", "out", "0", "of", "500"]


def test_a_picture_is_drawn_and_not_drawn_over(scan, capsys, tmp_path):
    picture = tmp_path / "scan.png"
    arguments = [scan(), "--plot", picture]
    measured(capsys, *arguments)
    before = picture.read_bytes()
    assert before.startswith(b"\x89PNG")
    assert (
        refused(capsys, *arguments) == f"--plot {picture}: exists already; --overwrite replaces it"
    )
    measured(capsys, *arguments, "--overwrite")
    assert picture.read_bytes() == before
    assert "must end in .pdf or .png or .svg" in refused(
        capsys, scan(), "--plot", tmp_path / "scan.gif"
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("y,w\n1,0\n0,0\n0,0\n-1,0\n", ", line 4, column y: 0 stands in line 3 too"),
        ("y,w\n1,0\n0,0\n0.5,0\n-1,0\n", ", line 4, column y: 0.5 comes after 0 of line 3"),
        (
            "# width: 140 mm\ny,w\n1,0\n2,0\n",
            ", line 1, width: '140 mm' is not a number; write the number without the unit 'mm'",
        ),
        (
            "# width: 140 mm\ny_m,w_m\n1,0\n2,0\n",
            ", line 1, width: '140 mm' is not a number; write the number without the unit 'mm'",
        ),
        (
            "# width: 140 mm\ny_mm,w_mm\n-30,0\n30,0\n",
            ": y runs over 0.429 W, must be",
        ),
        ("y,w\n0,1e400\n", ", line 2, column w: 1e400 must be a finite number"),
    ],
)
def test_a_bad_file_is_refused_with_its_line(tmp_path, capsys, text, message):
    path = tmp_path / "bad.csv"
    path.write_text(text)
    assert refused(capsys, path).startswith(f"{path}{message}")


def test_a_missing_file_is_named(tmp_path, capsys):
    path = tmp_path / "none.csv"
    assert refused(capsys, path) == f"{path}: cannot be read (No such file or directory)"
