"""Curves, scans, tables and fits that someone broke: taken, or refused in one line that names them.

Whatever is taken gives finite numbers, or says in its own words that it gives none.
"""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from fuzzing import broken, fuzzed, outcome
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.material import data
from wrinklestudy.material.choice import Choice
from wrinklestudy.material.fit import fit_choice
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import LAWS, Material
from wrinklestudy.metrics.scan import measure_scan
from wrinklestudy.results.materials import load_fit, load_material
from wrinklestudy.results.thickness_table import read_thickness_table
from wrinklestudy.study import measurements
from wrinklestudy.study.scan_file import read_scan_file

DATA = Path(__file__).parents[2] / "data"
CURVES = (
    (DATA / "latex_panaitescu2019.csv").read_text(),
    (DATA / "treloar1944.csv").read_text(),
    "stretch,stress_mpa\n1.0,0\n1.1,0.1\n1.2,0.18\n1.3,0.24\n1.4,0.3\n1.6,0.4\n",
    "# width_mm: 10\n# thickness_mm: 0.2\n# length_mm: 50\nextension_mm;force_n\n"
    "0;0\n5;0,2\n10;0,35\n20;0,6\n30;0,8\n",
    "strain_percent\tstress_kpa\tmode\tbranch\tstandard_error_pa\n0\t0\tuniaxial\tloading\t100\n"
    "10\t50\tuniaxial\tloading\t100\n20\t90\tuniaxial\tloading\t100\n"
    "30\t120\tequibiaxial\tloading\t100\n40\t160\tequibiaxial\tunloading\t100\n",
)


def scan(points=90):
    y = np.linspace(-70.0, 70.0, points)
    w = 0.4 * np.sin(2.0 * np.pi * y / 17.0) * np.exp(-((y / 40.0) ** 2))
    rows = "".join(f"{a:.3f},{b:.4f}\n" for a, b in zip(y, w, strict=True))
    notes = "# aspect: 2\n# thickness: 1e-3\n# strain: 0.1\n# width: 147\n# error: 0.02\n"
    return f"{notes}y_mm,w_mm\n{rows}"


FIT = fit_choice(DATA / "latex_panaitescu2019.csv", "mooney-rivlin", Choice())
TABLES = {
    "stress": ("strain,stress_pa,error_pa\n0.1,1.1e5,5e3\n0.6,4e5,\n",),
    "amplitude": (
        "aspect,thickness,strain,amplitude_over_thickness,error\n2,1e-3,0.1,2.5,0.2\n"
        "2.0,1e-3,0.55,0,0.1\n3,1e-3,0.1,1.5,\n",
    ),
    "wavelength": ("aspect,thickness,strain,wavelength_over_width\n2,1e-3,0.1,0.15\n",),
}
THICKNESSES = "x,y,thickness\n-1,-0.5,1\n1,-0.5,1.1\n-1,0.5,0.9\n1,0.5,1\n"


@pytest.fixture(scope="module")
def file_of(tmp_path_factory):
    """Write bytes to a file of a name and return its path."""
    folder = tmp_path_factory.mktemp("fuzz")
    (folder / "profiles").mkdir()

    def write(name, content):
        path = folder / name
        path.write_bytes(content)
        return path

    return write


@fuzzed()
@given(broken(*CURVES), st.sampled_from(sorted(LAWS)))
def test_curves(file_of, content, law):
    path = file_of("curve.csv", content)
    read = outcome(lambda: data.read(path), path)
    if isinstance(read, ValueError):
        return
    assert np.isfinite(read.stretch).all()
    assert np.isfinite(read.stress).all()
    fit = outcome(lambda: fit_choice(read, law, Choice()), path)
    if isinstance(fit, Fit):
        assert all(math.isfinite(value) for value in fit.constants.values())
        assert math.isfinite(fit.rms_pa)
        assert fit.material().shear_modulus > 0.0
        json.dumps(fit.as_dict(), allow_nan=False)


@fuzzed(0.5)
@given(broken(scan(), scan(12)))
def test_scans(file_of, content):
    path = file_of("scan.csv", content)
    file = outcome(lambda: read_scan_file(path), path)
    if isinstance(file, ValueError):
        return
    measured = measure_scan(file.y, file.z, draws=3)
    if measured.measures is None:
        assert measured.reason
        return
    assert math.isfinite(measured.measures.amplitude)
    assert measured.measures.amplitude >= 0.0
    assert measured.wrinkled or measured.reason


@fuzzed(0.5)
@given(broken(scan(), scan(12)))
def test_scans_of_a_study(file_of, content):
    path = file_of("profiles/scan.csv", content)
    one = outcome(lambda: measurements.read_scan(path), path)
    if isinstance(one, measurements.Scan):
        assert all(map(math.isfinite, (*one.sheet, one.strain, one.measures.amplitude)))


@pytest.mark.parametrize("name", TABLES)
@fuzzed(0.5)
@given(data=st.data())
def test_tables_of_measurements(file_of, name, data):
    path = file_of(f"{name}.csv", data.draw(broken(*TABLES[name])))
    reader = measurements.read_stress if name == "stress" else measurements.read_sheets
    read = outcome(lambda: reader(path), path)
    if isinstance(read, ValueError):
        return
    for points in [read] if name == "stress" else read.values():
        assert np.isfinite(points.strain).all()
        assert np.isfinite(points.value).all()


@fuzzed()
@given(broken(THICKNESSES))
def test_tables_of_thickness(file_of, content):
    path = file_of("thickness.csv", content)
    table = outcome(lambda: read_thickness_table(path), path)
    if not isinstance(table, ValueError):
        assert np.isfinite(table.thickness).all()
        assert np.min(table.thickness) > 0.0


@fuzzed()
@given(broken(json.dumps(FIT.as_dict(), indent=1)))
def test_files_of_fits(file_of, content):
    path = file_of("fit.json", content)
    material = outcome(lambda: load_material(path), path)
    if isinstance(material, Material):
        assert 0.0 < material.shear_modulus < math.inf
    outcome(lambda: load_fit(path), path)
