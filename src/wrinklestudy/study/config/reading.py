"""Config files as they are read without Snakemake."""

from pathlib import Path
from typing import Any

import yaml

from wrinklestudy.study.config.checks import ConfigError, load_config
from wrinklestudy.study.config.model import StudyConfig
from wrinklestudy.typing import AnyPath

DEFAULT_CONFIG = "config.yaml"


def read_study(path: AnyPath) -> StudyConfig:
    """Return the study of a config file, which goes over `config.yaml` of the working folder.

    This is what ``snakemake --configfile`` makes of it.

    Raises
    ------
    ConfigError
        If a file cannot be read or the config is wrong; a line per problem.
    """
    default = Path(DEFAULT_CONFIG)
    files = [Path(path)]
    if default.is_file() and default.resolve() != files[0].resolve():
        files.append(default)
    merged: Any = {}
    for file in reversed(files):
        content = read_yaml(file)
        merged = _over(content, merged) if isinstance(content, dict) else content
    return load_config(merged, files)


def read_yaml(path: AnyPath) -> Any:
    """Return the content of a config file.

    Raises
    ------
    ConfigError
        If the file cannot be read or is not YAML; one line that names it.
    """
    try:
        return yaml.safe_load(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise ConfigError(f"{path}: cannot be read ({error.strerror})") from None
    except UnicodeDecodeError:
        raise ConfigError(f"{path}: is not UTF-8 text") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f"{path}, line {mark.line + 1}" if mark else f"{path}"
        problem = getattr(error, "problem", None) or getattr(error, "reason", None) or str(error)
        raise ConfigError(f"{where}: is not YAML ({problem})") from None
    except ValueError as error:  # a date that is none, a number with a tag that it is none of
        raise ConfigError(f"{path}: has a value that YAML cannot read ({error})") from None
    except RecursionError:
        raise ConfigError(f"{path}: has lists and blocks too deep in each other") from None


def _over(upper: dict[Any, Any], lower: dict[Any, Any]) -> dict[Any, Any]:
    """Return one block over another: key by key, where both have a block at a key."""
    merged = dict(lower)
    for key, value in upper.items():
        below = merged.get(key)
        both = isinstance(value, dict) and isinstance(below, dict)
        merged[key] = _over(value, below) if both else value  # type: ignore[arg-type]
    return merged
