"""Measured data of the user is read as it is meant, or refused in one line that says why."""

import math
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.study.measurements import KINDS, Points, kind, read_scan, read_sheets, read_stress

README = Path(__file__).parents[3] / "data" / "experiment" / "README.md"
AMPLITUDE = "aspect,thickness,strain,amplitude_over_thickness,error\n"
SCAN = "# aspect: 2\n# thickness: 0.001\n# strain: 0.1\n"


def scan_text(header=SCAN, half=0.47, points=200):
    y = np.linspace(-half, half, points)
    rows = [f"{a},{2e-3 * math.cos(50.0 * a)}" for a in y]
    return header + "y,w\n" + "\n".join(rows) + "\n"


@pytest.fixture
def write(tmp_path):
    def written(name, text):
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    return written


def refusal(read, path):
    with pytest.raises(ValueError, match=r".") as caught:
        read(path)
    message = str(caught.value)
    assert message.startswith(str(path))
    assert "\n" not in message
    return message.removeprefix(str(path))


@pytest.mark.parametrize(
    ("name", "expected"),
    [("stress.csv", "stress"), ("wavelength.csv", "wavelength"), ("profiles/a b.csv", "profiles")],
)
def test_a_file_is_known_by_its_name(name, expected):
    assert kind(f"data/experiment/{name}") == expected


@pytest.mark.parametrize("name", ["amplitudes.csv", "profiles.csv", "stress.txt", "profiles/a.txt"])
def test_other_names_are_refused(name):
    allowed = "allowed are stress.csv, amplitude.csv, wavelength.csv and profiles/"
    with pytest.raises(ValueError, match=allowed):
        kind(name)


def test_columns_may_stand_in_any_order_among_notes_and_blank_lines(write):
    text = "\ufeff# latex of May, 140 um\n\nstress_pa, strain\n1e5, 0.1\n# a remark\n2e5,0.25\n"
    points = read_stress(write("stress.csv", text))
    assert points.strain.tolist() == [0.1, 0.25]
    assert points.value.tolist() == [1e5, 2e5]
    assert np.isnan(points.error).all()


def test_per_cent_and_megapascals_are_read_as_such(write):
    text = "strain_percent;stress_mpa;error_kpa\n10;0,1;5\n25;0,2;\n"
    points = read_stress(write("stress.csv", text))
    assert points.strain.tolist() == pytest.approx([0.1, 0.25])
    assert points.value.tolist() == pytest.approx([1e5, 2e5])
    assert points.error[0] == pytest.approx(5e3)
    amplitude = "aspect,thickness,strain_percent,amplitude_over_thickness\n2,1e-3,12,3\n"
    (points,) = read_sheets(write("amplitude.csv", amplitude)).values()
    assert points.strain.tolist() == pytest.approx([0.12])


def test_an_error_may_be_known_for_some_points_only(write):
    points = read_stress(write("stress.csv", "strain,stress_pa,error_pa\n0.1,1e5,5e3\n0.2,2e5,\n"))
    assert points.error[0] == 5e3
    assert math.isnan(points.error[1])


def test_rows_are_sorted_into_sheets_whatever_the_spelling_of_numbers(write):
    rows = "2,1e-3,0.1,2.5,0.1\n2.0,0.0010,0.2,3,\n1.5,1e-3,0.1,0,0.1\n"
    sheets = read_sheets(write("amplitude.csv", AMPLITUDE + rows))
    assert list(sheets) == [(1.5, 1e-3), (2.0, 1e-3)]
    assert sheets[2.0, 1e-3].value.tolist() == [2.5, 3.0]
    assert sheets[2.0, 1e-3].highest()[0] == 3.0
    assert sheets[1.5, 1e-3].highest() == (0.0, 0.1)


@given(
    st.lists(
        st.tuples(
            st.sampled_from([1.5, 2.0, 2.5]),
            st.sampled_from([5e-4, 1e-3]),
            st.floats(0.0, 1.0),
            st.floats(0.0, 100.0),
        ),
        min_size=1,
        max_size=20,
    )
)
def test_what_is_written_is_read(tmp_path_factory, rows):
    path = tmp_path_factory.mktemp("data") / "amplitude.csv"
    path.write_text(AMPLITUDE + "".join(f"{a!r},{t!r},{e!r},{v!r},\n" for a, t, e, v in rows))
    found = read_sheets(path)
    assert sum(len(one.strain) for one in found.values()) == len(rows)
    for sheet, points in found.items():
        own = [(e, v) for a, t, e, v in rows if (a, t) == sheet]
        assert list(zip(points.strain, points.value, strict=True)) == own


def test_points_of_two_sources_are_joined_in_order():
    first, second = (Points(*np.full((3, 2), value)) for value in (1.0, 2.0))
    assert first.joined(second).value.tolist() == [1.0, 1.0, 2.0, 2.0]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", ": is empty; a line of column names and the data are needed"),
        ("# only a note\n", ": is empty; a line of column names and the data are needed"),
        (AMPLITUDE, ": has column names but no data"),
        (
            "aspect,strain,amplitude_over_thickness\n2,0.1,3\n",
            ", line 1: a column thickness is missing "
            "(has aspect, strain, amplitude_over_thickness)",
        ),
        (
            "aspect,thickness,strain,amplitude_over_thickness,err\n2,1e-3,0.1,3,0\n",
            ", line 1: column 'err' is unknown; allowed are aspect, thickness, strain, "
            "strain_percent, strain_%, error, amplitude_over_thickness",
        ),
        (
            "aspect,aspect,thickness,strain,amplitude_over_thickness\n2,2,1e-3,0.1,3\n",
            ", line 1: column 'aspect' stands twice",
        ),
        (
            AMPLITUDE + "2,1e-3,0.1\n",
            ", line 2: 3 cells where 5 columns are named "
            "(aspect, thickness, strain, amplitude_over_thickness, error)",
        ),
        (
            AMPLITUDE + "# note\n2,1e-3,12,3,0\n",
            ", line 3, column strain: 12 must be >= 0 and <= 1 "
            "(0.12 is 12 %; per cent belongs in a column strain_percent)",
        ),
        (
            AMPLITUDE + "2,140,0.1,3,0\n",
            ", line 2, column thickness: 140 must be >= 1e-6 and <= 0.05 (t/W)",
        ),
        (
            AMPLITUDE + "28,1e-3,0.1,3,0\n",
            ", line 2, column aspect: 28 must be >= 0.5 and <= 20 (L/W)",
        ),
        (
            AMPLITUDE + "2,1e-3,0.1,-3,0\n",
            ", line 2, column amplitude_over_thickness: -3 must be >= 0 (A/t)",
        ),
        (AMPLITUDE + "2,1e-3,0.1,3,-1\n", ", line 2, column error: -1 must be >= 0"),
        (
            AMPLITUDE + "2,1e-3,0.1,,0\n",
            ", line 2, column amplitude_over_thickness: '' is not a number; a number is needed, "
            "such as 0.12 or 1.5e5",
        ),
        (
            AMPLITUDE + "2,1e-3,0.1,inf,0\n",
            ", line 2, column amplitude_over_thickness: 'inf' is not a number; a number is "
            "needed, such as 0.12 or 1.5e5",
        ),
    ],
)
def test_a_bad_table_is_refused_in_one_line(write, text, message):
    assert refusal(read_sheets, write("amplitude.csv", text)) == message


def test_files_that_are_no_text_are_refused(tmp_path):
    path = tmp_path / "stress.csv"
    assert "cannot be read (No such file" in refusal(read_stress, path)
    path.write_bytes(b"strain,stress_pa\n\xff\xfe,1\n")
    assert refusal(read_stress, path) == ", line 2: is not UTF-8 text; save the file as UTF-8"
    path.write_text("strain,stress_pa\n0.1,abc\n")
    message = ", line 2, column stress_pa: 'abc' is not a number; a number is needed, such as"
    message += " 0.12 or 1.5e5"
    assert refusal(read_stress, path) == message


def test_a_wavelength_is_over_the_width(write):
    text = "aspect,thickness,strain,wavelength_over_width\n2,1e-3,0.1,17\n"
    message = ", line 2, column wavelength_over_width: 17 must be > 0 and <= 1 (lambda/W)"
    assert refusal(read_sheets, write("wavelength.csv", text)) == message


def test_a_scan_is_measured_in_units_of_the_width(experiment):
    """A sinusoid of 0.35 mm and 17 mm on a sheet of 140 mm, tilted, shifted and noisy."""
    path = next(path for path in experiment if path.name == "0.1.csv")
    scan = read_scan(path)
    assert scan.sheet == (2.0, 1e-3)
    assert scan.strain == 0.1
    assert scan.wrinkled
    assert scan.measures.amplitude == pytest.approx(0.35 / 140.0, rel=0.01)
    assert scan.measures.wavelength == pytest.approx(17.0 / 140.0, rel=0.01)
    assert scan.measures.projected_width == pytest.approx(1.1**-0.5, rel=1e-6)
    # (pi A / lambda)^2 of a sinusoid of small slope, over the central wrinkle
    expected = (np.pi * 0.35 / 17.0) ** 2
    assert scan.measures.phi_squared_central == pytest.approx(expected, rel=0.02)
    assert scan.noise == pytest.approx(0.004 / 140.0, rel=0.1)
    assert scan.profile.y[0] == pytest.approx(-scan.profile.y[-1])
    # noise of 0.004 mm on 1200 points, 9 for each knot of the spline
    assert 0.001 < 140.0 * scan.error < 0.03
    assert scan.left_out == 0


def test_lost_points_and_spikes_of_a_scan_are_left_out_and_counted(experiment, write, caplog):
    """-9999 where the laser lost the line: the measures stay, and the log says how many."""
    path = next(path for path in experiment if path.name == "0.1.csv")
    whole = read_scan(path)
    lines = path.read_text().splitlines()
    for k, value in ((300, "-9999"), (700, "-9999"), (701, "-9999"), (900, "12.5"), (1000, "")):
        cells = lines[k].split(",")
        lines[k] = ",".join([cells[0], value, *cells[2:]])
    scan = read_scan(write("profiles/lost.csv", "\n".join(lines)))
    assert scan.left_out == 5
    assert "5 points left out" in caplog.text
    assert scan.measures.amplitude == pytest.approx(whole.measures.amplitude, rel=5e-3)
    assert scan.measures.phi_squared == pytest.approx(whole.measures.phi_squared, rel=5e-3)


def test_a_scan_that_cannot_tell_is_left_out_with_a_reason(write, caplog):
    path = write("profiles/coarse.csv", scan_text(points=40))
    assert read_scan(path) is None
    assert f"{path}: not shown: " in caplog.text
    assert "points per wavelength; at least 10 are needed" in caplog.text


def test_the_stated_error_of_a_scan_is_in_its_own_unit_and_the_larger_one_counts(write):
    """Of W = 2 units; Phi^2 grows as the square of the height."""
    header = SCAN + "# width: 2\n# error: {}\n# at: 12:30\n# free text\n"
    large, small = (
        read_scan(write("profiles/a.csv", scan_text(header.format(error), half=0.94)))
        for error in (0.004, 1e-9)
    )
    assert large.error == pytest.approx(0.002)
    # the mean of a broken number of waves, which is taken off, is a few percent of A
    assert large.measures.amplitude == pytest.approx(1e-3, rel=0.05)
    relative = large.error / large.measures.amplitude
    assert large.phi_squared_error == pytest.approx(2.0 * relative * large.measures.phi_squared)
    assert 1e-9 < small.error < large.error
    assert small.phi_squared_error < large.phi_squared_error


def test_a_scan_of_noise_is_not_wrinkled(write):
    rng = np.random.default_rng(5)
    y = np.linspace(-0.4, 0.4, 400)
    rows = "".join(f"{a},{b}\n" for a, b in zip(y, 1e-5 * rng.standard_normal(400), strict=True))
    scan = read_scan(write("profiles/flat.csv", SCAN + "y,w\n" + rows))
    assert not scan.wrinkled
    assert scan.measures.amplitude < 2e-5


ROWS = "".join(f"{0.01 * k},0\n" for k in range(-47, 48))
BAD_SCANS = {
    "no thickness": (
        "# aspect: 2\n# strain: 0.1\ny,w\n" + ROWS,
        ": a line '# thickness: number' is missing; must be >= 1e-6 and <= 0.05 (t/W)",
    ),
    "strain twice": (SCAN + "# strain: 0.2\ny,w\n" + ROWS, ", line 4: '# strain:' is given twice"),
    "percent": (
        "# strain: 12 %\n# aspect: 2\n# thickness: 0.001\ny,w\n" + ROWS,
        ", line 1, strain: '12 %' is not a number; write the number without the unit '%'",
    ),
    "width in another unit": (
        SCAN + "# width: 1000 mm\ny,w\n" + ROWS,
        ", line 4, width: '1000 mm' is not a number; write the number without the unit 'mm', "
        "in the unit of column y",
    ),
    "no width": (
        scan_text(half=65.0),
        ": y runs over 130 W, must be 0.72 to 1.1 (from edge to edge); "
        "'# width:' gives W in the unit of y",
    ),
    "half of the sheet": (
        SCAN + "y,w\n" + ROWS[ROWS.index("0.0,0") :],
        ": y runs over 0.47 W, must be 0.72 to 1.1 (from edge to edge); "
        "'# width:' gives W in the unit of y",
    ),
    "other column": (
        SCAN + "y,height\n0,1\n",
        ", line 4: a column w or w_m or w_cm or w_mm or w_um or z or z_m or z_cm or z_mm or z_um "
        "is missing (has y, height)",
    ),
    "y twice": (
        SCAN + "y,w\n-0.4,0\n0.1,0\n0.1,0\n0.5,0\n",
        ", line 7, column y: 0.1 stands in line 6 too; y must rise, or fall, from row to row",
    ),
    "unsorted": (
        SCAN + "y,w\n-0.4,0\n0.2,0\n0.1,0\n0.3,0\n0.5,0\n",
        ", line 7, column y: 0.1 comes after 0.2 of line 6; y must rise, or fall, from row to row",
    ),
    "one unit": (
        SCAN + "y_mm,w\n" + ROWS,
        ": columns y_mm and w: one has a unit and the other none; "
        "name the unit of both, or of none where it is the same",
    ),
    "word": (
        SCAN + "y,w\n0,abc\n",
        ", line 5, column w: 'abc' is not a number; a number is needed, such as 0.12 or 1.5e5",
    ),
    "underscore": (
        SCAN + "y,w\n0,1_000\n",
        ", line 5, column w: '1_000' is not a number; a number is needed, such as 0.12 or 1.5e5",
    ),
}


@pytest.mark.parametrize(("text", "message"), BAD_SCANS.values(), ids=BAD_SCANS)
def test_a_bad_scan_is_refused_in_one_line(write, text, message):
    assert refusal(read_scan, write("profiles/a.csv", text)) == message


def test_the_examples_of_the_documentation_are_read(write):
    blocks = dict(re.findall(r"```csv (\S+)\n(.*?)```", README.read_text(), re.DOTALL))
    assert sorted({kind(name) for name in blocks}) == sorted(KINDS)
    readers = {"stress": read_stress, "profiles": read_scan}
    for name, text in blocks.items():
        read = readers.get(kind(name), read_sheets)(write(name, text))
        # ten points show the form of a scan; they cannot tell a wrinkle
        assert read is None if kind(name) == "profiles" else read
