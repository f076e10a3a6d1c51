"""The figures stage: one figure in all formats asked for, and the numbers that it shows."""

from collections.abc import Mapping, Sequence
from importlib import import_module
from os import PathLike
from pathlib import Path

from wrinklestudy.study.loading import load_catalogue
from wrinklestudy.typing import AnyPath

SUFFIXES = (".pdf", ".png", ".svg")
NUMBERS = ".csv"  # what the figure shows, as a table


def run(
    study: str,
    name: str,
    *,
    output: AnyPath | Sequence[AnyPath] | Mapping[str, AnyPath],
    metrics: Sequence[AnyPath] = (),
    stability: Sequence[AnyPath] = (),
    materials: Sequence[AnyPath] = (),
    states: Sequence[AnyPath] = (),
    data: Sequence[AnyPath] = (),
    experiment: Sequence[AnyPath] = (),
    constants: Sequence[AnyPath] = (),
    **analyses: AnyPath | Sequence[AnyPath],
) -> None:
    """Draw one figure and write it in all formats asked for.

    The same inputs give the same bytes, because no dates are written. Inputs that the figure does
    not show are ignored.

    Parameters
    ----------
    study : str
        Name of the study as in the config: `study.loading.load_catalogue`.
    name : str
        One of the figures of its catalogue.
    output : path-like, sequence or mapping of path-like
        Files to write; the suffix (.pdf, .png, .svg) is the format, .csv the numbers shown.
    metrics : sequence of path-like
        Tables of the metrics stage of the sheets that the figure shows, in their order.
    stability : sequence of path-like
        Files of the stability stage of these sheets, for birth and decay.
    materials : sequence of path-like
        Files of the material stage.
    states : sequence of path-like
        Files of the wrinkle stage at the strains of `FigureEntry.strains_shown`.
    data : sequence of path-like
        Stress-strain files that the materials were fitted to.
    experiment : sequence of path-like
        Files of measured data (`wrinklestudy.study.measurements`), of the kinds that the entry of
        the figure names.
    constants : sequence of path-like
        Files of the material stage, for their constants.
    **analyses : path-like or sequence of path-like
        Files of the analyses that the entry of the figure names, by
        `results.analyses.input_name`.

    Raises
    ------
    ValueError
        If the study, the figure or a format is unknown, the module of the figure has no ``draw``,
        or an input lacks what the figure shows.
    """
    module = load_catalogue(study).figure(name).module
    paths = _paths(list(output.values()) if isinstance(output, Mapping) else output)
    for path in paths:
        if path.suffix not in (*SUFFIXES, NUMBERS):
            allowed = ", ".join((*SUFFIXES, NUMBERS))
            raise ValueError(f"{path}: a figure must end in one of {allowed}")

    from wrinklestudy.results.analyses import analysis_files
    from wrinklestudy.study.figures import style
    from wrinklestudy.study.figures.inputs import Inputs
    from wrinklestudy.study.figures.shown_numbers import write_numbers

    inputs = Inputs(
        metrics=_paths(metrics),
        stability=_paths(stability),
        materials=_paths(materials),
        states=_paths(states),
        data=_paths(data),
        experiment=_paths(experiment),
        constants=_paths(constants),
        analyses=analysis_files(analyses),
    )
    with style.applied():
        draw = getattr(import_module(module), "draw", None)
        if draw is None:
            raise ValueError(f"figure {name!r}: module {module} must define draw(inputs)")
        figure = draw(inputs)
        for path in paths:
            if path.suffix == NUMBERS:
                write_numbers(figure, path)
            else:
                style.save(figure, path)


def _paths(paths: AnyPath | Sequence[AnyPath]) -> tuple[Path, ...]:
    return tuple(Path(path) for path in ([paths] if isinstance(paths, str | PathLike) else paths))
