"""The config of a study: what may stand in it, and one clear line for each thing that may not."""

from wrinklestudy.study.config.checks import ConfigError, load_config, parse_config
from wrinklestudy.study.config.model import StudyConfig

__all__ = ["ConfigError", "StudyConfig", "load_config", "parse_config"]
