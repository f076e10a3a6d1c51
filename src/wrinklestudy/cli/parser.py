"""The parser: which commands there are, and how their options are read."""

import argparse
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, NoReturn

from wrinklestudy.cli import (
    explore_command,
    film_command,
    fit,
    map_command,
    measure,
    provenance_command,
    solve,
    stability,
    tension_command,
)
from wrinklestudy.cli.numbers import is_negative
from wrinklestudy.vocabulary import one_line


class Command(NamedTuple):
    """A command: its options, and the function that runs it."""

    help: str
    add_options: Callable[[argparse.ArgumentParser], None]
    run: Callable[[argparse.Namespace], Any]


COMMANDS = {
    "solve": Command("state of one sheet at one or more strains", solve.add_options, solve.run),
    "stability": Command(
        "birth and decay strain of one sheet", stability.add_options, stability.run
    ),
    "map": Command(
        "critical thickness over strain and L/W", map_command.add_options, map_command.run
    ),
    "tension-field": Command(
        "state of a sheet in the limit of no thickness",
        tension_command.add_options,
        tension_command.run,
    ),
    "explore": Command(
        "page to look at a study or a sheet in a browser",
        explore_command.add_options,
        explore_command.run,
    ),
    "film": Command(
        "film of a sheet from birth to decay", film_command.add_options, film_command.run
    ),
    "fit": Command("constants of a law from measured stress and strain", fit.add_options, fit.run),
    "measure": Command(
        "amplitude and wavelength of scanned profiles",
        measure.add_options,
        measure.run,
    ),
    "provenance": Command(
        "config, code, versions and mesh that a figure, table or state was made from",
        provenance_command.add_options,
        provenance_command.run,
    ),
}


class _Store(argparse.Action):
    """Store a value; ``namespace.given`` has the names of all options that were given.

    A default cannot be told from a value otherwise, where options go with others or do not.
    """

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: Any,
        option_string: str | None = None,
    ) -> None:
        """Store the value."""
        del parser, option_string
        namespace.given = namespace.given | {self.dest}
        setattr(namespace, self.dest, values)


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one line."""

    def error(self, message: str) -> NoReturn:
        """Say what is wrong and stop."""
        self.exit(2, f"{self.prog}: {one_line(message)} (--help lists the options)\n")


class _Version(argparse.Action):
    """Print the version, which takes a while to look up, only where it is asked for."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        """Print the version and stop."""
        from importlib.metadata import version

        print(f"{parser.prog} {version('wrinklestudy')}")
        parser.exit()


def parse(argv: Sequence[str]) -> argparse.Namespace:
    """Return the arguments of a command line without the name of the program.

    Only the command that is asked for gets its options: they come from the registry of laws, which
    needs numpy, and `--help` alone does without.
    """
    parser = _Parser(
        prog="wrinklestudy",
        description="Wrinkles in stretched hyperelastic sheets.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action=_Version, nargs=0, help="print the version")
    commands = parser.add_subparsers(dest="command", required=True)
    for name, command in COMMANDS.items():
        sub = commands.add_parser(name, help=command.help, allow_abbrev=False)
        for action in (None, "store"):
            sub.register("action", action, _Store)
        sub.set_defaults(given=frozenset())
        if name in argv[:1]:
            command.add_options(sub)
            sub.add_argument("--json", action="store_true", help="print JSON")
    # argparse takes -1.5 for a number but -3.1e4 for an option: no option begins with a space.
    return parser.parse_args([f" {text}" if is_negative(text) else text for text in argv])
