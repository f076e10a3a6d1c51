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
from wrinklestudy.studies.panaitescu2019.figures import FIGURES
from wrinklestudy.study.config import ConfigError, parse_config
from wrinklestudy.study.config_figures import sheets_shown

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


@pytest.mark.parametrize(
    ("path", "value", "line"),
    [
        (
            ("sheets", 0, "thickness"),
            [1e-3, -0.001],
            "sheets[0].thickness[1] = -0.001: must be a number > 0 and <= 0.05 (t/W)",
        ),
        (STRAIN, [], "sheets[0].strain = []: must be a list with at least one entry"),
        (STRAIN, [0.1, 5], "sheets[0].strain[1] = 5: must be a number > 0 and <= 1"),
        (STRAIN, [0.0], "sheets[0].strain[0] = 0.0: must be a number > 0 and <= 1"),
        (STRAIN, [True], "sheets[0].strain[0] = true: must be a number > 0 and <= 1"),
        (STRAIN, [None], "sheets[0].strain[0] = null: must be a number > 0 and <= 1"),
        (STRAIN, ["0_1"], "sheets[0].strain[0] = '0_1': must be a number > 0 and <= 1"),
        (STRAIN, [math.nan], "sheets[0].strain[0] = nan: must be a number > 0 and <= 1"),
        (STRAIN, 0.1, "sheets[0].strain = 0.1: must be a list with at least one entry"),
        (
            STRAIN,
            {"start": 0.3, "stop": 0.1, "step": 0.1},
            "sheets[0].strain.stop = 0.1: must be >= start = 0.3",
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
            "variants.latex-fixed.bending = 'fixed': must be 'thinning', 'fixed-thickness' or "
            "'fvk'",
        ),
        (
            ("variants", "Fixed"),
            {"material": "latex", "bending": "fvk"},
            "variants.Fixed = 'Fixed': must be a name of lower-case letters, digits, '-' and '_'",
        ),
        (("variants",), None, "variants = null: must be a block"),
        (("folders", "results"), "", "folders.results = '': must be text"),
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


def test_numbers_that_yaml_takes_for_text_are_numbers():
    raw = changed(("sheets", 0, "thickness"), ["1e-3"])
    assert parse_config(raw, "c").cases == parse_config(RAW, "c").cases


def test_the_default_study_has_the_sheets_of_the_paper():
    study = parse_config(RAW, "config.yaml")
    assert study.figure_sheet == StudySheet("latex", 2.0, 1e-3)
    paper = [k / 50 for k in range(1, 26)]
    assert set(paper) <= {case.strain for case in study.cases_of(study.figure_sheet)}
    aspects = {sheet.aspect for sheet in sheets_shown(study, "fig06_aspect")}
    assert aspects >= {1.5, 1.8, 2.0, 2.5, 3.0, 3.5}
    thicknesses = {sheet.thickness for sheet in sheets_shown(study, "fig06_thickness")}
    assert thicknesses >= {5e-4, 7e-4, 1e-3, 1.2e-3, 1.4e-3, 1.6e-3}
    laws = {study.materials[study.base(one.material)].law for one in study.compared_sheets}
    assert laws == {"mooney-rivlin", "neo-hookean", "svk"}
    assert study.figures.names == tuple(FIGURES)


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
    bare = {key: RAW[key] for key in ("materials", "variants", "sheets", "figures")}
    study = parse_config(bare, "bare.yaml")
    assert MeshSettings(**study.settings("mesh")) == MeshSettings()
    assert planar.PlanarSettings(**study.settings("planar")) == planar.PlanarSettings()
    assert planar.PlanarSettings(**study.settings("stability")) == planar.PlanarSettings()
    assert wrinkled.WrinkleSettings(**study.settings("wrinkle")) == wrinkled.WrinkleSettings()
    assert parse_config(RAW, "config.yaml").model_dump() == study.model_dump()
