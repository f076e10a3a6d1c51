"""What each figure shows of a study, and how its caption says so."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from wrinklestudy.fem.grid import MeshSettings, cells
from wrinklestudy.results.cases import Case, StudySheet, format_value
from wrinklestudy.studies.panaitescu2019.figures import MEASURED, state_strains
from wrinklestudy.study.config import StudyConfig

Sheets = tuple[StudySheet, ...]


def _none(_study: StudyConfig) -> Sheets:
    return ()


def _single(study: StudyConfig) -> Sheets:
    return (study.figure_sheet,)


def _models(study: StudyConfig) -> Sheets:
    return study.compared_sheets


def _aspects(study: StudyConfig) -> Sheets:
    one = study.figure_sheet
    same = (one.material, one.thickness)
    return tuple(s for s in study.all_sheets if (s.material, s.thickness) == same)


def _thicknesses(study: StudyConfig) -> Sheets:
    one = study.figure_sheet
    same = (one.material, one.aspect)
    return tuple(s for s in study.all_sheets if (s.material, s.aspect) == same)


@dataclass(frozen=True)
class Content:
    """What one figure shows.

    Parameters
    ----------
    panel : str
        Number and panel of the figure in the paper.
    title : str
        What it shows, in a few words.
    part : str
        Part of the report that it belongs to.
    tables : callable
        Gives the sheets of a study whose tables the figure is drawn from.
    """

    panel: str
    title: str
    part: str
    tables: Callable[[StudyConfig], Sheets] = _none


_MATERIAL, _WRINKLES = "1 Material", "2 Wrinkles"
_SIZES, _FAR = "3 Aspect and thickness", "4 Far from threshold"
TABLES = "5 Tables and claims"

CONTENTS: Mapping[str, Content] = {
    "fig01_stress": Content("1", "stress", _MATERIAL),
    "fig02_sheet": Content("2", "sheet from above", _WRINKLES),
    "fig03_surface": Content("3c", "surface", _WRINKLES),
    "fig04_profiles": Content("4b", "profiles", _WRINKLES),
    "fig05_amplitude": Content("5a", "amplitude", _WRINKLES, _models),
    "fig05_wavelength": Content("5b", "wavelength", _WRINKLES, _models),
    "fig06_aspect": Content("6a", "amplitude against L/W", _SIZES, _aspects),
    "fig06_thickness": Content("6b", "amplitude against W/t", _SIZES, _thicknesses),
    "fig07_width": Content("7a", "width", _FAR, _single),
    "fig07_confinement": Content("7b", "confinement", _FAR, _single),
    "fig07_slaving": Content("7c", "slaving", _FAR, _single),
    "fig07_collapse": Content("7d", "collapse", _FAR, _aspects),
}
_OF_MATERIALS = "fig01_stress"


def materials_shown(study: StudyConfig, figure: str) -> tuple[str, ...]:
    """Return the names of the materials that a figure compares."""
    return tuple(sorted(study.materials)) if figure == _OF_MATERIALS else ()


def sheets_shown(study: StudyConfig, figure: str) -> Sheets:
    """Return the sheets whose tables a figure is drawn from."""
    return CONTENTS[figure].tables(study)


def states_shown(study: StudyConfig, figure: str) -> tuple[Case, ...]:
    """Return the states of the figure sheet that a figure shows."""
    strains = [case.strain for case in study.cases_of(study.figure_sheet)]
    return tuple(Case(study.figure_sheet, one) for one in state_strains(figure, strains))


def measured(study: StudyConfig, figure: str) -> list[str]:
    """Return the files of the user's measurements that a figure overlays: those that exist."""
    folder = Path(study.folders.experiment)
    patterns = (
        "profiles/*.csv" if kind == "profiles" else f"{kind}.csv" for kind in _kinds(figure)
    )
    return sorted(path.as_posix() for pattern in patterns for path in folder.glob(pattern))


def _kinds(figure: str) -> tuple[str, ...]:
    return MEASURED.get(figure, ())


def labels(figure: str) -> dict[str, str]:
    """Return how the report lists a figure."""
    return {"figure": CONTENTS[figure].panel, "shows": CONTENTS[figure].title}


def cases_text(study: StudyConfig, figure: str) -> str:
    """Return the cases or materials that a figure shows, for its caption."""
    if figure == _OF_MATERIALS:
        fits = (f"{name} ({one.law}, {one.data})" for name, one in study.materials.items())
        return ", ".join(fits)
    states = states_shown(study, figure)
    shown = {study.figure_sheet: states} if states else {}
    shown |= {sheet: study.cases_of(sheet) for sheet in sheets_shown(study, figure)}
    return "; ".join(
        f"{sheet.material}, {_size(sheet)}: {_strains_text([one.strain for one in found])}"
        for sheet, found in shown.items()
    )


def mesh_text(study: StudyConfig, figure: str) -> str:
    """Return the meshes behind a figure, for its caption; empty if it shows no sheet."""
    states = states_shown(study, figure)
    shown = [*sheets_shown(study, figure), *(case.sheet for case in states)]
    return "; ".join(
        f"{along} x {across} cells on the quarter sheet for {', '.join(sizes)}"
        for (along, across), sizes in _meshes(study, shown).items()
    )


def _meshes(study: StudyConfig, sheets: Iterable[StudySheet]) -> dict[tuple[int, int], list[str]]:
    settings = MeshSettings(**study.settings("mesh"))
    found: dict[tuple[int, int], list[str]] = {}
    for sheet in sheets:
        sizes = found.setdefault(cells(sheet.aspect, sheet.resolved, settings), [])
        sizes += [_size(sheet)] if _size(sheet) not in sizes else []
    return found


def _size(sheet: StudySheet) -> str:
    return f"L/W = {format_value(sheet.aspect)}, t/W = {format_value(sheet.thickness)}"


def _strains_text(strains: list[float]) -> str:
    texts = list(map(format_value, strains))
    if len(texts) < 8:
        return f"strain {', '.join(texts)}"
    return f"{len(texts)} strains from {texts[0]} to {texts[-1]}"
