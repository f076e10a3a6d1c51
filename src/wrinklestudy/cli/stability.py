"""`wrinklestudy stability`: birth and decay strain of one sheet."""

import argparse
import sys
from typing import Any

from wrinklestudy.cli.sheet_options import add_sheet, sheet


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    add_sheet(parser)


def run(arguments: argparse.Namespace) -> dict[str, Any]:
    """Return birth and decay strain with the critical thicknesses between."""
    return vars(sheet(arguments).stability(_report))


def _report(strain: float, thickness: float) -> None:
    print(f"strain {strain:.5f}: critical thickness {thickness:.6g} W", file=sys.stderr)
