"""The material stage: a law with constants, fitted to a measured curve or given."""

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from wrinklestudy.files.storage import write_json
from wrinklestudy.material.choice import Choice
from wrinklestudy.material.data import read
from wrinklestudy.material.fit import fit_choice
from wrinklestudy.results.materials import given_material


def run(
    law: str,
    name: str,
    output: str | Path,
    *,
    csv: str | Path | None = None,
    constants: Mapping[str, float] | None = None,
    stretch: tuple[float, float] | None = None,
    modes: Sequence[str] | None = None,
    branch: str = "loading",
    cycle: int = 1,
    preload: str = "keep",
) -> None:
    """Fit one material, or take its constants as given, and write its file: the material stage.

    Parameters
    ----------
    law : str
        A name in `LAWS`.
    name : str
        Name of the material in the study.
    output : str or Path
        JSON file to write: with the name, `Fit.as_dict` and the header note of the data or, for
        given constants, `given_material`.
    csv : str or Path, optional
        Measured data; not read if there are constants.
    constants : mapping, optional
        Constants of the law by name, in Pa or pure numbers.
    stretch, modes, branch, cycle, preload : optional
        As in `fit`.

    Raises
    ------
    ValueError
        As `fit`; if there are neither data nor constants, or the law does not allow these.
    """
    if constants is not None:
        write_json(output, {"name": name, **given_material(law, constants)})
        return
    if csv is None:
        raise ValueError(f"{name}: needs data or constants")
    measurement = read(csv)
    result = fit_choice(measurement, law, Choice(stretch, modes, branch, cycle, preload))
    for warning in result.warnings:
        print(f"{name}: {warning}", file=sys.stderr)
    content = {"name": name, **result.as_dict(), "source_note": measurement.note}
    write_json(output, content)
