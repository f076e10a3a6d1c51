"""Files that are asked for by name: one clear line for one that no study can have."""

import os
import re
from collections.abc import Collection, Mapping
from math import isfinite, nan

from wrinklestudy.results.cases import format_value, resolved_thickness
from wrinklestudy.results.paths import STAGES, Paths
from wrinklestudy.study.config import StudyConfig
from wrinklestudy.study.config.wording import closest
from wrinklestudy.study.plan import files_of
from wrinklestudy.vocabulary import ASPECT, STRAIN, THICKNESS, Limits

_LIMITS = {
    "aspect": ASPECT,
    "thickness": THICKNESS,
    "resolved": Limits(resolved_thickness(THICKNESS.lowest), THICKNESS.highest, unit="t/W"),
    "strain": STRAIN,
}


def refusal(target: str, study: StudyConfig, paths: Paths) -> str | None:
    """Return why a file that is asked for cannot be made; None if it can, or is no result.

    A case need not stand in the config, but the limits of the config hold for it, and its numbers
    have one spelling: another one would be another file for the same case.

    Parameters
    ----------
    target : str
        Path as it was given.
    study : StudyConfig
        Has the materials and variants that there are.
    paths : Paths
        Of the study.

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
                if not faults and stage == "metrics" and path not in files_of(study, paths, stage):
                    faults = ["the config has no strains of this sheet (sheets)"]
                return f"{target}: {'; '.join(faults)}" if faults else None
    return None


def _wildcards(pattern: str, path: str) -> dict[str, str] | None:
    """Return the texts of the wildcards in a path, whatever they are; None for another path."""
    parts = re.split(r"\{(\w+)\}", pattern)
    literal = [re.escape(part) for part in parts[::2]]
    groups = [f"(?P<{name}>[^/]*?)" for name in parts[1::2]]
    expression = "".join(part for pair in zip(literal, [*groups, ""], strict=True) for part in pair)
    match = re.fullmatch(expression, path)
    return None if match is None else match.groupdict()


def _models(study: StudyConfig, stage: str) -> list[str]:
    """Return what may stand for {material}: only a material has constants of its own."""
    return [*study.materials] if stage == "material" else [*study.materials, *study.variants]


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
            fault = f"{name} = {texts[name]}: must be 0.001, or that halved a number of times"
            faults.append(f"{fault}; write {right}")
    return faults


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        return nan
    return value if isfinite(value) else nan


def _misspelt(pattern: str, texts: Mapping[str, str]) -> list[str]:
    """Return the right path if a number is written in another way; numbers are allowed by now."""
    right = {
        name: format_value(_number(text)) if name in _LIMITS else text
        for name, text in texts.items()
    }
    return [] if right == texts else [f"numbers have one spelling; write {pattern.format(**right)}"]
