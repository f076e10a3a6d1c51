"""`wrinklestudy film`: a sheet from the birth of its wrinkles to their decay, as MP4 or GIF."""

import argparse

from wrinklestudy.cli.numbers import whole_number
from wrinklestudy.cli.output import Answer
from wrinklestudy.cli.outputs import add_overwrite, planned, write
from wrinklestudy.cli.sentences import failures
from wrinklestudy.cli.shaped_states import add_strains, given_strains, shaped_states
from wrinklestudy.cli.sheet_options import add_sheet, given_size, sheet
from wrinklestudy.cli.solving import pictured_sheet
from wrinklestudy.vocabulary import Limits

SUFFIXES = (".gif", ".mp4")
_FRAMES = Limits(2, 500, unit="strains")


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    add_sheet(parser)
    add_strains(parser)
    parser.add_argument(
        "--frames", type=whole_number, default=48, help="strains without --strain; default 48"
    )
    parser.add_argument(
        "--output", metavar="FILE", help="the film: .gif, or .mp4 where ffmpeg is installed"
    )
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> Answer:
    """Compute the states, write the film and say what it shows."""
    from wrinklestudy.explorer.film import check_writer, write_film

    if arguments.output is None:
        raise ValueError("--output: missing; the film to write, such as film.gif")
    if arguments.frames not in _FRAMES:
        raise ValueError(f"--frames = {arguments.frames}: must be {_FRAMES}")
    strains, size = given_strains(arguments), given_size(arguments)
    if strains is not None and "frames" in arguments.given:
        raise ValueError("--strain, --frames: give strains or how many, not both")
    (file,) = planned("--output", arguments.output, SUFFIXES, arguments.overwrite, [""])
    assert file is not None
    check_writer(file)
    chosen = sheet(arguments, size)
    states, shapes = shaped_states(chosen, strains, arguments.frames, arguments.jobs)
    pictured = pictured_sheet(chosen, size)
    write(file, lambda path: write_film(pictured, states, shapes, path))
    shown = sum(shape is not None for shape in shapes)
    values = {"output": str(file), "frames": shown, "bytes": file.stat().st_size}
    text = f"{file}: {shown} strains, {file.stat().st_size / 1e6:.1f} MB\n"
    return Answer(values, text, tuple(failures([row.shown() for row in states.states])))
