"""A wrong config gets one clear line that names the key and what is allowed."""

import copy
import math
from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.equilibrium import planar, wrinkled
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.results.cases import StudySheet
from wrinklestudy.study.config import ConfigError, load_config, parse_config
from wrinklestudy.study.selections import same_aspect, same_thickness

ROOT = Path(__file__).parents[3]
RAW = yaml.safe_load((ROOT / "config.yaml").read_text())
DELETED = object()


def changed(path, value):
    """Return the config of the study with another value at a path, or without it."""
    raw = copy.deepcopy(RAW)
    block = raw
    for part in path[:-1]:
        block = block[part]
    if value is DELETED:
        del block[path[-1]]
    else:
        block[path[-1]] = value
    return raw


STRAIN = ("sheets", 0, "strain")
MEMBRANE = {"law": "foppl-von-karman", "constants": {"young": 1.0e6, "poisson": 0.5}}


@pytest.mark.parametrize(
    ("path", "value", "line"),
    [
        (
            ("sheets", 0, "thickness"),
            [1e-3, -0.001],
            "sheets[0].thickness[1] = -0.001: must be a number >= 1e-6 and <= 0.05 (t/W)",
        ),
        (STRAIN, [], "sheets[0].strain = []: must be a list with at least one entry"),
        (STRAIN, [0.1, 5], "sheets[0].strain[1] = 5: must be a number >= 1e-7 and <= 1"),
        (STRAIN, [0.0], "sheets[0].strain[0] = 0.0: must be a number >= 1e-7 and <= 1"),
        (STRAIN, [True], "sheets[0].strain[0] = true: must be a number >= 1e-7 and <= 1"),
        (STRAIN, [None], "sheets[0].strain[0] = null: must be a number >= 1e-7 and <= 1"),
        (STRAIN, ["0_1"], "sheets[0].strain[0] = '0_1': must be a number >= 1e-7 and <= 1"),
        (STRAIN, [math.nan], "sheets[0].strain[0] = nan: must be a number >= 1e-7 and <= 1"),
        (STRAIN, 0.1, "sheets[0].strain = 0.1: must be a list with at least one entry"),
        (
            STRAIN,
            {"start": 0.3, "stop": 0.1, "step": 0.1},
            "sheets[0].strain.stop = 0.1: must be >= start = 0.3",
        ),
        (
            STRAIN,
            {"start": 0.03, "stop": 0.3, "step": 0.04},
            "sheets[0].strain.stop = 0.3: must be a whole number of steps above start; "
            "nearest: 0.27 or 0.31",
        ),
        (
            STRAIN,
            {"start": 0.1, "stop": 0.9, "step": 1e-6},
            "sheets[0].strain.step = 1e-06: must leave at most 1000 strains",
        ),
        (
            STRAIN,
            {"start": 0.1, "stop": 0.2},
            "sheets[0].strain.step: is missing: distance of the strains",
        ),
        (("sheets",), [], "sheets = []: must be a list with at least one entry"),
        (("sheets", 0), "latex", "sheets[0] = 'latex': must be a block of keys"),
        (
            ("sheets", 0, "aspect"),
            [0.1],
            "sheets[0].aspect[0] = 0.1: must be a number >= 0.5 and <= 20 (L/W)",
        ),
        (
            ("mesh", "cell_across"),
            36,
            "mesh.cell_across: unknown key; did you mean cells_across? "
            "allowed: cells_across, cells_along, grading",
        ),
        (
            ("mesh", "cells_across"),
            36.5,
            "mesh.cells_across = 36.5: must be a whole number >= 2 and <= 500",
        ),
        (("mesh",), None, "mesh = null: must be a block of keys"),
        (
            ("plate", "bending"),
            "FvK",
            "plate.bending = 'FvK': must be 'thinning', 'fixed-thickness' or 'fvk'",
        ),
        (
            ("gate", "allow_not_converged"),
            True,
            "gate.allow_not_converged = true: must be a whole number >= 0 and <= 1000000",
        ),
        (
            ("materials", "latex", "law"),
            DELETED,
            "materials.latex.law: is missing: law to fit",
        ),
        (
            ("materials", "latex", "stretch"),
            [1.2, 1.0],
            "materials.latex.stretch = [1.2, 1.0]: must be two stretches [low, high], "
            "0 < low < high",
        ),
        (
            ("materials", "latex", "modes"),
            ["torsion"],
            "materials.latex.modes[0] = 'torsion': must be 'uniaxial', 'biaxial' or 'shear'",
        ),
        (
            ("materials", "latex", "branch"),
            "up",
            "materials.latex.branch = 'up': must be 'loading' or 'unloading'",
        ),
        (
            ("materials", "latex", "cycle"),
            0,
            "materials.latex.cycle = 0: must be a whole number >= 1 and <= 1000",
        ),
        (
            ("materials", "latex", "preload"),
            "shift",
            "materials.latex.preload = 'shift': must be 'keep' or 'remove'",
        ),
        (
            ("materials", "latex", "data"),
            DELETED,
            "materials.latex: must have data (a CSV file) or constants",
        ),
        (
            ("materials", "latex", "constants"),
            {"c10": 1e5, "c01": 2e5},
            "materials.latex: data is for a fit, and this has constants",
        ),
        (
            ("materials", "given"),
            {"law": "mooney-rivlin", "constants": {"c10": 1e5, "c01": -1}},
            "materials.given.constants: c01 = -1: must be >= 0 Pa",
        ),
        (
            ("materials", "given"),
            {"law": "svk", "constants": {"c10": 1e5}},
            "materials.given.constants: c10: not a constant of svk, which takes young, poisson",
        ),
        (
            ("materials", "given"),
            {"law": "svk", "constants": {"young": "stiff"}},
            "materials.given.constants.young = 'stiff': must be a number",
        ),
        (
            ("maps",),
            [{"material": "latx", "aspect": [2], "strain": [0.1]}],
            "maps[0].material = 'latx': is not in materials or variants; did you mean latex? "
            f"allowed: {', '.join([*RAW['materials'], *RAW['variants']])}",
        ),
        (
            ("maps",),
            [{"material": "latex", "aspect": [0.1], "strain": [0.1]}],
            "maps[0].aspect[0] = 0.1: must be a number >= 0.5 and <= 20 (L/W)",
        ),
        (
            ("maps",),
            [{"material": "latex", "aspect": [2], "thickness": [1e-3], "strain": [0.1]}],
            "maps[0].thickness: unknown key; allowed: material, aspect, strain",
        ),
        (
            ("tension",),
            [{"material": "latex-fvk", "aspect": [2], "strain": [0.1]}],
            "tension[0].material = 'latex-fvk': is not in materials; did you mean latex-svk? "
            f"allowed: {', '.join(RAW['materials'])}",
        ),
        (
            ("tension",),
            [
                {
                    "material": "latex",
                    "aspect": [2],
                    "strain": {"start": 0.3, "stop": 0.1, "step": 0.1},
                }
            ],
            "tension[0].strain.stop = 0.1: must be >= start = 0.3",
        ),
        (("materials",), {}, "materials = {}: must be a block with at least one material"),
        (
            ("figures", "sheet", "material"),
            "latex-symetric",
            "figures.sheet = latex-symetric, 2, 0.001: must be a sheet of sheets "
            "(material, aspect, thickness)",
        ),
        (
            ("figures", "compare"),
            ["latex", "treloar"],
            "figures.compare[1] = treloar, 2, 0.001: must be a sheet of sheets "
            "(material, aspect, thickness)",
        ),
        (("figures", "compare"), "latex", "figures.compare = 'latex': must be a list"),
        (
            ("variants", "latex-fixed"),
            {"material": "latx", "bending": "fvk"},
            "variants.latex-fixed.material = 'latx': is not in materials; did you mean latex? "
            f"allowed: {', '.join(RAW['materials'])}",
        ),
        (
            ("variants", "latex"),
            {"material": "latex", "bending": "fvk"},
            "variants.latex: is the name of a material; a variant needs one of its own",
        ),
        (
            ("variants", "latex-fixed"),
            {"material": "latex"},
            "variants.latex-fixed: must have bending, parity or both",
        ),
        (
            ("variants", "latex-fixed", "bending"),
            "fixed",
            "variants.latex-fixed.bending = 'fixed': "
            "must be 'thinning', 'fixed-thickness' or 'fvk'",
        ),
        (
            ("variants", "Fixed"),
            {"material": "latex", "bending": "fvk"},
            "variants.Fixed = 'Fixed': must be a name of at most 100 lower-case "
            "letters, digits, '-' and '_'",
        ),
        (
            ("materials", "latex"),
            {"law": "neo-hookean", "constants": {"C 10": 1.0e5}},
            "materials.latex.constants.C 10 = 'C 10': must be a name of at most 100 lower-case "
            "letters, digits, '-' and '_'",
        ),
        (("variants",), None, "variants = null: must be a block"),
        (("folders", "results"), "", "folders.results = '': must be text"),
        (
            ("folders", "figures"),
            "pictures/{law}",
            "folders.figures = 'pictures/{law}': must be a path, not blank and without { and }",
        ),
        (
            ("materials", "latex", "data"),
            "a{b.csv",
            "materials.latex.data = 'a{b.csv': must be a path, not blank and without { and }",
        ),
        (
            ("folders", "results"),
            True,
            "folders.results = true: must be text; YAML reads yes and on as true: "
            "put the word in quotes",
        ),
        (
            ("sheets", 0, "material"),
            1944,
            "sheets[0].material = 1944: must be a name of at most 100 lower-case "
            "letters, digits, '-' and '_'; "
            "YAML reads it as a number: put it in quotes",
        ),
        (
            ("materials", False),
            {"data": "a.csv"},
            "materials.false = false: must be a name of at most 100 lower-case "
            "letters, digits, '-' and '_'; "
            "YAML reads no and off as false: put the word in quotes",
        ),
        (
            ("materials", "latex", "stretch"),
            [1.0],
            "materials.latex.stretch = [1.0]: must be two stretches [low, high], 0 < low < high",
        ),
        (
            ("solver", "tolerance"),
            1e-3,
            "solver.tolerance = 0.001: must be a number > 0 and <= 1e-6",
        ),
        (
            ("mesh", "cells_along"),
            "1_0",
            "mesh.cells_along = '1_0': must be a whole number >= 2 and <= 500",
        ),
        (("mesh", "grading"), True, "mesh.grading = true: must be a number >= 1 and <= 4"),
        (("mesh", "grading"), math.inf, "mesh.grading = inf: must be a number >= 1 and <= 4"),
        (
            ("mesh", "grading"),
            10**400,
            f"mesh.grading = 1{56 * '0'}...: must be a number >= 1 and <= 4",
        ),
    ],
)
def test_one_mistake_is_one_line(path, value, line):
    with pytest.raises(ConfigError) as caught:
        parse_config(changed(path, value), "config.yaml")
    assert str(caught.value) == f"config.yaml: {line}"


def test_an_unknown_material_gets_the_closest_known_one():
    with pytest.raises(ConfigError) as caught:
        parse_config(changed(("sheets", 0, "material"), "latx"), "config.yaml")
    first = str(caught.value).splitlines()[0]
    start = "config.yaml: sheets[0].material = 'latx': is not in materials or variants; "
    assert first.startswith(start)
    assert "did you mean latex?" in first


def test_every_mistake_gets_its_line():
    raw = changed(STRAIN, [5, "x"])
    raw["mesh"]["grading"] = 0.5
    with pytest.raises(ConfigError) as caught:
        parse_config(raw, "config.yaml")
    keys = [line.split(" ")[1] for line in str(caught.value).splitlines()]
    assert keys == ["sheets[0].strain[0]", "sheets[0].strain[1]", "mesh.grading"]


@pytest.mark.parametrize("raw", [None, [], "text", 3])
def test_a_file_that_is_no_config_is_one_line(raw):
    with pytest.raises(ConfigError) as caught:
        parse_config(raw, "empty.yaml")
    assert str(caught.value).startswith("empty.yaml: the config = ")
    assert str(caught.value).endswith("must be a block of keys")


anything = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.text(max_size=5) | st.integers(), inner, max_size=3)
    ),
    max_leaves=5,
)
PLACES = [(key,) for key in RAW]
PLACES += [(key, inner) for key, block in RAW.items() if isinstance(block, dict) for inner in block]
PLACES += [("sheets", 0, key) for key in RAW["sheets"][0]]


@given(st.sampled_from(PLACES), anything)
def test_whatever_stands_in_a_config_is_taken_or_refused_with_lines_that_name_it(place, value):
    try:
        parse_config(changed(place, value), "c.yaml")
    except ConfigError as error:
        lines = str(error).splitlines()
        assert all(line.startswith("c.yaml: ") for line in lines)
        assert any(place[0] in line for line in lines)


def test_a_key_with_a_line_break_still_makes_one_line():
    with pytest.raises(ConfigError) as caught:
        parse_config(changed(("mesh", "cells\nacross"), 36), "c.yaml")
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize("text", ["1e-3", "1.E-3", "0.001", ".001", "+0.0010"])
def test_numbers_that_come_as_text_are_numbers(text):
    """YAML 1.1 reads 1e-3 as text, and Snakemake every number inside of --config."""
    raw = changed(("sheets", 0, "thickness"), [text])
    raw["mesh"]["cells_across"] = "36"
    study = parse_config(raw, "c")
    assert study.cases == parse_config(RAW, "c").cases
    assert study.mesh.cells_across == 36


@pytest.mark.parametrize("text", ["1_0", "0x10", " 10", "10 ", "", "1:30", "ten", "٣", "1e", "--1"])
def test_a_text_that_is_no_plain_number_is_none(text):
    for key in ("cells_across", "grading"):
        with pytest.raises(ConfigError):
            parse_config(changed(("mesh", key), text), "c")


@pytest.mark.parametrize(
    ("written", "folder"),
    [
        ("out/", "out"),
        ("./out", "out"),
        ("out//a/./b/", "out/a/b"),
        ("out/a/../b", "out/b"),
        ("/out/", "/out"),
        ("//out", "/out"),
        ("~/out", "/users/ann/out"),
        ("~", "/users/ann"),
        ("./~", "~"),
        (".", "."),
    ],
)
def test_a_path_has_one_spelling(monkeypatch, written, folder):
    monkeypatch.setenv("HOME", "/users/ann")
    raw = changed(("folders",), dict.fromkeys(RAW["folders"], written))
    raw["materials"]["latex"]["data"] = written
    study = parse_config(raw, "c")
    assert set(study.folders.model_dump().values()) == {folder}
    assert study.materials["latex"].data == folder


@pytest.fixture
def places(tmp_path, monkeypatch):
    """A folder with a config and what it names; returns a function that reads another one."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "data").mkdir()
    for material in RAW["materials"].values():
        (tmp_path / material["data"]).touch()

    def load(path, value):
        raw = changed(path, value)
        (tmp_path / "my.yaml").write_text(yaml.safe_dump(raw))
        return load_config(raw, [tmp_path / "my.yaml"])

    return load


def test_places_that_are_not_there_yet_are_no_mistake(places):
    assert places(("folders", "results"), "new/one").folders.results == "new/one"


@pytest.mark.parametrize(
    ("path", "value", "line"),
    [
        (
            ("materials", "latex", "data"),
            "data",
            "materials.latex.data = 'data': must be a CSV file; it is a folder",
        ),
        (
            ("materials", "latex", "data"),
            "data/none.csv",
            "materials.latex.data = 'data/none.csv': must be a CSV file; there is no such file",
        ),
        (
            ("folders", "figures"),
            "data/treloar1944.csv/figures",
            "folders.figures = 'data/treloar1944.csv/figures': must be a folder; "
            "data/treloar1944.csv is a file",
        ),
        (
            ("folders", "experiment"),
            "my.yaml",
            "folders.experiment = 'my.yaml': must be a folder; my.yaml is a file",
        ),
    ],
)
def test_a_place_of_the_wrong_kind_is_one_line(places, path, value, line):
    with pytest.raises(ConfigError) as caught:
        places(path, value)
    assert str(caught.value) == f"my.yaml: {line}"


def test_the_default_study_has_the_sheets_of_the_paper():
    study = parse_config(RAW, "config.yaml")
    assert study.figure_sheet == StudySheet("latex", 2.0, 1e-3)
    paper = [k / 50 for k in range(1, 26)]
    assert set(paper) <= {case.strain for case in study.cases_of(study.figure_sheet)}
    aspects = {sheet.aspect for sheet in same_thickness(study)}
    assert aspects >= {1.5, 1.8, 2.0, 2.5, 3.0, 3.5}
    thicknesses = {sheet.thickness for sheet in same_aspect(study)}
    assert thicknesses >= {5e-4, 7e-4, 1e-3, 1.2e-3, 1.4e-3, 1.6e-3}
    laws = {study.materials[study.base(one.material)].law for one in study.compared_sheets}
    assert laws == {"mooney-rivlin", "neo-hookean", "svk"}
    assert study.study == study.catalogue.name == "panaitescu2019"
    assert study.figures_to_make == study.catalogue.figures


@pytest.mark.parametrize(
    ("path", "value", "line"),
    [
        (
            ("study",),
            "panaitescu",
            "study = 'panaitescu': must be one of beyond, imperfections, literature, "
            "panaitescu2019, or a ",
        ),
        (("study",), 2019, "study = 2019: must be text"),
        (("figures", "names"), [], "figures.names = []: must be a list with at least one entry"),
        (
            ("figures", "names"),
            ["fig07_width", "fig07_with"],
            "figures.names[1] = 'fig07_with': is no figure of panaitescu2019; did you mean "
            "fig07_width? allowed: fig01_stress, ",
        ),
    ],
)
def test_study_and_figures_are_checked_against_the_catalogue(path, value, line):
    with pytest.raises(ConfigError) as caught:
        parse_config(changed(path, value), "c")
    assert str(caught.value).startswith(f"c: {line}")


def test_the_figures_that_are_named_are_made_in_the_order_given():
    study = parse_config(changed(("figures", "names"), ["fig07_width", "fig01_stress"]), "c")
    assert [figure.name for figure in study.figures_to_make] == ["fig07_width", "fig01_stress"]


def test_a_variant_changes_what_it_names_and_nothing_else():
    raw = changed(("variants",), {"stiff": {"material": "latex", "bending": "fixed-thickness"}})
    raw["plate"]["parity"] = "symmetric"
    raw["sheets"] = [{**RAW["sheets"][0], "material": name} for name in ("latex", "stiff")]
    raw["figures"]["compare"] = ["stiff", "latex", "stiff"]
    study = parse_config(raw, "c")
    assert study.base("stiff") == study.base("latex") == "latex"
    for stage in ("planar", "stability"):
        own, base = study.settings(stage, "stiff"), study.settings(stage, "latex")
        assert base == study.settings(stage) == {**own, "bending": "thinning"}
        assert own["bending"] == "fixed-thickness"
        assert own["parity"] == "symmetric"
    assert study.settings("wrinkle", "stiff") == study.settings("wrinkle")
    assert [sheet.material for sheet in study.compared_sheets] == ["stiff", "latex"]


def test_the_figures_compare_the_material_of_their_sheet_if_nothing_is_said():
    study = parse_config(changed(("figures", "compare"), DELETED), "c")
    assert study.compared_sheets == (study.figure_sheet,)


def test_a_key_left_out_has_the_value_of_the_library():
    """A study, the command line and a script must not differ by defaults of their own."""
    bare = {key: RAW[key] for key in ("materials", "variants", "sheets", "tension", "figures")}
    study = parse_config(bare, "bare.yaml")
    assert MeshSettings(**study.settings("mesh")) == MeshSettings()
    assert planar.PlanarSettings(**study.settings("planar")) == planar.PlanarSettings()
    assert planar.PlanarSettings(**study.settings("stability")) == planar.PlanarSettings()
    assert wrinkled.WrinkleSettings(**study.settings("wrinkle")) == wrinkled.WrinkleSettings()
    assert parse_config(RAW, "config.yaml").model_dump() == study.model_dump()


def test_the_entries_of_an_analysis_are_joined_by_model_and_length():
    entries = [
        {"material": "latex-fvk", "aspect": [3, 2.0], "strain": [0.2, 0.1]},
        {
            "material": "latex-fvk",
            "aspect": [2],
            "strain": {"start": 0.2, "stop": 0.3, "step": 0.1},
        },
    ]
    study = parse_config(changed(("maps",), entries), "c")
    assert study.maps == {
        ("latex-fvk", 2.0): (0.1, 0.2, 0.3),
        ("latex-fvk", 3.0): (0.1, 0.2),
    }
    assert study.analyses("map") == study.maps
    assert study.tension == parse_config(RAW, "config.yaml").tension


def test_a_law_is_refused_with_a_bending_law_that_does_not_go_with_it():
    raw = changed(("materials", "latex"), {"law": "foppl-von-karman", "constants": {"young": 1e6}})
    with pytest.raises(ConfigError) as refused:
        parse_config(raw, "config.yaml")
    line = "materials.latex: bending = 'thinning': must be fvk with the law foppl-von-karman"
    assert line in str(refused.value)


def test_a_law_without_a_tension_field_is_refused_before_any_job():
    """It bends by one law alone, so that no sheet may name it with another either."""
    raw = changed(("materials", "membrane"), MEMBRANE)
    raw["tension"] = [*raw["tension"], {"material": "membrane", "aspect": [2], "strain": [0.1]}]
    line = (
        "config.yaml: tension[1].material = 'membrane': law foppl-von-karman: has no tension "
        "field, its strain is linear in the plane"
    )
    with pytest.raises(ConfigError) as caught:
        parse_config(raw, "config.yaml")
    assert str(caught.value) == line
