"""A single material of a config, whatever else the file may lack."""

from pathlib import Path
from typing import Any

import yaml
from pydantic import ValidationError

from wrinklestudy.study.config.blocks import MaterialBlock
from wrinklestudy.study.config.checks import ConfigError
from wrinklestudy.study.config.spelling import misleading
from wrinklestudy.study.config.wording import closest, lines
from wrinklestudy.typing import AnyPath


def read_material(path: AnyPath, name: str) -> MaterialBlock:
    """Return the block of one material of a config file.

    Only this block is looked at, so that a file may hold no more than what differs from the
    config of a study.

    Raises
    ------
    ConfigError
        If the file cannot be read, has no such material or its block is wrong; a line per problem
        that names the file and, where there is one, the key.
    """
    materials = _read(path)
    if name not in materials:
        raise ConfigError(f"{path}: materials has no {name!r}{closest(name, map(str, materials))}")
    try:
        return MaterialBlock.model_validate(materials[name])
    except ValidationError as error:
        problems = lines(MaterialBlock, error.errors(include_url=False))
        text = "\n".join(f"{path}: materials.{name}.{problem}" for problem in problems)
        raise ConfigError(text) from None


def _read(path: AnyPath) -> dict[Any, Any]:
    """Return the block of materials of a file."""
    try:
        problems = misleading(str(path))
        content = yaml.safe_load(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise ConfigError(f"{path}: cannot be read ({error.strerror})") from None
    except UnicodeDecodeError:
        raise ConfigError(f"{path}: is not UTF-8 text") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f"{path}, line {mark.line + 1}" if mark else f"{path}"
        raise ConfigError(f"{where}: is not YAML ({getattr(error, 'problem', error)})") from None
    if problems:
        raise ConfigError("\n".join(problems))
    materials = content.get("materials") if isinstance(content, dict) else None
    if not isinstance(materials, dict) or not materials:
        raise ConfigError(f"{path}: materials: must be a block with at least one material")
    return materials
