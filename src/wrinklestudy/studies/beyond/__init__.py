"""Beyond the paper: what the conclusion of Panaitescu et al. (2019) leaves open."""

from wrinklestudy.studies.beyond.catalogue import CATALOGUE

__all__ = ["CATALOGUE"]
