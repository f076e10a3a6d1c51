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
    from wrinklestudy.equilibrium import stability

    chosen = sheet(arguments)
    curve = stability.critical_curve(chosen.space, chosen.material, chosen.settings)

    def reported(strain: float) -> float:
        value = curve(strain)
        print(f"strain {strain:.5f}: critical thickness {value:.6g} W", file=sys.stderr)
        return value

    return vars(stability.find(reported, chosen.thickness))
