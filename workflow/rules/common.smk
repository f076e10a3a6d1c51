import functools
import hashlib
import json
import os
import re
import sys
from dataclasses import astuple
from pathlib import Path

from wrinklestudy.study import figure_contents
from wrinklestudy.results.cases import (
    NAME_PATTERN,
    VALUE_PATTERN,
    Case,
    StudySheet,
    parse_value,
)
from wrinklestudy.results.paths import Paths
from wrinklestudy.study.config import ConfigError, parse_config
from wrinklestudy.study.digest import code_digest
from wrinklestudy.study.loading import claim_modules, sources

# a file given with --configfile stands first: it goes over config.yaml
CONFIG_FILES = " over ".join(os.path.relpath(file) for file in workflow.configfiles)
try:
    STUDY = parse_config(config, CONFIG_FILES)
except ConfigError as error:
    sys.exit(str(error))

CATALOGUE = STUDY.catalogue
# for the first page of the report, which sees nothing but the config
config["report"] = {"title": CATALOGUE.title, "citation": CATALOGUE.citation}

PATHS = Paths(STUDY.folders.results, STUDY.folders.figures)


# {material} is a material or a variant of one, but in files of the stage material
wildcard_constraints:
    material=NAME_PATTERN,
    figure=NAME_PATTERN,
    aspect=VALUE_PATTERN,
    resolved=VALUE_PATTERN,
    thickness=VALUE_PATTERN,
    strain=VALUE_PATTERN,


@functools.cache
def code(stage, *modules):
    """Digest of the code of a stage, and of modules that its script does not name."""
    script = Path(workflow.basedir, "workflow", "scripts", f"{stage}.py")
    return code_digest(script, modules, sources(STUDY.study))


def code_of_figure(name):
    return code("figures", CATALOGUE.figure(name).module)


def code_of_claims():
    tables = [entry.module for entry in CATALOGUE.tables]
    return code("claims", *claim_modules(STUDY.study), *tables)


def value(wildcard):
    """The number in a wildcard, as a function for params."""
    return lambda wildcards: parse_value(wildcards[wildcard])


def settings(stage):
    """The settings of a stage for the model in the wildcard, as a function for params."""
    return lambda wildcards: STUDY.settings(stage, wildcards.material)


def material_setting(key):
    """A setting of the material in the wildcard, as a function for params."""
    return lambda wildcards: getattr(STUDY.materials[wildcards.material], key)


def material_of_model(wildcards):
    return PATHS.of("material", material=STUDY.base(wildcards.material))


def sheet_of(wildcards):
    return StudySheet(
        wildcards.material,
        parse_value(wildcards.aspect),
        parse_value(wildcards.thickness),
    )


def mesh_of_sheet(wildcards):
    sheet = sheet_of(wildcards)
    return PATHS.of("mesh", aspect=sheet.aspect, resolved=sheet.resolved)


def planar_of_case(wildcards):
    return PATHS.planar(Case(sheet_of(wildcards), parse_value(wildcards.strain)))


def planar_of_sheet(wildcards):
    return [PATHS.planar(case) for case in STUDY.cases_of(sheet_of(wildcards))]


def wrinkle_of_sheet(wildcards):
    return [PATHS.wrinkle(case) for case in STUDY.cases_of(sheet_of(wildcards))]


def inputs_of_figure(wildcards):
    """Only what a figure shows: materials, tables of some sheets, states, measurements."""
    figure = CATALOGUE.figure(wildcards.figure)
    materials = figure_contents.materials_shown(STUDY, figure)
    sheets = figure_contents.sheets_shown(STUDY, figure)
    return {
        "materials": [PATHS.of("material", material=name) for name in materials],
        "data": sorted({STUDY.materials[name].data for name in materials}),
        "metrics": [PATHS.of_sheet("metrics", sheet) for sheet in sheets],
        "stability": [PATHS.of_sheet("stability", sheet) for sheet in sheets],
        "states": [PATHS.wrinkle(case) for case in figure_contents.states_shown(STUDY, figure)],
        "experiment": figure_contents.measured(STUDY, figure),
    }


def all_figures():
    names = sorted(figure.name for figure in STUDY.figures_to_make)
    return expand([PATHS.figure(".pdf"), PATHS.figure(".png")], figure=names)


def all_sheets(output):
    return [PATHS.of_sheet(output, sheet) for sheet in STUDY.all_sheets]


def of_figure(content):
    """A part of what the report says of the figure in the wildcard, as a function."""
    return lambda wildcards: content(STUDY, CATALOGUE.figure(wildcards.figure))


def extra_tables():
    return [PATHS.of("claims_table", table=entry.name) for entry in CATALOGUE.tables]


def final_files():
    """What a study is run for but the gate; everything else is made on the way."""
    return [*all_figures(), *map(PATHS.pattern, ("claims", "claims_page")), *extra_tables()]


def files_on_the_way():
    sheets = STUDY.all_sheets
    found = [PATHS.of("material", material=name) for name in STUDY.materials]
    found += [PATHS.of("mesh", aspect=one.aspect, resolved=one.resolved) for one in sheets]
    found += [path for case in STUDY.cases for path in (PATHS.planar(case), PATHS.wrinkle(case))]
    found += [*all_sheets("stability"), *all_sheets("metrics")]
    return [*found, *map(PATHS.pattern, ("summary", "summary_stability", "summary_peaks"))]


def study_digest():
    """Digest of all that the results follow from: config, code, measured data."""
    stages = ("material", "mesh", "planar", "stability", "wrinkle", "metrics", "summary", "gate")
    codes = [*map(code, stages), code_of_claims()]
    codes += [code_of_figure(figure.name) for figure in STUDY.figures_to_make]
    files = {material.data for material in STUDY.materials.values()}
    files |= {
        path for figure in STUDY.figures_to_make for path in figure_contents.measured(STUDY, figure)
    }
    digest = hashlib.sha256("\0".join([STUDY.model_dump_json(), *codes]).encode())
    for path in sorted(path for path in files if Path(path).exists()):
        digest.update(path.encode() + b"\0" + Path(path).read_bytes())
    return digest.hexdigest()[:16]


def targets(_wildcards):
    """All that is wanted; of a finished study only what it has lost since, if anything.

    Snakemake would leave a lost file alone as long as nothing needs it, and once it makes it again,
    run everything that comes after it.
    """
    gate = Path(PATHS.pattern("gate"))
    if gate.exists() and json.loads(gate.read_text()).get("study") == study_digest():
        lost = [one for one in (*files_on_the_way(), *final_files()) if not Path(one).exists()]
        if lost:
            return lost
    return [*final_files(), gate.as_posix()]
