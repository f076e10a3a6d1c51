"""`wrinklestudy fit`: constants of a law from measured stress and strain."""

import argparse
import sys
from typing import TYPE_CHECKING

from wrinklestudy.cli.material_options import DEFAULT_LAW
from wrinklestudy.cli.numbers import number, whole_number
from wrinklestudy.cli.output import Answer
from wrinklestudy.cli.outputs import add_overwrite, planned, write

if TYPE_CHECKING:
    from wrinklestudy.material.choice import Choice
    from wrinklestudy.material.result import Fit

ALL = "all"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    from wrinklestudy.material.branches import BRANCHES
    from wrinklestudy.material.homogeneous import MODES
    from wrinklestudy.mechanics.laws import LAWS

    add = parser.add_argument
    add(
        "data",
        help="table with stretch, strain, strain_percent or extension_mm; stress_pa, stress_kpa, "
        "stress_mpa or force_n; mode, branch, standard_error_pa: docs/recipes/own_rubber.md",
    )
    add(
        "--law",
        choices=(*LAWS, ALL),
        default=DEFAULT_LAW,
        help=f"strain energy, {DEFAULT_LAW} by default; {ALL} compares them",
    )
    add("--stretch", type=number, nargs=2, metavar=("LOW", "HIGH"), help="stretches to fit")
    add(
        "--mode",
        action="append",
        choices=MODES,
        help="modes of deformation to fit; repeatable, default all",
    )
    add("--branch", choices=BRANCHES, default=BRANCHES[0], help="of cyclic data; default loading")
    add("--cycle", type=whole_number, default=1, help="of cyclic data, from 1; default the first")
    add(
        "--remove-preload",
        action="store_true",
        help="shift the stresses of each mode so that there is none at stretch 1",
    )
    add("--plot", metavar="FILE", help="draw data, fit and its 95%% band: .png, .pdf or .svg")
    add("--yaml", action="store_true", help="print the block of a config that makes this material")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> Answer:
    """Return the fit, or those of all laws, as plain values for JSON, otherwise as text."""
    from wrinklestudy.cli import fit_text
    from wrinklestudy.material.comparison import compare
    from wrinklestudy.material.data import read
    from wrinklestudy.material.fit import fit_choice
    from wrinklestudy.material.result import Fit
    from wrinklestudy.stages.figures import SUFFIXES

    _check(arguments)
    choice = _choice(arguments)
    (picture,) = planned("--plot", arguments.plot, SUFFIXES, arguments.overwrite, [""])
    data = read(arguments.data)
    results = (
        compare(data, choice) if arguments.law == ALL else [fit_choice(data, arguments.law, choice)]
    )
    fits = [result for result in results if isinstance(result, Fit)]
    if picture is not None:
        from wrinklestudy.cli.fit_plot import draw

        write(picture, lambda path: draw(path, data, fits))
    _warn(arguments, fits)
    values = [result.as_dict() for result in results]
    if arguments.law == ALL:
        return Answer(values, fit_text.table(results))
    block = arguments.yaml and fit_text.block(arguments.data, arguments.law, choice)
    return Answer(values[0], block or fit_text.report(fits[0]))


def _check(arguments: argparse.Namespace) -> None:
    if arguments.yaml and arguments.json:
        raise ValueError("--yaml and --json exclude each other")
    if arguments.yaml and arguments.law == ALL:
        raise ValueError(f"--yaml: needs one law, not --law {ALL}")


def _choice(arguments: argparse.Namespace) -> "Choice":
    from wrinklestudy.material.choice import Choice
    from wrinklestudy.material.preload import KEEP, REMOVE

    return Choice(
        stretch=None if arguments.stretch is None else tuple(arguments.stretch),
        modes=arguments.mode,
        branch=arguments.branch,
        cycle=arguments.cycle,
        preload=REMOVE if arguments.remove_preload else KEEP,
    )


def _warn(arguments: argparse.Namespace, fits: "list[Fit]") -> None:
    """Print the warnings on stderr, unless the text shows them on the same terminal."""
    if sys.stdout.isatty() and sys.stderr.isatty() and not (arguments.json or arguments.yaml):
        return
    from wrinklestudy.cli.fit_text import warnings_of

    for warning in warnings_of(fits):
        print(f"wrinklestudy fit: warning: {warning}", file=sys.stderr)
