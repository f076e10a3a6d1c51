"""The metrics stage: the table of the states of one sheet."""

from collections.abc import Sequence

from wrinklestudy.results.table import CASE, COLUMNS, measure_state, refuse_twins, write_table
from wrinklestudy.typing import AnyPath


def run(wrinkle: Sequence[AnyPath], output: AnyPath) -> None:
    """Write the table of the wrinkle files of one sheet.

    Rows are sorted by case and strain, whatever the order of the files, and numbers are
    written with all their digits, so that the same files give the same bytes. No state
    is left out: one that did not converge is a row without measures.

    Parameters
    ----------
    wrinkle : sequence of path-like
        Files of the wrinkle stage.
    output : path-like
        CSV file to write.

    Raises
    ------
    ValueError
        If a file lacks something or two files hold the same case; one line that names the file.
    """
    key = (*CASE, "strain")
    states = [measure_state(path) for path in wrinkle]
    refuse_twins(states, key, wrinkle)
    write_table(states, COLUMNS, key, output)
