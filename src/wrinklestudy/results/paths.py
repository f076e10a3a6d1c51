"""The stages of a study and the paths of their files, which are made nowhere else."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import PurePosixPath

from wrinklestudy.files import records
from wrinklestudy.results.cases import Case, StudySheet, format_value


@dataclass(frozen=True)
class Stage:
    """What a stage writes.

    Parameters
    ----------
    outputs : mapping
        Name of each output file in the rule, and its path below the folder of the stage. The
        wildcards say what each job is for; logs and run times are named after the first output.
    wanted : bool
        Whether a study is run for these files; others are only needed on the way to them.
    analysis : bool
        Whether it has a block of its own in the config, with a job for each model and L/W, or each
        imperfect sheet, there; figures and claims read its output ``table``.
    """

    outputs: Mapping[str, str]
    wanted: bool = False
    analysis: bool = False


_SHEET = "{material}/aspect{aspect}_thickness{thickness}"
_FLAT = "{material}/aspect{aspect}_resolves{resolved}"

# In the order in which they run. The module of a stage in `wrinklestudy.stages` and its rule in
# workflow/rules have the same name. The gate comes last: a study that has its file is finished.
STAGES: Mapping[str, Stage] = {
    "material": Stage({"fit": "{material}.json"}),
    "mesh": Stage({"mesh": "aspect{aspect}_resolves{resolved}.vtu"}),
    "planar": Stage({"state": f"{_FLAT}/strain{{strain}}.h5"}),
    "stability": Stage({"limits": f"{_SHEET}.json"}),
    "map": Stage({"table": "{material}/aspect{aspect}.csv"}, analysis=True),
    "tension": Stage(
        {"table": "{material}/aspect{aspect}.csv", "fields": "{material}/aspect{aspect}.h5"},
        analysis=True,
    ),
    "compression": Stage({"table": "{material}/aspect{aspect}.csv"}, analysis=True),
    "imperfection": Stage({"table": f"{_SHEET}/{{imperfection}}.csv"}, analysis=True),
    "wrinkle": Stage({"state": f"{_SHEET}/strain{{strain}}.h5"}),
    "metrics": Stage({"table": f"{_SHEET}.csv"}),
    "summary": Stage(
        {"states": "states.csv", "stability": "stability.csv", "peaks": "peaks.csv"},
    ),
    "figures": Stage(
        {"pdf": "{figure}.pdf", "png": "{figure}.png", "csv": "{figure}.csv"}, wanted=True
    ),
    "claims": Stage(
        {
            "csv": "claims.csv",
            "page": "claims.html",
            "markdown": "claims.md",
            "tables": "{table}.csv",
        },
        wanted=True,
    ),
    "gate": Stage({"counts": "gate.json"}),
}


@dataclass(frozen=True)
class Paths:
    """Where the files of a study lie.

    Parameters
    ----------
    results : str
        Folder of the results, with a folder for each stage, one for logs, one for run times and one
        for the record of each file (`files.records`).
    figures : str
        Folder of the figures, and of their records.
    """

    results: str = "results"
    figures: str = "figures"

    def pattern(self, stage: str, output: str | None = None) -> str:
        """Return the path of an output of a stage, the first by default, with its wildcards."""
        outputs = STAGES[stage].outputs
        path = outputs[output] if output is not None else next(iter(outputs.values()))
        if stage == "figures":
            return PurePosixPath(self.figures, path).as_posix()
        return PurePosixPath(self.results, stage, path).as_posix()

    def log(self, stage: str) -> str:
        """Return the path of a stage's log files, with the wildcards of its first output."""
        return self._about(stage, "log", ".log")

    def benchmark(self, stage: str) -> str:
        """Return the path of a stage's run times, with the wildcards of its first output."""
        return self._about(stage, "benchmark", ".tsv")

    def record(self, path: str) -> str:
        """Return the path of the record of a file of a stage (`files.records`), or of a pattern."""
        file = PurePosixPath(path)
        root = self.results if file.is_relative_to(self.results) else self.figures
        below = file.relative_to(root).with_name(f"{file.name}.json")
        return PurePosixPath(root, records.FOLDER, below).as_posix()

    def records(self, stage: str) -> list[str]:
        """Return the paths of the records of all outputs of a stage, with their wildcards."""
        return [self.record(self.pattern(stage, output)) for output in STAGES[stage].outputs]

    def _about(self, stage: str, folder: str, suffix: str) -> str:
        first = next(iter(STAGES[stage].outputs.values())).rpartition(".")[0]
        return PurePosixPath(self.results, folder, stage, f"{first}{suffix}").as_posix()

    def of(self, stage: str, **wildcards: str | float) -> str:
        """Return the path of the first output of a stage."""
        return filled(self.pattern(stage), wildcards)

    def of_sheet(self, stage: str, sheet: StudySheet) -> str:
        """Return the first output of a stage for a sheet: its mesh, stability or metrics."""
        return filled(self.pattern(stage), sheet_wildcards(sheet))

    def of_case(self, stage: str, case: Case) -> str:
        """Return the first output of a stage for a case: its flat state or its equilibrium."""
        return filled(self.pattern(stage), case_wildcards(case))


def filled(pattern: str, wildcards: Mapping[str, str | float]) -> str:
    """Return a path with its wildcards filled in, names as they are, numbers as in file names."""
    texts = {
        name: value if isinstance(value, str) else format_value(value)
        for name, value in wildcards.items()
    }
    return pattern.format(**texts)


def sheet_wildcards(sheet: StudySheet) -> dict[str, str | float]:
    """Return the values of all wildcards that a sheet has."""
    return {
        "material": sheet.material,
        "aspect": sheet.aspect,
        "thickness": sheet.thickness,
        "resolved": sheet.resolved,
    }


def case_wildcards(case: Case) -> dict[str, str | float]:
    """Return the values of all wildcards that a case has."""
    return {**sheet_wildcards(case.sheet), "strain": case.strain}
