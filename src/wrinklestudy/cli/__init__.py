"""Command line: a sheet, its stability, a fit, scans. Results go to stdout, progress to stderr."""

import os
import sys
from collections.abc import Sequence

from wrinklestudy.cli.output import print_text
from wrinklestudy.cli.parser import COMMANDS, parse


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status: 0, or 2 for input that is not allowed."""
    # The factorisations are small: more threads than one only get in each other's way.
    for name in ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    arguments = parse(sys.argv[1:] if argv is None else argv)
    command = COMMANDS[arguments.command]
    try:
        result = command.run(arguments)
    except (ValueError, ArithmeticError, OSError) as error:
        print(f"wrinklestudy {arguments.command}: {error}", file=sys.stderr)
        return 2
    if arguments.json:
        from wrinklestudy.files.storage import format_json

        print(format_json(result), end="")
    elif command.text is not None:
        print(command.text(result))
    else:
        print_text(result)
    return 0
