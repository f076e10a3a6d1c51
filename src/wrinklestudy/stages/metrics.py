"""The metrics stage: the table of the states of one sheet."""

from collections.abc import Sequence

from wrinklestudy.results.rows import refuse_twins
from wrinklestudy.results.states import measure_state
from wrinklestudy.results.tables import write_states
from wrinklestudy.typing import AnyPath


def run(wrinkle: Sequence[AnyPath], output: AnyPath) -> None:
    """Write the table of the wrinkle files of one sheet.

    Rows are sorted by case and strain, whatever the order of the files, and numbers are
    written with all their digits, so that the same files give the same bytes. No state
    is left out: a state that did not converge is a row without measures.

    Parameters
    ----------
    wrinkle : sequence of path-like
        Files of the wrinkle stage.
    output : path-like
        CSV file to write, columns of `results.rows.StateRow`.

    Raises
    ------
    ValueError
        If a file lacks something or two files hold the same case; one line that names the file.
    """
    states = [measure_state(path) for path in wrinkle]
    refuse_twins(states, wrinkle)
    write_states(states, output)
