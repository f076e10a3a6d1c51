import os
import sys
from pathlib import Path

from wrinklestudy.cases import (
    NAME_PATTERN,
    VALUE_PATTERN,
    Case,
    Paths,
    Sheet,
    parse_value,
)
from wrinklestudy.config import ConfigError, parse_config
from wrinklestudy.digest import code_digest
from wrinklestudy.figures import state_strains

# a file given with --configfile stands first: it goes over config.yaml
CONFIG_FILES = " over ".join(os.path.relpath(file) for file in workflow.configfiles)
try:
    STUDY = parse_config(config, CONFIG_FILES)
except ConfigError as error:
    sys.exit(str(error))

PATHS = Paths(STUDY.folders.results, STUDY.folders.figures)
CASES = STUDY.cases
SHEETS = sorted({case.sheet for case in CASES})


wildcard_constraints:
    material=NAME_PATTERN,
    figure=NAME_PATTERN,
    aspect=VALUE_PATTERN,
    resolved=VALUE_PATTERN,
    thickness=VALUE_PATTERN,
    strain=VALUE_PATTERN,


def code(stage, *modules):
    """Digest of the code of a stage, and of modules that its script does not name."""
    return code_digest(Path(workflow.basedir, "workflow", "scripts", f"{stage}.py"), modules)


def value(wildcard):
    """The number in a wildcard, as a function for params."""
    return lambda wildcards: parse_value(wildcards[wildcard])


def sheet_of(wildcards):
    return Sheet(
        wildcards.material,
        parse_value(wildcards.aspect),
        parse_value(wildcards.thickness),
    )


def planar_of_case(wildcards):
    return PATHS.planar(Case(sheet_of(wildcards), parse_value(wildcards.strain)))


def planar_of_sheet(wildcards):
    sheet = sheet_of(wildcards)
    return [PATHS.planar(case) for case in CASES if case.sheet == sheet]


def mesh_of_sheet(wildcards):
    sheet = sheet_of(wildcards)
    return PATHS.of("mesh", aspect=sheet.aspect, resolved=sheet.resolved)


def material_setting(key):
    """A setting of the material in the wildcard, as a function for params."""
    return lambda wildcards: getattr(STUDY.materials[wildcards.material], key)


def inputs_of_figure(wildcards):
    """Only what a figure shows: the materials, a few states of one sheet, or the tables."""
    if wildcards.figure == "fig01_stress":
        return {
            "materials": [PATHS.of("material", material=name) for name in sorted(STUDY.materials)],
            "data": sorted({material.data for material in STUDY.materials.values()}),
        }
    strains = [case.strain for case in CASES if case.sheet == STUDY.figure_sheet]
    shown = state_strains(wildcards.figure, strains)
    if shown:
        return {"states": [PATHS.wrinkle(Case(STUDY.figure_sheet, strain)) for strain in shown]}
    return {
        "metrics": PATHS.pattern("metrics"),
        "stability": PATHS.pattern("metrics_stability"),
    }


def all_figures():
    return expand([PATHS.figure(".pdf"), PATHS.figure(".png")], figure=sorted(STUDY.figures.names))
