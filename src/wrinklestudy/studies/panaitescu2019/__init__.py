"""Birth and decay of tensional wrinkles: Panaitescu et al., PRE 100, 053003 (2019)."""

from wrinklestudy.studies.panaitescu2019.catalogue import CATALOGUE

__all__ = ["CATALOGUE"]
