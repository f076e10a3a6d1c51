"""Options that choose a material: a law with its constants, or a material that is fitted."""

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from wrinklestudy.cli.numbers import number

if TYPE_CHECKING:
    from wrinklestudy.mechanics.laws import Material
    from wrinklestudy.vocabulary import Parity

DEFAULT_LAW = "mooney-rivlin"
DEFAULT_CONFIG = "config.yaml"


@dataclass(frozen=True)
class Model:
    """A material, and the bending law and the parity where a variant of the config sets them."""

    material: "Material"
    bending: str | None = None
    parity: "Parity | None" = None


def add_law(parser: argparse.ArgumentParser) -> None:
    """Add the option that names a law."""
    from wrinklestudy.mechanics.laws import LAWS

    parser.add_argument(
        "--law",
        choices=tuple(LAWS),
        default=DEFAULT_LAW,
        help=f"strain energy, {DEFAULT_LAW} by default",
    )


def add_material(parser: argparse.ArgumentParser) -> None:
    """Add the options of a material."""
    from wrinklestudy.mechanics.laws import LAWS

    group = parser.add_argument_group("material", "a law with its constants, or --material")
    add_law(group)  # type: ignore[arg-type]  # a group takes the same calls
    texts: dict[str, dict[str, list[str]]] = {}
    for law in LAWS.values():
        for constant in law.constants:
            default = "" if constant.default is None else f", default {constant.default:g}"
            unit = f" ({constant.unit})" if constant.unit else ""
            meaning = f"{constant.meaning}{unit}, {constant.allowed}{default}"
            texts.setdefault(constant.name, {}).setdefault(meaning, []).append(law.name)
    for name, meanings in texts.items():
        lines = [f"{', '.join(names)}: {meaning}" for meaning, names in meanings.items()]
        group.add_argument(f"--{name}", type=number, help="; ".join(lines))
    group.add_argument(
        "--material",
        metavar="NAME or FILE.json",
        help="a material or variant of the config, fitted to its data, or the file of a fit",
    )
    group.add_argument(
        "--config", metavar="FILE", help=f"where --material looks, {DEFAULT_CONFIG} by default"
    )


def model(arguments: argparse.Namespace) -> Model:
    """Return the material that the options describe, as the variant that they name."""
    from wrinklestudy.mechanics.laws import LAWS

    names = dict.fromkeys(c.name for law in LAWS.values() for c in law.constants)
    given = {name: getattr(arguments, name) for name in names}
    given = {name: value for name, value in given.items() if value is not None}
    if arguments.material is None:
        if arguments.config is not None:
            raise ValueError("--config: goes with --material NAME")
        return Model(_of_law(arguments.law, given))
    for name in ("law", *given):
        if name in arguments.given:
            raise ValueError(f"--material {arguments.material}: --{name} cannot go with it")
    if Path(arguments.material).suffix == ".json":
        if arguments.config is not None:
            raise ValueError("--config: goes with --material NAME, not with a file of a fit")
        return Model(_of_file(arguments.material))
    chosen = _of_config(arguments.material, arguments.config or DEFAULT_CONFIG)
    for name in ("bending", "parity"):
        own = getattr(chosen, name)
        if own is not None and name in arguments.given:
            raise ValueError(
                f"--material {arguments.material}: is a variant with {name} = {own}; --{name} "
                "cannot go with it"
            )
    return chosen


def _of_law(name: str, given: dict[str, float]) -> "Material":
    from wrinklestudy.mechanics.laws import law_of

    law = law_of(name)
    allowed = {constant.name: constant for constant in law.constants}
    for constant_name in given:
        if constant_name not in allowed:
            options = ", ".join(f"--{known}" for known in allowed)
            raise ValueError(
                f"--{constant_name}: not a constant of {law.name}, which takes {options}"
            )
    for constant_name, constant in allowed.items():
        if constant_name not in given and constant.default is None:
            unit = constant.unit or "a number"
            raise ValueError(f"--{constant_name}: {law.name} needs it ({unit})")
    return law.material(**given)


def _of_file(path: str) -> "Material":
    from wrinklestudy.results.materials import load_material

    return load_material(path)


def _of_config(name: str, path: str) -> Model:
    from wrinklestudy.material.fit import fit
    from wrinklestudy.mechanics.laws import law_of
    from wrinklestudy.study.config.one_material import read_model

    block, variant = read_model(path, name)
    if block.data is None:
        material = law_of(block.law).material(**(block.constants or {}))
    else:
        options = block.model_dump(exclude={"data", "law", "constants"})
        material = fit(block.data, block.law, **options).material()
    return Model(material, variant.bending, variant.parity)
