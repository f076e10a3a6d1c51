"""A figure gets what it shows of a study, no more and no less, and its caption says so."""

from dataclasses import replace

import pytest

from wrinklestudy.results.cases import Case, StudySheet
from wrinklestudy.study import figure_contents
from wrinklestudy.study.config import parse_config
from wrinklestudy.study.loading import load_catalogue

CATALOGUE = load_catalogue("panaitescu2019")
LATEX = {"data": "a.csv", "law": "mooney-rivlin"}
ONE = StudySheet("latex", 2.0, 1e-3)


def sheets(material, aspect, thickness, strain=(0.1, 0.2)):
    entry = {"material": material, "strain": list(strain)}
    return entry | {"aspect": aspect, "thickness": thickness}


@pytest.fixture
def study(tmp_path):
    raw = {
        "folders": {"experiment": str(tmp_path)},
        "materials": {"latex": LATEX, "other": {**LATEX, "law": "svk"}},
        "variants": {"thick": {"material": "latex", "bending": "fixed-thickness"}},
        "sheets": [
            sheets("latex", [1.5, 2.0, 3.0], [1e-3]),
            sheets("latex", [2.0], [5e-4, 1e-3], [0.3]),
            sheets("latex", [3.0], [5e-4]),
            sheets("thick", [2.0, 3.0], [1e-3]),
            sheets("other", [2.0], [1e-3]),
        ],
        "mesh": {"cells_across": 36, "cells_along": 24},
        "figures": {
            "sheet": {"material": "latex", "aspect": 2.0, "thickness": 1e-3},
            "compare": ["latex", "thick"],
        },
    }
    return parse_config(raw, "test")


@pytest.mark.parametrize(
    ("figure", "shown"),
    [
        ("fig01_stress", ()),
        ("fig02_sheet", ()),
        ("fig05_amplitude", (ONE, StudySheet("thick", 2.0, 1e-3))),
        ("fig06_aspect", tuple(StudySheet("latex", aspect, 1e-3) for aspect in (1.5, 2.0, 3.0))),
        ("fig07_collapse", tuple(StudySheet("latex", aspect, 1e-3) for aspect in (1.5, 2.0, 3.0))),
        ("fig06_thickness", (StudySheet("latex", 2.0, 5e-4), ONE)),
        ("fig07_width", (ONE,)),
    ],
)
def test_a_figure_is_drawn_from_the_tables_of_its_sheets_only(study, figure, shown):
    assert figure_contents.sheets_shown(study, CATALOGUE.figure(figure)) == shown


def test_states_are_those_of_the_figure_sheet(study):
    every = tuple(Case(ONE, strain) for strain in (0.1, 0.2, 0.3))
    assert figure_contents.states_shown(study, CATALOGUE.figure("fig04_profiles")) == every
    assert figure_contents.states_shown(study, CATALOGUE.figure("fig07_width")) == ()


def test_only_the_figure_of_the_stress_takes_the_materials(study):
    takers = [
        figure.name
        for figure in CATALOGUE.figures
        if figure_contents.materials_shown(study, figure)
    ]
    assert takers == ["fig01_stress"]
    assert figure_contents.materials_shown(study, CATALOGUE.figure("fig01_stress")) == (
        "latex",
        "other",
    )


def test_measurements_are_inputs_once_they_exist(study, tmp_path):
    assert all(figure_contents.measured(study, figure) == [] for figure in CATALOGUE.figures)
    (tmp_path / "profiles").mkdir()
    files = [tmp_path / "amplitude.csv", *(tmp_path / "profiles" / f"{k}.csv" for k in "ba")]
    for path in [*files, tmp_path / "notes.csv"]:
        path.touch()
    profiles = [str(path) for path in sorted(files[1:])]
    for figure in CATALOGUE.figures:
        wanted = profiles if "profiles" in figure.measured else []
        wanted = [*wanted, str(files[0])] if "amplitude" in figure.measured else wanted
        assert figure_contents.measured(study, figure) == sorted(wanted)


def test_a_caption_names_the_cases_and_their_meshes(study):
    text = figure_contents.cases_text(study, CATALOGUE.figure("fig06_thickness"))
    assert text == (
        "latex, L/W = 2, t/W = 0.0005: strain 0.3; "
        "latex, L/W = 2, t/W = 0.001: strain 0.1, 0.2, 0.3"
    )
    mesh = figure_contents.mesh_text(study, CATALOGUE.figure("fig06_thickness"))
    # the wavelength falls as sqrt(t): sqrt(2) as many cells across
    assert mesh == (
        "24 x 51 cells on the quarter sheet for L/W = 2, t/W = 0.0005; "
        "24 x 36 cells on the quarter sheet for L/W = 2, t/W = 0.001"
    )
    assert figure_contents.mesh_text(study, CATALOGUE.figure("fig01_stress")) == ""
    assert "latex (mooney-rivlin, a.csv)" in figure_contents.cases_text(
        study, CATALOGUE.figure("fig01_stress")
    )


def test_a_long_list_of_strains_is_told_by_its_ends():
    raw = {
        "materials": {"latex": LATEX},
        "sheets": [sheets("latex", [2.0], [1e-3], [k / 50 for k in range(1, 11)])],
        "figures": {"sheet": {"material": "latex", "aspect": 2.0, "thickness": 1e-3}},
    }
    text = figure_contents.cases_text(parse_config(raw, "test"), CATALOGUE.figure("fig07_width"))
    assert text == "latex, L/W = 2, t/W = 0.001: 10 strains from 0.02 to 0.2"


def test_a_caption_begins_with_the_number_in_the_publication_if_there_is_one(study):
    entry = CATALOGUE.figure("fig07_width")
    assert figure_contents.caption_text(study, entry).startswith("Figure 7a. Arc width")
    unnumbered = replace(entry, panel="")
    assert figure_contents.caption_text(study, unnumbered) == entry.caption
