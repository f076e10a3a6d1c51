"""The schema that editors use takes what the program takes, and refuses what it refuses."""

import copy
import json
import re
from pathlib import Path

import jsonschema
import pytest
import yaml

from wrinklestudy.study.config import ConfigError, parse_config
from wrinklestudy.study.config.schema import schema, text
from wrinklestudy.vocabulary import ASPECT

ROOT = Path(__file__).parents[3]
WRITTEN = ROOT / "config" / "schema.json"
CONFIGS = [ROOT / "config.yaml", *sorted((ROOT / "config").glob("*.yaml"))]
RAW = yaml.safe_load((ROOT / "config.yaml").read_text())


@pytest.fixture(scope="module")
def validator():
    jsonschema.Draft202012Validator.check_schema(schema())
    return jsonschema.Draft202012Validator(schema())


def test_the_schema_in_the_project_is_that_of_the_models():
    assert WRITTEN.read_text() == text(schema()), "run make schema"


@pytest.mark.parametrize("path", CONFIGS, ids=lambda path: path.name)
def test_a_config_of_the_project_fits_the_schema_that_it_names(validator, path):
    named = re.match(r"# yaml-language-server: \$schema=(\S+)\n", path.read_text())
    assert named is not None
    assert (path.parent / named[1]).resolve() == WRITTEN.resolve()
    validator.validate(yaml.safe_load(path.read_text()))


def changed(path, value):
    raw = copy.deepcopy(RAW)
    block = raw
    for part in path[:-1]:
        block = block[part]
    block[path[-1]] = value
    return raw


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (("sheets", 0, "aspect"), [25]),
        (("sheets", 0, "thickness"), [0.06]),
        (("sheets", 0, "thickness"), [0]),
        (("sheets", 0, "strain"), [1.2]),
        (("sheets", 0, "strain"), []),
        (("sheets", 0, "strain"), {"start": 0.1, "stop": 0.2}),
        (("sheets", 0, "material"), "Latex"),
        (("sheets", 0), {"material": "latex"}),
        (("sheets",), []),
        (("materials", "latex", "law"), "hooke"),
        (("materials", "latex", "stretch"), [1.0]),
        (("materials", "latex", "modes"), ["torsion"]),
        (("materials", "latex", "branch"), "up"),
        (("materials", "latex", "cycle"), 1.5),
        (("materials", "latex", "preload"), "shift"),
        (("materials", "Latex"), RAW["materials"]["latex"]),
        (("materials", "latex", "data"), "data/{name}.csv"),
        (("materials", "latex", "constants"), {"c10": "soft"}),
        (("maps",), [{"material": "latex", "aspect": [0.1], "strain": [0.1]}]),
        (("tension",), [{"material": "latex", "aspect": [2]}]),
        (("mesh", "cells_across"), True),
        (("mesh", "cells_across"), 20.5),
        (("mesh", "grading"), 0.9),
        (("mesh", "gradng"), 1.5),
        (("plate", "bending"), "thick"),
        (("solver", "tolerance"), 0),
        (("folders", "results"), ""),
        (("folders",), None),
        (("gate", "allow_not_converged"), -1),
        (("figures", "names"), ["Fig. 5"]),
        (("nonsense",), {}),
    ],
)
def test_the_schema_refuses_what_the_program_refuses(validator, path, value):
    raw = changed(path, value)
    assert not validator.is_valid(raw)
    with pytest.raises(ConfigError):
        parse_config(raw, "c")


@pytest.mark.parametrize(
    "short",
    [
        {},
        {"figures": {"compare": ["latex"]}},
        {"figures": {"sheet": {"aspect": 3.0}}},
        {"materials": {"latex": {"law": "svk"}}},
        {"variants": {"latex-fvk": {"parity": "symmetric"}}},
        {"mesh": {"cells_across": 20}},
    ],
)
def test_a_short_file_need_hold_only_what_differs(validator, short):
    assert not list(validator.iter_errors(short))


def test_an_entry_of_a_list_is_whole_in_a_short_file_too(validator):
    assert not validator.is_valid({"sheets": [{"material": "latex"}]})


def test_limits_descriptions_and_units_reach_the_editor():
    entry = schema()["$defs"]["SheetsBlock"]["properties"]["aspect"]
    assert entry["description"] == "length over width, L/W"
    assert (entry["items"]["minimum"], entry["items"]["maximum"]) == (ASPECT.lowest, ASPECT.highest)
    assert entry["items"]["unit"] == "L/W"
    described = json.loads(WRITTEN.read_text())["$defs"]
    for name, block in described.items():
        assert all("description" in key for key in block["properties"].values()), name
