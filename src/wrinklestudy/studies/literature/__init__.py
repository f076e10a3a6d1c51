"""What others published on clamped stretched sheets, statement by statement."""

from wrinklestudy.studies.literature.catalogue import CATALOGUE

__all__ = ["CATALOGUE"]
