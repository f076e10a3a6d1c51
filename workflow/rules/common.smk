import functools
import hashlib
import json
import os
import re
import shutil
import sys
from base64 import urlsafe_b64encode
from dataclasses import astuple
from pathlib import Path

from wrinklestudy.files.records import DamagedFileError, read_record
from wrinklestudy.results.analyses import input_name
from wrinklestudy.results.cases import NAME_PATTERN, VALUE_PATTERN, Case, StudySheet, parse_value
from wrinklestudy.results.imperfect_sheets import IMPERFECTION_PATTERN
from wrinklestudy.results.paths import STAGES, Paths, filled
from wrinklestudy.stages.recording import program
from wrinklestudy.study import figure_contents, holding, plan, stored, targets
from wrinklestudy.study.config import ConfigError, load_config
from wrinklestudy.study.digest import code_digest
from wrinklestudy.study.loading import claim_modules, sources

# Of the files given with --configfile the last takes precedence, and all go over config.yaml.
given = len(workflow.overwrite_configfiles)
config_files = [*reversed(workflow.configfiles[:given]), *workflow.configfiles[given:]]
try:
    STUDY = load_config(config, config_files, overridden=bool(workflow.config_settings.config))
except ConfigError as error:
    sys.exit(str(error))

CATALOGUE = STUDY.catalogue
# for the jobs, which write it into their files
config["program"] = program()
# for the first page of the report, which sees only the config
config["report"] = {"title": CATALOGUE.title, "citation": CATALOGUE.citation}

PATHS = Paths(STUDY.folders.results, STUDY.folders.figures)

# A file asked for by name need not be in the config. Snakemake tells no Snakefile its targets, and of a
# path that fits no rule it says only that; so each word of the command line that is the path of a result
# is checked here, before anything runs.
for word in sys.argv[1:]:
    if fault := targets.refusal(word, STUDY, PATHS):
        sys.exit(fault)


RUNS = workflow.is_main_process and holding.makes_files(sys.argv[1:])
if RUNS:
    HELD = holding.take_over(PATHS.results, [f"{PATHS.results}/{stage}" for stage in STAGES])


# {material} is a material or, except in files of the stage material, a variant of one
wildcard_constraints:
    material=NAME_PATTERN,
    figure=NAME_PATTERN,
    imperfection=IMPERFECTION_PATTERN,
    aspect=VALUE_PATTERN,
    resolved=VALUE_PATTERN,
    thickness=VALUE_PATTERN,
    strain=VALUE_PATTERN,


@functools.cache
def code(stage, *modules):
    """Digest of the code of a stage, and of modules that it imports by a name from the config."""
    adapter = Path(workflow.basedir, "workflow", "scripts", "stage.py")
    return code_digest(adapter, [f"wrinklestudy.stages.{stage}", *modules], sources(STUDY.study))


def code_of_figure(name):
    return code("figures", CATALOGUE.figure(name).module)


def code_of_claims():
    tables = [entry.module for entry in CATALOGUE.tables]
    return code("claims", *claim_modules(STUDY.study), *tables)


def wildcard(name):
    """The text of a wildcard, as a function for params."""
    return lambda wildcards: wildcards[name]


def value(wildcard):
    """The number in a wildcard, as a function for params."""
    return lambda wildcards: parse_value(wildcards[wildcard])


def settings(stage):
    """The settings of a stage for the model in the wildcard, as a function for params."""
    return lambda wildcards: STUDY.settings(stage, wildcards.material)


def material_setting(key):
    """A setting of the material in the wildcard, as a function for params."""
    return lambda wildcards: getattr(STUDY.materials[wildcards.material], key)


def data_of_material(wildcards):
    """The measured curve of a material; none if its constants are given."""
    data = STUDY.materials[wildcards.material].data
    return {} if data is None else {"csv": data}


def material_of_model(wildcards):
    return PATHS.of("material", material=STUDY.base(wildcards.material))


def sheet_of(wildcards):
    return StudySheet(
        wildcards.material,
        parse_value(wildcards.aspect),
        parse_value(wildcards.thickness),
    )


def imperfect_of(wildcards):
    return STUDY.imperfect_sheet(sheet_of(wildcards), wildcards.imperfection)


def thickness_table_of_imperfect(wildcards):
    """The measured thickness of an imperfect sheet, if it has any."""
    given = dict(imperfect_of(wildcards).given)
    return {key: given[key] for key in ["thickness_table"] if key in given}


def mesh_of_sheet(wildcards):
    return PATHS.of_sheet("mesh", sheet_of(wildcards))


def planar_of_case(wildcards):
    return PATHS.of_case("planar", Case(sheet_of(wildcards), parse_value(wildcards.strain)))


def planar_of_sheet(wildcards):
    return [PATHS.of_case("planar", case) for case in STUDY.cases_of(sheet_of(wildcards))]


def wrinkle_of_sheet(wildcards):
    return [PATHS.of_case("wrinkle", case) for case in STUDY.cases_of(sheet_of(wildcards))]


def files_of_analyses(stages, outputs=None):
    """The files of analyses over the whole study, under the names that figures and claims take."""
    return {
        input_name(stage, output): plan.files_of_output(STUDY, PATHS, stage, output)
        for stage in stages
        for output in STAGES[stage].outputs
        if outputs is None or output in outputs
    }


def tables_of_analyses(_wildcards):
    """The tables of all analyses, from which claims are judged."""
    return files_of_analyses([stage for stage in STAGES if STAGES[stage].analysis], ["table"])


def strains_of(stage):
    """All strains of a job of an analysis, as a function for params."""
    return lambda wildcards: STUDY.analyses(stage)[
        (wildcards.material, parse_value(wildcards.aspect))
    ]


def inputs_of_figure(wildcards):
    """What a figure shows and nothing else: materials, tables of some sheets, states, measurements."""
    figure = CATALOGUE.figure(wildcards.figure)
    materials = figure_contents.materials_shown(STUDY, figure)
    sheets = figure_contents.sheets_shown(STUDY, figure)
    return {
        "materials": [PATHS.of("material", material=name) for name in materials],
        "data": sorted({STUDY.materials[name].data for name in materials}),
        "metrics": [PATHS.of_sheet("metrics", sheet) for sheet in sheets],
        "stability": [PATHS.of_sheet("stability", sheet) for sheet in sheets],
        "states": [
            PATHS.of_case("wrinkle", case) for case in figure_contents.states_shown(STUDY, figure)
        ],
        "experiment": figure_contents.measured(STUDY, figure),
        "constants": [
            PATHS.of("material", material=name)
            for name in figure_contents.constants_shown(STUDY, figure)
        ],
        **files_of_analyses(figure.analyses),
    }


def all_sheets(output):
    return [PATHS.of_sheet(output, sheet) for sheet in STUDY.all_sheets]


def of_figure(content):
    """What the report says about the figure in the wildcard, as a function for params."""
    return lambda wildcards: content(STUDY, CATALOGUE.figure(wildcards.figure))


def code_of_file(stage, file):
    """Digest of the code that makes a file."""
    if stage == "figures":
        return code_of_figure(Path(file).stem)
    return code_of_claims() if stage == "claims" else code(stage)


def remembered(file):
    """Whether Snakemake knows how a file was made, so that it runs again what has changed."""
    name = urlsafe_b64encode(file.encode()).decode()
    return len(name) > 200 or Path(".snakemake", "metadata", name).exists()


# Files that are there and must not be used count as lost. While another run works here, some have no
# record yet.
UNSOUND = []
if RUNS or (workflow.is_main_process and not holding.is_held(PATHS.results)):
    UNSOUND = stored.unsound_files(STUDY, PATHS, code_of_file, remembered)
    for line in stored.report(UNSOUND, "removed, to be made again" if RUNS else "a run removes it"):
        print(line, file=sys.stderr)
    for unsound in UNSOUND if RUNS else ():
        Path(unsound.file).unlink()
        Path(unsound.record).unlink(missing_ok=True)
UNUSABLE = {unsound.file for unsound in UNSOUND}


def is_there(file):
    """Whether a file is there and may be used."""
    return Path(file).exists() and file not in UNUSABLE


def origin_of(file):
    """One line about how a file was made, for the report; empty before it is made."""
    try:
        made = read_record(PATHS.record(file)).made
    except (OSError, DamagedFileError):
        return ""
    versions = ", ".join(f"{name} {text}" for name, text in made["versions"].items())
    return f"{made['program']}, code {made['code']}; {versions}; {made['machine']}"


# What the report says of the files in it: their captions see the config
config["report"]["origins"] = (
    {file: origin_of(file) for file in plan.wanted_files(STUDY, PATHS)}
    | {file: origin_of(file) for file in plan.files_of(STUDY, PATHS, "summary")}
    if any(word.startswith("--report") for word in sys.argv[1:])
    else {}
)


def reason_of_stop(logs):
    """One line about a run that failed: what to do, from what Snakemake's logs say."""
    said = "".join(Path(path).read_text(errors="replace") for path in logs if Path(path).exists())
    why = "see above"
    if "Signals.SIGKILL" in said:
        why = "a job was killed, as the system does when memory is short (fewer --cores need less)"
    elif (free := shutil.disk_usage(PATHS.results).free) < 20e6:
        why = f"its disk is full ({free / 1e6:.1f} MB are free)"
    return f"{PATHS.results}: stopped, {why}; finished files are kept, the same command goes on"


def study_digest():
    """Digest of all that the results depend on: config, code, measured data."""
    codes = [code(stage) for stage in STAGES]
    codes += [code_of_claims(), *(code_of_figure(figure.name) for figure in STUDY.figures_to_make)]
    files = {material.data for material in STUDY.materials.values() if material.data is not None}
    files |= {
        series.thickness_table
        for series in STUDY.imperfection_series
        if series.thickness_table is not None
    }
    files |= {
        path for figure in STUDY.figures_to_make for path in figure_contents.measured(STUDY, figure)
    }
    digest = hashlib.sha256("\0".join([STUDY.model_dump_json(), *codes]).encode())
    for path in sorted(path for path in files if Path(path).exists()):
        digest.update(b"\0".join([path.encode(), Path(path).read_bytes()]))
    return digest.hexdigest()[:16]


def all_targets(_wildcards):
    """Everything wanted; of a finished study only the files lost since, if there are any.

    Snakemake would not miss a lost file as long as nothing needs it and, once it makes it again,
    would run everything that comes after it.
    """
    gate, wanted = PATHS.pattern("gate"), plan.wanted_files(STUDY, PATHS)
    on_the_way = plan.files_on_the_way(STUDY, PATHS)
    if is_there(gate) and json.loads(Path(gate).read_text()).get("study") == study_digest():
        lost = [file for file in (*on_the_way, *wanted) if not is_there(file)]
        if lost:
            return lost
    return [*wanted, gate, *UNUSABLE.intersection(on_the_way)]
