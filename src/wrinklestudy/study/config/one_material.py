"""A single material of a config, or a variant of one, whatever else the file may lack."""

from typing import Any, TypeVar

from pydantic import ValidationError

from wrinklestudy.study.config.blocks import Block, MaterialBlock, VariantBlock
from wrinklestudy.study.config.checks import ConfigError
from wrinklestudy.study.config.reading import read_yaml
from wrinklestudy.study.config.spelling import misleading
from wrinklestudy.study.config.wording import closest, lines
from wrinklestudy.typing import AnyPath

_Kind = TypeVar("_Kind", bound=Block)


def read_model(path: AnyPath, name: str) -> tuple[MaterialBlock, VariantBlock]:
    """Return the block of one material of a config file, and that of its variant.

    Only these blocks are looked at, so that a file may hold no more than what differs from the
    config of a study.

    Parameters
    ----------
    path : path-like
        The config file.
    name : str
        A material, whose variant is one that changes nothing, or a variant.

    Raises
    ------
    ConfigError
        If the file cannot be read, has no such material or its block is wrong; a line per problem
        that names the file and, where there is one, the key.
    """
    materials, variants = _read(path)
    variant = VariantBlock(material=name)
    if name in variants and name not in materials:
        variant = _validated(VariantBlock, path, f"variants.{name}", variants[name])
    base = variant.material
    if base not in materials:
        known = [*map(str, materials), *map(str, variants)]
        raise ConfigError(f"{path}: materials has no {base!r}{closest(base, known)}")
    return _validated(MaterialBlock, path, f"materials.{base}", materials[base]), variant


def _validated(kind: type[_Kind], path: AnyPath, key: str, content: Any) -> _Kind:
    try:
        return kind.model_validate(content)
    except ValidationError as error:
        problems = lines(kind, error.errors(include_url=False))
        text = "\n".join(f"{path}: {key}.{problem}" for problem in problems)
        raise ConfigError(text) from None


def _read(path: AnyPath) -> tuple[dict[Any, Any], dict[Any, Any]]:
    """Return the blocks of materials and of variants of a file."""
    content = read_yaml(path)
    problems = misleading(str(path))
    if problems:
        raise ConfigError("\n".join(problems))
    materials = content.get("materials") if isinstance(content, dict) else None
    if not isinstance(materials, dict) or not materials:
        raise ConfigError(f"{path}: materials: must be a block with at least one material")
    variants = content.get("variants")
    return materials, variants if isinstance(variants, dict) else {}
