"""Files asked for by name: a clear line about any that no study can have."""

import os
import re
from collections.abc import Collection, Mapping
from math import isfinite, nan

from wrinklestudy.results.cases import format_value, resolved_thickness
from wrinklestudy.results.paths import STAGES, Paths
from wrinklestudy.study.config import StudyConfig
from wrinklestudy.study.config.wording import closest
from wrinklestudy.study.plan import files_of
from wrinklestudy.vocabulary import ASPECT, STRAIN, THICKNESS, Limits, one_line

_LIMITS = {
    "aspect": ASPECT,
    "thickness": THICKNESS,
    "resolved": Limits(resolved_thickness(THICKNESS.lowest), THICKNESS.highest, unit="t/W"),
    "strain": STRAIN,
}

# Stages whose jobs take all strains of the config, and what it lacks where there are none.
_NEEDS_STRAINS = {
    "metrics": "this sheet (sheets)",
    "map": "this model and L/W (maps)",
    "tension": "this material and L/W (tension)",
    "compression": "this material and L/W (compression)",
    "imperfection": "this imperfect sheet (imperfections)",
}


def refusal(target: str, study: StudyConfig, paths: Paths) -> str | None:
    """Return why a file asked for cannot be made; None if it can, or if it is no result.

    A case need not be in the config, but must be within the limits of the config. Its numbers have
    one spelling, because another spelling would be another file for the same case.

    Parameters
    ----------
    target : str
        Path as it was given.
    study : StudyConfig
        The study, with its materials and variants.
    paths : Paths
        Paths of the study.

    Returns
    -------
    str or None
        One line: path, what is wrong, what is allowed or the right spelling.
    """
    path = os.path.normpath(target)
    for stage, written in STAGES.items():
        for output in written.outputs:
            pattern = paths.pattern(stage, output)
            texts = _wildcards(pattern, path)
            if texts is not None:
                known = {
                    "figure": study.catalogue.figure_names,
                    "table": [entry.name for entry in study.catalogue.tables],
                    "material": _models(study, stage),
                }
                faults = [*_unknown(texts, known), *_outside(texts)] or _misspelt(pattern, texts)
                needs_strains = stage == "metrics" or written.analysis
                if not faults and needs_strains and path not in files_of(study, paths, stage):
                    faults = [f"the config has no strains for {_NEEDS_STRAINS[stage]}"]
                return one_line(f"{target}: {'; '.join(faults)}") if faults else None
    return None


def _wildcards(pattern: str, path: str) -> dict[str, str] | None:
    """Return the texts of the wildcards in a path, valid or not; None for any other path."""
    parts = re.split(r"\{(\w+)\}", pattern)
    literal = [re.escape(part) for part in parts[::2]]
    groups = [f"(?P<{name}>[^/]*?)" for name in parts[1::2]]
    expression = "".join(part for pair in zip(literal, [*groups, ""], strict=True) for part in pair)
    match = re.fullmatch(expression, path)
    return None if match is None else match.groupdict()


def _models(study: StudyConfig, stage: str) -> list[str]:
    """Return the names allowed for {material}; some stages are about materials only."""
    only_materials = stage in ("material", "tension", "compression")
    return [*study.materials] if only_materials else [*study.materials, *study.variants]


def _unknown(texts: Mapping[str, str], known: Mapping[str, Collection[str]]) -> list[str]:
    return [
        f"{name} {texts[name]!r} is unknown{closest(texts[name], names)}"
        for name, names in known.items()
        if name in texts and texts[name] not in names
    ]


def _outside(texts: Mapping[str, str]) -> list[str]:
    """Return which numbers are not allowed."""
    faults = []
    for name, limits in _LIMITS.items():
        value = _number(texts.get(name, "1"))
        if name in texts and value not in limits:
            faults.append(f"{name} = {texts[name]}: must be a number {limits}")
        elif name == "resolved" and name in texts and resolved_thickness(value) != value:
            right = format_value(resolved_thickness(value))
            fault = f"{name} = {texts[name]}: must be 0.001, or 0.001 halved any number of times"
            faults.append(f"{fault}; write {right}")
    return faults


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        return nan
    return value if isfinite(value) else nan


def _misspelt(pattern: str, texts: Mapping[str, str]) -> list[str]:
    """Return the right path if a number is spelt differently; all numbers are allowed ones here."""
    right = {
        name: format_value(_number(text)) if name in _LIMITS else text
        for name, text in texts.items()
    }
    return [] if right == texts else [f"numbers have one spelling; write {pattern.format(**right)}"]
