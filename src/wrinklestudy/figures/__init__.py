"""Figures stage: one module per figure of the paper, one shared style.

A module has one function ``draw(inputs)`` that returns a matplotlib figure of whatever series the
tables and states hold. No point is drawn that was not computed or measured; a state that
did not converge is a gap. Importing this package loads no plotting library.
"""

from collections.abc import Sequence
from importlib import import_module
from os import PathLike, fspath
from pathlib import Path

# Name of each figure, numbered as in the paper, and the strains of the states that it shows: a
# sequence of wanted strains, "all", or () for a figure of tables only.
FIGURES: dict[str, tuple[float, ...] | str] = {
    "fig01_stress": (),
    "fig02_sheet": (0.0, 0.1, 0.2, 0.32, 0.46),
    "fig03c_surface": (0.06, 0.12),
    "fig04b_profiles": "all",
    "fig05a_amplitude": (),
    "fig05b_wavelength": (),
    "fig07a_width": (),
    "fig07b_confinement": (),
    "fig07c_slaving": (),
}

# The sheet of the paper's single-sheet figures: L/W and t/W.
PAPER_SHEET = (2.0, 1e-3)

SUFFIXES = (".pdf", ".png", ".svg")


def state_strains(name: str, available: Sequence[float]) -> list[float]:
    """Return the strains whose states a figure shows, out of those that a study has.

    For each strain that the paper shows the nearest one of the study is taken, once; a
    figure is labelled with what it shows. The undeformed sheet (strain 0) needs no state.

    Parameters
    ----------
    name : str
        Figure.
    available : sequence of float
        Strains of the study.

    Returns
    -------
    list of float
        Increasing; empty if the figure shows no state.

    Raises
    ------
    ValueError
        If there is no such figure.
    """
    wanted = FIGURES[_known(name)]
    if isinstance(wanted, str):
        return sorted(available)
    tensile = [strain for strain in wanted if strain > 0.0]
    if not available:
        return []
    return sorted({min(available, key=lambda one: (abs(one - want), one)) for want in tensile})


def run(
    name: str,
    metrics: str | PathLike[str],
    stability: str | PathLike[str],
    materials: Sequence[str | PathLike[str]],
    states: Sequence[str | PathLike[str]],
    output: str | PathLike[str] | Sequence[str | PathLike[str]],
    data: Sequence[str | PathLike[str]] = (),
    sheet: tuple[float, float] = PAPER_SHEET,
) -> None:
    """Draw one figure and write it in each of the formats asked for.

    The same inputs give the same bytes: no dates are written.

    Parameters
    ----------
    name : str
        One of `FIGURES`.
    metrics, stability : path-like
        Tables of the metrics stage.
    materials : sequence of path-like
        Files of the material stage.
    states : sequence of path-like
        Files of the wrinkle stage, those of `state_strains`.
    output : path-like or sequence of path-like
        Files to write; the suffix (.pdf, .png, .svg) is the format.
    data : sequence of path-like
        Stress-strain files that the materials were fitted to.
    sheet : tuple of float
        L/W and t/W of the rows that a figure of a single sheet takes from the tables; if the
        tables have no such sheet it shows all that they have.

    Raises
    ------
    ValueError
        If the figure or a format is unknown, or an input lacks what the figure shows.
    """
    paths = [output] if isinstance(output, str | PathLike) else list(output)
    _known(name)
    for path in paths:
        if Path(path).suffix not in SUFFIXES:
            allowed = ", ".join(SUFFIXES)
            raise ValueError(f"{fspath(path)}: a figure must end in one of {allowed}")

    from wrinklestudy.figures import style
    from wrinklestudy.figures.inputs import Inputs

    inputs = Inputs(
        metrics=Path(metrics),
        stability=Path(stability),
        materials=tuple(Path(path) for path in materials),
        states=tuple(Path(path) for path in states),
        data=tuple(Path(path) for path in data),
        sheet=sheet,
    )
    with style.applied():
        figure = import_module(f"wrinklestudy.figures.{name}").draw(inputs)
        for path in paths:
            style.save(figure, path)


def _known(name: str) -> str:
    if name not in FIGURES:
        raise ValueError(f"figure {name!r}: must be one of {', '.join(FIGURES)}")
    return name
