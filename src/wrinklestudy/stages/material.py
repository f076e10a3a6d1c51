"""The material stage: a law fitted to the measured stress-strain curve of one material."""

import sys
from collections.abc import Sequence
from pathlib import Path

from wrinklestudy.files.storage import write_json
from wrinklestudy.material.choice import Choice
from wrinklestudy.material.data import read
from wrinklestudy.material.fit import fit_choice


def run(
    csv: str | Path,
    law: str,
    name: str,
    stretch: tuple[float, float] | None,
    modes: Sequence[str] | None,
    output: str | Path,
    branch: str = "loading",
    cycle: int = 1,
    preload: str = "keep",
) -> None:
    """Fit one material and write its file: the material stage.

    Parameters
    ----------
    csv : str or Path
        Measured data.
    law : str
        A name in `LAWS`.
    name : str
        Name of the material in the study.
    stretch, modes : optional
        As in `fit`; None takes the default.
    output : str or Path
        JSON file to write, as `Fit.as_dict` with the name and the header note of the data.
    branch, cycle, preload : optional
        As in `fit`.

    Raises
    ------
    ValueError
        As `fit`.
    """
    measurement = read(csv)
    result = fit_choice(measurement, law, Choice(stretch, modes, branch, cycle, preload))
    for warning in result.warnings:
        print(f"{name}: {warning}", file=sys.stderr)
    content = {"name": name, **result.as_dict(), "source_note": measurement.note}
    write_json(output, content)
