"""Imperfections: what clamps that are off, uneven rubber and gravity do to the wrinkles."""

from wrinklestudy.studies.imperfections.catalogue import CATALOGUE

__all__ = ["CATALOGUE"]
