"""`wrinklestudy fit`: constants of a law from measured stress and strain."""

import argparse
from typing import Any

from wrinklestudy.cli.numbers import number
from wrinklestudy.cli.sheet_options import add_law


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    from wrinklestudy.material.homogeneous import MODES

    parser.add_argument("data", help="CSV with stretch or strain, stress_pa or stress_mpa, mode")
    add_law(parser)
    parser.add_argument(
        "--stretch", type=number, nargs=2, metavar=("LOW", "HIGH"), help="stretches to fit"
    )
    parser.add_argument(
        "--mode",
        action="append",
        choices=MODES,
        help="modes of deformation to fit; repeatable, default all",
    )


def run(arguments: argparse.Namespace) -> dict[str, Any]:
    """Return the fit as plain values."""
    from wrinklestudy.material.fit import fit

    window = None if arguments.stretch is None else tuple(arguments.stretch)
    return fit(arguments.data, arguments.law, stretch=window, modes=arguments.mode).as_dict()
