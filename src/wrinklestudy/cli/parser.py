"""The parser: which commands there are, and numbers as values of options."""

import argparse
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from wrinklestudy.cli import fit, measure, solve, stability


class Command(NamedTuple):
    """A command: its options, the function that runs it, and its result as text."""

    help: str
    add_options: Callable[[argparse.ArgumentParser], None]
    run: Callable[[argparse.Namespace], Any]
    text: Callable[[Any], str] | None = None


COMMANDS = {
    "solve": Command("state of one sheet at one or more strains", solve.add_options, solve.run),
    "stability": Command(
        "birth and decay strain of one sheet", stability.add_options, stability.run
    ),
    "fit": Command("constants of a law from measured stress and strain", fit.add_options, fit.run),
    "measure": Command(
        "amplitude and wavelength of scanned profiles",
        measure.add_options,
        measure.run,
        measure.text,
    ),
}


def parse(argv: Sequence[str]) -> argparse.Namespace:
    """Return the arguments of a command line without the name of the program.

    Only the command that is asked for gets its options: they come from the registry of laws, which
    needs numpy, and `--help` alone does without.
    """
    parser = argparse.ArgumentParser(
        prog="wrinklestudy", description="Wrinkles in stretched hyperelastic sheets."
    )
    commands = parser.add_subparsers(dest="command", required=True)
    for name, command in COMMANDS.items():
        sub = commands.add_parser(name, help=command.help)
        if name in argv[:1]:
            command.add_options(sub)
            sub.add_argument("--json", action="store_true", help="print JSON")
    return parser.parse_args([_as_value(text) for text in argv])


def _as_value(text: str) -> str:
    """Return a negative number with a space before it, which no option has.

    argparse takes -1.5 for a number but -3.1e4 for an option.
    """
    if not text.startswith("-"):
        return text
    try:
        float(text)
    except ValueError:
        return text
    return f" {text}"
