"""`wrinklestudy stability`: birth and decay strain of one sheet."""

import argparse
import sys
from typing import TYPE_CHECKING

from wrinklestudy.cli.imperfection_options import add_imperfections
from wrinklestudy.cli.output import Answer
from wrinklestudy.cli.outputs import add_overwrite, planned, write
from wrinklestudy.cli.sentences import stability_text
from wrinklestudy.cli.sheet_options import GivenSize, add_sheet, announce, given_size, sheet

if TYPE_CHECKING:
    from wrinklestudy.equilibrium.ranges import Stability
    from wrinklestudy.sheet import Sheet


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    add_sheet(parser)
    add_imperfections(parser)
    parser.add_argument("--plot", metavar="FILE", help="draw tau_1 over strain: .png, .pdf or .svg")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> Answer:
    """Return birth and decay strain with the critical thicknesses between."""
    from wrinklestudy.stages.figures import SUFFIXES

    size = given_size(arguments)
    (plot,) = planned("--plot", arguments.plot, SUFFIXES, arguments.overwrite, [""])
    chosen = sheet(arguments, size)
    announce(chosen, wrinkled=False)
    limits = chosen.stability(report_critical)
    if plot is not None:
        write(plot, lambda path: _draw(chosen, size, limits, path))
    values = dict(vars(limits))
    if not chosen.is_plain:
        kind, reason = chosen.bifurcation
        values |= {"windows": limits.ranges, "bifurcation": kind, "bifurcation_reason": reason}
    if size.width_mm is not None:
        for name in ("birth", "decay"):
            values[f"{name}_clamps_mm"] = size.clamps_mm(values[f"{name}_strain"])
    return Answer(values, stability_text(values, size))


def report_critical(strain: float, thickness: float) -> None:
    """Say on stderr what is known at a strain."""
    print(f"strain {strain:.5f}: critical thickness {thickness:.6g} W", file=sys.stderr)


def _draw(chosen: "Sheet", size: GivenSize, limits: "Stability", path: object) -> None:
    from wrinklestudy.cli.solving import pictured_sheet
    from wrinklestudy.study.figures import one_sheet, style

    with style.applied():
        style.save(one_sheet.draw_stability(pictured_sheet(chosen, size), limits), str(path))
