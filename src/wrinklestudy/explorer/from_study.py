"""The content of a page from the files of a study that has been computed."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path

from wrinklestudy.explorer.content import (
    Content,
    ShownMap,
    ShownSheet,
    map_of_curves,
    map_of_points,
)
from wrinklestudy.files.storage import read_json
from wrinklestudy.mechanics.laws import Material, describe, law_of
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.results.cases import Case, StudySheet, canonical
from wrinklestudy.results.fields import deformed_sheet, read_wrinkle
from wrinklestudy.results.load import load_sheets
from wrinklestudy.results.materials import load_material
from wrinklestudy.results.paths import Paths
from wrinklestudy.results.rows import StateRow
from wrinklestudy.results.tables import read_map, read_tension
from wrinklestudy.study.config import StudyConfig


def content_of_study(study: StudyConfig, source: str) -> Content:
    """Return what a page shows of a study.

    Parameters
    ----------
    study : StudyConfig
    source : str
        Where its config is, for the page and for messages.

    Raises
    ------
    ValueError
        If a file of the study is missing or is not what it should be; one line.
    """
    paths = Paths(study.folders.results, study.folders.figures)
    _refuse_missing(study, paths, source)
    sheets = [_sheet(study, paths, sheet) for sheet in study.all_sheets]
    models = list(dict.fromkeys(sheet.material for sheet in study.all_sheets))
    maps = [shown for model in models if (shown := _map(study, paths, model)) is not None]
    materials = list(dict.fromkeys(study.base(model) for model in models))
    tension = {
        name: [
            row
            for material, aspect in study.tension
            if material == name
            for row in read_tension(paths.of("tension", material=name, aspect=aspect))
        ]
        for name in materials
    }
    return Content(
        title=study.catalogue.title,
        source=source,
        sheets=sheets,
        maps=maps,
        tension=tension,
        constants={
            name: constants_text(load_material(paths.of("material", material=name)))
            for name in materials
        },
        first=study.all_sheets.index(study.figure_sheet),
    )


def constants_text(material: Material) -> str:
    """Return a law with its constants in words."""
    law = law_of(str(describe(material)["law"]))
    values = material.law.physical(material.shear_modulus)
    texts = []
    for constant in law.constants:
        value = values[constant.name]
        pascal = constant.unit == "Pa"
        number = f"{value / 1e3:.4g} kPa" if pascal else f"{value:.4g} {constant.unit}".strip()
        texts.append(f"{constant.name} = {number}")
    return f"{law.label}, {', '.join(texts)}"


def _needed(study: StudyConfig, paths: Paths) -> Iterator[str]:
    for sheet in study.all_sheets:
        yield paths.of("material", material=study.base(sheet.material))
        yield paths.of_sheet("metrics", sheet)
        yield paths.of_sheet("stability", sheet)
    yield from (paths.of_case("wrinkle", case) for case in study.cases)
    for stage in ("map", "tension"):
        for model, aspect in study.analyses(stage):
            yield paths.of(stage, material=model, aspect=aspect)


def _refuse_missing(study: StudyConfig, paths: Paths, source: str) -> None:
    needed = dict.fromkeys(_needed(study, paths))
    missing = [file for file in needed if not Path(file).is_file()]
    if missing:
        others = f" and {len(missing) - 1} more are" if missing[1:] else " is"
        raise ValueError(
            f"{source}: {missing[0]}{others} missing; run the study first (make figures, make "
            "beyond or snakemake)"
        )


def _sheet(study: StudyConfig, paths: Paths, sheet: StudySheet) -> ShownSheet:
    metrics, limits = paths.of_sheet("metrics", sheet), paths.of_sheet("stability", sheet)
    loaded = load_sheets([metrics], [limits])
    if len(loaded) != 1:
        raise ValueError(f"{metrics}: must hold one sheet, has {len(loaded)}")
    (states,) = loaded
    shapes = tuple(_shape(paths, sheet, row) for row in states.states)
    return ShownSheet(states, shapes, study.base(sheet.material))


def _shape(paths: Paths, sheet: StudySheet, row: StateRow) -> DeformedSheet | None:
    """Return the shape of a state of a table."""
    if row.status == "not-converged":
        return None
    file = paths.of_case("wrinkle", Case(sheet, canonical(row.strain)))
    if not Path(file).is_file():
        raise ValueError(f"{file}: is missing, a state of {paths.of_sheet('metrics', sheet)}")
    try:
        return deformed_sheet(*read_wrinkle(file))
    except ValueError as error:
        raise ValueError(str(error) if file in str(error) else f"{file}: {error}") from None


def _map(study: StudyConfig, paths: Paths, model: str) -> ShownMap | None:
    """Return the map of a model: its own tables, or else the curves of its sheets."""
    aspects = [aspect for name, aspect in study.maps if name == model]
    if aspects:
        files = [paths.of("map", material=model, aspect=aspect) for aspect in aspects]
        rows = [row for file in files for row in read_map(file)]
        return map_of_points(
            model, ((row.aspect, row.strain, row.critical_thickness) for row in rows)
        )
    sheets = [sheet for sheet in study.all_sheets if sheet.material == model]
    largest = max(case.strain for sheet in sheets for case in study.cases_of(sheet))
    return map_of_curves(model, _curves(paths, sheets), largest)


def _curves(
    paths: Paths, sheets: Sequence[StudySheet]
) -> dict[float, Sequence[tuple[float, float]]]:
    """Return tau_1 over strain by L/W, of the thinnest sheet of each: its mesh is the finest."""
    by_aspect: defaultdict[float, list[StudySheet]] = defaultdict(list)
    for sheet in sheets:
        by_aspect[sheet.aspect].append(sheet)
    curves = {}
    for aspect, same in by_aspect.items():
        thinnest = min(same, key=lambda sheet: sheet.thickness)
        file = paths.of_sheet("stability", thinnest)
        try:
            pairs = read_json(file)["critical_thickness"]
            curves[aspect] = [(float(strain), float(tau)) for strain, tau in pairs]
        except (KeyError, TypeError, ValueError) as error:
            raise ValueError(f"{file}: 'critical_thickness' is not a table ({error})") from None
    return {aspect: curve for aspect, curve in curves.items() if curve}
