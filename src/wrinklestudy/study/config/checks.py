"""Checks of a config: each key, keys against each other, and the files and folders it names."""

from collections.abc import Iterator, Sequence
from os import PathLike, fspath
from os.path import relpath
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from wrinklestudy.mechanics.bending import check_bending
from wrinklestudy.mechanics.laws import law_of
from wrinklestudy.mechanics.relaxed import check_relaxed
from wrinklestudy.results import cases
from wrinklestudy.results.imperfect_sheets import check_imperfect, repeated_names
from wrinklestudy.study.config.blocks import (
    AnalysisBlock,
    FigureSheetBlock,
    LengthsBlock,
    SheetsBlock,
    StrainRange,
)
from wrinklestudy.study.config.model import StudyConfig
from wrinklestudy.study.config.spelling import misleading
from wrinklestudy.study.config.wording import closest, lines
from wrinklestudy.study.loading import CatalogueError
from wrinklestudy.vocabulary import printable

MAX_STRAINS = 1000


class ConfigError(ValueError):
    """The config is wrong; the message has one line per problem."""

    def __init__(self, message: str):
        super().__init__("\n".join(map(printable, message.split("\n"))))


def load_config(
    merged: Any, files: Sequence[str | PathLike[str]], overridden: bool = False
) -> StudyConfig:
    """Check a config that was put together from files, and the files themselves.

    Parameters
    ----------
    merged : object
        The content of all files together.
    files : sequence of path
        The files, starting with the one that takes precedence.
    overridden : bool
        Whether single keys were also given on the command line (``--config``).

    Returns
    -------
    StudyConfig
        The checked study.

    Raises
    ------
    ConfigError
        As `parse_config`; also if a file has a key twice or spells a number so that YAML reads a
        different one, or if a folder or file that the config names cannot be one.
    """
    names = [relpath(fspath(file)) for file in files]
    spellings = [line for name in names for line in misleading(name)]
    if spellings:
        raise ConfigError("\n".join(dict.fromkeys(spellings)))
    source = " over ".join([*(["--config"] if overridden else []), *names])
    study = parse_config(merged, source)
    _refuse(list(wrong_places(study)), source)
    return study


def parse_config(raw: Any, source: str) -> StudyConfig:
    """Check the content of a config, without looking at the files it names.

    Parameters
    ----------
    raw : object
        What the YAML file holds.
    source : str
        Name of the file, for the messages.

    Returns
    -------
    StudyConfig
        The checked study.

    Raises
    ------
    ConfigError
        If anything is wrong: one line per problem with the dotted key, the value and what is
        allowed.
    """
    try:
        study = StudyConfig.model_validate(raw)
    except ValidationError as error:
        problems = lines(StudyConfig, error.errors(include_url=False))
        raise ConfigError(_of_source(problems, source)) from None
    _refuse(list(_contradictions(study)), source)
    return study


def _refuse(problems: Sequence[str], source: str) -> None:
    if problems:
        raise ConfigError(_of_source(problems, source))


def _of_source(problems: Sequence[str], source: str) -> str:
    return "\n".join(f"{source}: {problem}" for problem in dict.fromkeys(problems))


def wrong_places(study: StudyConfig) -> Iterator[str]:
    """Yield what is wrong with the folders and files that a config names."""
    for key, folder in study.folders.model_dump().items():
        for place in (Path(folder), *Path(folder).parents):
            if place.exists() and not place.is_dir():
                yield f"folders.{key} = {folder!r}: must be a folder; {place} is a file"
    files = {f"materials.{name}.data": m.data for name, m in study.materials.items()}
    files |= {
        f"imperfections[{i}].thickness_table": series.thickness_table
        for i, series in enumerate(study.imperfection_series)
    }
    for key, file in files.items():
        if file is not None and not Path(file).is_file():
            fault = "it is a folder" if Path(file).is_dir() else "there is no such file"
            yield f"{key} = {file!r}: must be a CSV file; {fault}"


def _contradictions(study: StudyConfig) -> Iterator[str]:
    """Yield the contradictions between keys that are right by themselves."""
    yield from _wrong_study(study)
    yield from _wrong_variants(study)
    materials = [*study.materials]
    models = [*materials, *study.variants]
    yield from _wrong_series("sheets", study.sheets, models, "materials or variants")
    yield from _wrong_series("maps", study.map_series, models, "materials or variants")
    # in a tension field there is nothing to bend, and no wrinkle with a parity
    yield from _wrong_series("tension", study.tension_series, materials, "materials")
    yield from _wrong_series("compression", study.compression_series, materials, "materials")
    entries = study.imperfection_series
    yield from _wrong_series("imperfections", entries, models, "materials or variants")
    yield from _wrong_imperfections(study)
    yield from _without_tension_field(study)
    yield from _wrong_bendings(study)
    yield from _missing_figure_sheets(study)


def _wrong_series(
    block: str, entries: Sequence[LengthsBlock], known: Sequence[str], where: str
) -> Iterator[str]:
    for i, series in enumerate(entries):
        key = f"{block}[{i}]"
        if series.material not in known:
            hint = closest(series.material, known)
            yield f"{key}.material = {series.material!r}: is not in {where}{hint}"
        if isinstance(series, AnalysisBlock) and isinstance(series.strain, StrainRange):
            yield from _wrong_range(f"{key}.strain", series.strain)


def _wrong_study(study: StudyConfig) -> Iterator[str]:
    try:
        known = study.catalogue.figure_names
    except CatalogueError as error:
        yield str(error)
        return
    for i, name in enumerate(study.figures.names or ()):
        if name not in known:
            hint = closest(name, known)
            yield f"figures.names[{i}] = {name!r}: is no figure of {study.study}{hint}"


def _wrong_range(key: str, span: StrainRange) -> Iterator[str]:
    if span.stop < span.start:
        yield f"{key}.stop = {span.stop:g}: must be >= start = {span.start:g}"
    elif span.stop - span.start > MAX_STRAINS * span.step:
        yield f"{key}.step = {span.step:g}: must leave at most {MAX_STRAINS} strains"
    else:
        try:
            cases.strain_range(span.start, span.stop, span.step)
        except ValueError as error:
            yield f"{key}.{error}"


def _wrong_variants(study: StudyConfig) -> Iterator[str]:
    for name, variant in study.variants.items():
        if name in study.materials:
            yield f"variants.{name}: is the name of a material; a variant needs one of its own"
        if variant.material not in study.materials:
            hint = closest(variant.material, study.materials)
            yield f"variants.{name}.material = {variant.material!r}: is not in materials{hint}"
        if variant.bending is None and variant.parity is None:
            yield f"variants.{name}: must have bending, parity or both"


def _wrong_imperfections(study: StudyConfig) -> Iterator[str]:
    """Yield what is wrong with imperfect sheets, a table of the thickness included."""
    faults = []
    for i, series in enumerate(study.imperfection_series):
        key = f"imperfections[{i}]"
        if (series.density is None) != (series.width_mm is None):
            faults.append(f"{key}: density and width_mm must be given together")
        elif series.density is None and "gravity" in series.model_fields_set:
            faults.append(f"{key}.gravity: needs density and width_mm")
        for sheet, _ in series.cases():
            try:
                check_imperfect(sheet)
            except ValueError as error:
                faults.append(f"{key}: {error}")
    repeated = repeated_names(study.imperfect_sheets)
    faults += [f"imperfections: two different entries have the name {name}" for name in repeated]
    yield from dict.fromkeys(faults)


def _wrong_bendings(study: StudyConfig) -> Iterator[str]:
    """Yield which models of sheets and maps bend by a law that does not go with their material."""
    every = (*study.sheets, *study.map_series, *study.imperfection_series)
    used = {series.material for series in every}
    for name in sorted(used):
        variant = study.variants.get(name)
        material = study.materials.get(name if variant is None else variant.material)
        bending = study.plate.bending if variant is None else variant.bending or study.plate.bending
        if material is None:
            continue  # already refused
        try:
            check_bending(law_of(material.law), bending)
        except ValueError as error:
            yield f"{'variants' if variant else 'materials'}.{name}: {error}"


def _without_tension_field(study: StudyConfig) -> Iterator[str]:
    """Yield which entries of tension are of a law without a tension field."""
    for i, series in enumerate(study.tension_series):
        material = study.materials.get(series.material)
        if material is None:
            continue  # already refused
        try:
            check_relaxed(law_of(material.law))
        except ValueError as error:
            yield f"tension[{i}].material = {series.material!r}: {error}"


def _missing_figure_sheets(study: StudyConfig) -> Iterator[str]:
    shown = study.figures.sheet
    models = {"sheet": shown.material}
    models |= {f"compare[{i}]": model for i, model in enumerate(study.figures.compare)}
    for key, model in models.items():
        sheet = shown.model_copy(update={"material": model})
        if not any(_holds(series, sheet) for series in study.sheets):
            yield (
                f"figures.{key} = {model}, {shown.aspect:g}, {shown.thickness:g}: "
                "must be a sheet of sheets (material, aspect, thickness)"
            )


def _holds(series: SheetsBlock, sheet: FigureSheetBlock) -> bool:
    return (
        series.material == sheet.material
        and cases.canonical(sheet.aspect) in map(cases.canonical, series.aspect)
        and cases.canonical(sheet.thickness) in map(cases.canonical, series.thickness)
    )
