"""The gate stage, last in a study: it fails unless enough of the cases converged."""

from collections import Counter
from os import fspath

from wrinklestudy.files.storage import write_json
from wrinklestudy.results.tables import read_states
from wrinklestudy.typing import AnyPath

_NAMED = ("material", "aspect", "thickness", "strain")
_SHOWN = 5


class GateError(ValueError):
    """More cases than allowed did not converge."""


def run(states: AnyPath, allow_not_converged: int, study: str, output: AnyPath) -> None:
    """Count the cases by status and write the counts, if enough of them converged.

    Parameters
    ----------
    states : path-like
        Table of all states, of the summary stage.
    allow_not_converged : int
        Number of cases that may have the status ``not-converged``.
    study : str
        Digest of all that the study depends on; a study whose digest is in the output is finished.
    output : path-like
        JSON file with the counts and the digest.

    Raises
    ------
    GateError
        If there are more than allowed; the message names the first. Nothing is written.
    ValueError
        If the table lacks a column or a cell is not what its column allows.
    """
    rows = read_states(states)
    failed = [row for row in rows if row.status == "not-converged"]
    if len(failed) > allow_not_converged:
        shown = [" ".join(f"{name}={getattr(row, name)}" for name in _NAMED) for row in failed]
        shown = shown[:_SHOWN]
        more = ["..."] if len(failed) > _SHOWN else []
        raise GateError(
            f"{fspath(states)}: {len(failed)} of {len(rows)} cases have not converged "
            f"(gate.allow_not_converged = {allow_not_converged}): {'; '.join(shown + more)}"
        )
    by_status = Counter(row.status for row in rows)
    write_json(output, {"cases": len(rows), "by_status": by_status, "study": study})
