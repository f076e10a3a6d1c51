"""Which files a study consists of: they follow from its cases and the table of stages."""

from collections.abc import Iterable, Mapping
from string import Formatter

from wrinklestudy.results.paths import STAGES, Paths, case_wildcards, filled
from wrinklestudy.study.config import StudyConfig


def files_of(study: StudyConfig, paths: Paths, stage: str) -> list[str]:
    """Return all files that a stage writes in a study, each once.

    There is one job for each value of the wildcards in the paths of the stage: for each figure
    where there is ``{figure}``, for each further table of the claims where there is ``{table}``,
    for each material where there is nothing but ``{material}``, else for what the cases of the
    study differ in.
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
    """Return what a study is run for, but the gate."""
    stages = [stage for stage in STAGES if STAGES[stage].wanted]
    return [file for stage in stages for file in files_of(study, paths, stage)]


def files_on_the_way(study: StudyConfig, paths: Paths) -> list[str]:
    """Return what is made so that the wanted files can be made."""
    *before_gate, _gate = STAGES
    stages = [stage for stage in before_gate if not STAGES[stage].wanted]
    return [file for stage in stages for file in files_of(study, paths, stage)]
