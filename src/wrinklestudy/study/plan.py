"""The files of a study, which follow from its cases and the table of stages."""

from collections.abc import Iterable, Mapping
from string import Formatter

from wrinklestudy.results.paths import STAGES, Paths, case_wildcards, filled
from wrinklestudy.study.config import StudyConfig


def files_of(study: StudyConfig, paths: Paths, stage: str) -> list[str]:
    """Return all files that a stage writes in a study, without repetitions.

    There is one job for each value of the wildcards in the paths of the stage: for each figure
    with ``{figure}``, for each further table of the claims with ``{table}``, for each material with
    ``{material}`` alone, and otherwise for each combination that the cases of the study have.
    """
    files = []
    for output in STAGES[stage].outputs:
        pattern = paths.pattern(stage, output)
        names = {name for _, name, _, _ in Formatter().parse(pattern) if name}
        jobs: Iterable[Mapping[str, str | float]]
        if names == {"figure"}:
            jobs = [{"figure": name} for name in sorted(f.name for f in study.figures_to_make)]
        elif names == {"table"}:
            jobs = [{"table": entry.name} for entry in study.catalogue.tables]
        elif names == {"material"}:
            jobs = [{"material": name} for name in sorted(study.materials)]
        else:
            jobs = [case_wildcards(case) for case in study.cases]
        files += [filled(pattern, job) for job in jobs]
    return list(dict.fromkeys(files))


def wanted_files(study: StudyConfig, paths: Paths) -> list[str]:
    """Return the files that a study is run for, except that of the gate."""
    stages = [stage for stage in STAGES if STAGES[stage].wanted]
    return [file for stage in stages for file in files_of(study, paths, stage)]


def files_on_the_way(study: StudyConfig, paths: Paths) -> list[str]:
    """Return the files that are needed to make the wanted ones."""
    *before_gate, _gate = STAGES
    stages = [stage for stage in before_gate if not STAGES[stage].wanted]
    return [file for stage in stages for file in files_of(study, paths, stage)]
