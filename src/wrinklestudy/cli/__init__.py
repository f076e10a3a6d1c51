"""Command line: a sheet, its stability, a fit, scans. Results go to stdout, progress to stderr."""

import gc
import os
import sys
from collections.abc import Sequence

from wrinklestudy.cli.origin_of_command import stating
from wrinklestudy.cli.output import answer_of, discard, put
from wrinklestudy.cli.outputs import WriteError
from wrinklestudy.cli.parser import COMMANDS, parse
from wrinklestudy.vocabulary import one_line

# New objects before Python looks for garbage: imports make many, and none of them is garbage.
_OBJECTS = 100_000
_INTERRUPTED = 130  # 128 + SIGINT, as shells have it


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status.

    Returns
    -------
    int
        0; 1 if something did not converge, could not be computed or written; 2 for input that is
        not allowed; 130 if interrupted.
    """
    # The factorisations are small: more threads than one only get in each other's way.
    for name in ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    gc.set_threshold(_OBJECTS)
    words = sys.argv[1:] if argv is None else argv
    name = next((f"wrinklestudy {word}" for word in words[:1] if word in COMMANDS), "wrinklestudy")
    try:
        return _run(name, words)
    except KeyboardInterrupt:
        return _end(name, "interrupted", _INTERRUPTED)
    except BrokenPipeError:  # nobody reads what stderr says
        discard(sys.stderr)
        return 0
    except MemoryError as error:
        return _end(name, str(error) or "not enough memory", 1)
    except (ArithmeticError, WriteError) as error:
        return _end(name, str(error), 1)
    except (ValueError, OSError) as error:
        return _end(name, str(error), 2)


def _run(name: str, words: Sequence[str]) -> int:
    try:
        arguments = parse(words)
    except SystemExit:
        put("")  # the help may be what cannot be written
        raise
    command = COMMANDS[arguments.command]
    with stating(arguments.command, arguments, command.run.__module__):
        answer = answer_of(command.run(arguments))
    text = answer.text
    if arguments.json:
        from wrinklestudy.files.storage import format_json

        text = format_json(answer.values)
    put(text)
    for failure in answer.failures:
        _end(name, failure, 1)
    return 1 if answer.failures else 0


def _end(name: str, message: str, status: int) -> int:
    """Say in one line why the command ends, and return its exit status."""
    print(f"{name}: {one_line(message)}", file=sys.stderr)
    return status
