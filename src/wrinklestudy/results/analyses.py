"""The tables and files of the stages that are analyses, as figures and claims read them."""

from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING

from wrinklestudy.results.paths import STAGES
from wrinklestudy.typing import AnalysisFiles, AnyPath

if TYPE_CHECKING:
    import pandas as pd


def analysis_files(inputs: Mapping[str, AnyPath | Sequence[AnyPath]]) -> AnalysisFiles:
    """Return the files of analyses by stage and output from the named inputs of a rule.

    Parameters
    ----------
    inputs : mapping
        By ``{stage}_{output}``, such as ``map_table``: `input_name`.

    Raises
    ------
    TypeError
        If a name is not that of an output of an analysis.
    """
    names = {
        input_name(stage, output): (stage, output)
        for stage in STAGES
        if STAGES[stage].analysis
        for output in STAGES[stage].outputs
    }
    files: dict[str, dict[str, list[Path]]] = {}
    for name, paths in inputs.items():
        if name not in names:
            raise TypeError(f"{name}: not one of {', '.join(names)}")
        stage, output = names[name]
        several = [paths] if isinstance(paths, str | PathLike) else paths
        files.setdefault(stage, {})[output] = [Path(path) for path in several]
    return files


def input_name(stage: str, output: str) -> str:
    """Return the name under which a rule takes the files of an output of an analysis."""
    return f"{stage}_{output}"


def joined_table(paths: Sequence[AnyPath]) -> "pd.DataFrame":
    """Return the tables of all jobs of an analysis as one, in the order of the files.

    Numbers keep all their digits; an empty cell is NaN.

    Raises
    ------
    ValueError
        If a file is no table; one line that names it.
    """
    import pandas as pd

    tables = []
    for path in paths:
        try:
            tables.append(pd.read_csv(path, float_precision="round_trip"))
        except (pd.errors.ParserError, pd.errors.EmptyDataError, UnicodeDecodeError) as error:
            message = str(error).strip().splitlines()[-1]
            raise ValueError(f"{fspath(path)}: is not a table ({message})") from None
    return pd.concat(tables, ignore_index=True)
