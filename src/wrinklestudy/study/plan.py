"""The files of a study, which follow from its cases and the table of stages."""

from collections.abc import Iterable, Mapping
from string import Formatter

from wrinklestudy.results.paths import STAGES, Paths, case_wildcards, filled
from wrinklestudy.study.config import StudyConfig


def files_of(study: StudyConfig, paths: Paths, stage: str) -> list[str]:
    """Return all files that a stage writes in a study, without repetitions.

    There is one job for each value of the wildcards in the paths of the stage: for each figure
    with ``{figure}``, for each further table of the claims with ``{table}``, for each material with
    ``{material}`` alone, for each model and L/W or each imperfect sheet in the block of an
    analysis, and otherwise for each combination that the cases of the study have.
    """
    outputs = STAGES[stage].outputs
    return [file for output in outputs for file in files_of_output(study, paths, stage, output)]


def files_of_output(study: StudyConfig, paths: Paths, stage: str, output: str) -> list[str]:
    """Return the files of one output of a stage in a study, without repetitions."""
    pattern = paths.pattern(stage, output)
    names = {name for _, name, _, _ in Formatter().parse(pattern) if name}
    jobs: Iterable[Mapping[str, str | float]]
    if names == {"figure"}:
        jobs = [{"figure": name} for name in sorted(f.name for f in study.figures_to_make)]
    elif names == {"table"}:
        jobs = [{"table": entry.name} for entry in study.catalogue.tables]
    elif STAGES[stage].analysis:
        jobs = study.analysis_jobs(stage)
    elif names == {"material"}:
        jobs = [{"material": name} for name in sorted(study.materials)]
    else:
        jobs = [case_wildcards(case) for case in study.cases]
    return list(dict.fromkeys(filled(pattern, job) for job in jobs))


def wanted_files(study: StudyConfig, paths: Paths) -> list[str]:
    """Return the files that a study is run for, except that of the gate."""
    stages = [stage for stage in STAGES if STAGES[stage].wanted]
    return [file for stage in stages for file in files_of(study, paths, stage)]


def files_on_the_way(study: StudyConfig, paths: Paths) -> list[str]:
    """Return the files that are needed to make the wanted ones."""
    *before_gate, _gate = STAGES
    stages = [stage for stage in before_gate if not STAGES[stage].wanted]
    return [file for stage in stages for file in files_of(study, paths, stage)]
