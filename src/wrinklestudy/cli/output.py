"""Results on stdout."""

import contextlib
import os
import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from wrinklestudy.cli.outputs import WriteError


@dataclass(frozen=True)
class Answer:
    """What a command found.

    Parameters
    ----------
    values : object
        Plain values, for ``--json``.
    text : str
        The same for people.
    failures : tuple of str
        Why something could not be computed, a line each; the exit status is 1 if there is any.
    """

    values: Any
    text: str
    failures: tuple[str, ...] = ()


def answer_of(result: Any) -> Answer:
    """Return the answer that values without words of their own are: a line per value."""
    if isinstance(result, Answer):
        return result
    return Answer(result, "".join(f"{key}: {cell(value, 6)}\n" for key, value in result.items()))


def cell(value: Any, digits: int = 4) -> str:
    """Return a value as text: numbers with that many significant digits, a dash for none."""
    if value is None or value != value:
        return "-"
    return f"{value:.{digits}g}" if isinstance(value, float) else str(value)


def table(names: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """Return a table with columns as wide as they need to be, numbers on the right."""
    lines = [list(names), *([cell(value) for value in row] for row in rows)]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return "".join(
        "  ".join(text.rjust(width) for text, width in zip(line, widths, strict=True)) + "\n"
        for line in lines
    )


def wrapped(text: str) -> str:
    """Return sentences in lines as wide as a terminal, at most 80 columns."""
    import shutil
    import textwrap

    return textwrap.fill(text, min(shutil.get_terminal_size().columns, 80)) + "\n"


def put(text: str) -> None:
    """Print a text; quietly stop where nobody reads on (``| head``).

    Raises
    ------
    WriteError
        If it cannot be written (``> /dev/full``); one line.
    """
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except BrokenPipeError:
        discard(sys.stdout)
    except OSError as error:
        discard(sys.stdout)
        raise WriteError(f"standard output: cannot be written ({error.strerror})") from None


def discard(stream: Any) -> None:
    """Let what is left in the buffer of a stream go nowhere, so that Python ends in peace."""
    with contextlib.suppress(OSError, ValueError, AttributeError):
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, stream.fileno())
        os.close(null)
