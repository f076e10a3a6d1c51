"""Fits as text: a report of one law, a table of several, the block of a config."""

import json
import re
from collections.abc import Iterator, Sequence

from wrinklestudy.material.choice import Choice
from wrinklestudy.material.comparison import Unfitted
from wrinklestudy.material.remarks import ILL_CONDITIONED
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import law_of

_ANSWERS = {True: "yes", False: "no", None: "not known"}
# What YAML takes for something else than text.
_NO_NAME = re.compile(r"y|n|yes|no|on|off|true|false|null|[0-9._+-].*")


def report(fit: Fit) -> str:
    """Return what a person wants to know of a fit."""
    low, high = fit.stretch_range
    lines = [
        f"{fit.law} fitted to {fit.source}: {fit.count} points, {', '.join(fit.modes)}, "
        f"stretch {low:.4g} to {high:.4g}",
        "",
        f"{'constant':<12}{'value':>14}{'standard error':>18}",
    ]
    for name, value in fit.constants.items():
        error = "at its bound" if name in fit.at_bound else f"{fit.standard_errors[name]:.3g}"
        lines.append(f"{name:<12}{value:>14.6g}{error:>18}  {fit.units[name]}".rstrip())
    lines.append("")
    lines += [f"{name:<24}{text}" for name, text in _facts(fit)]
    if fit.warnings:
        lines += ["", *(f"warning: {warning}" for warning in fit.warnings)]
    return "\n".join(lines) + "\n"


def _facts(fit: Fit) -> Iterator[tuple[str, str]]:
    names = fit.parameters
    for i, first in enumerate(names):
        for j in range(i + 1, len(names)):
            yield f"correlation {first}, {names[j]}", f"{fit.correlation[i, j]:.4f}"
    good = "well" if fit.condition_number <= ILL_CONDITIONED else "ill"
    yield (
        "condition number",
        f"{fit.condition_number:.4g} ({good}-conditioned; the bound is {ILL_CONDITIONED:g})",
    )
    material = fit.material()
    yield "initial shear modulus", f"{material.shear_modulus:.6g} Pa"
    yield "initial Young's modulus", f"{material.young_modulus:.6g} Pa"
    yield (
        "root mean square misfit",
        f"{fit.rms_pa:.4g} Pa, {fit.rms_percent:.3g} % of the largest stress",
    )
    yield "AICc", "-" if fit.aicc != fit.aicc else f"{fit.aicc:.2f}"
    yield "stable", f"{_ANSWERS[fit.stability.stable]}: {fit.stability.text}"
    yield "polyconvex", _ANSWERS[fit.polyconvex]
    for mode, offset in fit.offsets.items():
        done = f", {'removed' if fit.preload == 'remove' else 'kept'}" if offset.told else ""
        yield (
            f"{mode} stress at rest",
            f"{offset.stress_pa:.4g} +- {offset.standard_error_pa:.2g} Pa{done}",
        )


def table(results: Sequence[Fit | Unfitted]) -> str:
    """Return laws side by side, the best first, then their constants."""
    fits = [result for result in results if isinstance(result, Fit)]
    best = fits[0].aicc
    first = fits[0]
    lines = [
        f"{first.source}: {first.count} points, {', '.join(first.modes)}",
        "",
        f"{'law':<15}{'points':>7}{'rms (Pa)':>12}{'rms (%)':>9}{'AICc':>11}{'- best':>10}  stable",
    ]
    for fit in fits:
        known = fit.aicc == fit.aicc
        aicc, more = (f"{fit.aicc:.2f}", f"{fit.aicc - best:.2f}") if known else ("-", "-")
        lines.append(
            f"{fit.law:<15}{fit.count:>7}{fit.rms_pa:>12.4g}{fit.rms_percent:>9.3g}{aicc:>11}"
            f"{more:>10}  {_ANSWERS[fit.stability.stable]}"
        )
    lines.append("")
    for fit in fits:
        lines.append(f"{fit.law}: {', '.join(_constants(fit))}")
    for fit in fits:
        if law_of(fit.law).small_strain:
            lines.append(
                f"{fit.law}: fitted to the initial slope, so that its rms and AICc do not compare"
            )
    lines += [
        f"{result.law}: cannot be fitted: {result.reason}"
        for result in results
        if isinstance(result, Unfitted)
    ]
    lines += [f"warning: {warning}" for warning in warnings_of(fits)]
    return "\n".join(lines) + "\n"


def warnings_of(fits: Sequence[Fit]) -> list[str]:
    """Return the warnings of fits, each once, with the laws that it is about if not of all."""
    laws: dict[str, list[str]] = {}
    for fit in fits:
        for warning in fit.warnings:
            laws.setdefault(warning, []).append(fit.law)
    return [
        warning if len(names) == len(fits) else f"{', '.join(names)}: {warning}"
        for warning, names in laws.items()
    ]


def _constants(fit: Fit) -> Iterator[str]:
    for name, value in fit.constants.items():
        if name in fit.at_bound:
            yield f"{name} = {value:.5g} (at its bound)"
        else:
            error = fit.standard_errors[name]
            yield f"{name} = {value:.5g} +- {error:.2g} {fit.units[name]}".rstrip()


def block(data: str, law: str, choice: Choice) -> str:
    """Return the block of a config that makes the fitted law a material of a study.

    Raises
    ------
    ValueError
        If a config cannot hold it; one line.
    """
    from pydantic import ValidationError

    from wrinklestudy.study.config.blocks import MaterialBlock

    values = {"data": data, "law": law, **vars(choice)}
    values = {key: value for key, value in values.items() if value is not None}
    try:
        keys = MaterialBlock.model_validate(values).model_dump(exclude_defaults=True)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        raise ValueError(
            f"--yaml: a config cannot hold {first['loc'][0]} = {first['input']!r}: {first['msg']}"
        ) from None
    lines = [f"    {key}: {json.dumps(value, ensure_ascii=False)}" for key, value in keys.items()]
    return "\n".join(["materials:", f"  {_name(data)}:", *lines]) + "\n"


def _name(data: str) -> str:
    """Return a name for a material from that of its file."""
    stem = re.sub(r"\.[^./\\]*$", "", re.split(r"[/\\]", data)[-1]).lower()
    name = re.sub(r"[^a-z0-9_]+|_{2,}", "-", stem).strip("-_").replace("_-", "-").replace("-_", "-")
    return f"rubber-{name}".rstrip("-") if not name or _NO_NAME.fullmatch(name) else name
