"""Gate stage: the last word on a finished study, whether enough of its cases converged."""

import csv
from collections import Counter
from os import fspath

from wrinklestudy.results.files import write_json
from wrinklestudy.typing import AnyPath

_CASE = ("material", "aspect", "thickness", "strain")
_SHOWN = 5


class GateError(ValueError):
    """More cases than allowed have not converged."""


def run(states: AnyPath, allow_not_converged: int, study: str, output: AnyPath) -> None:
    """Count the cases by status and write the counts, if enough of them converged.

    Parameters
    ----------
    states : path-like
        Table of all states, of the summary stage.
    allow_not_converged : int
        Number of cases that may have the status ``not-converged``.
    study : str
        Digest of all that the study follows from; a study is finished if it is in the output.
    output : path-like
        JSON file with the counts and the digest.

    Raises
    ------
    GateError
        If there are more; the message names the first of them. Nothing is written.
    """
    with open(states, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    failed = [row for row in rows if row["status"] == "not-converged"]
    if len(failed) > allow_not_converged:
        shown = [" ".join(f"{key}={row[key]}" for key in _CASE) for row in failed[:_SHOWN]]
        more = ["..."] if len(failed) > _SHOWN else []
        raise GateError(
            f"{fspath(states)}: {len(failed)} of {len(rows)} cases have not converged "
            f"(gate.allow_not_converged = {allow_not_converged}): {'; '.join(shown + more)}"
        )
    by_status = Counter(row["status"] for row in rows)
    write_json(output, {"cases": len(rows), "by_status": by_status, "study": study})
