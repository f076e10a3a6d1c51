"""What each figure shows of a study, and the words for it in its caption."""

from collections.abc import Iterable
from pathlib import Path

from wrinklestudy.fem.grid import MeshSettings, cells
from wrinklestudy.results.cases import Case, StudySheet, format_value
from wrinklestudy.study.catalogue import FigureEntry
from wrinklestudy.study.config import StudyConfig
from wrinklestudy.study.selections import Sheets


def materials_shown(study: StudyConfig, figure: FigureEntry) -> tuple[str, ...]:
    """Return the names of the materials that a figure compares: those fitted to data."""
    fitted = [name for name, material in study.materials.items() if material.data is not None]
    return tuple(sorted(fitted)) if figure.materials else ()


def constants_shown(study: StudyConfig, figure: FigureEntry) -> tuple[str, ...]:
    """Return the names of the materials whose constants a figure needs: see `FigureEntry`."""
    if not figure.constants:
        return ()
    fitted = {name for name, material in study.materials.items() if material.data is not None}
    models = {sheet.material for sheet in sheets_shown(study, figure)}
    models |= {model for stage in figure.analyses for model, _ in study.analyses(stage)}
    return tuple(sorted(fitted | {study.base(model) for model in models}))


def sheets_shown(study: StudyConfig, figure: FigureEntry) -> Sheets:
    """Return the sheets whose tables a figure is drawn from."""
    return figure.sheets(study)


def states_shown(study: StudyConfig, figure: FigureEntry) -> tuple[Case, ...]:
    """Return the states that a figure shows, of the figure sheet unless it selects others."""
    if not figure.strains:
        return ()
    return tuple(
        Case(sheet, strain)
        for sheet in figure.states_of(study)
        for strain in figure.strains_shown([case.strain for case in study.cases_of(sheet)])
    )


def measured(study: StudyConfig, figure: FigureEntry) -> list[str]:
    """Return the existing files of the user's measurements that a figure draws over its curves."""
    folder = Path(study.folders.experiment)
    patterns = (
        "profiles/*.csv" if kind == "profiles" else f"{kind}.csv" for kind in figure.measured
    )
    return sorted(path.as_posix() for pattern in patterns for path in folder.glob(pattern))


def labels(figure: FigureEntry) -> dict[str, str]:
    """Return the labels under which the report lists a figure."""
    return {"figure": figure.panel, "shows": figure.title}


def caption_text(_study: StudyConfig, figure: FigureEntry) -> str:
    """Return the first sentence of a caption: number in the publication, if any, and content."""
    return f"Figure {figure.panel}. {figure.caption}" if figure.panel else figure.caption


def cases_text(study: StudyConfig, figure: FigureEntry) -> str:
    """Return the cases or materials that a figure shows, for its caption."""
    if figure.materials:
        fits = (
            f"{name} ({study.materials[name].law}, {study.materials[name].data})"
            for name in materials_shown(study, figure)
        )
        return ", ".join(fits)
    states = states_shown(study, figure)
    shown = {
        state.sheet: tuple(case for case in states if case.sheet == state.sheet) for state in states
    }
    shown |= {sheet: study.cases_of(sheet) for sheet in sheets_shown(study, figure)}
    texts = [
        f"{sheet.material}, {_size(sheet)}: {_strains_text([case.strain for case in cases])}"
        for sheet, cases in shown.items()
    ]
    texts += [
        f"{stage} of {model}, L/W = {format_value(aspect)}"
        + (f": {_strains_text(list(strains))}" if strains else "")
        for stage in figure.analyses
        for (model, aspect), strains in study.analyses(stage).items()
    ]
    return "; ".join(texts)


def mesh_text(study: StudyConfig, figure: FigureEntry) -> str:
    """Return the meshes behind a figure, for its caption; empty if it shows no sheet."""
    states = states_shown(study, figure)
    shown = [*sheets_shown(study, figure), *(case.sheet for case in states)]
    return "; ".join(
        f"{along} x {across} cells on the quarter sheet for {', '.join(sizes)}"
        for (along, across), sizes in _meshes(study, shown).items()
    )


def _meshes(study: StudyConfig, sheets: Iterable[StudySheet]) -> dict[tuple[int, int], list[str]]:
    settings = MeshSettings(**study.settings("mesh"))
    sizes_by_mesh: dict[tuple[int, int], list[str]] = {}
    for sheet in sheets:
        sizes = sizes_by_mesh.setdefault(cells(sheet.aspect, sheet.resolved, settings), [])
        sizes += [_size(sheet)] if _size(sheet) not in sizes else []
    return sizes_by_mesh


def _size(sheet: StudySheet) -> str:
    return f"L/W = {format_value(sheet.aspect)}, t/W = {format_value(sheet.thickness)}"


def _strains_text(strains: list[float]) -> str:
    texts = list(map(format_value, strains))
    if len(texts) < 8:
        return f"strain {', '.join(texts)}"
    return f"{len(texts)} strains from {texts[0]} to {texts[-1]}"
