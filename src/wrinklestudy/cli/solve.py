"""`wrinklestudy solve`: the state of one sheet at one or more strains."""

import argparse
import sys
from collections.abc import Iterable, Sequence
from typing import Any

from wrinklestudy.cli.numbers import number
from wrinklestudy.cli.sheet_options import add_sheet, sheet
from wrinklestudy.vocabulary import STRAIN


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    add_sheet(parser)
    parser.add_argument(
        "--strain", type=number, action="append", required=True, help="0 < eps <= 1; repeatable"
    )


def run(arguments: argparse.Namespace) -> list[dict[str, Any]]:
    """Return the states as plain values."""
    chosen = sheet(arguments)
    for strain in arguments.strain:
        if strain not in STRAIN:
            raise ValueError(f"--strain = {strain:g}: must be {STRAIN}")
    return [chosen.solve(strain).as_dict() for strain in _progress(arguments.strain)]


def _progress(strains: Sequence[float]) -> Iterable[float]:
    """Show a bar on a terminal, a line for each strain elsewhere; both on stderr."""
    if sys.stderr.isatty():
        from tqdm import tqdm

        yield from tqdm(strains, unit="strain", file=sys.stderr)
        return
    for count, strain in enumerate(strains, 1):
        print(f"strain {strain:g} ({count} of {len(strains)})", file=sys.stderr)
        yield strain
