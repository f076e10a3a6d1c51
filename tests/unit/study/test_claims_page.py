"""From the tables of a study to the claims table and its page."""

import csv
import json
import re
import subprocess
import sys
from collections import Counter
from html.parser import HTMLParser

import numpy as np
import pytest

from wrinklestudy.files.storage import write_json
from wrinklestudy.material.result import Fit
from wrinklestudy.results.tables import PEAK_COLUMNS, STABILITY_COLUMNS
from wrinklestudy.results.tables import STATE_COLUMNS as COLUMNS
from wrinklestudy.stages.claims import run
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.studies.panaitescu2019.table1 import COLUMNS as TABLE1_COLUMNS
from wrinklestudy.study.claims.discovery import load_claims
from wrinklestudy.study.claims.finding import VERDICTS
from wrinklestudy.study.claims.write import CLAIM_COLUMNS

BIRTH, DECAY = 0.0246750242, 0.3983437946
VOID = {"meta", "br"}
CLAIMS = load_claims("panaitescu2019")


def case(name):
    return {
        "material": name,
        "law": "mooney-rivlin",
        "bending": "thinning",
        "parity": "antisymmetric",
        "aspect": 2.0,
        "thickness": 1e-3,
    }


def state(name, strain):
    wrinkled = BIRTH < strain < DECAY
    phi = 1.2e-3 * np.sin(np.pi * (strain - BIRTH) / (DECAY - BIRTH)) if wrinkled else 0.0
    length = theory.cm_wavelength(strain, 2.0, 1e-3, factor=0.8).item()
    width = (1.0 + strain) ** -0.5
    row = dict.fromkeys(COLUMNS, 0) | case(name)
    row |= {"strain": strain, "status": "wrinkled" if wrinkled else "flat", "reason": ""}
    row |= {"phi_squared": phi, "phi_squared_central": 4.0 * phi, "young_modulus_pa": 1320600.0}
    row |= {"arc_width_over_width": width, "planar_width_over_width": width}
    row |= {"projected_width_over_width": width / (1.0 + phi)}
    row |= {"amplitude_over_thickness": 0.7 * length * phi**0.5 / 1e-3}
    measured = {"wavelength_over_width": length, "shape_constant": 0.7}
    measured |= {"shape_constant_central": 0.35}
    return row | (measured if wrinkled else dict.fromkeys(measured, ""))


def write_csv(path, columns, rows):
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(columns))
        writer.writeheader()
        writer.writerows(rows)
    return path


def write_study(folder, name="latex"):
    """Write the tables of one sheet and its material file; return the arguments of `run`."""
    limits = case(name) | {"birth_strain": BIRTH, "decay_strain": DECAY}
    limits |= {"max_critical_thickness": 1.5e-3, "strain_at_max": 0.12}
    peak = dict.fromkeys(PEAK_COLUMNS, 18) | case(name) | {"strain_at_max_amplitude": 0.14}
    strains = [round(0.02 * k, 12) for k in range(1, 26)]
    constants = {"c10": 62100.0, "c01": 158000.0}
    note = "x & y"
    fit = Fit(
        *("mooney-rivlin", constants, np.zeros((2, 2)), (), 10.0, 51, (1.0, 1.5)),
        *(("uniaxial",), 1.0, "latex.csv", 3.5e5, 0.0),
    )
    write_json(folder / "material.json", {"name": name, **fit.as_dict(), "source_note": note})
    return {
        "study": "panaitescu2019",
        "states": write_csv(folder / "states.csv", COLUMNS, [state(name, eps) for eps in strains]),
        "stability": write_csv(folder / "stability.csv", STABILITY_COLUMNS, [limits]),
        "peaks": write_csv(folder / "peaks.csv", PEAK_COLUMNS, [peak]),
        "materials": [folder / "material.json"],
        "sheet": (name, 2.0, 1e-3),
        "output": {
            "csv": folder / "out" / "claims.csv",
            "page": folder / "out" / "claims.html",
            "markdown": folder / "out" / "claims.md",
            "tables": [folder / "out" / "table1.csv"],
        },
    }


@pytest.fixture
def study(tmp_path):
    return write_study(tmp_path)


def rows_of(path):
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Parser(HTMLParser):
    """Collects text by tag and checks that every tag that opens also closes."""

    def __init__(self):
        super().__init__()
        self.open, self.ids, self.text = [], [], ""

    def handle_starttag(self, tag, attrs):
        self.ids += [value for name, value in attrs if name == "id"]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text += data


def parsed(path):
    parser = Parser()
    parser.feed(path.read_text(encoding="utf-8"))
    parser.close()
    assert parser.open == []
    return parser


def test_the_table_has_every_claim_with_its_numbers(study):
    run(**study)
    rows = rows_of(study["output"]["csv"])
    assert list(rows[0]) == list(CLAIM_COLUMNS)
    assert [row["key"] for row in rows] == [claim.key for claim in CLAIMS]
    assert [int(row["number"]) for row in rows] == list(range(1, len(CLAIMS) + 1))
    assert {row["verdict"] for row in rows} <= set(VERDICTS)
    found = {row["key"]: row for row in rows}
    assert json.loads(found["appear-at-finite-strain"]["values"])["birth strain"] == BIRTH
    assert "birth strain: 0.0247" in found["appear-at-finite-strain"]["computed"]
    assert "latex (mooney-rivlin, thinning, antisymmetric)" in found["sinusoid"]["sheets"]
    assert found["young-modulus"]["verdict"] == "disagree"
    assert "+32%" in found["young-modulus"]["explanation"]


def test_what_the_study_lacks_is_named_and_nothing_is_dropped(study):
    run(**study)
    found = {row["key"]: row for row in rows_of(study["output"]["csv"])}
    for key, lack in {
        "none-when-short": "L/W = 1.5",
        "neo-hookean-smaller": "law = neo-hookean",
        "antisymmetric": "parity = symmetric",
        "tension-field": "tension fields of latex, L/W = 2",
    }.items():
        assert found[key]["verdict"] == "not computed"
        assert lack in found[key]["explanation"]


def test_the_page_lists_every_claim_once_and_counts_the_verdicts(study):
    run(**study)
    page = parsed(study["output"]["page"])
    assert sorted(page.ids) == sorted(claim.key for claim in CLAIMS)
    number = Counter(row["verdict"] for row in rows_of(study["output"]["csv"]))
    for verdict in VERDICTS:
        assert f"{number[verdict]} {verdict}" in page.text
    for claim in CLAIMS:
        assert claim.statement in page.text
        assert claim.tolerance in page.text


def test_the_page_stands_alone(study):
    run(**study)
    text = study["output"]["page"].read_text(encoding="utf-8")
    assert not re.search(r"https?:|src=|<link|<script|@import|url\(", text)


def test_text_is_escaped(tmp_path):
    name = "<script>alert('&')</script>"
    study = write_study(tmp_path, name)
    run(**study)
    text = study["output"]["page"].read_text(encoding="utf-8")
    assert "<script" not in text
    assert "&lt;script&gt;" in text
    assert name in parsed(study["output"]["page"]).text


def test_table_1_has_the_formulas_and_leaves_a_cell_empty_where_there_is_no_number(study):
    run(**study)
    rows = rows_of(study["output"]["tables"][0])
    assert list(rows[0]) == list(TABLE1_COLUMNS)
    arc = next(row for row in rows if row["quantity"] == "W_act")
    strain = float(arc["strain"])
    assert float(arc["computed"]) == (1.0 + strain) ** -0.5
    assert float(arc["current_value"]) == pytest.approx(1.0 - 0.5 * strain)
    assert float(arc["original_value"]) == 1.0
    projected = next(row for row in rows if row["quantity"] == "W_proj")
    assert projected["current"] == "tension field theory"
    assert projected["current_value"] == projected["deviation_from_current"] == ""


def test_a_study_without_the_sheet_still_has_all_its_files(study):
    run(**study | {"sheet": ("latex", 7.0, 1e-3)})
    assert {row["verdict"] for row in rows_of(study["output"]["csv"])} == {"not computed"}
    assert rows_of(study["output"]["tables"][0]) == []
    assert "lacks wrinkled states" in parsed(study["output"]["page"]).text


def test_the_same_tables_give_the_same_bytes(study):
    run(**study)
    files = [study["output"][name] for name in ("csv", "page", "markdown")]
    files += study["output"]["tables"]
    first = [path.read_bytes() for path in files]
    rows = rows_of(study["states"])
    write_csv(study["states"], COLUMNS, rows[::-1])
    run(**study)
    assert [path.read_bytes() for path in files] == first


@pytest.mark.parametrize(
    ("table", "change", "message"),
    [
        ("states", ("strain", "strane"), r"states.csv: column 'strain' is missing"),
        ("peaks", ("max_phi_squared", "x"), r"peaks.csv: column 'max_phi_squared' is missing"),
        (
            "stability",
            ("0.12", "much"),
            r"stability.csv, line 2: strain_at_max = 'much': must be a",
        ),
    ],
)
def test_a_bad_table_gets_one_line_and_nothing_is_written(study, table, change, message):
    study[table].write_text(study[table].read_text().replace(*change, 1))
    with pytest.raises(ValueError, match=message):
        run(**study)
    assert not study["output"]["csv"].parent.exists()


def test_a_file_that_is_no_material_gets_one_line(study):
    write_json(study["materials"][0], {"law": "mooney-rivlin"})
    with pytest.raises(ValueError, match=r"material.json: key 'name' is missing"):
        run(**study)


def test_the_job_loads_no_plotting_and_no_table_library():
    code = (
        "import sys; from wrinklestudy.study.claims.discovery import load_claims;"
        "import wrinklestudy.study.claims.page; assert load_claims('panaitescu2019');"
        "print([m for m in ('pandas', 'matplotlib', 'pydantic', 'skfem') if m in sys.modules])"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"
