"""The config of a study: what it may hold, and one clear line for each mistake."""

from wrinklestudy.study.config.checks import ConfigError, load_config, parse_config
from wrinklestudy.study.config.model import StudyConfig

__all__ = ["ConfigError", "StudyConfig", "load_config", "parse_config"]
