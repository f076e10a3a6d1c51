"""The figures stage: one figure in each of the formats asked for."""

from collections.abc import Mapping, Sequence
from importlib import import_module
from os import PathLike
from pathlib import Path

from wrinklestudy.studies.panaitescu2019.figures import _known
from wrinklestudy.typing import AnyPath

SUFFIXES = (".pdf", ".png", ".svg")


def run(
    name: str,
    *,
    output: AnyPath | Sequence[AnyPath] | Mapping[str, AnyPath],
    metrics: Sequence[AnyPath] = (),
    stability: Sequence[AnyPath] = (),
    materials: Sequence[AnyPath] = (),
    states: Sequence[AnyPath] = (),
    data: Sequence[AnyPath] = (),
    experiment: Sequence[AnyPath] = (),
) -> None:
    """Draw one figure and write it in each of the formats asked for.

    The same inputs give the same bytes: no dates are written. A figure leaves alone what it
    does not show.

    Parameters
    ----------
    name : str
        One of `FIGURES`.
    output : path-like, sequence or mapping of path-like
        Files to write; the suffix (.pdf, .png, .svg) is the format.
    metrics : sequence of path-like
        Tables of the metrics stage, of the sheets that the figure shows and in their order.
    stability : sequence of path-like
        Files of the stability stage of these sheets, for birth and decay.
    materials : sequence of path-like
        Files of the material stage.
    states : sequence of path-like
        Files of the wrinkle stage, those of `state_strains`.
    data : sequence of path-like
        Stress-strain files that the materials were fitted to.
    experiment : sequence of path-like
        Files of measured data (`wrinklestudy.study.measurements`); those of `MEASURED` are shown.

    Raises
    ------
    ValueError
        If the figure or a format is unknown, or an input lacks what the figure shows.
    """
    _known(name)
    paths = _paths(list(output.values()) if isinstance(output, Mapping) else output)
    for path in paths:
        if path.suffix not in SUFFIXES:
            allowed = ", ".join(SUFFIXES)
            raise ValueError(f"{path}: a figure must end in one of {allowed}")

    from wrinklestudy.study.figures import style
    from wrinklestudy.study.figures.inputs import Inputs

    inputs = Inputs(
        metrics=_paths(metrics),
        stability=_paths(stability),
        materials=_paths(materials),
        states=_paths(states),
        data=_paths(data),
        experiment=_paths(experiment),
    )
    with style.applied():
        figure = import_module(f"wrinklestudy.studies.panaitescu2019.figures.{name}").draw(inputs)
        for path in paths:
            style.save(figure, path)


def _paths(paths: AnyPath | Sequence[AnyPath]) -> tuple[Path, ...]:
    return tuple(Path(path) for path in ([paths] if isinstance(paths, str | PathLike) else paths))
